//! The fall of the amplitude by each kind of damping, against the averaged law.

use libration::decay::{Damping, DampingKind, Decay, EnvelopeLaw};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration_lab::internals::fit::cycles::decay_rates::DecayRates;

/// The same fall as the averaged law, which integrates over the amplitude.
#[test]
fn the_rates_are_those_of_the_averaged_law() {
    let (omega0, start) = (2.0, 2.5);
    let rates = DecayRates::new(omega0, start);
    for (term, exponent, coefficient) in
        [(DampingKind::Dry, 0.0, 0.1), (DampingKind::Linear, 1.0, 0.1), (DampingKind::Quadratic, 2.0, 0.05)]
    {
        let pendulum = Pendulum::from_angular_frequency(omega0).unwrap();
        let damping = Damping::of_degree(exponent, coefficient).unwrap();
        let decay = Decay::new(pendulum, damping, Angle::from_radians(start).unwrap()).unwrap();
        let envelope = decay.envelope(EnvelopeLaw::Averaged);
        for time in [0.5, 3.0, 6.0] {
            let (before, after) = (envelope.amplitude_at(time - 1e-3), envelope.amplitude_at(time + 1e-3));
            let rate = (before - after) / 2e-3;
            let ours = coefficient * rates.at(term, envelope.amplitude_at(time));
            assert!((ours / rate - 1.0).abs() < 1e-6, "{term:?} {time}: {ours} {rate}");
        }
    }
}
