use libration::algebra::Variable;
use std::cmp::Ordering;

#[test]
fn names_are_read_and_written_back() {
    for (name, latex) in
        [("a1", "a_1"), ("B11", "B_{11}"), ("Delta", "\\Delta"), ("q01", "\\mathrm{q01}"), ("d", "d")]
    {
        assert_eq!(Variable::from(name).to_string(), name);
        assert_eq!(Variable::from(name).to_latex(), latex);
    }
    assert_eq!(Variable::from("a99999999999").index(), None);
}

#[test]
fn variables_stand_in_the_order_of_a_book() {
    let sorted = ["a0", "a1", "a3", "a11", "B3", "c", "C5", "d2", "Delta"].map(Variable::from);
    assert!(sorted.is_sorted(), "{sorted:?}");
    assert_ne!(Variable::from("a1").cmp(&Variable::from("A1")), Ordering::Equal);
}

#[test]
fn an_indexed_variable_is_the_one_of_that_name() {
    assert_eq!(Variable::indexed("a", 11), Variable::from("a11"));
    assert_eq!((Variable::indexed("B", 3).letters(), Variable::indexed("B", 3).index()), ("B", Some(3)));
}
