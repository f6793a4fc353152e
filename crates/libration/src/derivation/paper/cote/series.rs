//! Côté, (23) to (37): the binomial series under the integral, its integrals by recursion, the series of the period.

use super::statement;
use crate::algebra::{Polynomial, Rational};
use crate::derivation::paper::Verdict;
use crate::derivation::paper::compare::{decimal, identity, polynomial, series_in};
use crate::derivation::paper::exact::agreement;
use crate::derivation::paper::finding::Finding;
use crate::derivation::paper::printed::Printed;
use crate::derivation::paper::quadrature::quarter;
use crate::derivation::paper::statement::Statement;
use crate::elliptic::Modulus;
use crate::expression::{Expression, Symbol};
use crate::pendulum::{Amplitude, Pendulum};
use crate::period_formulas::{PeriodFormula, period_in_sine_squared};
use crate::quantity::Angle;
use std::f64::consts::{FRAC_PI_2, PI};

// In the formulas odd stands for (2n - 1)!!, even for (2n)!!, nn for n!!, s for sin(psi), I for the integral of
// sin^(2n) from 0 to pi/2 and I1, I2, I3 for those of n - 1, n - 2, n - 3.
pub(super) const STATEMENTS: &[Statement] = &[
    statement(
        "(23)",
        "The binomial series of the integrand (s is sin(psi)), its signs as displayed.",
        &["1 + m*s^2/2 + (-1/2)*(-3/2)*m^2*s^4/2 + (-1/2)*(-3/2)*(-5/2)*(-m^3*s^6)/6 + \
             (-1/2)*(-3/2)*(-5/2)*(-7/2)*m^4*s^8/24 = \
             1 + m*s^2/2 + 1*3/(2*4)*m^2*s^4 + 1*3*5/(2*4*6)*m^3*s^6 + 1*3*5*7/(2*4*6*8)*m^4*s^8"],
        binomial_terms,
    ),
    statement(
        "(24)",
        "The integrand as the sum of this from the given n on (odd is (2n-1)!!, even is (2n)!!).",
        &["n = 1", "odd/even*m^n*s^(2*n)"],
        sum_of_the_integrand,
    ),
    statement(
        "text: 5!! = 5*3*1 and 6!! = 6*4*2",
        "Double factorials skip every second factor.",
        &["5*3*1", "6*4*2"],
        double_factorials,
    ),
    statement(
        "(25)",
        "K(m) as the sum of this from the given n on (I is the integral of sin(psi)^(2n) from 0 to pi/2).",
        &["n = 1", "odd/even*m^n*I"],
        sum_of_the_integral,
    ),
    statement("(26)", "The integral of sin(psi)^(2n) from 0 to pi/2.", &["I = odd/even*pi/2"], wallis),
    statement(
        "text: our lowest value of n will be one",
        "Where the sum begins, and with it the recursion.",
        &["n = 1", "odd/even*m^n*I"],
        lowest_index,
    ),
    statement("(27)", "The integral at n = 1.", &["I = pi/4"], first_integral),
    statement(
        "(28)",
        "One sine is split off.",
        &["sin(psi)^(2*n) = sin(psi)^(2*n - 1)*sin(psi)"],
        split_sine,
    ),
    statement(
        "(29)",
        "By parts: the first, between 0 and pi/2, and the integral of the second.",
        &["-cos(psi)*sin(psi)^(2*n - 1)", "(2*n - 1)*cos(psi)^2*sin(psi)^(2*n - 2)"],
        by_parts,
    ),
    statement(
        "text: u = sin(psi)^(2n-1) and dv = sin(psi)",
        "The two parts of the integration.",
        &["dv = sin(psi)"],
        parts,
    ),
    statement(
        "(30)",
        "The cosine by sines: the integral of this.",
        &["(2*n - 1)*(sin(psi)^(2*(n - 1)) - sin(psi)^(2*n))"],
        by_sines,
    ),
    statement(
        "(31)",
        "The same in the integrals (I1 is that of n - 1).",
        &["I = (2*n - 1)*(I1 - I)"],
        recursion,
    ),
    statement("(32)", "Solved: the recursion.", &["I = (2*n - 1)/(2*n)*I1"], recursion),
    statement(
        "(33)",
        "Applied three times.",
        &["I = (2*n - 1)/(2*n)*I1 = (2*n - 1)/(2*n)*(2*(n - 1) - 1)/(2*(n - 1))*I2 = \
             (2*n - 1)/(2*n)*(2*(n - 1) - 1)/(2*(n - 1))*(2*(n - 2) - 1)/(2*(n - 2))*I3"],
        recursion,
    ),
    statement(
        "(34)",
        "The closed form, written (2n-1)!!/2n!!; nn is n!!, to which the sign belongs.",
        &["I = odd/(2*nn)*pi/2"],
        closed_form,
    ),
    statement(
        "(35)",
        "K(m) as the sum of this from the given n on.",
        &["n = 1", "pi/2*(odd/even)^2*m^n"],
        sum_of_squares,
    ),
    statement(
        "(36)",
        "Its first terms.",
        &["pi/2*(1 + (1/2)^2*m + (1*3/(2*4))^2*m^2 + (1*3*5/(2*4*6))^2*m^3)"],
        first_terms,
    ),
    statement(
        "(37)",
        "The series of the period.",
        &["T = T0*(1 + sin(theta0/2)^2/4 + 9*sin(theta0/2)^4/64 + 25*sin(theta0/2)^6/256)"],
        period,
    ),
    statement(
        "text: the expression holds for any starting angle",
        "The amplitudes for which the series converges, up to this.",
        &["theta0 = pi"],
        any_starting_angle,
    ),
    statement(
        "text: at small angles the period becomes 2*pi*sqrt(l/g)",
        "The limit of the series.",
        &["T = T0*(1 + sin(theta0/2)^2/4 + 9*sin(theta0/2)^4/64 + 25*sin(theta0/2)^6/256)"],
        small_angle,
    ),
    statement(
        "text: the larger the angle, the more terms are important",
        "The terms that a relative error of this takes.",
        &["error = 1/1000000"],
        terms_needed,
    ),
    statement(
        "text: a physical pendulum requires the centre of mass",
        "What the period of a rod of length L needs: the point mass at half its length has this period.",
        &["T = 2*pi*sqrt(L/(2*g))"],
        physical_pendulum,
    ),
];

