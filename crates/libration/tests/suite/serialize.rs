//! Answers as data, with the feature `serde`.

use libration::chaos::{Doubt, LyapunovVerdict, Regularity, Theorem};
use libration::comparison::Backbone;
use libration::normal_modes::NormalModes;
use libration::oscillator::Oscillator;
use libration::pendulum::Pendulum;
use libration::perturbation::{Gauge, expand};
use libration::quantity::Angle;
use libration::taylor::{Cause, Effort, Event, System, integrate};
use serde_json::{Value, json, to_value};

#[test]
fn fractions_are_text_that_reads_back() {
    let pendulum = Oscillator::new(&"x'' = -sin(x)".parse().unwrap()).unwrap();
    let expansion = to_value(expand(&pendulum, 5, &Gauge::Fundamental).unwrap()).unwrap();
    assert_eq!(expansion["frequency_ratio"], json!(["1", "0", "-1/16", "0", "1/1024"]));
    assert_eq!(expansion["of_amplitude"]["period_ratio"], json!(["1", "0", "1/16", "0", "11/3072"]));
    assert_eq!(expansion["variable"], json!({"epsilon": "fundamental"}));
}

#[test]
fn an_angle_carries_its_complement() {
    let angle: Angle = "pi-1e-300".parse().unwrap();
    assert_eq!(to_value(angle).unwrap(), json!({"radians": std::f64::consts::PI, "complement": 1e-300}));
}

#[test]
fn a_motion_is_its_times_states_and_events() {
    let event = Event::zero_of("x".parse().unwrap());
    let system = System::new(&"x'' + x = 0".parse().unwrap()).unwrap().with_events(&[event]).unwrap();
    let start = system.start(&[("x", 1.0)]).unwrap();
    let solution = integrate(&system, &start, &[2.0], &Effort::to_tolerance(1e-15)).unwrap();
    let value = to_value(&solution).unwrap();
    assert_eq!(value["samples"][0]["time"], json!(2.0));
    assert_eq!(value["samples"][0]["state"], json!(solution.samples[0].state));
    assert_eq!(value["events"][0]["contact"], json!("falling"));
}

#[test]
fn a_verdict_has_its_reason_and_a_missing_value_its_error() {
    let theorem = LyapunovVerdict::Regular(Regularity::Theorem(Theorem::Plane));
    assert_eq!(to_value(theorem).unwrap(), json!({"regular": {"theorem": "plane"}}));
    let stopped = LyapunovVerdict::Undecided(Doubt::Stopped(Cause::StepLimit));
    assert_eq!(to_value(stopped).unwrap(), json!({"undecided": {"stopped": "step_limit"}}));

    let backbone = Backbone::new(&"x'' + x - x^3 = 0".parse().unwrap(), None, 5).unwrap();
    let (inside, beyond) = (to_value(backbone.at(0.5)).unwrap(), to_value(backbone.at(2.0)).unwrap());
    assert_eq!(inside["orbit"]["frequency"], json!(backbone.at(0.5).orbit.unwrap().frequency));
    assert_eq!(beyond["orbit"], json!({"error": backbone.at(2.0).orbit.unwrap_err().to_string()}));
}

#[test]
fn numbers_that_are_none_are_null() {
    let upright = Pendulum::from_angular_frequency(1.0).unwrap().on_separatrix();
    assert_eq!(to_value(upright.state_at(f64::NAN)).unwrap()["velocity"], Value::Null);
    assert_eq!(to_value(upright.regime()).unwrap(), json!("separatrix"));
}

#[test]
fn modes_keep_their_square_roots() {
    let modes = NormalModes::new(&"x'' = y - 2*x; y'' = x - 2*y".parse().unwrap()).unwrap();
    let modes = to_value(modes).unwrap();
    assert_eq!(modes["modes"][1]["frequency_squared"], json!("3"));
    assert_eq!(modes["modes"][1]["behaviour"], json!("oscillating"));
}
