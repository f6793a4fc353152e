//! `libration response`: the periodic responses of a driven system, or the limit cycles of a self-excited one, over a parameter.

mod branch_fields;
mod fields;
mod sweep_fields;
mod write;

use crate::arguments::{
    CoordinateName, InitialOptions, ParameterSpan, SystemOptions, constant, coordinate, count,
    parameter_span, with_idle_drive,
};
use crate::figure::response::ResponseCurve;
use crate::interrupt::{self, Cancellation};
use crate::output::{Form, FormOptions, announce};
use crate::query_error::{QueryError, argument, option};
use crate::{figure, parallel};
use libration::continuation::{
    Branch, BranchError, FreeOscillation, PreciseSpecial, ResonanceOrder, Response, ResponseOptions,
    Rotation, Space, SpecialPoint, Sweep,
};
use libration::progress::Status;
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use fields::answers;

/// Largest number of drive periods in a response.
const MOST_PERIODS: usize = 100;
/// Largest number of digits of a special point: the order of the series grows with each digit.
const MOST_DIGITS: usize = 100;
/// Largest number of values in a sweep.
const MOST_VALUES: usize = 10_000;
/// Number of values of the sweeps in a picture: their dots do not touch each other in a column.
const DOTS: usize = 48;
/// Largest number of turns of a response.
const MOST_TURNS: i32 = 100;
/// Largest depth of secondary branches: in a cascade each range is 4.669 times shorter than the one before.
const MOST_GENERATIONS: usize = 6;

/// The periodic responses of a driven system, or limit cycles, over a parameter: amplitude, stability, folds and jumps, symmetry breakings, period doublings
///
/// Branches begin with the solutions found at both ends of the range, from the start and by harmonic balance, and are followed through their
/// folds; secondary branches are followed too. Every point has an error, special points are exact to their last digits.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration response driven_pendulum --set A=0.15,c=0.1 --over omega=0.3:1.4
  libration response driven_pendulum --set omega=0.8,c=0.1 --over A=0:0.7 \\
    --figure response.svg
  libration response \"x'' + 0.05 x' + x + 0.1 x^3 = 0.18 cos(w t)\" \\
    --over w=0.5:1.6 --json
  libration response \"x'' + 0.15 x' + x + x^3 = 5 cos(w t)\" --over w=2.5:6 \\
    --orders 1/3
  libration response driven_pendulum --set c=0.5,A=2 --over omega=0.67:1 \\
    --turns 1
  libration response van_der_pol --over mu=0.1:10
  libration response \"x' = -y - z; y' = x + 0.2 y; z' = 0.2 + z (x - c)\" \\
    --over c=2:4 --generations 1

