//! Frequencies and shapes as numbers: in a tower of square roots if the modes are exact, otherwise in floating point.

use super::expansion::LinearMotion;
use crate::normal_modes::{Mode, NormalModes};
use libration_numbers::{
    algebra::{Complex, Doubles, Rational, Rationals, Ring, Surd},
    internals::algebra::{Quadratic, QuadraticField, Tower},
};

/// The linear motion over a field that contains the roots of all frequencies and shapes; `None` if one of them is known in floating point only.
pub(super) fn exactly(modes: &NormalModes) -> Option<LinearMotion<Tower>> {
    let rest = modes.exact_equilibrium.as_ref()?;
    let mut tower = Tower::default();
    let mut frequencies = vec![];
    for mode in &modes.modes {
        for surd in mode.exact_shape.as_ref()?.iter().chain(mode.frequency_squared.as_ref()) {
            element(&mut tower, surd)?;
        }
        let square = mode.frequency_squared.as_ref()?;
        frequencies.push(match square.to_rational() {
            // The square root of a positive radicand without square factors.
            Some(square) => {
                element(&mut tower, &Surd::new(Rational::from(0), Rational::from(1), square.clone()))?
            }
            None => {
                let square = element(&mut tower, square)?;
                tower.adjoin_root(&square)?
            }
        });
    }
    let frequencies = frequencies.iter().map(|frequency| tower.lifted(frequency)).collect();
    let shape = |mode: &Mode| -> Option<Vec<Vec<Rational>>> {
        // The tower contains all roots.
        let mut same = tower.clone();
        mode.exact_shape.as_ref()?.iter().map(|surd| element(&mut same, surd)).collect()
    };
    let shapes = modes.modes.iter().map(shape).collect::<Option<Vec<_>>>()?;
    let rest = rest.iter().map(|x| tower.lifted(std::slice::from_ref(x))).collect();
    let minus_one = tower.lifted(&[Rational::from(-1)]);
    let numbers = QuadraticField { base: tower, square: minus_one };
    let shapes =
        shapes.into_iter().map(|shape| shape.into_iter().map(|x| numbers.plain(x)).collect()).collect();
    Some(LinearMotion { numbers, frequencies, shapes, rest })
}

fn element(tower: &mut Tower, surd: &Surd) -> Option<Vec<Rational>> {
    let root = match surd.to_rational() {
        Some(_) => tower.lifted(&[Rational::from(0)]),
        None => tower.adjoin_root(&[surd.radicand().clone()])?,
    };
    let root = tower.lifted(&root);
    let scaled: Vec<Rational> = root.iter().map(|x| Rationals.multiply(x, surd.root())).collect();
    let plain = tower.lifted(std::slice::from_ref(surd.plain()));
    Some(tower.add(&plain, &scaled))
}

/// The linear motion of normal modes, in floating-point numbers.
pub(super) fn in_digits(modes: &NormalModes) -> LinearMotion<Doubles> {
    let pair = |z: &Complex| Quadratic { plain: z.re, root: z.im };
    LinearMotion {
        numbers: QuadraticField { base: Doubles, square: -1.0 },
        frequencies: modes.modes.iter().map(Mode::frequency).collect(),
        shapes: modes.modes.iter().map(|mode| mode.shape.iter().map(pair).collect()).collect(),
        rest: modes.equilibrium.clone(),
    }
}
