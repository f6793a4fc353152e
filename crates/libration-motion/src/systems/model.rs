//! Equations of motion with their values, and the names and units of their coordinates.

use super::count::Counted;
use super::{Bodies, Coordinate, Energy, EnergyError, ModelError, NamedSystem, VelocityPower};
use crate::oscillator::{NamedOscillator, Oscillator};
use crate::taylor::{Moment, StateLayout, StateNameError, System, named_state};
use libration_numbers::expression::{Equation, EquationError, Expression, Function, Symbol, WithoutValue};

/// Equations of motion with values for their parameters, ready to be integrated.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::Model;
/// let model = Model::by_key("double_pendulum", &[("m2", "1/2".parse()?)], &[])?;
/// assert_eq!(model.state_names(), ["theta1", "theta2", "theta1'", "theta2'"]);
/// assert!(model.energy().is_ok());
/// let kepler = Model::typed("x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)", &[], &[])?;
/// assert!(kepler.energy().is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    key: Option<&'static str>,
    title: &'static str,
    equation: Equation,
    coordinates: Vec<Coordinate>,
    values: Vec<(String, Expression)>,
    properties: Option<NamedProperties>,
}

/// Properties that only named systems have, with values substituted.
#[derive(Clone, Debug)]
struct NamedProperties {
    energy: Option<Expression>,
    power: Option<Expression>,
    drive_frequency: Option<Expression>,
    /// The position of each body, and the position of the point that holds it.
    bodies: Vec<[[Expression; 2]; 2]>,
}

