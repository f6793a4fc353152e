//! The open gauge against the published coefficients and the exact solution of the pendulum.

use libration::algebra::{Rational, Variable};
use libration::perturbation::{EpsilonPowers, OpenGauge, OpenGaugeError};
use libration::progress::Quiet;

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

/// sin x = x − x³/6 + … as the coefficients of x, x², ….
fn sine(powers: i64) -> Vec<Rational> {
    let mut factorial = Rational::from(1);
    (1..=powers)
        .map(|power| {
            factorial = factorial.clone() * Rational::from(power);
            let sign = [0, 1, 0, -1][usize::try_from(power % 4).unwrap()];
            Rational::from(sign).checked_div(&factorial).unwrap()
        })
        .collect()
}

fn pendulum(order: u32) -> OpenGauge {
    OpenGauge::new(&sine(15), order, EpsilonPowers::OneParity, &Quiet).unwrap()
}

/// Cubic, quartic and quintic terms: no symmetry.
fn asymmetric(order: u32) -> OpenGauge {
    let force = ["3", "2", "-1/2", "5/7", "1"].map(rational);
    OpenGauge::new(&force, order, EpsilonPowers::All, &Quiet).unwrap()
}

#[test]
fn the_fifth_order_of_the_pendulum_is_the_published_general_solution() {
    let solution = pendulum(5);
    for (name, polynomial) in [
        ("B1", "0"),
        ("C1", "0"),
        ("C3", "0"),
        ("d2", "-A1^2/16"),
        ("B3", "-A1^3/192"),
        ("d4", "-A1*A3/8 + A1^4/1024"),
        ("B5", "-A1^2*A3/64 - A1^5/4096"),
        ("C5", "A1^5/20480"),
    ] {
        assert_eq!(solution.solution()[&name.into()].to_string(), polynomial, "{name}");
    }
}

/// Black and Vel count 11 unknowns and choose three; of their nine equations one is 0 = 0.
#[test]
fn nine_conditions_leave_three_of_eleven_unknowns_free() {
    let fifth = pendulum(5);
    assert_eq!(fifth.unknowns().len(), 11);
    assert_eq!(fifth.conditions().len(), 9);
    assert_eq!(fifth.conditions().iter().filter(|condition| condition.polynomial.is_zero()).count(), 1);
    assert_eq!(fifth.free_constants(), ["A1", "A3", "A5"].map(Variable::from).into());
}

/// (38) with (C2), and (46), of Black and Vel.
#[test]
fn published_gauges_have_their_published_coefficients() {
    let fundamental = pendulum(7).in_gauge(|n| Rational::from(i64::from(n == 1)));
    for (name, value) in [
        ("B3", "-1/192"),
        ("B5", "-1/4096"),
        ("B7", "-3/262144"),
        ("C5", "1/20480"),
        ("C7", "1/262144"),
        ("D7", "-1/1835008"),
        ("d2", "-1/16"),
        ("d4", "1/1024"),
        ("d6", "-1/65536"),
    ] {
        assert_eq!(fundamental[&name.into()], rational(value), "{name}");
    }
    let other = pendulum(5).in_gauge(|n| Rational::from([0, 1, 0, -1, 0, 0][n as usize]));
    assert_eq!(other[&"B5".into()], rational("63/4096"));
    assert_eq!(other[&"d4".into()], rational("129/1024"));
    assert_eq!(other[&"A3".into()], rational("-1"));
}

/// Coefficients of the gauges A₁ = 1 and A₁ = 1, A₃ = −1 from the nome, with python-flint.
#[test]
fn the_ninth_order_agrees_with_the_elliptic_functions() {
    let ninth = pendulum(9);
    let fundamental = ninth.in_gauge(|n| Rational::from(i64::from(n == 1)));
    for (name, value) in [
        ("B9", "-9/16777216"),
        ("C9", "1/4194304"),
        ("D9", "-1/16777216"),
        ("E9", "1/150994944"),
        ("d8", "-1/4194304"),
    ] {
        assert_eq!(fundamental[&name.into()], rational(value), "{name}");
    }
    let other = ninth.in_gauge(|n| Rational::from(i64::from(n == 1) - i64::from(n == 3)));
    for (name, value) in [
        ("B9", "143269/50331648"),
        ("C9", "1937/4194304"),
        ("D9", "63/16777216"),
        ("E9", "1/150994944"),
        ("d8", "24959/4194304"),
        ("d6", "-4353/65536"),
    ] {
        assert_eq!(other[&name.into()], rational(value), "{name}");
    }
}