The parameter is a number in the equations or the frequency of the drive. At the
ends of the range solutions are searched from --initial and near estimates with
few harmonics; if there are several wells, at three values within it too; and
where a slow sweep leaves all known stable ones, by following the motion until
it settles. Those with many harmonics and isolated closed branches (isolas)
within the range can be missed: try --at, or --initial near them, or --orders,
which finds sub- and superharmonic responses from the free oscillations that the
drive can sustain; --turns is for rotating responses.
Without a drive the solutions are limit cycles, to which the motion from
--initial settles. Ctrl-C stops early and keeps what is done.")
)]
pub(crate) struct ResponseQuestion {
    #[command(flatten)]
    system: SystemOptions,
    /// The parameter and its range, such as omega=0.3:1.4
    #[arg(long, value_name = "NAME=FROM:TO", value_parser = parameter_span)]
    over: ParameterSpan,
    #[command(flatten)]
    initial: InitialOptions,
    /// Number of periods of the drive in one period of the response, for subharmonic responses
    #[arg(long, value_name = "N", default_value = "1", value_parser = count::<MOST_PERIODS>)]
    drive_periods: usize,
    /// Number of turns of the angle of --coordinate in one period, for rotating responses; negative for backward rotation
    #[arg(long, value_name = "N", value_parser = turns, allow_negative_numbers = true)]
    turns: Option<i32>,
    /// Search for sub- and superharmonic responses too: oscillations per drive periods, such as 1/3,1/2
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    orders: Vec<ResonanceOrder>,
    /// The value at which solutions are searched, for isolated closed branches (isolas) within the range [default: the ends of the range]
    #[arg(long, value_name = "VALUE", value_parser = value)]
    at: Option<f64>,
    /// Maximum depth of secondary branches (symmetry breaking, period doubling)
    #[arg(long, value_name = "N", default_value = "2", value_parser = whole)]
    generations: usize,
    /// The coordinate of the amplitude [default: the first]
    #[arg(long, value_name = "NAME")]
    coordinate: Option<CoordinateName>,
    /// Compute the parameter at special points to this number of digits, up to 100
    #[arg(long, value_name = "N", value_parser = count::<MOST_DIGITS>)]
    digits: Option<usize>,
    /// Also sweep the parameter slowly up and down through N values by integration [default: 48 if a picture is drawn, else none]
    #[arg(long, value_name = "N", value_parser = count::<MOST_VALUES>)]
    sweeps: Option<usize>,
    /// Draw amplitude against parameter to FILE.svg, .pdf, .png or .json instead of listing the points
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

/// A value as text, with a bound on its error.
pub(crate) struct Decimal {
    text: String,
    error: f64,
}

/// The result to write.
pub(crate) struct ResponseResult {
    pub(crate) model: Model,
    pub(crate) parameter: String,
    pub(crate) range: [f64; 2],
    /// The coordinate whose amplitude is shown.
    pub(crate) coordinate: usize,
    pub(crate) response: Response,
    /// The precise values of the special points of each branch, where requested and known.
    precise: Vec<Vec<Option<Decimal>>>,
    pub(crate) sweeps: Vec<Sweep>,
    /// Free oscillations, where the parameter is the frequency of the drive and the form of the result has them.
    pub(crate) backbone: Vec<FreeOscillation>,
}

impl ResponseQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let answer = self.computed()?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::response::response(&answer.curve()))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        match answer.response.interrupted {
            true => Err(QueryError::cancelled("interrupted: the branches up to then are written")),
            false => Ok(()),
        }
    }

    fn computed(&self) -> Result<ResponseResult, QueryError> {
        let ParameterSpan { name, range } = &self.over;
        let model = self.system.model_with_open(&[name], &option("over"))?;
        let named = |name: &CoordinateName| coordinate(&model, &option("coordinate"), name);
        let coordinate = self.coordinate.as_ref().map(named).transpose()?.unwrap_or(0);
        interrupt::listen()?;
        let mut response = self.response(&model, coordinate)?;
        let sweeps = self.sweeps(&model, &response)?;
        let precise = self.digits.map_or(Ok(vec![]), |digits| self.precise(&model, &response, digits))?;
        response.interrupted |= interrupt::check().is_break();
        let parameter = name.clone();
        let backbone = match self.figure.is_some() || self.form.form() == Form::Json {
            true => response.backbone(model.equation(), *range, model.coordinates()[0].is_angle()),
            false => vec![],
        };
        Ok(ResponseResult {
            model,
            parameter,
            range: *range,
            coordinate,
            response,
            precise,
            sweeps,
            backbone,
        })
    }

    fn response(&self, model: &Model, coordinate: usize) -> Result<Response, QueryError> {
        let options = ResponseOptions {
            start: self.initial.guess(model)?,
            drive_periods: u32::try_from(self.drive_periods).unwrap_or(1),
            rotation: self.turns.map(|turns| Rotation { coordinate, turns }),
            generations: self.generations,
            at: self.at,
            orders: self.orders.clone(),
            ..ResponseOptions::default()
        };
        let points = AtomicUsize::new(0);
        let how_far = || format!("{} points of the branches", points.load(Ordering::Relaxed));
        let progress = |status: Status| {
            points.store(status.done, Ordering::Relaxed);
            parallel::update(&how_far)
        };
        let ParameterSpan { name, range } = &self.over;
        let response = parallel::with_progress(how_far, || {
            Response::over(model.equation(), name, *range, &options, &progress)
        });
        response.map_err(|error| failure(error, model))
    }

    /// The slow sweeps, if they are requested or part of the picture.
    fn sweeps(&self, model: &Model, response: &Response) -> Result<Vec<Sweep>, QueryError> {
        if self.sweeps.is_some() && !response.driven {
            return Err(QueryError::usage(
                option("sweeps"),
                "nothing drives the system: sweeps are of driven ones",
            ));
        }
        let in_picture = self.figure.as_ref().filter(|_| response.driven).map(|_| DOTS);
        let Some(values) = self.sweeps.or(in_picture) else { return Ok(vec![]) };
        let done = AtomicUsize::new(0);
        let how_far = || format!("{} of {} values of the sweeps", done.load(Ordering::Relaxed), 2 * values);
        let progress = |status: Status| {
            done.store(status.done, Ordering::Relaxed);
            parallel::update(&how_far)
        };
        let ParameterSpan { name, range } = &self.over;
        let sweeps = parallel::with_progress(how_far, || {
            response.sweeps(model.equation(), name, *range, values, &progress)
        });
        sweeps.map_err(|error| failure(error, model))
    }
}