/// n·(n − 2)·(n − 4)⋯, which is 1 for n below 2.
fn double_factorial(n: i64) -> i64 {
    (1..=n).rev().step_by(2).product()
}

fn constant(value: i64) -> Polynomial {
    Polynomial::constant(Rational::from(value))
}

/// The integral over π/2: the mean of sin²ⁿ, which is binomial(2n, n)/4ⁿ as the constant term of its cosines.
fn mean_of_power(n: i64) -> Option<Rational> {
    let factors = (1..=n).map(|j| Rational::new(n + j, 4 * j));
    factors.into_iter().try_fold(Rational::from(1), |product, factor| Some(product * factor?))
}

/// A term of a sum at n as a polynomial in m and s, the integrals in units of π/2.
fn term(formula: &Expression, n: i64) -> Option<Polynomial> {
    let at = at_index(formula, n);
    let integral = |n: i64| Some(Polynomial::constant(mean_of_power(n.max(0))?));
    let over = |value: Rational| Some(Polynomial::constant(value));
    let replaced = [
        ("odd", constant(double_factorial(2 * n - 1))),
        ("even", constant(double_factorial(2 * n))),
        ("nn", constant(double_factorial(n))),
        ("I", integral(n)?),
        ("I1", integral(n - 1)?),
        ("I2", integral(n - 2)?),
        ("I3", integral(n - 3)?),
        ("halfpi", over(Rational::from(1))?),
    ];
    polynomial(&in_half_pi(&at), &replaced)
}

/// π/2 as a name of its own.
fn in_half_pi(formula: &Expression) -> Expression {
    let twice = Expression::Multiply(
        Box::new(Expression::Number(Rational::from(2))),
        Box::new(Expression::symbol("halfpi")),
    );
    replace_pi(formula, &twice)
}

