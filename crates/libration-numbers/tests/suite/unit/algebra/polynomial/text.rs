use libration::algebra::Polynomial;

#[test]
fn polynomials_are_written_as_physicists_do() {
    let (a1, a3) = (Polynomial::variable("a1"), Polynomial::variable("a3"));
    let number = |text: &str| Polynomial::constant(text.parse().unwrap());
    let squares = a1.pow(2) + number("2") * a3.pow(2) + number("8") * Polynomial::variable("Delta").pow(2);
    let condition = squares + a1.clone() * a3.clone() - number("8");
    assert_eq!(condition.to_string(), "-8 + a1^2 + a1*a3 + 2*a3^2 + 8*Delta^2");
    assert_eq!(condition.to_latex(), "-8 + a_1^2 + a_1 a_3 + 2 a_3^2 + 8 \\Delta^2");
    let fractions = number("-3/16") * a1.pow(11) - a3 * number("1/2") + number("5/2");
    assert_eq!(fractions.to_string(), "5/2 - a3/2 - 3*a1^11/16");
    assert_eq!(fractions.to_latex(), "\\frac{5}{2} - \\frac{1}{2} a_3 - \\frac{3}{16} a_1^{11}");
    assert_eq!((a1.clone() - a1).to_string(), "0");
}
