//! The period near the upright position, from the motion on the separatrix.

use super::super::check::{DerivationError, same_series};
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, call, cos, integral, letter, ln, number, order, rounded, sin,
};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::super::words::{amplitude, omega_0, period_ratio, small_swing_period, theta_0};
use super::report::{exact_ratio, stated};
use libration::algebra::{Function, Rational};

fn distance() -> Formula {
    letter("η")
}

/// (2/π) ln(8/(π − θ0)).
fn formula() -> Formula {
    number(2) / Formula::Pi * ln(number(8) / (Formula::Pi - theta_0()))
}

pub(super) fn butikov(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let upright = integral("φ", 0, letter("θ"), number(1) / (2 * cos(letter("φ") / 2)));
    let to_angle = Statement::equal(upright, ln(call(Function::Tan, Formula::Pi / 4 + letter("θ") / 4)));
    let near_top = Statement::equal(
        ln(distance() * cos(distance() / 4) / (4 * sin(distance() / 4))),
        -(distance().squared() / 48) + order(distance().pow(4)),
    );
    let growth = trials.with(&Name::new("u"), number(50))?;
    let u = || letter("u");
    let cosine = Statement::equal(call(Function::Cosh, ln(2 * u())), u() + number(1) / (4 * u()));
    let both =
        trials.with(&Name::new("η"), number(1) / 10)?.with(&Name::new("δ"), Formula::Pi - theta_0())?;
    let sum = Statement::equal(
        ln(number(4) / distance()) + ln(2 * distance() / letter("δ")),
        ln(number(8) / letter("δ")),
    );
    Ok(DerivationStep::new("butikov", "Butikov: from the separatrix")
        .say(
            "Released just below the upright position, a pendulum spends nearly all its time there. Let {} be its \
             distance from the upright position at the release, {}, and {} that distance later. Over most of the circle it moves \
             as if it had come from the upright position itself, with the energy of the separatrix, where {} is {}. With time in \
             units of {} this motion takes, from the bottom to the angle {},",
            [
                letter("δ"),
                Formula::Pi - theta_0(),
                distance(),
                Formula::from(Name::new("θ").prime()),
                2 * omega_0() * cos(letter("θ") / 2),
                number(1) / omega_0(),
                letter("θ"),
            ],
        )
        .show(trials.compare(to_angle)?)
        .say("which is the logarithm of the cotangent of {}, and near the top nearly that of {}, because the quotient of the two has the logarithm", [
            distance() / 4,
            number(4) / distance(),
        ])
        .show(same_series(&Name::new("η"), 4, near_top)?)
        .say(
            "Near the top the force grows with the distance, and the distance as {} with the time since the release. It has \
             grown by a factor {} when the time is nearly the logarithm of {}, because",
            [letter("δ") * call(Function::Cosh, omega_0() * letter("t")), u(), 2 * u()],
        )
        .show(growth.compare_once(cosine)?)
        .say(
            "(checked at {} = 50). With {} for {} both descriptions hold where {} is small and yet much larger than {}, and there \
             the two times add up to a quarter of the period. The place where they are joined drops out:",
            [u(), distance() / letter("δ"), u(), distance(), letter("δ")],
        )
        .show(both.compare(sum)?)
        .say("A quarter of {} is {} in this unit, so that the ratio is nearly", [small_swing_period(), Formula::Pi / 2])
        .show(stated(trials, "butikov", "But", formula())?))
}

pub(super) fn error_near_the_top(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let delta = || Formula::Pi - theta_0();
    let logarithm = || ln(number(8) / delta());
    let predicted = -(delta().squared() * (number(1) / 16 - number(1) / (48 * logarithm())));
    let mut rows = Vec::new();
    for power in [1, 2, 3, 4] {
        let small =
            Formula::from(Rational::from(10).integer_power(-power).unwrap_or_else(|| Rational::from(0)));
        let near = trials.with(&amplitude(), Formula::Pi - small.clone())?;
        let value = |formula: &Formula| Ok::<f64, DerivationError>(near.value(formula)?.to_f64());
        let error = value(&(formula() / exact_ratio() - 1))?;
        rows.push(vec![
            Prose::formula(rounded(value(&small)?, 1, DecimalUnit::One)),
            Prose::formula(rounded(value(&exact_ratio())?, 11, DecimalUnit::One)),
            Prose::formula(rounded(value(&formula())?, 11, DecimalUnit::One)),
            Prose::formula(rounded(error, 5, DecimalUnit::One)),
            Prose::formula(rounded(value(&predicted)?, 5, DecimalUnit::One)),
        ]);
    }
    let head = vec![
        Prose::formula(letter("δ")),
        Prose::text("exact ").and(Prose::formula(period_ratio())),
        Prose::text("formula"),
        Prose::text("error"),
        Prose::text("expected"),
    ];
    Ok(DerivationStep::new("near-the-top", "Accuracy near the top")
        .say(
            "The corrections are of the order of the square of {}. The next terms of the elliptic integral near the top give \
             an error of about {}, with {} for the logarithm:",
            [
                letter("δ"),
                -(letter("δ").squared() * (number(1) / 16 - number(1) / (48 * letter("L")))),
                letter("L"),
            ],
        )
        .table(DerivationTable::numbers(head, rows, Prose::text("computed with 77 digits")))
        .remark("At small swings the formula is 40 % too low: it knows the upright position and nothing else.", []))
}
