use libration::comparison::SeriesQuantity;

#[test]
fn quantities_are_read_and_written_back() {
    for text in ["period", "frequency", "a0", "a3"] {
        assert_eq!(text.parse::<SeriesQuantity>().unwrap().to_string(), text);
    }
    for text in ["", "b3", "a", "a-1", "a99999", "energy"] {
        assert!(text.parse::<SeriesQuantity>().is_err(), "{text}");
    }
}
