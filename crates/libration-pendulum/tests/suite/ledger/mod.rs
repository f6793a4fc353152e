//! The ledger on random inputs: the largest errors of each function against the quadruple-precision oracle.
//!
//! Ignored by default; `scripts/ledger` builds the oracle and runs these tests. `LIBRATION_LEDGER_COUNT` is the number of inputs per function.

mod oracle;
mod tally;

use crate::promises::{
    COMPLEMENT, COMPLETE, EXCESS, FOUR_ROUNDOFFS, HARMONICS, INCOMPLETE, JACOBI, NOME, OF_NOME, Promise,
    RATIO, STATE, SUBNORMAL, jacobi_allowance,
};
use libration::elliptic::Modulus;
use libration::pendulum::{self, Amplitude, Motion, Pendulum, State};
use libration::quantity::Angle;
use oracle::{Record, records};
use tally::Tally;

const MODULUS_REGIONS: [&str; 8] = [
    "m uniform",
    "1 − m from 1e-300",
    "k′ from 1e-300",
    "m from 1e-300",
    "k uniform",
    "m or 1 − m next to 1",
    "seams",
    "m, k from 1e-323",
];

const ANGLES: [&str; 9] = [
    "φ to π/2",
    "φ from 1e-320",
    "π/2 − φ from 1e-16",
    "next to nπ/2, φ to 20",
    "next to nπ/2, φ to 1e6",
    "φ to 1e6",
    "φ from 1e6 to 1e20",
    "next to nπ/2, φ to 2⁶⁰",
    "φ next to 1e18 and beyond 1e20",
];

const AMPLITUDES: [&str; 8] = [
    "uniform",
    "θ0 from 1e-150",
    "π − θ0 from 1e-15",
    "complement from 1e-300",
    "seams",
    "next to π",
    "complement uniform",
    "either from 1.54 to 1.61",
];

fn angle(kind: f64, value: f64) -> Angle {
    if kind == 1.0 { Angle::from_complement(value) } else { Angle::from_radians(value) }.unwrap()
}