/// Appendices A and B say that odd corrections of the frequency vanish: only while A₂ = A₄ = … = 0.
#[test]
fn even_coefficients_of_the_fundamental_are_gauge_too() {
    let solution = OpenGauge::new(&sine(15), 4, EpsilonPowers::All, &Quiet).unwrap();
    for (name, polynomial) in
        [("d1", "0"), ("B2", "0"), ("d3", "-A1*A2/8"), ("B4", "-A1^2*A2/64"), ("d2", "-A1^2/16")]
    {
        assert_eq!(solution.solution()[&name.into()].to_string(), polynomial, "{name}");
    }
    assert_eq!(solution.free_constants(), ["A1", "A2", "A3", "A4"].map(Variable::from).into());
}

#[test]
fn the_solution_satisfies_the_whole_system_identically() {
    for solution in [pendulum(7), asymmetric(4)] {
        for condition in solution.whole_system().unwrap() {
            let inserted = solution
                .solution()
                .iter()
                .fold(condition.polynomial, |left, (unknown, value)| left.substitute(unknown, value));
            assert!(inserted.is_zero(), "order {}, harmonic {}", condition.order, condition.harmonic);
        }
    }
}

/// For ẍ + x + αx² + βx³ = 0: Landau and Lifshitz, Mechanics, (28.9)–(28.13).
#[test]
fn an_asymmetric_well_shifts_the_mean_position() {
    let (alpha, beta) = (rational("2/3"), rational("-5/7"));
    let force = [Rational::from(1), alpha.clone(), beta.clone()];
    let values = OpenGauge::new(&force, 3, EpsilonPowers::All, &Quiet)
        .unwrap()
        .in_gauge(|n| Rational::from(i64::from(n == 1)));
    let value = |name: &str| values[&name.into()].clone();
    let square = alpha.clone() * alpha.clone();
    assert_eq!(value("P2"), rational("-1/2") * alpha.clone());
    assert_eq!(value("Q2"), rational("1/6") * alpha);
    assert_eq!(value("B3"), rational("1/48") * square.clone() + rational("1/32") * beta.clone());
    assert_eq!(value("d2"), rational("3/8") * beta - rational("5/12") * square);
}

#[test]
fn every_coefficient_of_an_asymmetric_well_is_fixed_but_the_gauge() {
    let solution = asymmetric(7);
    assert_eq!(solution.unknowns().len(), 8 * 7 + 6);
    assert_eq!(solution.free_constants().len(), 7);
}

/// The numbers of terms are those that the documentation states.
#[test]
fn the_whole_system_grows_very_fast() {
    let terms = |order| {
        let system = pendulum(order).whole_system()?;
        Some(system.iter().map(|condition| condition.polynomial.terms().count()).sum::<usize>())
    };
    assert_eq!([terms(5), terms(7), terms(11)], [Some(115), Some(1303), None]);
}

#[test]
fn what_cannot_be_expanded_is_refused() {
    let error = |force: &[Rational], order| {
        OpenGauge::new(force, order, EpsilonPowers::OneParity, &Quiet).unwrap_err()
    };
    assert_eq!(error(&sine(5), 0), OpenGaugeError::Order { order: 0 });
    assert_eq!(error(&sine(5), 16), OpenGaugeError::Order { order: 16 });
    assert_eq!(error(&[], 3), OpenGaugeError::NotRestoring);
    assert_eq!(error(&["-1", "0", "1"].map(rational), 3), OpenGaugeError::NotRestoring);
    assert_eq!(error(&["1", "0", "1", "2"].map(rational), 3), OpenGaugeError::EvenTerm { power: 4 });
}