fn replace_pi(formula: &Expression, by: &Expression) -> Expression {
    let inner = |a: &Expression| Box::new(replace_pi(a, by));
    match formula {
        Expression::Pi => by.clone(),
        Expression::Multiply(a, b) => Expression::Multiply(inner(a), inner(b)),
        Expression::Divide(a, b) => Expression::Divide(inner(a), inner(b)),
        Expression::Power(a, b) => Expression::Power(inner(a), inner(b)),
        _ => formula.clone(),
    }
}

const TERMS: i64 = 9;

/// The sum of the terms from the printed n on, to order 8 in m.
fn partial_sum(printed: &Printed) -> Option<Polynomial> {
    let first = i64::try_from(printed.number(0)?.to_natural()?).ok()?;
    (first..TERMS).try_fold(Polynomial::zero(), |sum, n| Some(sum + term(printed.formula(1)?, n)?))
}

/// (1 − m·s²)^(−1/2), to order 8 in m, with the binomial coefficients of −1/2.
fn integrand() -> Option<Polynomial> {
    let x = Polynomial::variable("m") * Polynomial::variable("s").pow(2);
    let series = Printed::read(&["1/sqrt(1 - x)"])?;
    let coefficients = series_in("x", usize::try_from(TERMS).ok()?, series.formula(0)?, &[])?;
    Some((0..).zip(coefficients).fold(Polynomial::zero(), |sum, (n, c)| sum + x.pow(n).scaled(&c)))
}

fn binomial_terms(printed: &Printed) -> Option<Finding> {
    let exact = integrand()?;
    let m = "m".into();
    let kept = (0..=4)
        .fold(Polynomial::zero(), |sum, n| sum + exact.coefficient(&m, n) * Polynomial::variable("m").pow(n));
    let sides = printed.sides(0)?.iter().map(|side| polynomial(side, &[])).collect::<Option<Vec<_>>>()?;
    let right = sides.iter().all(|side| *side == kept);
    let evidence = "both forms are the binomial series of (1 - m*s^2)^(-1/2) to m^4, exactly, with every sign as displayed";
    Some(Finding::verified_if(right, kept.to_string(), evidence))
}

fn sum_of_the_integrand(printed: &Printed) -> Option<Finding> {
    let missing = integrand()? - partial_sum(printed)?;
    let evidence = format!(
        "(1 - m*s^2)^(-1/2) less the sum is {missing}, exactly to m^8; (23), which it abbreviates, begins with n = 0"
    );
    Some(Finding::verified_if(missing.is_zero(), "sum from n = 0, with (-1)!! = 0!! = 1", evidence))
}

fn double_factorials(printed: &Printed) -> Option<Finding> {
    let (five, six) = (printed.number(0)?, printed.number(1)?);
    let right = five == Rational::from(double_factorial(5)) && six == Rational::from(double_factorial(6));
    Some(Finding::verified_if(
        right,
        "",
        format!("5!! = {}, 6!! = {}", double_factorial(5), double_factorial(6)),
    ))
}

/// K(m)/(π/2) to order 8 in m.
fn complete_integral() -> Option<Polynomial> {
    let coefficients = period_in_sine_squared(usize::try_from(TERMS).ok()?.checked_sub(1)?);
    let m = Polynomial::variable("m");
    Some((0..).zip(coefficients).fold(Polynomial::zero(), |sum, (n, c)| sum + m.pow(n).scaled(&c)))
}

/// A sum that should be K(m).
fn sum_for_the_integral(printed: &Printed, remark: &str) -> Option<Finding> {
    let missing = complete_integral()? - partial_sum(printed)?;
    let at_half = {
        let value = partial_sum(printed)?.value(|_| Rational::new(1, 2))?;
        format!(
            "at m = 1/2 K = {:.6}, the sum to n = 8 is {:.6}",
            Modulus::from_parameter(0.5).ok()?.first(),
            value.to_f64() * FRAC_PI_2
        )
    };
    let evidence = format!("K(m) less the sum is ({missing})*pi/2, exactly to m^8; {at_half}{remark}");
    Some(Finding::verified_if(missing.is_zero(), "sum from n = 0", evidence))
}

fn sum_of_the_integral(printed: &Printed) -> Option<Finding> {
    sum_for_the_integral(printed, "")
}

fn sum_of_squares(printed: &Printed) -> Option<Finding> {
    let remark = "; its two sides, begun alike, agree with each other but not with K(m), and (36), called its expansion, has \
                  the term of n = 0 again";
    sum_for_the_integral(printed, remark)
}

