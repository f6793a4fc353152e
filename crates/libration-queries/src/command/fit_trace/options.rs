//! Options that follow the advice of a warning.

use crate::call::in_words;
use libration_lab::fit::swings::{Advice, Warning};
use libration_lab::measurement::Observable;

/// The warning, with the options that help.
pub(super) fn warning(warning: &Warning) -> String {
    let options = match warning {
        Warning::AnglesAreRadians { .. } => "<--angle-unit=rad>",
        Warning::AnglesAreDegrees { .. } => "<--angle-unit=deg>",
        Warning::PivotContradicted { .. } => "<--pivot>",
        Warning::PoorFit { .. } => "<--from>, <--to>, <--angle-unit>",
        Warning::FeedsEnergy { .. } => "<--model>",
        Warning::ImplausibleLength { .. } => "<--time-unit>",
        _ => return warning.to_string(),
    };
    in_words(&format!("{warning} ({options})"))
}

/// The advice, with the options that follow it.
pub(super) fn advice(advice: &Advice) -> String {
    let options = match advice {
        Advice::GiveLength => "<--length>",
        Advice::CheckScale { observable: Observable::Angle } => "<--counts-per-turn>, <--free-scale>",
        Advice::CheckScale { observable: Observable::AngularVelocity } => "<--free-scale>",
        Advice::StateScale { .. } => "<--angle-scale>",
        Advice::LookAtResiduals => "<--report>, <--from>",
        Advice::CorrectOutliers => "<--robust>",
        Advice::LeaveOutEnds { .. } => "<--from>, <--to>",
        Advice::WriteMoreDigitsOfTimes { .. } => "<--even-times>",
        _ => return advice.to_string(),
    };
    in_words(&format!("{advice} ({options})"))
}
