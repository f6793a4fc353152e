//! The derivation of the first correction alone: from sin θ ≈ θ − θ³/6 to T ≈ T0(1 + θ0²/16), for a first course.

use super::check::{CheckedEquation, DerivationError, same_series};
use super::document::{Block, Derivation, DerivationStep, DerivationTable};
use super::formula::{
    DecimalUnit, Formula, Name, Statement, cos, derivative, letter, number, order, rounded, sin, sqrt,
};
use super::prose::Prose;
use super::trials::{Swing, Trials};
use super::words::{amplitude, omega_0, period, small_swing_period, theta_0};
use libration::algebra::Rational;
use libration::pendulum::period_ratio;

/// The largest amplitude in degrees: 1 − θ0²/8 vanishes at 162.1°.
const LARGEST: f64 = 160.0;

/// The period of a pendulum to the first correction, on two pages, with the numbers of a swing if one is given.
///
/// # Errors
/// An amplitude below 0.01° or above 160°, where 1 − θ0²/8 is nearly zero; and a formula that fails its check, which would be an error of this program.
pub fn first_correction(swing: Option<&Swing>) -> Result<Derivation, DerivationError> {
    let degrees = swing.map_or(0.0, |swing| swing.amplitude.angle().degrees());
    if degrees > LARGEST {
        return Err(DerivationError::Amplitude { degrees, largest: LARGEST });
    }
    let mut trials = Trials::new(swing)?;
    let steps = vec![force(&mut trials)?, trial_motion(&trials)?, condition(&mut trials)?, result(&trials)?];
    let introduction = Prose::text(
        "Textbooks call the period of a pendulum independent of its amplitude. It is longer by the part 1/16 of the square of the \
         amplitude in radians, 0.8 % at 20 degrees, which a stopwatch shows within ten swings. This page derives the 1/16 \
         with nothing but a formula for the cube of a cosine.",
    );
    Ok(Derivation {
        title: "The first correction to the period of a pendulum".to_owned(),
        introduction: vec![Block::Paragraph(introduction)],
        steps,
        answers: vec![],
    })
}

fn theta() -> Formula {
    letter("θ")
}

fn omega() -> Formula {
    letter("ω")
}

/// ωt.
fn phase() -> Formula {
    letter("ψ")
}

fn acceleration() -> Formula {
    Name::new("θ").prime().prime().into()
}

/// 1 − θ0²/8.
fn weakening() -> Formula {
    number(1) - theta_0().squared() / 8
}

fn force(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let frequency = trials.define(&Name::new("ω").index(0), sqrt(letter("g") / letter("ℓ")))?;
    let small = trials.define(&Name::new("T").index(0), number(2) * Formula::Pi / omega_0())?;
    let motion = Statement::equal(acceleration(), -(omega_0().squared() * sin(theta())));
    let sine = Statement::equal(sin(theta()), theta() - theta().pow(3) / 6 + order(theta().pow(5)));
    let kept = acceleration() + omega_0().squared() * theta() - omega_0().squared() * theta().pow(3) / 6;
    Ok(DerivationStep::new("force", "The force, one term further")
        .say(
            "A small heavy body swings without friction at the end of a rod of length {} under the acceleration of free fall {}. \
             Its angle {} from the downward vertical, in radians, obeys",
            [letter("ℓ"), letter("g"), theta()],
        )
        .show(CheckedEquation::premise(motion))
        .show(frequency)
        .say_where(trials.wanted(), "The pendulum whose numbers follow has the amplitude, length and gravity", [])
        .show_all(trials.given())
        .say("The sine begins with the angle itself:", [])
        .show(same_series(&Name::new("θ"), 5, sine)?)
        .say(
            "With the first term alone the motion is {} times the cosine of {}, whatever the amplitude, with the period",
            [theta_0(), omega_0() * letter("t")],
        )
        .show(small)
        .say("The second term makes the force weaker than a linear one, and so the pendulum slower. Keep both:", [])
        .show(CheckedEquation::premise(Statement::equal(kept, number(0)))))
}

fn trial_motion(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    // Any frequency and any phase would do.
    let here = trials.with(&Name::new("ω"), omega_0() * number(9) / 10)?;
    let here = here.with(&Name::new("ψ"), number(7) / 10)?;
    let trial = theta_0() * cos(phase());
    let twice = Statement::equal(
        omega() * derivative(-(omega() * theta_0() * sin(phase())), "ψ"),
        -(omega().squared() * theta_0() * cos(phase())),
    );
    let cube = Statement::equal(
        cos(phase()).pow(3),
        number(3) / 4 * cos(phase()) + number(1) / 4 * cos(3 * phase()),
    );
    let swing = trial.clone();
    let left = -(omega().squared() * swing.clone()) + omega_0().squared() * swing.clone()
        - omega_0().squared() * swing.clone().pow(3) / 6;
    let bracket = omega_0().squared() * weakening() - omega().squared();
    let third = omega_0().squared() * theta_0().pow(3) / 24 * cos(3 * phase());
    let put_in = Statement::equal(left, bracket * swing - third);
    Ok(DerivationStep::new("trial", "A trial motion")
        .say(
            "The body, released at the amplitude {}, still swings nearly like a cosine. Its frequency {} is not known yet; let {} stand for \
             {}, which grows by {} in each second:",
            [theta_0(), omega(), phase(), omega() * letter("t"), omega()],
        )
        .show(CheckedEquation::definition(Statement::defined(theta(), trial)))
        .say("Each derivative with respect to the time brings a factor {}, so that the acceleration is", [omega()])
        .show(here.compare(twice)?)
        .say("The cube of a cosine is a sum of two cosines:", [])
        .show(here.compare(cube)?)
        .say("Put into the left side of the equation of motion, the trial gives", [])
        .show(here.compare(put_in)?)
        .remark(
            "Count it once by hand: the cube contributes {} of {} to the cosine, and {} is {}.",
            [number(3) / 4, number(1) / 6, number(3) / 4 * number(1) / 6, number(1) / 8],
        ))
}

