//! Motions that go on together, for as long as the page likes.
//!
//! # Method
//! An ensemble of the page is the `Ensemble` of the library, with the options of `simulate --each` and a table of starts that the page writes. Its
//! states are those of the command, bit for bit, until the last step of the command, which ends for the last of its times. Each worker has a part
//! of the ensemble and computes one picture after the other, so that it can be stopped and resumed between two pictures (`engine/ensemble.ts`,
//! `player.ts`). Another worker follows sixteen of the motions a second time to 1e-14; the difference is the error that the page states, next to
//! the spread of the ensemble.

use crate::host::PageHost;
use crate::{Given, page, take_given, tell_of_panics};
use libration::chaos::drive_period;
use libration::progress::Quiet;
use libration::systems::{Bodies, Model};
use libration::taylor::{Ensemble, Moment};
use libration_web::exchange::exchange;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Ensemble that is being integrated.
struct Followed {
    ensemble: Ensemble,
    bodies: Option<Bodies>,
    /// The last time that was requested, and the states there.
    time: f64,
    states: Vec<f64>,
}

static FOLLOWED: Mutex<Option<Followed>> = Mutex::new(None);

fn followed() -> MutexGuard<'static, Option<Followed>> {
    FOLLOWED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Begins the motions of the words so far, as `simulate … --each` does; returns the exit status. Of their system: how many there are, how many
/// coordinates, how many bodies, the period of the drive (NaN without one); as text the names of the numbers of a state and their units, a line
/// each with a tabulator between.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn ensemble() -> u8 {
    tell_of_panics();
    let Given { words, files } = take_given();
    match libration_queries::ensemble(words, Arc::new(PageHost::new(files))) {
        Ok((model, ensemble)) => {
            begin(&model, ensemble);
            0
        }
        Err(error) => {
            page::error(&error.to_json());
            error.status()
        }
    }
}

fn begin(model: &Model, mut ensemble: Ensemble) {
    let bodies = model.bodies();
    let states = ensemble.states_at(0.0, &Quiet).unwrap_or_default();
    let count = |places: &Bodies| places.at(&Moment { time: 0.0, state: model.state_at_rest() }).len();
    let counts = [ensemble.len(), model.coordinates().len(), bodies.as_ref().map_or(0, count)];
    let lines = model.state_names().into_iter().zip(model.state_units());
    let mut exchange = exchange();
    #[expect(clippy::cast_precision_loss, reason = "far fewer than 2⁵³")]
    let mut numbers = counts.map(|count| count as f64).to_vec();
    numbers.push(drive_period(model.equation()).unwrap_or(f64::NAN));
    exchange.numbers = numbers;
    exchange.text = lines.map(|(name, unit)| format!("{name}\t{unit}\n")).collect();
    *followed() = Some(Followed { ensemble, bodies, time: 0.0, states });
}

/// The states at a time in s, at or after the last requested one: the components of the state of each motion, one motion after the other, NaN for
/// ended ones.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn advance(time: f64) {
    if let Some(Followed { ensemble, time: now, states, .. }) = followed().as_mut() {
        (*now, *states) = (time, ensemble.states_at(time, &Quiet).unwrap_or_default());
        exchange().numbers.clone_from(states);
    }
}

/// Positions of the bodies in these states: for each body of each motion its position and that from which it hangs, each to the right and upwards.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn bodies() {
    let followed = followed();
    let Some(Followed { ensemble, bodies, time, states }) = followed.as_ref() else { return };
    let of_state = |state: &[f64]| {
        let moment = Moment { time: *time, state: state.to_vec() };
        bodies.as_ref().map_or_else(Vec::new, |bodies| bodies.at(&moment))
    };
    let all = states.chunks(ensemble.system().layout().numbers()).flat_map(of_state);
    exchange().numbers = all.flat_map(|body| [body.place, body.pivot]).flatten().collect();
}

/// The motions that have ended: the cause of the first as text; returns their number.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn ended() -> usize {
    let followed = followed();
    let Some(Followed { ensemble, .. }) = followed.as_ref() else { return 0 };
    exchange().text = ensemble.ended().next().map(|(_, cause)| cause.to_string()).unwrap_or_default();
    ensemble.ended().count()
}
