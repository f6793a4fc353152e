//! Fields of an equilibrium, and of each mode about it.

use super::ModesResult;
use crate::output::description::{Answers, DescriptionRow, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json;
use libration::algebra::Surd;
use libration::normal_modes::{Behaviour, Mode, Resonance};

/// A mode with its number, from 1.
pub(super) struct NumberedMode<'a> {
    pub(super) number: usize,
    pub(super) mode: &'a Mode,
}

impl ModesResult {
    pub(super) fn numbered(&self) -> impl Iterator<Item = NumberedMode<'_>> {
        (1..).zip(&self.modes.modes).map(|(number, mode)| NumberedMode { number, mode })
    }
}

pub(super) fn of_equilibrium() -> Fields<ModesResult> {
    type Of = Field<ModesResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equations[]", "", "equations of motion as they were read", |result| {
            json::list(result.model.equation().to_string().split("; "))
        }),
        Of::value("parameters.NAME", "", "value of the parameter with this name, as text", |result| {
            json::object(result.model.values().iter().map(|(name, value)| (name.clone(), value.to_string())))
        }),
        Of::value("coordinates[]", "", "names of the coordinates", |result| {
            json::list(result.modes.variables.clone())
        }),
        Of::value(
            "equilibrium[]",
            "",
            "coordinates of the equilibrium, in the order of the names",
            |result| json::list(result.modes.equilibrium.clone()),
        ),
        Of::value("exact_equilibrium[]", "", "the same as fractions, or null", |result| {
            result.modes.exact_equilibrium.as_ref().map(|exact| texts(exact)).into()
        }),
    ])
}

/// The fields before the shape in CSV.
pub(super) fn of_mode<'a>() -> Fields<NumberedMode<'a>> {
    type Of<'a> = Field<NumberedMode<'a>>;
    Fields::from([
        Of::value("mode", "1", "number of the mode, from 1", |mode| mode.number.into()).only_csv(),
        Of::value("behaviour", "", "oscillating, free, unstable or damped", |mode| {
            word(mode.mode.behaviour).into()
        }),
        Of::number(
            "angular_frequency_rad_per_s",
            "rad/s",
            "angular frequency ω of small oscillations",
            |mode| mode.mode.exponent.im,
        ),
        Of::number("growth_rate_per_s", "1/s", "rate of growth, negative where it decays", |mode| {
            mode.mode.exponent.re
        }),
        Of::value(
            "angular_frequency_squared",
            "",
            "ω² as a fraction or with a square root, or null",
            |mode| mode.mode.frequency_squared.as_ref().map(ToString::to_string).into(),
        )
        .only_json(),
        Of::value("exact_angular_frequency", "", "ω with square roots, or null", |mode| {
            exact_frequency(mode.mode).into()
        }),
        Of::value("shape[]", "", "displacements of the coordinates, the largest 1, real part", |mode| {
            json::list(mode.mode.shape.iter().map(|part| part.re))
        }),
        Of::value("shape_imaginary[]", "", "their imaginary parts, of damped modes", |mode| {
            json::list(mode.mode.shape.iter().map(|part| part.im))
        }),
        Of::value("exact_shape[]", "", "displacements as fractions or with square roots, or null", |mode| {
            mode.mode.exact_shape.as_ref().map(|exact| texts(exact)).into()
        }),
        Of::value("multiplicity", "1", "number of modes with this frequency", |mode| {
            mode.mode.multiplicity.into()
        })
        .only_json(),
        Of::value(
            "with_powers_of_time",
            "1",
            "number of further motions with this exponent and a factor t",
            |mode| mode.mode.with_powers_of_time.into(),
        )
        .only_json(),
        Of::nested("resonances[].", &of_resonance(), |mode| of_resonance().records(&mode.mode.resonances)),
    ])
}

/// The fields after the shape.
pub(super) fn of_shift<'a>() -> Fields<NumberedMode<'a>> {
    type Of<'a> = Field<NumberedMode<'a>>;
    Fields::from([
        Of::value(
            "shift",
            "",
            "κ in Ω = ω + κa², with a the amplitude of the largest displacement, or null",
            |mode| mode.mode.shift.as_ref().ok().map(|shift| json::number(shift.coefficient)).into(),
        ),
        Of::value("exact_relative_shift", "", "κ/ω as a fraction or with square roots, or null", |mode| {
            let relative = mode.mode.shift.as_ref().ok().and_then(|shift| shift.relative.as_ref());
            relative.map(ToString::to_string).into()
        })
        .only_json(),
        Of::value("no_shift", "", "reason why no κ is given, or null", |mode| {
            mode.mode.shift.as_ref().err().map(ToString::to_string).into()
        })
        .only_json(),
    ])
}

fn of_resonance() -> Fields<Resonance> {
    type Of = Field<Resonance>;
    Fields::from([
        Of::value("with_mode", "1", "number of the other mode, from 1", |resonance| {
            (resonance.other + 1).into()
        }),
        Of::value("multiple", "1", "integer ratio of the faster frequency to the slower one", |resonance| {
            resonance.multiple.into()
        }),
        Of::value("other_is_faster", "", "true if the other mode is the faster one", |resonance| {
            resonance.other_is_faster.into()
        }),
        Of::value("exact", "", "true if the ratio is exact", |resonance| resonance.exact.into()),
        Of::number(
            "detuning",
            "1",
            "faster frequency over the multiple of the slower one, minus 1",
            |resonance| resonance.detuning,
        ),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    const SHAPE: DescriptionRow =
        ("shape_NAME", "", "displacement of the coordinate with this name, the largest 1, real part");
    let json = [of_mode().described("modes[]."), of_shift().described("modes[].")].concat();
    let csv = [of_mode().described_in_csv(), descriptions("", &[SHAPE]), of_shift().described_in_csv()];
    let json = [of_equilibrium().described(""), json].concat();
    vec![Answers { command: "modes", option: "", json, csv: csv.concat() }, super::follow::answers()]
}

/// The frequency of an oscillation with square roots.
pub(super) fn exact_frequency(mode: &Mode) -> Option<String> {
    let square = mode.frequency_squared.as_ref().filter(|_| mode.behaviour == Behaviour::Oscillating);
    square.map(Surd::square_root_text)
}

fn texts(list: &[impl ToString]) -> serde_json::Value {
    json::list(list.iter().map(ToString::to_string))
}

fn word(behaviour: Behaviour) -> &'static str {
    match behaviour {
        Behaviour::Oscillating => "oscillating",
        Behaviour::Free => "free",
        Behaviour::Unstable => "unstable",
        Behaviour::Damped => "damped",
    }
}
