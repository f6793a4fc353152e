//! The steps of the derivation.

use super::super::averaging::{AveragingQuestion, in_terms};
use super::super::check::{Check, CheckedEquation, CycleClaim, CycleFormula};
use super::super::document::{Cells, DerivationStep, DerivationTable};
use super::super::formula::{
    Formula, Name, Statement, cos, letter, monomial, number, order, polynomial, scaled, sin, sum,
};
use super::super::phase::{Wave, series};
use super::super::prose::Prose;
use super::cycle::{Cycle, CycleOrder};
use libration::algebra::{Polynomial, Rational, Variable};

/// Highest power whose table is shown unfolded; those of higher powers are folded.
const OPEN_TO_READ: usize = 2;

fn tau() -> Formula {
    letter("τ")
}

fn index(name: &str, n: usize) -> Name {
    Name::new(name).index(whole(n))
}

fn whole(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}

fn motion_name(question: &AveragingQuestion, n: usize) -> Name {
    question.displacement.clone().index(whole(n))
}

fn raised(base: Formula, n: usize) -> Formula {
    monomial(&Rational::from(1), &base, n)
}

/// factor·ω0ⁿ as a number.
fn with_omega0(question: &AveragingQuestion, factor: i64, exponent: isize) -> Rational {
    let power = question.omega0().integer_power(exponent).unwrap_or_else(|| Rational::from(1));
    Rational::from(factor) * power
}

pub(super) fn equation(question: &AveragingQuestion) -> DerivationStep {
    let second = Formula::from(question.variable.clone().prime().prime());
    let whole = second + question.acceleration().negated();
    let omega0 = Statement::equal(Name::new("ω").index(0), question.omega0().clone());
    let step = DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "The strength of the excitation is the small number {}; a prime is a derivative with respect to the time:",
            [question.small()],
        )
        .show(CheckedEquation::premise(Statement::equal(whole, number(0))));
    let step = match question.variable == question.displacement {
        true => step,
        false => {
            let (variable, equilibrium) =
                (Formula::from(&question.variable), Formula::from(question.equilibrium.clone()));
            let definition = Statement::defined(question.u(), variable - equilibrium);
            step.say("The displacement is counted from the place of rest:", [])
                .show(CheckedEquation::definition(definition))
        }
    };
    step.say("Without it a linear spring is left, with the frequency", [])
        .show(CheckedEquation::definition(omega0))
        .say("and all amplitudes are possible. The excitation chooses one of them.", [])
}

pub(super) fn ansatz(question: &AveragingQuestion) -> DerivationStep {
    let (c, x) = (|| question.small(), |n: usize| Formula::from(motion_name(question, n)));
    let phase = Statement::defined(tau(), letter("Ω") * letter("t"));
    let motion = vec![x(0), c() * x(1), raised(c(), 2) * x(2), letter("…")];
    let frequency = |n: usize| Formula::from(index("Ω", n));
    let omega = vec![
        Formula::from(Name::new("ω").index(0)),
        c() * frequency(1),
        raised(c(), 2) * frequency(2),
        letter("…"),
    ];
    let beginning = Formula::from(index("A", 0)) * cos(tau());
    DerivationStep::new("ansatz", "The ansatz")
        .say("The cycle has one frequency {}, which is not known yet. So time is counted by the phase", [letter("Ω")])
        .show(CheckedEquation::definition(phase))
        .say("and motion and frequency are power series,", [])
        .show(CheckedEquation::definition(Statement::equal(question.u(), sum(motion))))
        .show(CheckedEquation::definition(Statement::equal(letter("Ω"), sum(omega))))
        .say(
            "A derivative with respect to time is {} times one with respect to {}, and at the functions {} primes are from here on the latter; {} is what stands \
             beside a power in the velocity.",
            [
                letter("Ω"),
                tau(),
                Formula::from(question.displacement.clone().index(letter("n"))),
                Name::new("v").index(letter("n")).into(),
            ],
        )
        .say(
            "The equation does not say when the clock was started. That is chosen so that {} nowhere has a part of {}. Without excitation the motion is",
            [question.u(), sin(tau())],
        )
        .show(CheckedEquation::definition(Statement::equal(motion_name(question, 0), beginning)))
        .say(
            "with an amplitude that nothing fixes yet. And so in each power: the part of {} of the newest function cancels in the equation, its amplitude {} remains open, and \
             is fixed one power later. There the right side must have no part of {} and none of {}, which would make the motion grow: the first fixes the frequency, the second the amplitude one power below.",
            [cos(tau()), Name::new("A").index(letter("n")).into(), cos(tau()), sin(tau())],
        )
}

