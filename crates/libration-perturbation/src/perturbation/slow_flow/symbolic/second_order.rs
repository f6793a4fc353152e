//! The second approximation of a slow flow: what the waves that the small terms force, and the changes of amplitude and phase, make of these terms.

use super::letters::{Column, Sum};
use super::phase_sums::{PhaseSum, append_term};
use super::result::turned;
use super::scales::{SmallForceTerm, Solved};
use super::small_terms::{SmallTerm, Written, multiple};
use libration_numbers::algebra::Rational;

/// The order of the first small terms, of which products of two act in the next one.
#[derive(Clone, Debug, PartialEq)]
pub struct EarlierOrder {
    /// Order of the terms.
    pub order: usize,
    /// The small terms of this order.
    pub terms: Vec<SmallTerm>,
    /// The changes of these terms, in the names of the changes of displacement and velocity.
    pub changes: Vec<SmallTerm>,
    /// Names of the changes of displacement and velocity.
    pub names: [String; 2],
    /// Changes of displacement and velocity, in W·t and with (p/q)·(ψ − φ) in its place.
    pub motion: [[String; 2]; 2],
    /// The change of the velocity at constant amplitude and phase, in both forms.
    pub wave_velocity: [String; 2],
    /// Waves of the terms with other frequencies than the oscillation, which force the change of the displacement, in both forms.
    pub forcing: [String; 2],
    /// Products of the rates of this order; `None` if amplitude and phase do not change in this order.
    pub products: Option<RateProducts>,
}

/// The parts of the left side of the equation of motion that are of the first and the second order in the rates.
#[derive(Clone, Debug, PartialEq)]
pub struct RateProducts {
    /// ψ′ − ω0.
    pub excess: String,
    /// A″ − A·(ψ′ − ω0)².
    pub in_phase: String,
    /// 2·A′·(ψ′ − ω0) + A·ψ″.
    pub across: String,
}

impl EarlierOrder {
    /// `None` if terms have other orders, or if the drive is not small. The first terms have no kinks: the solution goes to this order.
    pub(super) fn new(
        written: &Written<'_>,
        solved: &Solved,
        [first, lowest, order]: [i64; 3],
    ) -> Option<Self> {
        let forced = written.forced;
        let letters = forced.letters;
        let is_of_both = |term: &SmallForceTerm| [first, order].contains(&term.order) || term.order > order;
        let early = || forced.terms[0].iter().filter(|term| term.order == first);
        let is_possible =
            order == 2 * first && forced.drives[0].is_zero() && forced.terms[0].iter().all(is_of_both);
        if !is_possible {
            return None;
        }
        let to_first = |sum: &Sum| letters.to_order(sum, first);
        let displacement = to_first(&solved.displacements[0]);
        let rate = to_first(&solved.rates[0]);
        let velocity = forced.rate_of_change(&displacement, std::slice::from_ref(&rate), first);
        let motion = [&displacement, &velocity].map(|sum| letters.of_order(sum, first));
        let powers =
            forced.powers(std::slice::from_ref(&displacement), std::slice::from_ref(&velocity), order + 1);
        let changed = |term: &SmallForceTerm| letters.of_order(&forced.product(term, &powers, order), order);
        let velocity_name = if written.variable == "v" { "u_1" } else { "v_1" };
        let names = [format!("{}_1", written.variable), velocity_name.to_owned()];
        let is_moving = |term: &&SmallForceTerm| term.powers[0] != [0, 0];
        let changes = early()
            .filter(is_moving)
            .map(|term| {
                let force = |written: &Written<'_>| change(written, term, &names);
                written.term(&force, &changed(term), true)
            })
            .collect();
        let forcing = early().fold(letters.zero(), |sum, term| {
            let along = forced.along(&solved.displacements[0], term);
            letters.add(&sum, &letters.part(&along, |powers| !written.is_resonant(powers)))
        });
        let products = (lowest == first).then(|| RateProducts::new(written, &rate, order));
        let in_both = |sum: Sum| written.both(&[sum, letters.zero()]).map(|[text, _]| text);
        Some(Self {
            order: usize::try_from(first).unwrap_or(0),
            terms: written.terms(solved, first..=first),
            changes,
            names,
            motion: written.both(&motion),
            wave_velocity: in_both(forced.velocity(&motion[0])),
            forcing: in_both(forcing),
            products,
        })
    }
}

/// The derivatives of a product with respect to displacement and velocity, each times its change.
fn change(written: &Written<'_>, term: &SmallForceTerm, names: &[String; 2]) -> String {
    let letters = written.forced.letters;
    let mut text = String::new();
    for (which, name) in names.iter().enumerate() {
        let mut powers = term.powers[0];
        let Some(lower) = powers[which].checked_sub(1) else { continue };
        let exponent = i64::try_from(powers[which]).unwrap_or(0);
        powers[which] = lower;
        let coefficient = letters.scaled(&term.coefficient, &Rational::from(exponent));
        let product = written.product(&coefficient, powers, term.signs, Some(name));
        append_term(&mut text, &product);
    }
    text
}

impl RateProducts {
    /// With u = A·e^{iφ} and d = ψ′ − ω0 − φ′, x″ + ω0²·x is the real part of (u″ + 2i·(ω0 + d)·u′ − (2ω0·d + d²)·u)·e^{i(ψ − φ)}.
    fn new(written: &Written<'_>, rate: &Sum, order: i64) -> Self {
        let forced = written.forced;
        let letters = forced.letters;
        let acceleration = forced.rate_of_change(rate, std::slice::from_ref(rate), order);
        let ratio = Rational::new(forced.harmonics[0], forced.drive_harmonic);
        let detuning = letters.scaled(&forced.detuning, &ratio.unwrap_or_else(|| Rational::from(0)));
        let rate = turned(letters, rate);
        let twice = letters.scaled(&letters.power(Column::Imaginary, 1), &Rational::from(2));
        let mixed = letters.times(&letters.times(&twice, &detuning), &rate);
        let amplitude = letters.power(Column::Amplitude, 1);
        let square = letters.times(&letters.times(&detuning, &detuning), &amplitude);
        let products = letters.subtract(&letters.add(&turned(letters, &acceleration), &mixed), &square);
        let [in_phase, across] = PhaseSum::parts(letters, &products);
        let detuned =
            letters.times(&letters.power(Column::Imaginary, 1), &letters.times(&detuning, &amplitude));
        let [_, turning] = PhaseSum::parts(letters, &letters.add(&rate, &detuned));
        let excess = turning.times(letters, &letters.power(Column::Amplitude, -1));
        let text = |sum: &PhaseSum| sum.text(letters, |k| multiple(k, written.phase()));
        Self { excess: text(&excess), in_phase: text(&in_phase), across: text(&across) }
    }
}
