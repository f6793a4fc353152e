use libration::expression::Expression;

fn part(text: &str) -> Option<String> {
    text.parse::<Expression>().unwrap().without_value().map(|obstacle| obstacle.part)
}

#[test]
fn what_has_no_value_anywhere_is_found() {
    let without = [
        ("x + 1/0*x", "1/0"),
        ("x/0", "x/0"),
        ("0/0", "0/0"),
        ("sin(2/(y - y))", "2/(y - y)"),
        ("0^(-1)", "0^(-1)"),
        ("ln(-1) - x", "ln(-1)"),
        ("ln(0)", "ln(0)"),
        ("sqrt(-2)*x", "sqrt(-2)"),
        ("sqrt(1 - pi)", "sqrt(1 - pi)"),
        ("asin(1.0000001)", "asin(1.0000001)"),
        ("acos(-exp(1))", "acos(-exp(1))"),
    ];
    for (text, expected) in without {
        assert_eq!(part(text).as_deref(), Some(expected), "{text}");
    }
}

#[test]
fn what_has_a_value_somewhere_is_left_alone() {
    for text in [
        "1/x",
        "ln(x)",
        "sqrt(x - 1)",
        "x^(-1)",
        "1/(x^2 + 1)",
        "asin(1)",
        "acos(-1)",
        "sqrt(0)",
        "ln(1e-400)",
        "exp(1000)",
        "10^400",
        "asin(sin(pi/2))",
        "sqrt(sin(pi))",
        "1/sin(pi/3)",
        "x^10001",
        "atan(10^400)",
    ] {
        assert_eq!(part(text), None, "{text}");
    }
}