fn checked(
    question: &AveragingQuestion,
    n: usize,
    statement: Statement,
    claim: CycleClaim,
) -> CheckedEquation {
    let formula = CycleFormula { flow: question.flow.clone(), order: n, claim };
    CheckedEquation::new(statement, Check::Cycle(Box::new(formula)))
}

pub(super) fn one_power(question: &AveragingQuestion, cycle: &Cycle, n: usize) -> DerivationStep {
    let order = &cycle.orders[n - 1];
    let open = index("A", n - 1);
    const ORDINALS: [&str; 9] =
        ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth"];
    let heading = format!("The {} power", ORDINALS.get(n - 1).unwrap_or(&"next"));
    let step = DerivationStep::new(&format!("order-{n}"), &heading);
    let way = |step: DerivationStep| {
        step.say("The parts of the equation of motion bring to the right side", [])
            .table(table(question, cycle, n))
            .say("so that the equation in this power is", [])
            .show(forcing(question, cycle, n))
    };
    let step = match n <= OPEN_TO_READ {
        true => way(step),
        false => step.fold("Contributions of lower powers, and the equation", way),
    };
    let sine = polynomial(&order.forcing.first_harmonic(Wave::Sine), &Formula::from(&open));
    let amplitude = Statement::equal(&open, order.amplitude_below.clone());
    let frequency = Statement::equal(index("Ω", n), order.frequency.clone());
    let newest = index("A", n);
    let mut motion = vec![Formula::from(&newest) * cos(tau())];
    if !order.forced.is_zero() {
        motion.push(series(&order.forced, "τ"));
    }
    let motion = motion.into_iter().reduce(|sum, term| sum + term).unwrap_or_else(|| number(0));
    let motion = Statement::equal(motion_name(question, n), motion);
    step.say("Its part of {} must vanish,", [sin(tau())])
        .show(checked(
            question,
            n,
            Statement::equal(sine, number(0)),
            CycleClaim::Sine { open: open.clone() },
        ))
        .say(amplitude_found(n), [])
        .show(checked(question, n, amplitude, CycleClaim::Amplitude))
        .say("With this amplitude the part of {} vanishes for", [cos(tau())])
        .show(checked(question, n, frequency, CycleClaim::Frequency))
        .say("What is left forces, each harmonic divided by its own stiffness,", [])
        .show(checked(question, n, motion, CycleClaim::Motion { open: newest }))
}

fn amplitude_found(n: usize) -> &'static str {
    match n {
        1 => "which it does for no motion at all, and for the amplitude",
        _ => "which fixes the amplitude that was left open:",
    }
}

fn table(question: &AveragingQuestion, cycle: &Cycle, n: usize) -> DerivationTable {
    let open = index("A", n - 1);
    let row = |(part, products, value): &(Option<usize>, Polynomial, super::open::Open)| {
        vec![
            Prose::formula(part_of_equation(question, *part)),
            in_terms(&of_products(question, products)),
            in_terms(&value.written(&open)),
        ]
    };
    let head =
        vec![Prose::text("part"), Prose::text("as products of what is known"), Prose::text("worked out")];
    DerivationTable {
        cells: Cells::Formulas,
        head,
        rows: cycle.orders[n - 1].parts.iter().map(row).collect(),
        note: Prose::text("the signs are those on the right side; checked with their sum"),
    }
}

