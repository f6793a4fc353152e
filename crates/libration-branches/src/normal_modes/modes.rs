//! All normal modes of a system about an equilibrium.

use super::equilibrium::equilibrium;
use super::error::ModesError;
use super::linearisation::linearisation;
use super::mode::{Behaviour, Mode};
use super::no_shift::ShiftError;
use super::resonance::resonances;
use super::shapes::shapes;
use super::shift::shift;
use super::spectrum::{Exponent, spectrum};
use libration_numbers::algebra::Rational;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress, Quiet, Stage};

/// The normal modes of a system, by ascending frequency.
///
/// # Accuracy
/// Frequencies and shapes without exact values are the eigenvalues and eigenvectors of the
/// linear equations in `f64`s, with errors of about 1e-15 times their condition numbers.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::normal_modes::NormalModes;
/// // Two equal pendulums, one hanging from the other.
/// let double = "theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))/(3 - cos(2*theta1 - 2*theta2));
///     theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))";
/// let modes = NormalModes::new(&double.parse()?)?;
/// let slow = &modes.modes[0];
/// assert_eq!(slow.frequency_squared.as_ref().ok_or("digits")?.square_root_text(), "sqrt(2 - sqrt(2))");
/// assert!((slow.shape[0].re - 0.5_f64.sqrt()).abs() < 1e-15 && slow.shape[1].re == 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct NormalModes {
    /// The names of the coordinates.
    pub variables: Vec<String>,
    /// The equilibrium.
    pub equilibrium: Vec<f64>,
    /// The equilibrium in fractions, if the accelerations provably vanish there.
    pub exact_equilibrium: Option<Vec<Rational>>,
    /// The modes.
    pub modes: Vec<Mode>,
}

impl NormalModes {
    /// The modes about the equilibrium at or near zero.
    ///
    /// # Errors
    /// Symbolic parameters, accelerations that depend on the time, and no equilibrium with derivatives.
    pub fn new(equation: &Equation) -> Result<Self, ModesError> {
        Self::about(equation, &vec![0.0; equation.variables().len()], &Quiet)
    }

    /// The modes about the equilibrium that Newton's method finds from a guess.
    ///
    /// # Errors
    /// As for [`new`](Self::new), and a guess with the wrong number of coordinates. [`ModesError::Interrupted`] if the call is cancelled.
    pub fn about(equation: &Equation, guess: &[f64], progress: &dyn Progress) -> Result<Self, ModesError> {
        let watch = &Watch::new(progress);
        equation.refuse_first_order()?;
        let wanted = equation.variables().len();
        if guess.len() != wanted || !guess.iter().all(|x| x.is_finite()) {
            return Err(ModesError::Guess { guess: guess.to_vec(), wanted });
        }
        if equation.depends_on_time() {
            return Err(ModesError::DependsOnTime);
        }
        let rest = equilibrium(equation, guess)?;
        let linear = linearisation(equation, &rest)?;
        let mut modes: Vec<Mode> = vec![];
        for exponent in spectrum(&linear)? {
            let shapes = shapes(&linear, &exponent);
            let multiplicity = shapes.len();
            modes.extend(shapes.into_iter().map(|shape| Mode {
                exponent: exponent.value,
                frequency_squared: exponent.exact.clone(),
                behaviour: behaviour(&exponent),
                shape: shape.parts,
                exact_shape: shape.exact,
                multiplicity,
                with_powers_of_time: exponent.multiplicity.saturating_sub(multiplicity),
                resonances: vec![],
                shift: Err(ShiftError::NotOscillating),
            }));
        }
        let resonances: Vec<_> = (0..modes.len()).map(|number| resonances(&modes, number)).collect();
        for (mode, list) in modes.iter_mut().zip(resonances) {
            mode.resonances = list;
        }
        watch.begin(Stage::Whole, Some(modes.len()));
        let shift = |number| {
            watch.reached(number)?;
            Ok(shift(equation, &rest, &modes, number))
        };
        let shifts = (0..modes.len()).map(shift).collect::<Result<Vec<_>, Interrupted>>()?;
        for (mode, shift) in modes.iter_mut().zip(shifts) {
            mode.shift = shift;
        }
        let variables = equation.variables().to_vec();
        Ok(Self { variables, equilibrium: rest.at, exact_equilibrium: rest.exact, modes })
    }
}

fn behaviour(exponent: &Exponent) -> Behaviour {
    match (exponent.value.re, exponent.value.im) {
        (re, _) if re > 0.0 => Behaviour::Unstable,
        (re, _) if re < 0.0 => Behaviour::Damped,
        (_, im) if im > 0.0 => Behaviour::Oscillating,
        _ => Behaviour::Free,
    }
}