/// Values of parameters, which may be formulas.
type ParameterValues<'a> = &'a [(&'a str, Expression)];

impl Model {
    /// A named system, or else an oscillator of the other catalogue, with values for
    /// some of its parameters, the default values for the others, and some left open.
    ///
    /// # Errors
    /// An unknown key; a value for a name that is not a parameter, or one that is not constant.
    pub fn by_key(key: &str, values: ParameterValues, open: &[&str]) -> Result<Self, ModelError> {
        match (NamedSystem::by_key(key), NamedOscillator::by_key(key)) {
            (Ok(named), _) => Self::named(named, values, open),
            (Err(_), Ok(oscillator)) => Self::oscillator(oscillator, values, open),
            (Err(system), Err(oscillator)) => {
                Err(ModelError::Unknown { system: Box::new(system), oscillators: oscillator.known })
            }
        }
    }

    /// A named system.
    ///
    /// # Errors
    /// A value for a name that is not a parameter, or one that is not constant.
    pub fn named(named: &NamedSystem, values: ParameterValues, open: &[&str]) -> Result<Self, ModelError> {
        let Counted { equations, values: given, count } = Counted::new(named, values)?;
        let given: Vec<(&str, Expression)> =
            given.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
        let others = named.parameters.iter().filter(|parameter| Some(parameter.name) != named.count);
        let defaults = others.map(|other| (other.name, other.default));
        let (equation, mut values) = filled(&equations, &given, defaults, open)?;
        values.extend(count);
        if let Some(powers) = named.velocity_power {
            check_power(powers, &values)?;
        }
        let defaults: Vec<_> =
            named.parameters.iter().map(|parameter| (parameter.name, parameter.default)).collect();
        let put_in = |text: &str| Ok::<_, ModelError>(with_values(formula(text)?, &values));
        let coordinates = named.coordinates.iter().map(|coordinate| {
            let at_rest = with_values(put_in(coordinate.at_rest)?, &all_defaults(&defaults)?);
            let at_rest = at_rest.to_f64().unwrap_or(0.0);
            Ok(Coordinate { name: coordinate.name.to_owned(), unit: coordinate.unit.to_owned(), at_rest })
        });
        let coordinates = coordinates.collect::<Result<Vec<_>, ModelError>>()?;
        let coordinates =
            if named.count.is_some() { each_like(&coordinates, &equation) } else { coordinates };
        let formulas = |[right, up]: [&str; 2]| Ok::<_, ModelError>([put_in(right)?, put_in(up)?]);
        let bodies = named.bodies.iter().map(|body| Ok([formulas(body.place)?, formulas(body.pivot)?]));
        let properties = NamedProperties {
            bodies: bodies.collect::<Result<_, ModelError>>()?,
            energy: Some(named.energy).filter(|text| !text.is_empty()).map(put_in).transpose()?,
            power: Some(named.power).filter(|text| !text.is_empty()).map(put_in).transpose()?,
            drive_frequency: named.drive_frequency.map(put_in).transpose()?,
        };
        let (key, title) = (Some(named.key), named.title);
        Ok(Self { key, title, equation, coordinates, values, properties: Some(properties) })
    }

    /// An oscillator of the other catalogue, at rest in its equilibrium.
    ///
    /// # Errors
    /// A value for a name that is not a parameter, or one that is not constant.
    pub fn oscillator(
        named: &NamedOscillator,
        values: ParameterValues,
        open: &[&str],
    ) -> Result<Self, ModelError> {
        let defaults = named.parameters.iter().map(|parameter| (parameter.name, parameter.default));
        let (equation, values) = filled(named.equation, values, defaults, open)?;
        let mut coordinates = by_names(&equation);
        if let Ok(oscillator) = Oscillator::new(&equation) {
            coordinates[0].at_rest = oscillator.equilibrium().to_f64();
        }
        Ok(Self { key: Some(named.key), title: named.title, equation, coordinates, values, properties: None })
    }

    /// Equations of motion as text, several with `;` between them. Times are in seconds,
    /// and a coordinate is an angle if its name is that of an angle, such as theta.
    ///
    /// # Errors
    /// Text that is not an equation of motion; a value for a name that is not a parameter, or one that is not constant.
    pub fn typed(equations: &str, values: ParameterValues, open: &[&str]) -> Result<Self, ModelError> {
        let (equation, values) = filled(equations, values, [].into_iter(), open)?;
        let coordinates = by_names(&equation);
        Ok(Self { key: None, title: "equations of motion", equation, coordinates, values, properties: None })
    }

    /// The key in one of the catalogues.
    #[must_use]
    pub fn key(&self) -> Option<&'static str> {
        self.key
    }

    /// The name used in a sentence.
    #[must_use]
    pub fn title(&self) -> &'static str {
        self.title
    }

    /// The equations of motion with their values.
    #[must_use]
    pub fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The coordinates in the order of the equations.
    #[must_use]
    pub fn coordinates(&self) -> &[Coordinate] {
        &self.coordinates
    }

    /// The parameters that have a value, with their values.
    #[must_use]
    pub fn values(&self) -> &[(String, Expression)] {
        &self.values
    }

    /// The value of a parameter as a number; `None` if it has none.
    #[must_use]
    pub fn value_of(&self, parameter: &str) -> Option<f64> {
        self.values.iter().find(|(name, _)| name == parameter).and_then(|(_, value)| value.to_f64())
    }

    /// The names of the parameters that have no value.
    #[must_use]
    pub fn open_parameters(&self) -> Vec<String> {
        self.equation.parameters().into_iter().collect()
    }

    /// The meaning of each state component.
    #[must_use]
    pub fn layout(&self) -> StateLayout {
        StateLayout::new(&self.equation)
    }

    /// The names of the state components: coordinates, then velocities.
    #[must_use]
    pub fn state_names(&self) -> Vec<String> {
        self.layout().symbols(self.equation.variables()).iter().map(ToString::to_string).collect()
    }

    /// The units of the state components, empty if they are not known.
    #[must_use]
    pub fn state_units(&self) -> Vec<String> {
        let units = self.coordinates.iter().map(|coordinate| coordinate.unit.clone());
        self.layout().arrange(units, |coordinate| self.coordinates[coordinate].velocity_unit())
    }

    /// The state of rest: the equilibrium value of every coordinate, without velocity.
    #[must_use]
    pub fn state_at_rest(&self) -> Vec<f64> {
        let coordinates = self.coordinates.iter().map(|coordinate| coordinate.at_rest);
        self.layout().arrange(coordinates, |_| 0.0)
    }

    /// A state at the time zero from names and values; components that are not named have their values at rest.
    ///
    /// # Errors
    /// A name that is none of [`Self::state_names`], or one that occurs twice.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::progress::Quiet;
    /// use libration::systems::Model;
    /// use libration::taylor::{Effort, integrate};
    /// let model = Model::by_key("double_pendulum", &[], &[])?;
    /// let start = model.start(&[("theta1", 2.0)])?;
    /// let solution = integrate(&model.system()?, &start, &[10.0], &Effort::to_tolerance(1e-15), &Quiet)?;
    /// assert!(model.energy()?.drift(&start, &solution.end).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn start(&self, values: &[(&str, f64)]) -> Result<Moment, StateNameError> {
        let state = named_state(&self.state_names(), self.state_at_rest(), values)?;
        Ok(Moment { time: 0.0, state })
    }

    /// The system to be integrated.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn system(&self) -> Result<System, WithoutValue> {
        System::new(&self.equation)
    }

    /// The angular frequency of the drive, if it is known.
    #[must_use]
    pub fn drive_frequency(&self) -> Option<f64> {
        self.properties.as_ref()?.drive_frequency.as_ref().and_then(Expression::to_f64)
    }

    /// The positions of the bodies, if known: those given for named systems; angles of other equations are those of rods on one axle.
    #[must_use]
    pub fn bodies(&self) -> Option<Bodies> {
        let names: Vec<Symbol> =
            self.coordinates.iter().map(|coordinate| Symbol::plain(&coordinate.name)).collect();
        let positions = match &self.properties {
            Some(properties) if properties.bodies.is_empty() => return None,
            Some(properties) => properties.bodies.clone(),
            None if self.layout().is_of_second_order()
                && self.coordinates.iter().all(Coordinate::is_angle) =>
            {
                names.iter().map(hanging).collect()
            }
            None => return None,
        };
        Bodies::new(&positions, &names).ok()
    }

    /// The energy gained per unit of time by a named system, a formula of the state and the time t.
    #[must_use]
    pub fn power(&self) -> Option<&Expression> {
        self.properties.as_ref().and_then(|properties| properties.power.as_ref())
    }

    /// The conserved energy: the known energy of a named system whose damping and driving are zero, and
    /// for other equations that of forces which depend on the coordinates only and have a potential.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn energy(&self) -> Result<Energy, EnergyError> {
        match &self.properties {
            Some(NamedProperties { energy: Some(energy), power: Some(power), .. }) => {
                match power.vanishes() {
                    true => Energy::of_formula(&self.equation, energy),
                    false => Err(EnergyError::NotConserved { power: power.to_string() }),
                }
            }
            _ => Energy::of_forces(&self.equation),
        }
    }
}