fn wallis(printed: &Printed) -> Option<Finding> {
    let exact = (0..12).map(|n| Some(term(printed.formula(0)?, n)?.to_constant() == mean_of_power(n)));
    let right = exact.collect::<Option<Vec<_>>>()?.into_iter().all(|same| same);
    let quadrature = quarter(&|psi| Some(libm::pow(libm::sin(psi), 6.0)))?;
    let evidence = format!(
        "equals binomial(2n, n)/4^n*pi/2, the constant term of sin^(2n) in cosines, for n = 0 to 11, exactly ((-1)!! = 1); \
         at n = 3 quadrature gives {quadrature:.12}, it is {:.12}",
        mean_of_power(3)?.to_f64() * FRAC_PI_2
    );
    Some(Finding::verified_if(right, "", evidence))
}

fn lowest_index(printed: &Printed) -> Option<Finding> {
    let missing = complete_integral()? - partial_sum(printed)?;
    let evidence = format!(
        "begun there the sum lacks ({missing})*pi/2, the term I(0) = pi/2; n = 0 is the natural seed of the recursion: I(1) = \
         (1/2)*I(0) = {}*pi/2 follows",
        mean_of_power(1)?
    );
    Some(Finding::verified_if(missing.is_zero(), "the lowest n is 0, with I(0) = pi/2", evidence))
}

fn first_integral(printed: &Printed) -> Option<Finding> {
    let stands = term(printed.formula(0)?, 1)?.to_constant()?;
    let computed = mean_of_power(1)?;
    let quadrature = quarter(&|psi| Some(libm::sin(psi) * libm::sin(psi)))?;
    let evidence =
        format!("the mean of sin^2 is {computed}, exactly, times pi/2; quadrature {quadrature:.12}");
    Some(Finding::verified_if(stands == computed, format!("I = {computed}*pi/2"), evidence))
}

fn at_index(formula: &Expression, n: i64) -> Expression {
    formula.substitute(&Symbol::plain("n"), &Expression::Number(Rational::from(n)))
}

fn split_sine(printed: &Printed) -> Option<Finding> {
    let mut last = None;
    for n in 1..5 {
        let found =
            identity(&at_index(&printed.residual(0)?, n), &[("psi", 0.0, FRAC_PI_2)], "for n = 1 to 4")?;
        if found.verdict != Verdict::Verified {
            return Some(found);
        }
        last = Some(found);
    }
    last
}

/// d/dψ of the boundary term and the integrand must sum to sin²ⁿψ, and the boundary term vanish at both ends.
fn by_parts(printed: &Printed) -> Option<Finding> {
    let power = Printed::read(&["sin(psi)^(2*n)"])?;
    let mut right = true;
    let mut at_ends = 0.0_f64;
    for n in 1..5 {
        let series = |formula: &Expression| series_in("psi", 14, &at_index(formula, n), &[]);
        let boundary = series(printed.formula(0)?)?;
        let slope = (1..).map(Rational::from).zip(boundary.iter().skip(1)).map(|(n, c)| c.clone() * n);
        let (integrand, whole) = (series(printed.formula(1)?)?, series(power.formula(0)?)?);
        right &= slope.zip(&integrand).zip(&whole).all(|((a, b), sum)| a + b.clone() == *sum);
        for psi in [0.0, FRAC_PI_2] {
            at_ends = at_ends.max(decimal(&at_index(printed.formula(0)?, n), &[("psi", psi)])?.abs());
        }
    }
    let evidence = format!(
        "for n = 1 to 4 the derivative of the first and the second sum to sin(psi)^(2n) to psi^12, exactly; the first is at most \
         {at_ends:.1e} at 0 and pi/2"
    );
    Some(Finding::verified_if(right && at_ends < 1e-15, "", evidence))
}

