use libration::internals::periodic::NewtonStep;

/// With M − I = ((1, 1), (1, −1)) and the same distance in both components, the change is (1, 0) or (0, 1), but each error is 1.
#[test]
fn errors_of_components_do_not_cancel_each_other() {
    let step = NewtonStep::new(&[vec![2.0, 1.0], vec![1.0, 0.0]], &[1.0, 1.0], &[0, 1], &[]);
    let change = step.change(&[-1.0, -1.0], &[]).unwrap();
    assert!((change[0] - 1.0).abs() < 1e-15 && change[1].abs() < 1e-15, "{change:?}");
    let errors = step.errors(&[1.0, 1.0]).unwrap();
    assert!(errors.iter().all(|error| (error - 1.0).abs() < 1e-15), "{errors:?}");
}

/// (1/2 − 1)·x + p = −1/2 and (1/4 − 1)·v = 0, where the border sets the change of p to one unit of 1/2: x = 2.
#[test]
fn a_step_in_units_with_a_border_moves_along_the_parameter() {
    let map = [vec![0.5, 0.0], vec![0.0, 0.25]];
    let step = NewtonStep::new(&map, &[1.0, 3.0], &[0, 1], &[(&[1.0, 0.0], 0.5)]);
    let change = step.bordered(&[0.0, 0.0, 1.0]).change(&[0.5, 0.0], &[-1.0]).unwrap();
    assert!((change[0] - 2.0).abs() < 1e-15 && change[1].abs() < 1e-15 && change[2] == 1.0, "{change:?}");
    // A full turn maps every state to itself.
    let turn = [vec![1.0, 0.0], vec![0.0, 1.0]];
    assert_eq!(NewtonStep::new(&turn, &[1.0, 3.0], &[0, 1], &[]).change(&[0.0, 0.1], &[]), None);
}