/// The end of a rod of length one on an axle at zero, and the axle.
fn hanging(angle: &Symbol) -> [[Expression; 2]; 2] {
    let angle = || Box::new(Expression::Symbol(angle.clone()));
    let up = Expression::Negate(Box::new(Expression::Call(Function::Cos, angle())));
    [[Expression::Call(Function::Sin, angle()), up], [Expression::from(0), Expression::from(0)]]
}

/// The equation with the given values, and default ones for all others that are not left open.
fn filled<'a>(
    text: &str,
    given: ParameterValues,
    defaults: impl Iterator<Item = (&'a str, &'a str)>,
    open: &[&str],
) -> Result<(Equation, Vec<(String, Expression)>), EquationError> {
    let equation: Equation = text.parse()?;
    let mut values: Vec<(String, Expression)> = vec![];
    for (name, value) in given {
        values.push((plain(name), value.clone()));
    }
    for name in open {
        // Rejects a name that is not a parameter, or has a value already.
        equation.with(&[given, &[(*name, Expression::from(1))]].concat())?;
    }
    let open: Vec<String> = open.iter().map(|name| plain(name)).collect();
    for (name, default) in defaults {
        if values.iter().all(|(given_name, _)| given_name != name)
            && !open.iter().any(|open_name| open_name == name)
        {
            values.push((name.to_owned(), formula(default)?));
        }
    }
    let borrowed: Vec<(&str, Expression)> =
        values.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
    Ok((equation.with(&borrowed)?, values))
}

/// The name as it is written in equations: ω0 is omega0.
pub(super) fn plain(name: &str) -> String {
    name.parse::<Expression>().map_or_else(|_| name.to_owned(), |symbol| symbol.to_string())
}

fn formula(text: &str) -> Result<Expression, EquationError> {
    Ok(text.parse::<Expression>()?)
}

fn all_defaults(defaults: &[(&str, &str)]) -> Result<Vec<(String, Expression)>, EquationError> {
    defaults.iter().map(|(name, default)| Ok(((*name).to_owned(), formula(default)?))).collect()
}

fn with_values(formula: Expression, values: &[(String, Expression)]) -> Expression {
    let put_in = |formula: Expression, (name, value): &(String, Expression)| {
        formula.substitute(&Symbol::plain(name), value)
    };
    values.iter().fold(formula, put_in).simplified()
}

/// The coordinate of each variable of the equations: that of its family, `x[i]` for x1, with the name of the variable.
fn each_like(families: &[Coordinate], equation: &Equation) -> Vec<Coordinate> {
    let of = |name: &String| {
        let family = families
            .iter()
            .find(|family| family.name.split('[').next().is_some_and(|stem| name.starts_with(stem)));
        family.map_or_else(
            || Coordinate::by_name(name),
            |family| Coordinate { name: name.clone(), ..family.clone() },
        )
    };
    equation.variables().iter().map(of).collect()
}

fn by_names(equation: &Equation) -> Vec<Coordinate> {
    equation.variables().iter().map(|name| Coordinate::by_name(name)).collect()
}

/// Rejects a value of the power n that is not allowed.
fn check_power(powers: VelocityPower, values: &[(String, Expression)]) -> Result<(), ModelError> {
    let power = values.iter().find(|(name, _)| name == "n").map(|(_, value)| value);
    let Some(power) = power else { return Ok(()) };
    let number = power.to_f64().unwrap_or(f64::NAN);
    let value = || power.to_string();
    match powers {
        _ if number.is_nan() || number < 0.0 => Err(ModelError::NegativePower { value: value() }),
        VelocityPower::Whole if number.fract() != 0.0 => Err(ModelError::NotWhole { value: value() }),
        VelocityPower::Whole | VelocityPower::Any => Ok(()),
    }
}
