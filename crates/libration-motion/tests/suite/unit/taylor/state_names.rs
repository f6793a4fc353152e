use libration::internals::taylor::named_state;

#[test]
fn names_are_the_state_s_and_come_once() {
    let names = ["x", "y", "x'", "y'"].map(str::to_owned);
    let state = |values: &[(&str, f64)]| named_state(&names, vec![0.5, 0.0, 0.0, 0.0], values);
    assert_eq!(state(&[]), Ok(vec![0.5, 0.0, 0.0, 0.0]));
    assert_eq!(state(&[("y'", 3.0), ("x", 1.0)]), Ok(vec![1.0, 0.0, 0.0, 3.0]));
    let unknown = state(&[("x''", 1.0)]).unwrap_err().to_string();
    assert_eq!(unknown, "the state has no variable `x''`: it has x, y, x', y'");
    let twice = state(&[("x", 1.0), ("x", 1.0)]).unwrap_err().to_string();
    assert_eq!(twice, "x is given twice: give it one value");
}
