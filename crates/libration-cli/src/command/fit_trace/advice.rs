//! What would make a measurement better, said to those who make it.

use super::answer::{Answer, Pendulum};
use super::warnings::{doubtful_beta, is_poor};
use crate::output::number::rounded;
use libration_lab::measurement::{Faults, Seen, Trace};

/// The advice, what helps most first.
pub(super) fn of(answer: &Answer<'_>) -> Vec<String> {
    let mut advice = vec![];
    advice.extend(about_length(answer));
    advice.extend(about_scale(answer));
    advice.extend(about_damping(answer));
    advice.extend(about_residuals(answer));
    advice.extend(about_outliers(answer));
    advice.extend(
        answer
            .measured
            .traces
            .iter()
            .zip(&answer.fit.traces)
            .find_map(|(trace, _)| about_times(answer, trace)),
    );
    advice.extend(about_tilt(answer));
    advice.extend(about_rows(answer));
    advice
}

fn about_length(answer: &Answer<'_>) -> Option<String> {
    const WHERE: &str = "from the axis of the pivot to the middle of the bob, which is its centre of mass";
    let (budget, length) = match &answer.pendulum {
        Pendulum::Length { .. } => {
            return Some(format!(
                "Give the length with --length 0.57m±0.004m to have gravity: measure it {WHERE}."
            ));
        }
        Pendulum::Gravity { budget, length } => (budget, length),
    };
    let Some(of_length) = length.uncertainty else {
        return Some(format!(
            "The length was given without an uncertainty, so that gravity has too small a one: write it as 0.57m±0.004m. \
             Measure it {WHERE}."
        ));
    };
    let (of_length, of_gravity) = (of_length / length.value, budget.uncertainty / budget.g);
    (of_length > 0.7 * of_gravity).then(|| {
        let percent = rounded(100.0 * of_length, 2);
        format!(
            "The length is known to {percent} %, and so is gravity: nothing else in the budget matters. Measure the length better, \
             {WHERE}; more swings would not help."
        )
    })
}

fn about_scale(answer: &Answer<'_>) -> Option<String> {
    doubtful_beta(answer)?.scale_error()?;
    let hint = match answer.measured.traces[0].seen() {
        Seen::Angle => {
            "film from far away and straight at the plane of the swing, check the pixels for being square, the origin for \
             being on the pivot, and the protractor or encoder for its counts in a turn"
        }
        Seen::AngularVelocity => {
            "check the sensor's sensitivity by turning it through a whole turn, and that its axis is that of the swing"
        }
    };
    Some(format!(
        "β is not 1, so look for a wrong scale of the angles: {hint}. With --free-scale the scale is fitted too."
    ))
}

fn about_damping(answer: &Answer<'_>) -> Option<String> {
    let rivals = answer.rivals();
    let (largest, smallest) = answer.amplitudes().filter(|_| !rivals.is_empty())?;
    let [largest, smallest] = [largest, smallest].map(|amplitude| rounded(amplitude.to_degrees(), 3));
    let fall = match largest == smallest {
        true => format!("Only an amplitude of {largest}° was measured"),
        false => format!("The amplitude went from {largest}° to {smallest}°"),
    };
    Some(format!(
        "{fall}. The kinds of damping differ in how the decay slows down: record for longer, until the amplitude is a quarter of \
         what it was at first."
    ))
}

fn about_residuals(answer: &Answer<'_>) -> Option<String> {
    (!answer.fit.autocorrelation.is_noise()).then(|| {
        "Look at the picture of the residuals: if they repeat with the swing, suspect the scale or the perspective of the \
         camera, a pivot that gives way, or a string that stretches; if they grow at the beginning, leave out the release with \
         --from."
            .to_owned()
    })
}

/// Rows at an end that do not follow the motion, or else rows here and there.
fn about_outliers(answer: &Answer<'_>) -> Option<String> {
    let traces = answer.measured.traces.iter().zip(&answer.fit.traces);
    let ends: Vec<String> =
        traces.flat_map(|(trace, fitted)| strange_ends(trace, &fitted.outliers)).collect();
    let some = answer.fit.traces.iter().any(|trace| !trace.outliers.is_empty());
    match ends.len() {
        0 => some.then(|| {
            "Some rows are far from all others: correct them in the tracking, or fit with --robust."
                .to_owned()
        }),
        _ => Some(format!(
            "Rows do not follow the motion {}: if the pendulum was held there or the tracking lost it, leave them out with \
             --from and --to.",
            ends.join(" and ")
        )),
    }
}

/// Where a trace begins or ends with outliers one after the other.
fn strange_ends(trace: &Trace, outliers: &[usize]) -> Vec<String> {
    const FEWEST: usize = 3;
    let (times, last) = (trace.times(), trace.len() - 1);
    let at_beginning = outliers.iter().enumerate().take_while(|(place, row)| place == *row).count();
    let at_end = outliers.iter().rev().enumerate().take_while(|(place, row)| last - *row == *place).count();
    let beginning = (at_beginning >= FEWEST && at_beginning < trace.len())
        .then(|| format!("of {} before {} s", trace.name(), rounded(times[at_beginning], 4)));
    let end = (at_end >= FEWEST && at_end < trace.len())
        .then(|| format!("of {} after {} s", trace.name(), rounded(times[last - at_end], 4)));
    beginning.into_iter().chain(end).collect()
}

/// Rounded times, where they matter beside the other errors.
fn about_times(answer: &Answer<'_>, trace: &Trace) -> Option<String> {
    let faults = Faults::find(trace.times(), trace.values(), None);
    let (noise, clock) = (faults.rounding_noise?, faults.clock?);
    let (resolution, _) = (clock.resolution?, clock.grid?);
    (noise > 0.25 * answer.fit.rms).then(|| {
        format!(
            "The times are rounded to {resolution} s, which makes {} % of the scatter: export them with more digits, or \
             fit with --even-times.",
            rounded(100.0 * (noise / answer.fit.rms).min(1.0), 2)
        )
    })
}

/// The zero of the angle.
fn about_tilt(answer: &Answer<'_>) -> Option<String> {
    const WORTH_A_WORD: f64 = 0.01;
    let offsets = answer.fit.parameters.iter().filter(|parameter| parameter.name == "offset");
    let seen = answer.measured.traces[0].seen();
    let worst = offsets
        .map(|offset| offset.value)
        .filter(|_| seen == Seen::Angle)
        .max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    (worst.abs() > WORTH_A_WORD && !is_poor(&answer.fit)).then(|| {
        format!(
            "The pendulum hangs at {}° on the scale of the instrument. That was fitted and does no harm; a plumb line in the \
             picture would set it right.",
            rounded(worst.to_degrees(), 2)
        )
    })
}

fn about_rows(answer: &Answer<'_>) -> Option<String> {
    const FEW: f64 = 15.0;
    let (period, _) = answer.fit.small_angle_period();
    let rows = answer.measured.traces.iter().filter_map(|trace| {
        Faults::find(trace.times(), trace.values(), None).clock.map(|clock| period / clock.interval)
    });
    let fewest = rows.reduce(f64::min)?;
    (fewest < FEW).then(|| {
        format!("There are only {} rows in a period: take more pictures a second.", rounded(fewest, 2))
    })
}
