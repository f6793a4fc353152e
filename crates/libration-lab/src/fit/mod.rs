//! Columns of measurements → parameters with their uncertainties.
//!
//! Measured periods T against amplitudes A, under a law T = T0·R(A): weighted least squares with the
//! *effective variance* of each row, var(T) + (T0·R′(A))²·var(A), which folds the uncertainty of the
//! amplitude into that of the period. The weights hold while the parameters are solved for and are renewed
//! until nothing changes, so that the estimate is not drawn towards parameters with a larger variance.
//!
//! Without σ of the periods every row counts alike and σ is the scatter about the law; χ² would then be its
//! number of degrees of freedom by construction and is not given. σ of the amplitudes alone is not used: a
//! constant period would have no uncertainty at all.
//!
//! Reference: J. Orear, *Least squares when both variables have uncertainties*, Am. J. Phys. 50 (1982) 912,
//! doi:10.1119/1.12972; M. Lybanon, Am. J. Phys. 52 (1984) 22, doi:10.1119/1.13822.

pub mod amplitudes;
mod angle_unit;
mod beta;
pub(crate) mod budget;
mod contradiction;
pub mod cycles;
mod damped_pendulum;
mod damping_model;
pub(crate) mod effective_weights;
mod error;
mod excess_scale;
mod falling;
pub mod gates;
mod gravity;
mod groups;
pub(crate) mod law;
mod lengths;
mod mistake;
mod normal_gravity;
mod numbered_time;
mod outliers;
mod period_table;
mod periods;
pub mod plan;
mod quality;
mod readings;
mod readings_of_fit;
pub mod response;
pub(crate) mod scatter;
mod significance;
mod small_angle_period;
pub mod spectrum;
pub mod swings;
pub mod trace;
pub(crate) mod typical_amplitude;
mod uncertain;

pub use angle_unit::MistakenUnit;
pub use beta::Beta;
pub use budget::{
    AIR_DENSITY, Apparatus, Bob, BobShape, Budget, BudgetError, BudgetInput, BudgetRow, BudgetWarning,
    COVERAGE_PROBABILITY, CombinedUncertainty, Contribution, Correction, Corrections, Correlation,
    Evaluation, MeasuredPeriod, PeriodDamping, evaluate_budget,
};
pub use contradiction::Contradiction;
pub use damping_model::{DampingModel, DampingModelError, alternatives};
pub use error::FitError;
pub use excess_scale::{ExcessScaleFit, fit_excess_scale};
pub use gravity::{GRAVITY_ON_EARTH, is_nowhere_on_earth};
pub use groups::{GroupMean, GroupResult};
pub use law::Law;
pub use lengths::{
    LengthColumns, LengthFit, LengthModel, LengthTable, LengthsFit, LengthsOptions, LengthsPendulum,
    LengthsWarning, PowerLaw, fit_lengths,
};
pub use libration::decay::DampingKind;
pub use mistake::GravityMistake;
pub use normal_gravity::{NormalGravityError, normal_gravity};
pub use numbered_time::swings_of_numbered_time;
pub use outliers::{DEFAULT_OUTLIER_THRESHOLD, find_outliers};
pub use period_table::{PeriodTable, Uncertainties, Weighting};
pub use periods::{PeriodFit, PeriodsOptions, PeriodsWarning, fit_periods};
pub use quality::Quality;
pub use readings::{
    MeanReading, ReadingSummary, RepeatedReadings, effective_degrees_of_freedom, shared_rounding,
};
pub use scatter::{Enlargement, Scatter, ScatterVerdict, ScatterWarning};
pub use significance::{SIGNIFICANT, limit_of_chance};
pub use small_angle_period::{LawFit, fit_small_angle_period};
pub use uncertain::Uncertain;