fn condition(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    trials.define(&Name::new("ω"), omega_0() * sqrt(weakening()))?;
    let here = trials.with(&Name::new("ψ"), number(7) / 10)?;
    let law = Statement::equal(omega().squared(), omega_0().squared() * weakening());
    let third = -(theta_0().pow(3) / 192 * cos(3 * phase()));
    let force = omega_0().squared() * theta_0().pow(3) / 24 * cos(3 * phase());
    // y″ is −9ω0² y but for higher powers of the amplitude.
    let answer = Statement::equal(
        -(9 * omega_0().squared() * third.clone()) + omega_0().squared() * third.clone(),
        force,
    );
    Ok(DerivationStep::new("condition", "No push in time with the swing")
        .say(
            "Two terms are left over, and a motion that solves the equation must account for both. The first is a push in time with \
             the swing, like that on a child’s swing: it would change the amplitude more and more. But the energy, and with it the \
             amplitude, is conserved. So its bracket must vanish:",
            [],
        )
        .show(trials.compare(law)?)
        .say(
            "The second comes three times in each swing. It only bends the motion a little: to the cosine is added {}, whose \
             acceleration and restoring force together are that push, up to higher powers of the amplitude,",
            [third],
        )
        .show(here.compare(answer)?)
        .remark(
            "At an amplitude of one radian this addition is half a per cent of the swing. Its own effect on the frequency is of the fourth \
             power of {}, like that of the next term of the sine.",
            [theta_0()],
        ))
}

fn result(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let root = Statement::equal(number(2) * Formula::Pi / omega(), small_swing_period() / sqrt(weakening()));
    let first = number(1) + theta_0().squared() / 16;
    let expanded = Statement::equal(number(1) / sqrt(weakening()), first.clone() + order(theta_0().pow(4)));
    let corrected = small_swing_period() * first;
    let numbers =
        [(small_swing_period(), 8, DecimalUnit::Second), (corrected.clone(), 8, DecimalUnit::Second)];
    let law = Formula::from(Name::new("T")) / small_swing_period() - 1;
    Ok(DerivationStep::new("period", "The period")
        .say("One swing takes the time in which {} grows by a whole turn:", [phase()])
        .show(trials.compare(root)?)
        .say("and for small amplitudes, by the binomial series,", [])
        .show(same_series(&amplitude(), 4, expanded)?)
        .say(
            "So {} is {} times one plus a sixteenth of the square of the amplitude in radians, to the first correction.",
            [period(), small_swing_period()],
        )
        .show_all(trials.numbers(&numbers)?)
        .say("The exact period, from the elliptic integral, shows how good this is:", [])
        .table(comparison(&law)?)
        .remark(
            "Ten swings of a pendulum of one metre take 20 seconds; at 20 degrees the correction makes them 0.15 seconds longer. The next \
             correction, {}, takes the same steps with more terms.",
            [Formula::from(Rational::new(11, 3072).unwrap_or_else(|| Rational::from(0))) * theta_0().pow(4)],
        ))
}

/// Amplitudes of the comparison, in degrees.
const AMPLITUDES: [i64; 7] = [5, 10, 20, 30, 45, 60, 90];

fn comparison(law: &Formula) -> Result<DerivationTable, DerivationError> {
    let cell = |value: f64, digits, unit| Prose::formula(rounded(value, digits, unit));
    let row = |&degrees: &i64| {
        let radians = f64::from(i32::try_from(degrees).unwrap_or(0)).to_radians();
        let exact = period_ratio(radians);
        let first = radians * radians / 16.0;
        vec![
            Prose::formula(number(degrees)),
            cell(exact - 1.0, 4, DecimalUnit::One),
            cell(first, 4, DecimalUnit::One),
            cell((1.0 + first) / exact - 1.0, 2, DecimalUnit::One),
        ]
    };
    let head = vec![
        Prose::text("amplitude in degrees"),
        Prose::text("exact ").and(Prose::formula(law.clone())),
        Prose::formula(theta_0().squared() / 16),
        Prose::text("error of the period"),
    ];
    let note = Prose::text("the exact values are those of the library; errors are relative");
    Ok(DerivationTable::numbers(head, AMPLITUDES.iter().map(row).collect(), note))
}
