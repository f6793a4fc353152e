//! Damping of the pendulum, and extent of the motion.

use crate::arguments;
use crate::query_error::QueryError;
use libration::decay::{Damping, PowerLawTerm};
use libration::perturbation::{MAX_PARAMETER_ORDER, MAX_SLOW_ORDER};

/// The coefficients of the damping.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct DampingOptions {
    /// Dry friction, a constant deceleration in rad/s²
    #[arg(long, value_name = "C0", value_parser = arguments::positive)]
    dry: Option<f64>,
    /// Viscous damping, proportional to the velocity, in 1/s
    #[arg(long, value_name = "C1", value_parser = arguments::positive)]
    linear: Option<f64>,
    /// Damping proportional to the square of the velocity, in 1/rad
    #[arg(long, value_name = "C2", value_parser = arguments::positive)]
    quadratic: Option<f64>,
    /// Damping proportional to the cube of the velocity, in s/rad²
    #[arg(long, value_name = "C3", value_parser = arguments::positive)]
    cubic: Option<f64>,
    /// Damping proportional to any power of the velocity, such as 1.5:0.1; may be given several times
    #[arg(long, value_name = "POWER:C", value_parser = term)]
    power: Vec<PowerLawTerm>,
}

impl DampingOptions {
    pub(super) fn damping(&self) -> Result<Damping, QueryError> {
        let named = [(0.0, self.dry), (1.0, self.linear), (2.0, self.quadratic), (3.0, self.cubic)];
        let named = named.into_iter().filter_map(|(exponent, coefficient)| {
            coefficient.map(|coefficient| PowerLawTerm { exponent, coefficient })
        });
        let terms: Vec<PowerLawTerm> = named.chain(self.power.iter().copied()).collect();
        if terms.is_empty() {
            let reason = "give <--dry>, <--linear>, <--quadratic>, <--cubic> or <--power>, such as <--linear=0.1>; \
                          without damping use <libration motion>";
            return Err(QueryError::usage("damping", reason));
        }
        Damping::new(&terms).map_err(|error| QueryError::usage("damping", error))
    }
}

fn term(text: &str) -> Result<PowerLawTerm, String> {
    let numbers = text.split_once(':').and_then(|(power, c)| Some((number(power)?, number(c)?)));
    let (exponent, coefficient) =
        numbers.ok_or("give the power of the velocity and the coefficient, such as 1.5:0.1")?;
    let term = PowerLawTerm { exponent, coefficient };
    Damping::new(&[term]).map_err(|error| error.to_string())?;
    Ok(term)
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok()
}

/// The slow flow.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct SlowFlowOptions {
    /// Compare with the slow flow too, up to this power of the amplitude (for whole powers of the velocity)
    #[arg(long, value_parser = arguments::count::<MAX_SLOW_ORDER>)]
    order: Option<usize>,
    /// Power of the damping to which the slow flow is expanded [default: 2]
    #[arg(long, value_parser = arguments::count::<MAX_PARAMETER_ORDER>, requires = "order")]
    damping_order: Option<usize>,
}

impl SlowFlowOptions {
    /// The requested orders in amplitude and damping; `None` without a slow flow.
    pub(super) fn orders(self) -> Option<[usize; 2]> {
        Some([self.order?, self.damping_order.unwrap_or(DAMPING_ORDER)])
    }
}

const DAMPING_ORDER: usize = 2;

/// Options for the end of the motion.
#[derive(Clone, Copy, Debug, clap::Args)]
#[group(multiple = false)]
pub(super) struct Extent {
    /// Number of cycles to follow, if the motion lasts that long [default: 20]
    #[arg(long, value_parser = arguments::count::<MOST_CYCLES>)]
    cycles: Option<usize>,
    /// Follow the cycles completed by this time, such as 60s; plain numbers are seconds
    #[arg(long, value_name = "TIME", value_parser = time)]
    until: Option<f64>,
}

const MOST_CYCLES: usize = 1_000_000;
const CYCLES: usize = 20;

impl Extent {
    /// The largest number of turning points after the start.
    pub(super) fn turns(self) -> usize {
        2 * self.cycles.unwrap_or(if self.until.is_some() { MOST_CYCLES } else { CYCLES })
    }

    pub(super) fn last_time(self) -> f64 {
        self.until.unwrap_or(f64::INFINITY)
    }
}

fn time(text: &str) -> Result<f64, String> {
    let time = arguments::finite_time(text).map_err(|error| error.to_string())?;
    if time > 0.0 { Ok(time) } else { Err("give a time above zero, such as 60s".to_owned()) }
}
