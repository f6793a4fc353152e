use libration::quantity::BareRadians;
use std::f64::consts::PI;

#[test]
fn only_bare_numbers_above_half_a_turn_are_doubted() {
    let said = |text: &str| BareRadians::in_text(text).map(|doubt| doubt.to_string());
    assert_eq!(said("-60").unwrap(), "taken as -60 rad = -9.549 turns; for degrees write -60deg");
    assert_eq!(said("1e5").unwrap(), "taken as 1e5 rad = 15915 turns; for degrees write 1e5deg");
    assert!(said("30deg,3.2").unwrap().starts_with("taken as 3.2 rad"));
    assert!(said("1:179:1").unwrap().starts_with("taken as 179 rad"));
    let [below, above] = [PI, PI.next_up()].map(|angle| said(&format!("{angle:?}")));
    assert!(below.is_none() && above.is_some());
    for clear in ["60deg", "60rad", "20pi", "pi-1e-6", "60 deg", "", "sixty", "inf", "200deg-1deg"] {
        assert_eq!(said(clear), None, "{clear}");
    }
}