/// With v = −cos ψ, the document's own, dv is sin ψ·dψ.
fn parts(printed: &Printed) -> Option<Finding> {
    let stands = series_in("psi", 12, printed.formula(0)?, &[("dpsi", 1)])?;
    let part = Printed::read(&["-cos(psi)"])?;
    let part = series_in("psi", 13, part.formula(0)?, &[])?;
    let slope = (1..).map(Rational::from).zip(part.iter().skip(1)).map(|(n, c)| c.clone() * n);
    let right = slope.eq(stands);
    let scales = series_in("psi", 12, printed.formula(0)?, &[("dpsi", 2)])?
        != series_in("psi", 12, printed.formula(0)?, &[("dpsi", 1)])?;
    let evidence = "the derivative of v = -cos(psi), which (29) uses, is sin(psi), exactly to psi^11; its differential has d(psi)";
    Some(match (right, scales) {
        (true, true) => Finding::verified(evidence),
        (true, false) => Finding::typo("dv = sin(psi)*d(psi)", evidence),
        _ => Finding::wrong("dv = sin(psi)*d(psi)", evidence),
    })
}

fn by_sines(printed: &Printed) -> Option<Finding> {
    let mut largest = 0.0_f64;
    for n in 1..8 {
        let integral = quarter(&|psi| decimal(&at_index(printed.formula(0)?, n), &[("psi", psi)]))?;
        largest = largest.max((integral - mean_of_power(n)?.to_f64() * FRAC_PI_2).abs());
    }
    let evidence = format!(
        "its quadrature is I(n) within {largest:.1e} for n = 1 to 7; as displayed the parentheses about the difference are missing"
    );
    Some(Finding::verified_if(largest < 1e-13, "", evidence))
}

fn recursion(printed: &Printed) -> Option<Finding> {
    let sides = printed.sides(0)?;
    let from = i64::try_from(sides.len()).ok()? - 1;
    let mut right = true;
    for n in from..12 {
        let exact = mean_of_power(n)?;
        for side in sides {
            right &= term(side, n)?.to_constant() == Some(exact.clone());
        }
    }
    let evidence = format!("exact for n = {from} to 11 with I(n) = binomial(2n, n)/4^n*pi/2");
    Some(Finding::verified_if(right, "I(n) = (2n-1)/(2n)*I(n-1)", evidence))
}

fn closed_form(printed: &Printed) -> Option<Finding> {
    let right = |formula: &Expression| {
        let same = (1..12).map(|n| Some(term(formula, n)?.to_constant() == mean_of_power(n)));
        same.collect::<Option<Vec<_>>>().map(|same| same.into_iter().all(|same| same))
    };
    if right(printed.formula(0)?)? {
        return Some(Finding::verified("exact for n = 1 to 11"));
    }
    let meant = Printed::read(&["odd/even*pi/2"])?;
    let evidence = format!(
        "at n = 2 it gives {}*pi/2 instead of {}*pi/2; with (2n)!! below it is exact for n = 1 to 11",
        term(printed.formula(0)?, 2)?.to_constant()?,
        mean_of_power(2)?
    );
    let correct = "I(n) = (2n-1)!!/(2n)!!*pi/2";
    Some(if right(meant.formula(0)?)? {
        Finding::typo(correct, evidence)
    } else {
        Finding::wrong(correct, evidence)
    })
}

fn first_terms(printed: &Printed) -> Option<Finding> {
    let stands = polynomial_in_half_pi(printed.formula(0)?)?;
    let exact = complete_integral()?;
    let m = "m".into();
    let kept = (0..=3)
        .fold(Polynomial::zero(), |sum, n| sum + exact.coefficient(&m, n) * Polynomial::variable("m").pow(n));
    let next = exact.coefficient(&m, 4);
    let evidence =
        format!("2*K(m)/pi from the squares of the central binomials, exactly: {kept} + {next}*m^4 + ...");
    Some(Finding::verified_if(stands == kept, format!("pi/2*({kept})"), evidence))
}

fn polynomial_in_half_pi(formula: &Expression) -> Option<Polynomial> {
    polynomial(&in_half_pi(formula), &[("halfpi", constant(1))])
}

fn period(printed: &Printed) -> Option<Finding> {
    let found = agreement(printed.formula(0)?, 6)?;
    let next = period_in_sine_squared(5);
    let evidence = format!(
        "{}; the next terms are {}*sin(theta0/2)^8 and {}*sin(theta0/2)^10",
        found.evidence, next[4], next[5]
    );
    Some(Finding { evidence, ..found })
}