fn part_of_equation(question: &AveragingQuestion, part: Option<usize>) -> Formula {
    let Some(term) = part.and_then(|number| question.flow.terms.get(number)) else {
        return letter("Ω").squared() * Formula::from(question.displacement.clone().prime().prime());
    };
    let velocity = Formula::from(Name::new("v"));
    let factors =
        [(question.small(), term.parameter), (question.u(), term.position), (velocity, term.velocity)];
    let product = factors.into_iter().filter(|(_, n)| *n > 0).map(|(base, n)| raised(base, n));
    match product.reduce(|product, factor| product * factor) {
        None => Formula::Number(term.factor.clone()),
        Some(product) => scaled(&term.factor, product),
    }
}

fn of_products(question: &AveragingQuestion, products: &Polynomial) -> Formula {
    let named = |variable: &Variable| {
        let n = usize::try_from(variable.index().unwrap_or(0)).unwrap_or(usize::MAX);
        match variable.letters() {
            "x" => motion_name(question, n),
            "x''" => motion_name(question, n).prime().prime(),
            "v" => index("v", n),
            _ => index("Ω", n),
        }
    };
    let terms = products.terms().map(|(monomial, factor)| {
        let factors = monomial.factors().iter();
        let factors = factors.map(|(variable, exponent)| {
            raised(named(variable).into(), usize::try_from(*exponent).unwrap_or(usize::MAX))
        });
        match factors.reduce(|product, power| product * power) {
            None => Formula::Number(factor.clone()),
            Some(product) => scaled(factor, product),
        }
    });
    sum(terms.collect())
}

fn forcing(question: &AveragingQuestion, cycle: &Cycle, n: usize) -> CheckedEquation {
    let CycleOrder { forcing, .. } = &cycle.orders[n - 1];
    let open = index("A", n - 1);
    let x = |primes: usize| {
        let name = (0..primes).fold(motion_name(question, n), |name, _| name.prime());
        scaled(&with_omega0(question, 1, 2), name.into())
    };
    let written = forcing.written(&open);
    let frequency = Formula::from(index("Ω", n)) * cos(tau());
    let newest = match n {
        1 => scaled(&with_omega0(question, 2, 1), Formula::from(&open) * frequency),
        _ => scaled(&(with_omega0(question, 2, 1) * cycle.orders[0].amplitude_below.clone()), frequency),
    };
    let right = if written == number(0) { newest } else { written.clone() + newest };
    let claim = CycleClaim::Forcing { open, value: written };
    checked(question, n, Statement::equal(x(2) + x(0), right), claim)
}

/// Frequency and harmonics as series.
pub(super) fn result(question: &AveragingQuestion, cycle: &Cycle) -> DerivationStep {
    let last = cycle.orders.len();
    let c = || question.small();
    let frequencies: Vec<Rational> = (0..=last).map(|n| cycle.frequency(question, n)).collect();
    let frequency = polynomial(&frequencies, &c()) + order(raised(c(), last + 1));
    let claim = CycleClaim::FrequencySeries { parameter: question.parameter.clone() };
    let frequency = checked(question, last, Statement::equal(letter("Ω"), frequency), claim);
    let amplitudes: Vec<Rational> = cycle.orders.iter().map(|order| order.amplitude_below.clone()).collect();
    let amplitude = polynomial(&amplitudes, &c()) + order(raised(c(), last));
    let first = checked(
        question,
        last,
        Statement::equal(letter("A"), amplitude),
        CycleClaim::AmplitudeSeries { parameter: question.parameter.clone() },
    );
    DerivationStep::new("limit-cycle", "The limit cycle")
        .say("Collected, the frequency is", [])
        .show(frequency)
        .say("and the amplitude of the first harmonic, the factor of {},", [cos(tau())])
        .show(first)
        .say(
            "It is not quite the largest displacement: at that the other harmonics have a part. The derivation by averaging leads to the \
             largest displacement and the same frequency, and to how fast the cycle is approached.",
            [],
        )
}
