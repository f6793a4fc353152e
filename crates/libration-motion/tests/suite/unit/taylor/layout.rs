use libration::expression::Equation;
use libration::taylor::StateLayout;

fn layout(text: &str) -> StateLayout {
    StateLayout::new(&text.parse().unwrap())
}

#[test]
fn velocities_follow_for_those_that_have_one() {
    let mixed = layout("q' = x; x'' = -x; z' = y; y'' = -q");
    assert_eq!((mixed.coordinates(), mixed.numbers()), (4, 6));
    assert_eq!(
        (0..6).map(|n| mixed.velocity(n)).collect::<Vec<_>>(),
        [None, Some(4), None, Some(5), None, None]
    );
    assert_eq!((0..4).map(|n| mixed.driven(n)).collect::<Vec<_>>(), [0, 4, 2, 5]);
    assert_eq!(
        (0..7).map(|n| mixed.driving(n)).collect::<Vec<_>>(),
        [Some(0), None, Some(2), None, Some(1), Some(3), None]
    );
    assert_eq!(
        mixed
            .symbols(&["q", "x", "z", "y"].map(str::to_owned))
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>(),
        ["q", "x", "z", "y", "x'", "y'"]
    );
    assert!(!mixed.is_of_second_order() && layout("x'' = -x; y'' = -y").is_of_second_order());
}

#[test]
fn copies_stand_between_coordinates_and_velocities() {
    use libration::taylor::with_tangents;
    let equation: Equation = "q' = x; x'' = -q*x".parse().unwrap();
    let (layout, copied) = (StateLayout::new(&equation), with_tangents(&equation, 2));
    let symbols = StateLayout::new(&copied).symbols(copied.variables());
    let names = layout.symbols(equation.variables());
    for (number, name) in names.iter().enumerate() {
        for copy in 0..3 {
            let expected = if copy == 0 { name.to_string() } else { format!("delta{copy} {name}") };
            assert_eq!(symbols[layout.place_in_copy(number, copy, 2)].to_string(), expected);
        }
    }
}