impl ResponseQuestion {
    /// The special points to this number of digits.
    fn precise(
        &self,
        model: &Model,
        response: &Response,
        digits: usize,
    ) -> Result<Vec<Vec<Option<Decimal>>>, QueryError> {
        let wanted = u32::try_from(digits).unwrap_or(u32::MAX);
        let of_point = |space: Space, special: &SpecialPoint| {
            let name = &self.over.name;
            let precise = special.to_digits(model.equation(), name, space, wanted, &Cancellation);
            let decimal = |special: PreciseSpecial| Decimal {
                text: special.parameter.to_rational().to_decimal(digits),
                error: special.error,
            };
            Ok(precise.map_err(|error| failure(error, model))?.map(decimal))
        };
        let of_branch =
            |branch: &Branch| branch.special.iter().map(|special| of_point(branch.space, special)).collect();
        parallel::with_progress(
            || format!("special points to {digits} digits"),
            || response.branches.iter().map(of_branch).collect(),
        )
    }
}

impl ResponseResult {
    pub(crate) fn is_angle(&self) -> bool {
        self.model.coordinates()[self.coordinate].is_angle()
    }

    /// Number of turns that the coordinate makes in a response of a branch.
    pub(crate) fn turns(&self, branch: &Branch) -> i32 {
        branch.space.rotation.map_or(0, |rotation| rotation.turns_of(self.coordinate))
    }

    /// The content of the picture.
    fn curve(&self) -> ResponseCurve<'_> {
        ResponseCurve {
            model: &self.model,
            parameter: &self.parameter,
            range: self.range,
            coordinate: self.coordinate,
            branches: self.branches(),
            backbone: &self.backbone,
            sweeps: &self.sweeps,
        }
    }

    pub(crate) fn branches(&self) -> &[Branch] {
        &self.response.branches
    }
}

fn failure(error: BranchError, model: &Model) -> QueryError {
    match error {
        BranchError::NoStart(_) => QueryError::no_result("response", with_idle_drive(error, model)),
        BranchError::Interrupted(_) => {
            QueryError::cancelled("interrupted before the first solution was known: nothing is written")
        }
        BranchError::Range { .. } => QueryError::usage(option("over"), error),
        BranchError::Outside { .. } => QueryError::usage(option("at"), error),
        BranchError::Family => QueryError::no_result(
            argument("SYSTEM|EQUATION"),
            format!("{error}, as <libration backbone> does"),
        ),
        BranchError::NotAnAngle(_) | BranchError::NoRotation { .. } => {
            QueryError::usage(option("turns"), error)
        }
        BranchError::NotOneOscillator => QueryError::usage(option("orders"), error),
        BranchError::NotDriven => QueryError::no_result(argument("SYSTEM|EQUATION"), error),
        _ => QueryError::no_result("response", error),
    }
}

fn value(text: &str) -> Result<f64, String> {
    let value = constant(text)?.to_f64().filter(|value| value.is_finite());
    value.ok_or_else(|| format!("`{}` is not a finite number", text.trim()))
}

fn turns(text: &str) -> Result<i32, String> {
    let number = text.trim().parse().ok().filter(|number: &i32| (1..=MOST_TURNS).contains(&number.abs()));
    number.ok_or_else(|| format!("give a whole number from 1 to {MOST_TURNS}, or from -{MOST_TURNS} to -1"))
}

fn whole(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|number| *number <= MOST_GENERATIONS);
    number.ok_or_else(|| format!("give a whole number from 0 to {MOST_GENERATIONS}"))
}
