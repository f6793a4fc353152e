//! Arguments that the commands have in common: angles, amplitudes, times, the pendulum, the formulas.

mod amplitudes;
mod angle_list;
mod apparatus;
mod bare;
mod bob;
mod column_units;
mod columns;
mod columns_in_si;
mod commas;
mod correlation;
mod counted;
pub(crate) mod displacements;
mod equilibrium;
mod formulas;
mod inferences;
mod initial;
mod input_file;
mod keys;
mod lines;
mod motion_table;
mod names;
pub(crate) mod negative;
mod one_amplitude;
mod oscillator;
pub(crate) mod parameter_range;
mod parameter_span;
mod pendulum;
mod place;
mod reading;
mod recording;
mod section;
mod sensitivities;
mod si_rows;
mod slow_flow;
pub(crate) mod sweep_options;
mod system;
mod table;
mod table_columns;
mod table_rows;
mod text;
mod times;
mod tolerances;
mod undecided;
mod values;
mod wanted;

pub(crate) use amplitudes::{AmplitudeOptions, Amplitudes, AngleSet};
pub(crate) use angle_list::{AngleList, angle_list};
pub(crate) use apparatus::{ApparatusOptions, CorrectionOptions, LinearDampingOption};
pub(crate) use bare::say as say_radians;
pub(crate) use columns::columns;
pub(crate) use columns_in_si::ColumnsInSi;
pub(crate) use commas::at_commas;
pub(crate) use counted::CountedOptions;
pub(crate) use displacements::displacements;
pub(crate) use equilibrium::EquilibriumOptions;
pub(crate) use formulas::{FormulaChoice, formula};
pub(crate) use inferences::{Inferences, of_columns};
pub(crate) use initial::{Initial, InitialOptions, SeveralInitialOptions};
pub(crate) use input_file::{read_at_most, read_bytes};
pub(crate) use keys::KeyOptions;
pub(crate) use motion_table::{Meaning, MotionRow, MotionTable, at_line};
pub(crate) use names::{CoordinateName, EquationText};
pub(crate) use negative::protect_negative_values;
pub(crate) use one_amplitude::{column_or_one_amplitude, one_amplitude};
pub(crate) use oscillator::{Asked, Chosen, ChosenWithLetters, OscillatorOptions, no_oscillator};
pub(crate) use parameter_range::{ParameterRange, constant, parameter_range, progression};
pub(crate) use parameter_span::{ParameterSpan, parameter_span, two_parameter_spans};
pub(crate) use pendulum::{PendulumOptions, motion};
pub(crate) use place::PlaceOptions;
pub(crate) use recording::{RecordingOptions, finding_with_option};
pub(crate) use section::{
    SectionOptions, coordinate, free_on, place_in_state, places_in_state, section_failure,
};
pub(crate) use sensitivities::sensitivities;
pub(crate) use slow_flow::{drive_resonance, frequency_ratios, small_orders};
pub(crate) use sweep_options::sweep_options_first;
pub(crate) use system::{GivenSystem, PendulumSystemOptions, SystemOptions, with_idle_drive};
pub(crate) use table::{
    AmplitudeUnit, DialectOptions, DisplacementUnit, FrequencyUnit, LengthUnit, optional_column,
};
pub(crate) use table_columns::{ChosenColumns, ColumnsOption, GroupOption, TableFit};
pub(crate) use table_rows::RowBound;
pub(crate) use text::{
    angle, angular_velocity, count, displacement, finite_time, fractional_error, gravity, length,
    length_with_uncertainty, not_negative, part, period_with_uncertainty, positive, rate_with_uncertainty,
};
pub(crate) use times::{TimeOptions, Times, times};
pub(crate) use tolerances::{Tolerances, tolerances};
pub(crate) use undecided::what_would_decide;
pub(crate) use values::plain_name;
pub(crate) use wanted::{AMPLITUDES, Wanted};
