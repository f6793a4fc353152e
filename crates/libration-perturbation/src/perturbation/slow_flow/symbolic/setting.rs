//! The names, orders and columns of an equation: small parameters, and the requested resonance.

use super::SymbolicSlowFlowOptions;
use super::error::{LARGEST_RESONANCE, SymbolicSlowFlowError as Error};
use super::force::DriveFrequency;
use super::letters::Letters;
use super::steady::greatest_common_divisor;
use libration_numbers::expression::{Equation, Expression};
use libration_numbers::internals::algebra::InOrder;

/// Names of the result that the symbols of the equation do not have.
#[derive(Clone, Debug)]
pub(super) struct Names {
    /// Names of each coordinate.
    pub(super) coordinates: Vec<CoordinateNames>,
    /// W − (p/q)·ω0.
    pub(super) detuning: String,
    pub(super) natural: String,
}

/// Names of one coordinate's amplitude and phase, and of the detuning of its natural frequency.
#[derive(Clone, Debug)]
pub(super) struct CoordinateNames {
    pub(super) amplitude: String,
    pub(super) phase: String,
    pub(super) detuning: String,
}

/// The equation as read.
pub(super) struct Setting {
    pub(super) names: Names,
    pub(super) letters: Letters,
    pub(super) drive: Option<DriveFrequency>,
    pub(super) resonance: (i64, i64),
    /// Natural frequencies as whole numbers; empty if they follow from the equations.
    pub(super) ratios: Vec<i64>,
    /// Parameters with columns and orders.
    pub(super) symbols: Vec<(String, usize, i64)>,
    /// The one small parameter that multiplies detunings as well.
    pub(super) bookkeeping: Option<usize>,
    pub(super) detuning_order: Option<i64>,
    /// The equilibrium of one coordinate; `None` for 0.
    pub(super) about: Option<Expression>,
}

impl Setting {
    pub(super) fn new(equation: &Equation, options: &SymbolicSlowFlowOptions) -> Result<Self, Error> {
        equation.refuse_first_order()?;
        let setting = Self::with_drive(equation, options, false)?;
        match &setting.drive {
            Some(DriveFrequency::Symbol(_)) if setting.is_drive_natural(equation)? => {
                Self::with_drive(equation, options, true)
            }
            _ => Ok(setting),
        }
    }

    /// Adds the drive; `is_natural` if its symbol is also one of the natural frequencies: in coefficients it is then an ordinary symbol.
    fn with_drive(
        equation: &Equation,
        options: &SymbolicSlowFlowOptions,
        is_natural: bool,
    ) -> Result<Self, Error> {
        let variables = equation.variables();
        let drive = DriveFrequency::of(equation.accelerations())?;
        let resonance = resonance(options.resonance, drive.is_some())?;
        let ratios = ratios(&options.ratios, variables.len())?;
        let mut open: Vec<String> = equation.parameters().into_iter().collect();
        let names = Names::new(&open, variables, drive.as_ref());
        if let Some(DriveFrequency::Symbol(frequency)) = &drive {
            open.retain(|name| name != frequency || is_natural);
        }
        let small = small(&open, options, &names)?;
        open.put_in_order_by(|name| small.iter().all(|(other, _)| other != name));
        if small.len() != 1 {
            open.sort();
        }
        let [first, further @ ..] = names.coordinates.as_slice() else {
            return Err(Error::SeveralEquations(0));
        };
        let further: Vec<[String; 2]> = further
            .iter()
            .map(|coordinate| [coordinate.detuning.clone(), coordinate.amplitude.clone()])
            .collect();
        let letters = Letters::new(&open, [&names.natural, &names.detuning, &first.amplitude], &further);
        let order = |name: &str| small.iter().find(|(other, _)| other == name).map_or(0, |(_, order)| *order);
        let symbols =
            open.iter().enumerate().map(|(index, name)| (name.clone(), index, order(name))).collect();
        let bookkeeping = (small.len() == 1).then_some(0);
        let stated = small.iter().find(|(name, _)| names.is_detuning(name)).map(|(_, order)| *order);
        let detuning_order = stated.or_else(|| bookkeeping.map(|index| order(&open[index])));
        let about = options.about.clone().filter(|_| variables.len() == 1);
        Ok(Self { names, letters, drive, resonance, ratios, symbols, bookkeeping, detuning_order, about })
    }