fn any_starting_angle(printed: &Printed) -> Option<Finding> {
    let limit = decimal(printed.formula(0)?, &[])?;
    let partial = |count: usize| -> f64 { period_in_sine_squared(count).iter().map(Rational::to_f64).sum() };
    let short_of = |degrees: f64| {
        let formula = PeriodFormula::by_key("sin2_series_40").ok()?;
        Some(formula.fractional_error(&Angle::from_degrees(degrees).ok()?))
    };
    let evidence = format!(
        "every coefficient is positive and tends to 1/(pi*n), so it converges for sin(theta0/2)^2 < 1 alone: at 180 degrees the \
         sums to n = 10, 100 and 1000 are {:.3}, {:.3} and {:.3}, without limit, as the period; with 40 corrections the error is \
         {:.1e} at 90 degrees, {:.1e} at 150 degrees and {:.1e} at 179 degrees",
        partial(10),
        partial(100),
        partial(1000),
        short_of(90.0)?,
        short_of(150.0)?,
        short_of(179.0)?
    );
    let right = limit <= PI;
    let finding =
        Finding::verified_if(right, "theta0 < pi", evidence).with_correct("for every theta0 < 180 degrees");
    Some(finding.restricted("for theta0 < pi").holding_for(vec![(0.0, PI)]))
}

fn small_angle(printed: &Printed) -> Option<Finding> {
    let series = series_in("theta0", 4, printed.formula(0)?, &[("T0", 1)])?;
    let right = series.first() == Some(&Rational::from(1)) && series.get(1).is_some_and(Rational::is_zero);
    let evidence = format!("T/T0 = {} + {}*theta0^2 + ..., exactly", series[0], series[2]);
    Some(Finding::verified_if(right, "", evidence))
}

fn terms_needed(printed: &Printed) -> Option<Finding> {
    let tolerance = decimal(printed.formula(0)?, &[])?;
    let needed = |stem: &str, degrees: f64| {
        let angle = Angle::from_degrees(degrees).ok()?;
        (1..200_usize).find(|n| {
            PeriodFormula::by_key(&format!("{stem}{n}"))
                .is_ok_and(|formula| formula.fractional_error(&angle).abs() < tolerance)
        })
    };
    let mut counts = Vec::new();
    let mut shown = Vec::new();
    for degrees in [30.0, 60.0, 90.0, 120.0] {
        let (sine, amplitude) = (needed("sin2_series_", degrees)?, needed("power_series_", degrees)?);
        shown.push(format!("{sine} at {degrees} degrees (the series in theta0: {amplitude})"));
        counts.push(sine);
    }
    let evidence = format!("corrections for a relative error of {tolerance}: {}", shown.join(", "));
    Some(Finding::verified_if(counts.is_sorted() && counts.first() < counts.last(), "", evidence))
}

/// A uniform rod about its end: I = mL²/3, centre of mass at L/2.
fn physical_pendulum(printed: &Printed) -> Option<Finding> {
    let (length, gravity) = (1.0, 9.81);
    let stands = decimal(printed.formula(0)?, &[("L", length), ("g", gravity)])?;
    let inertia_over_moment = (length * length / 3.0) / (length / 2.0);
    let rod = Pendulum::new(inertia_over_moment, gravity).ok()?;
    let exact = rod.small_angle_period();
    let degrees = Angle::from_degrees(60.0).ok()?;
    let ratio = rod.period(&Amplitude::new(degrees).ok()?) / exact;
    let evidence = format!(
        "a uniform rod of 1 m about its end swings as a point mass at I/(m*d) = 2/3 m: T0 = {exact:.6} s, while a point mass at \
         its centre of mass gives {stands:.6} s, {:.1} % less; the law of the amplitude is the same (T/T0 = {ratio:.6} at 60 degrees)",
        100.0 * (1.0 - stands / exact)
    );
    let correct = "also the moment of inertia I about the pivot: omega0^2 = m*g*d/I, d from the pivot to the centre of mass";
    let right = (stands / exact - 1.0).abs() < 1e-12;
    let finding = Finding::verified_if(right, correct, evidence);
    Some(if right { finding } else { finding.restricted("as far as it goes: it is not enough") })
}