fn modulus(record: &Record) -> Modulus {
    let value = record.inputs[1];
    let made = match record.inputs[0] {
        0.0 => Modulus::from_parameter(value),
        1.0 => Modulus::from_complementary_parameter(value),
        2.0 => Modulus::from_modulus(value),
        _ => Modulus::from_complementary_modulus(value),
    };
    made.unwrap()
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn period_ratio() {
    let mut tally = Tally::new(RATIO, &AMPLITUDES);
    for record in records("period", 2, 2) {
        let value = record.inputs[1];
        if record.inputs[0] == 1.0 {
            tally.add(&record, "near_top", record.truths[0], pendulum::period_ratio_near_top(value), 0.0);
        } else {
            tally.add(&record, "plain", record.truths[0], pendulum::period_ratio(value), 0.0);
        }
    }
    tally.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn period_excess() {
    let mut tally = Tally::new(EXCESS, &["uniform", "θ0 from 1e-150", "θ0 from 1e-4"]);
    for record in records("excess", 2, 2) {
        tally.add(&record, "plain", record.truths[1], pendulum::period_excess(record.inputs[1]), 0.0);
    }
    tally.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn amplitude() {
    let (mut ratio, mut excess) = (Tally::new(RATIO, &AMPLITUDES), Tally::new(EXCESS, &AMPLITUDES));
    for record in records("period", 2, 2) {
        let amplitude = Amplitude::new(angle(record.inputs[0], record.inputs[1])).unwrap();
        ratio.add(&record, "Amplitude", record.truths[0], amplitude.period_ratio(), 0.0);
        excess.add(&record, "Amplitude", record.truths[1], amplitude.period_excess(), 0.0);
    }
    ratio.print();
    excess.print();
    ratio.enforce();
    excess.enforce();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn complete_integrals() {
    let mut integrals = Tally::new(COMPLETE, &MODULUS_REGIONS);
    let mut nome = Tally::new(NOME, &MODULUS_REGIONS);
    for record in records("complete", 2, 4) {
        let modulus = modulus(&record);
        let got = [modulus.first(), modulus.second(), modulus.complementary_first()];
        for ((name, got), &truth) in ["K", "E", "K′"].into_iter().zip(got).zip(&record.truths) {
            integrals.add(&record, name, truth, got, 0.0);
        }
        nome.add(&record, "q", record.truths[3], modulus.nome(), SUBNORMAL);
    }
    integrals.print();
    nome.print();
    integrals.enforce();
    nome.enforce();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn incomplete_integrals() {
    let mut tally = Tally::new(INCOMPLETE, &ANGLES);
    for record in records("incomplete", 3, 2) {
        let (modulus, phi) = (modulus(&record), record.inputs[2]);
        tally.add(&record, "F", record.truths[0], modulus.incomplete_first(phi), 0.0);
        tally.add(&record, "E", record.truths[1], modulus.incomplete_second(phi), 0.0);
    }
    tally.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn modulus_of_a_nome() {
    let regions = ["uniform to 0.9929", "from 1e-307", "subnormal", "next to e^−π", "next to 0.9929"];
    let mut tally = Tally::new(OF_NOME, &regions);
    for record in records("nome", 1, 2) {
        let modulus = Modulus::from_nome(record.inputs[0]).unwrap();
        tally.add(&record, "k", record.truths[0], modulus.modulus(), 0.0);
        tally.add(&record, "k′", record.truths[1], modulus.complementary_modulus(), 0.0);
    }
    tally.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn jacobi_functions() {
    let regions = ["within 4K", "tiny u", "u to 1e6 K", "next to nK", "next to nK/2", "next to nK, n to 1e6"];
    let mut tally = Tally::new(JACOBI, &regions);
    for record in records("jacobi", 3, 4) {
        let u = record.inputs[2];
        let j = modulus(&record).jacobi(u);
        for ((name, got), &truth) in
            ["sn", "cn", "dn", "am"].into_iter().zip([j.sn, j.cn, j.dn, j.am]).zip(&record.truths)
        {
            tally.add(&record, name, truth, got, jacobi_allowance(u));
        }
    }
    tally.report();
}

fn launched(record: &Record) -> Motion {
    let [kind, start, velocity, _] = record.inputs[..] else { unreachable!("four inputs") };
    Pendulum::from_angular_frequency(1.0).unwrap().launched(angle(kind, start), velocity).unwrap()
}

const STARTS: [&str; 8] = [
    "from rest",
    "from rest at π − δ, δ from 1e-300",
    "any velocity to 4",
    "next to the separatrix",
    "next to the separatrix at π − δ",
    "many turns, velocity to 100",
    "from rest next to π/2 and π",
    "on the separatrix",
];

/// The errors of states, and of their complements.
struct States(Tally<'static>, Tally<'static>);

impl States {
    fn new() -> Self {
        Self(Tally::new(STATE, &STARTS), Tally::new(COMPLEMENT, &STARTS))
    }

    fn add(&mut self, record: &Record, state: State) {
        let late = FOUR_ROUNDOFFS * record.inputs[3].abs();
        let [angle, velocity, complement] = record.truths[..] else { unreachable!("three answers") };
        let (of_angle, of_velocity) = (late * velocity.hi.abs(), late * libm::sin(complement.hi).abs());
        self.0.add(record, "θ", angle, state.angle, of_angle + SUBNORMAL);
        self.0.add(record, "θ′", velocity, state.velocity, of_velocity + SUBNORMAL);
        self.1.add(record, "π − θ", complement, state.complement, of_angle + SUBNORMAL);
    }

    fn report(self) {
        self.0.print();
        self.1.print();
        self.0.enforce();
        self.1.enforce();
    }
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn states() {
    let mut errors = States::new();
    for record in records("motion", 4, 3) {
        errors.add(&record, launched(&record).state_at(record.inputs[3]));
    }
    errors.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn states_of_prepared_motions() {
    let (mut errors, mut current) = (States::new(), None);
    for record in records("orbit", 4, 3) {
        let start = [record.inputs[0], record.inputs[1], record.inputs[2]].map(f64::to_bits);
        if current.as_ref().is_none_or(|(made_from, _)| *made_from != start) {
            current = Some((start, launched(&record).prepare()));
        }
        let (_, prepared) = current.as_ref().unwrap();
        errors.add(&record, prepared.state_at(record.inputs[3]));
    }
    errors.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn states_of_varying_amplitudes() {
    let mut errors = States::new();
    for record in records("motion", 4, 3).filter(|record| record.region == 0 || record.region == 6) {
        errors.add(&record, pendulum::state(record.inputs[1], 1.0, record.inputs[3]));
    }
    errors.report();
}

#[test]
#[ignore = "heavy: run by scripts/ledger"]
fn harmonics() {
    let regions = [
        "uniform",
        "complement from 1e-300",
        "θ0 from 1e-3",
        "either next to π/2",
        "rotation, velocity from 2",
    ];
    let mut tally = Tally::new(HARMONICS, &regions);
    let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
    for record in records("harmonics", 3, 1) {
        let truth = record.truths[0];
        if truth.hi.abs() >= f64::MIN_POSITIVE {
            let value = record.inputs[1];
            let motion = match record.inputs[0] {
                2.0 => pendulum.launched(angle(0.0, 0.0), value),
                kind => pendulum.released_from(angle(kind, value)),
            };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number below 60")]
            let n = record.inputs[2] as usize;
            let harmonics = motion.unwrap().harmonics(0.0, n);
            let computed =
                harmonics.terms.iter().find(|term| term.n == n).map_or(f64::NAN, |term| term.angle);
            tally.add(&record, "a_n", truth, computed, 0.0);
        }
    }
    tally.report();
}

/// A bound of the ledger as a line of the report.
fn heading(promise: &Promise) -> String {
    let beyond = if promise.beyond.is_empty() { String::new() } else { format!(" + {}", promise.beyond) };
    format!("{}: ≤ {} ulp{beyond} for {}", promise.what, promise.ulp, promise.domain)
}
