use libration::perturbation::Gauge;

#[test]
fn gauges_are_read_and_written_back() {
    for text in ["fundamental", "x_max", "half_swing", "energy", "nome", "A1=1,A3=-1", "A1=-2/3,A2=5"] {
        assert_eq!(text.parse::<Gauge>().unwrap().to_string(), text);
    }
    assert_eq!("a3=-1, A_1 = 1".parse::<Gauge>().unwrap().to_string(), "A1=1,A3=-1");
}

#[test]
fn gauges_that_mean_nothing_are_refused() {
    for text in ["", "energie", "A1", "A0=1", "A1=x", "A2=1", "A1=0", "A1=1,A1=2", "A1=1,B3=2", "A99999999=1"]
    {
        assert!(text.parse::<Gauge>().is_err(), "{text}");
    }
}