    /// The highest order of a parameter.
    pub(super) fn highest_order(&self) -> Option<i64> {
        self.symbols.iter().map(|(.., order)| *order).filter(|order| *order > 0).max()
    }
}

/// Natural frequencies as whole numbers without a common factor, one for each coordinate; empty if they are not given.
fn ratios(given: &[u32], coordinates: usize) -> Result<Vec<i64>, Error> {
    let ratios: Vec<i64> = match (given, coordinates) {
        ([], 1) => vec![1],
        _ => given.iter().map(|&ratio| i64::from(ratio)).collect(),
    };
    let is_known =
        ratios.len() == coordinates && given.iter().all(|ratio| (1..=LARGEST_RESONANCE).contains(ratio));
    if !given.is_empty() && !is_known {
        return Err(Error::Ratios { given: given.to_vec(), coordinates });
    }
    let common = ratios.iter().copied().fold(0, greatest_common_divisor).max(1);
    Ok(ratios.iter().map(|ratio| ratio / common).collect())
}

fn resonance(given: Option<(u32, u32)>, is_driven: bool) -> Result<(i64, i64), Error> {
    match (given, is_driven) {
        (None, false) => Ok((1, 1)),
        (None, true) => Err(Error::NoResonance),
        (Some(_), false) => Err(Error::NoDrive),
        (Some((p, q)), true) => {
            let range = 1..=LARGEST_RESONANCE;
            let common = (2..=p.min(q)).any(|divisor| p.is_multiple_of(divisor) && q.is_multiple_of(divisor));
            if !range.contains(&p) || !range.contains(&q) || common {
                return Err(Error::Resonance(p, q));
            }
            Ok((i64::from(p), i64::from(q)))
        }
    }
}

/// The small parameters with their orders: those named, or `eps`.
fn small(
    open: &[String],
    options: &SymbolicSlowFlowOptions,
    names: &Names,
) -> Result<Vec<(String, i64)>, Error> {
    let mut small = vec![];
    for (name, order) in &options.small {
        if !open.contains(name) && !names.is_detuning(name) {
            return Err(Error::UnknownParameter { name: name.clone(), open: open.to_vec() });
        }
        if *order == 0 || *order > super::MAX_SYMBOLIC_SLOW_ORDER {
            return Err(Error::Order(*order));
        }
        small.push((name.clone(), i64::try_from(*order).unwrap_or(1)));
    }
    if small.is_empty() && open.iter().any(|name| name == "eps") {
        small.push(("eps".to_owned(), 1));
    }
    Ok(small)
}

impl Names {
    fn new(open: &[String], variables: &[String], drive: Option<&DriveFrequency>) -> Self {
        let is_taken = |name: &str| {
            let is_drive = matches!(drive, Some(DriveFrequency::Number(_))) && name == "W";
            is_drive || variables.iter().chain(open).any(|other| other == name)
        };
        let free = |name: &str| {
            if !is_taken(name) {
                return name.to_owned();
            }
            let numbered = (1..).map(|number| format!("{name}_{number}"));
            numbered.into_iter().find(|name| !is_taken(name)).unwrap_or_default()
        };
        let of_coordinate = |variable: &String| {
            let named = |letter: &str| match variables {
                [_] => free(letter),
                _ => free(&format!("{letter}_{variable}")),
            };
            CoordinateNames { amplitude: named("A"), phase: named("phi"), detuning: named("sigma") }
        };
        Self {
            coordinates: variables.iter().map(of_coordinate).collect(),
            detuning: free("sigma"),
            natural: free("w0"),
        }
    }

    fn is_detuning(&self, name: &str) -> bool {
        name == self.detuning || self.coordinates.iter().skip(1).any(|coordinate| coordinate.detuning == name)
    }
}
