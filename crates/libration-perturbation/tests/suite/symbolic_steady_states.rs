//! Relations, peaks and notes of slow flows with symbolic parameters, and the orders that they need.

use crate::symbolic_slow_flow::value;
use crate::typed::equation;
use libration::orbit::Orbit;
use libration::perturbation::{
    SymbolicSlowFlow, SymbolicSlowFlowOptions, next_slow_flow, slow_flow_symbolically,
};
use libration::progress::Quiet;
use std::f64::consts::TAU;

/// The slow flow near W = (p/q)·ω0, written p/q, for small parameters such as `c:1,m:2`.
fn flow(text: &str, resonance: &str, small: &str, order: Option<usize>) -> SymbolicSlowFlow {
    let resonance = resonance.split_once('/').map(|(p, q)| (p.parse().unwrap(), q.parse().unwrap()));
    let small = small.split(',').filter_map(|text| text.split_once(':'));
    let small = small.map(|(name, order)| (name.to_owned(), order.parse().unwrap())).collect();
    let options = SymbolicSlowFlowOptions { small, resonance, order, ..Default::default() };
    slow_flow_symbolically(&equation(text), &options, &Quiet).unwrap()
}

fn note<'a>(flow: &'a SymbolicSlowFlow, start: &str) -> &'a str {
    let notes = &flow.steady_state.notes;
    notes.iter().find(|note| note.contains(start)).unwrap_or_else(|| panic!("{start}: {notes:?}"))
}

const DUFFING: &str = "x'' + m*x' + x + c*x^3 = F*cos(W*t)";

#[test]
fn the_order_that_is_not_given_is_one_at_which_the_relation_has_drive_and_damping() {
    let mathieu = "x'' + m*x' + (1 + h*cos(W*t))*x + c*x^3 = 0";
    let forms = [
        (DUFFING, "1/1", "c:1,m:2,F:2", 3, "F"),
        (mathieu, "2/1", "c:1,m:2,h:2", 3, "h"),
        (DUFFING, "1/2", "c:1,m:2", 3, "F"),
        ("x'' + m*x' + x + x^3 = F*cos(W*t)", "1/1", "m:3,F:3", 4, "F"),
        ("x'' + m*x' + x + x^3 = F*cos(W*t)", "1/1", "m:4,F:4", 6, "F"),
        ("x'' + m*x' + x + x^2 = F*cos(W*t)", "1/1", "m:3,F:3", 4, "F"),
        ("x'' + eps^2*m*x' + x + eps*c*x^3 = eps^2*F*cos(W*t)", "1/1", "", 3, "F"),
        (DUFFING, "1/1", "c:1,m:1,F:2", 3, "F"),
    ];
    for (text, resonance, small, order, drive) in forms {
        let slow_flow = flow(text, resonance, small, None);
        assert_eq!(slow_flow.order, order, "{text}");
        let steady = &slow_flow.steady_state;
        let relation = steady.relation.as_ref().unwrap();
        assert!(relation.contains("m^2") && relation.contains(drive), "{text}: {relation}");
        // At a resonance of waves 2φ the determinant has the squares of the damping on both diagonals, which cancel.
        let determinant = steady.determinant.as_ref().unwrap();
        assert!(resonance != "1/1" || determinant.contains("m^2"), "{text}: {determinant}");
        assert!(steady.folds.is_some(), "{text}");
        let lower = flow(text, resonance, small, Some(order - 1)).steady_state;
        assert_eq!((lower.relation, lower.folds, lower.determinant), (None, None, None), "{text}");
        assert!(lower.notes[0].contains(&format!("need order {order}")), "{:?}", lower.notes);
    }
}

/// From A′ = −m·A/2 − F/2·sin φ and the backbone: the curve ends at A = F/m. The critical drive is that of drive and damping of the first order.
#[test]
fn peak_and_critical_drive_do_not_depend_on_how_small_drive_and_damping_are_called() {
    for small in ["c:1,m:1,F:1", "c:1,m:2,F:2"] {
        let steady = flow(DUFFING, "1/1", small, None).steady_state;
        assert_eq!(steady.peak_amplitude.as_deref(), Some("F/m"), "{small}");
        assert_eq!(
            steady.critical_drive.as_deref(),
            Some("sqrt((32*m^3/9)/(sqrt(3)*abs(c)))"),
            "{small}: {:?}",
            steady.notes
        );
    }
    let powers = "x'' + eps^2*m*x' + x + eps*c*x^3 = eps^2*F*cos(W*t)";
    let critical = flow(powers, "1/1", "", None).steady_state.critical_drive.unwrap();
    let at = [("eps", 0.3), ("m", 0.2), ("c", -0.7)];
    let expected = libm::sqrt(0.3 * 32.0 * 0.008 / (9.0 * libm::sqrt(3.0) * 0.7));
    assert!((value(&critical, &at) - expected).abs() < 1e-15, "{critical}");
}

/// The rates vanish up to terms of the next order, which are smaller than those of the drive by a factor of c.
#[test]
fn zeros_of_the_relation_are_steady_where_drive_and_damping_are_of_the_second_order() {
    let slow_flow = flow(DUFFING, "1/1", "c:1,m:2,F:2", None);
    let [c, drive] = [0.02, 0.000_8];
    let of_name = |name: &str| {
        [("c", c), ("m", 0.000_5), ("F", drive)].iter().find(|pair| pair.0 == name).map(|pair| pair.1)
    };
    for detuning in [0.004, 0.007, 0.01] {
        let at = slow_flow.at(&of_name, Some(1.0 + detuning)).unwrap();
        let states = at.steady_states().unwrap();
        assert!(!states.is_empty(), "{detuning}");
        for state in states {
            let [growth, turning] = at.rates(state.amplitude, state.phase);
            let missed = libm::hypot(growth, state.amplitude * turning);
            assert!(missed < 0.1 * drive, "{detuning}: {state:?} {missed}");
        }
    }
}

#[test]
fn terms_of_higher_order_are_noted() {
    let noted = |small: &str, order| flow(DUFFING, "1/1", small, Some(order)).order_note.unwrap_or_default();
    assert_eq!(noted("c:3,m:1,F:1", 2), "terms above order 2 are left out of x'': -c*x^3");
    assert_eq!(noted("c:1,m:2,F:1", 1), "terms above order 1 are left out of x'': -m*x'");
    assert_eq!(noted("c:1,m:2,F:2", 2), "");
    let explicit = "x'' + eps^2*m*x'*abs(x') + x + eps*c*x^3 = eps^2*F*W^2*sin(3*W*t)";
    let limited = flow(explicit, "1/1", "", Some(1));
    let expected = "terms above order 1 are left out of x'': eps^2*F*W^2*sin(3*W*t) - eps^2*m*x'*abs(x')";
    assert_eq!(limited.order_note.as_deref(), Some(expected));
    let by_amplitude = flow("x'' + eps*m*(x^2 - 1)*x' + x + x^3 = 0", "", "", None);
    assert_eq!(
        by_amplitude.order_note.as_deref(),
        Some("terms above order 2 are left out of x'': -eps*m*x^2*x'")
    );
}

#[test]
fn a_drive_that_does_not_act_is_the_reason_where_no_phase_occurs() {
    let texts = [
        ("x'' + eps^2*m*x' + x + eps*c*x^3 = eps^2*F*cos(W*t)", "1/1", "", 1),
        ("x'' + x + k*x^5 + d*x*cos(W*t) = F*cos(W*t)", "1/3", "k:3,d:2", 2),
        ("x'' + m*x' + x + c*x^3 = F*cos(W*t)", "1/1", "c:2,m:1,F:2", 1),
    ];
    for (text, resonance, small, order) in texts {
        let slow_flow = flow(text, resonance, small, Some(order));
        assert_eq!(slow_flow.steady_state.relation, None);
        assert_eq!(slow_flow.steady_state.notes.len(), 1, "{:?}", slow_flow.steady_state.notes);
        assert!(note(&slow_flow, "relation").contains("the phase does not occur to order"), "{text}");
    }
}

/// x‴ of the third harmonic: c·A³/4·cos 3ψ divided by 9 − 1.
#[test]
fn smooth_harmonics_stand_beside_forces_with_kinks() {
    for kink in ["x'*abs(x')", "sign(x')"] {
        let text = format!("x'' + eps*m*{kink} + x + eps*c*x^3 = eps*F*cos(W*t)");
        let slow_flow = flow(&text, "1/1", "", None);
        assert_eq!(slow_flow.displacement, "A*cos(W*t + phi) + eps*c*A^3/32*cos(3*W*t + 3*phi)", "{kink}");
        assert!(slow_flow.displacement_note.is_some());
    }
    let second = flow("x'' + eps^2*m*sign(x') + x + eps*c*x^3 = 0", "", "", None);
    assert_eq!(second.order, 2);
    let smooth = flow("x'' + x + eps*c*x^3 = 0", "", "", Some(2));
    assert_eq!(second.displacement, smooth.displacement);
}

#[test]
fn free_motions_that_only_decay_have_no_relation() {
    let free = |order| flow("x'' + m*x' + x + c*x^3 = 0", "", "c:1,m:2", Some(order));
    let (first, second) = (free(1), free(2));
    assert_eq!(first.order_note.as_deref(), Some("terms above order 1 are left out of x'': -m*x'"));
    let steady = "to order 1 the amplitude does not change, every amplitude is steady";
    assert!(note(&first, "relation").ends_with(steady));
    assert_eq!(second.steady_state.relation, None);
    assert!(note(&second, "relation").contains("no amplitude but zero is steady"));
    let at = second.at(&|_| Some(0.1), None).unwrap();
    assert_eq!(at.steady_states().unwrap(), []);
}

/// The two drives are one of the amplitude √(F² + G²), turned.
#[test]
fn two_drives_of_one_frequency_have_peak_trace_and_determinant() {
    let forced =
        |drive: &str| flow(&format!("x'' + eps*(m*x' + c*x^3) + x = eps*({drive})"), "1/1", "", None);
    let (two, one) = (forced("F*cos(W*t) + G*sin(W*t)"), forced("H*cos(W*t)"));
    let steady = &two.steady_state;
    assert_eq!(steady.peak_amplitude.as_deref(), Some("sqrt(F^2/m^2 + G^2/m^2)"));
    assert_eq!(steady.trace, one.steady_state.trace);
    assert_eq!(steady.determinant, one.steady_state.determinant);
    assert_eq!(steady.backbone, one.steady_state.backbone);
    assert!(!steady.notes.iter().any(|note| note.contains("several harmonics")), "{:?}", steady.notes);
    let parametric =
        |drive: &str| flow(&format!("x'' + eps*(m*x' + c*x^3) + (1 + eps*({drive}))*x = 0"), "2/1", "", None);
    let (two, one) = (parametric("F*cos(W*t) + G*sin(W*t)"), parametric("H*cos(W*t)"));
    let at = [("eps", 1.0), ("m", 0.2), ("c", 0.7), ("F", 0.3), ("G", 0.4), ("H", 0.5), ("sigma", 0.3)];
    // The amplitude of a steady state, from the relation of one drive.
    let at_drive =
        one.at(&|name| at.iter().find(|pair| pair.0 == name).map(|pair| pair.1), Some(2.3)).unwrap();
    for state in at_drive.steady_states().unwrap() {
        let at: Vec<_> = at.iter().copied().chain([("A", state.amplitude)]).collect();
        let determinant = value(two.steady_state.determinant.as_ref().unwrap(), &at);
        assert!((determinant - state.determinant).abs() < 1e-12, "{determinant} {state:?}");
        assert!(value(two.steady_state.relation.as_ref().unwrap(), &at).abs() < 1e-12);
    }
}

/// m·A + 4n/π = F at resonance.
#[test]
fn viscous_and_dry_friction_have_their_peak() {
    let both = "x'' + eps*(m*x' + n*sign(x') + c*x^3) + x = eps*F*cos(W*t)";
    let steady = flow(both, "1/1", "", None).steady_state;
    let at = [("m", 0.3), ("n", 0.2), ("F", 0.7), ("c", 0.5)];
    let [m, n, drive, c] = at.map(|(_, value)| value);
    let peak = (drive - 4.0 * n / std::f64::consts::PI) / m;
    assert!((value(steady.peak_amplitude.as_ref().unwrap(), &at) - peak).abs() < 1e-14);
    let detuning = value(steady.peak_detuning.as_ref().unwrap(), &at);
    assert!((detuning - 3.0 * c * peak * peak / 8.0).abs() < 1e-14);
    let rising = flow("x'' + eps*(m*x' + n*x'^3) + x = eps*F*cos(W*t)", "1/1", "", None);
    assert!(note(&rising, "peak_amplitude").contains("not found"));
    let dry = flow("x'' + eps*n*sign(x') + x = eps*F*cos(W*t)", "1/1", "", None);
    assert!(note(&dry, "peak_amplitude").contains("none is the largest"));
}

#[test]
fn critical_drives_do_not_depend_on_the_sign_of_a_divisor() {
    let text = "x'' + eps*(m*x' + c*x^3/k) + x = eps*F*cos(W*t)";
    let critical = flow(text, "1/1", "", None).steady_state.critical_drive.unwrap();
    let at = |k: f64| value(&critical, &[("m", 0.2), ("c", 0.5), ("k", k)]);
    assert!(at(2.0) > 0.0 && at(2.0) == at(-2.0), "{critical}");
}

#[test]
fn orders_that_are_needed_but_out_of_reach_are_said_to_be() {
    let dry = flow("x'' + m*sign(x') + x + c*x^3 = F*cos(W*t)", "1/1", "c:1,m:2,F:2", None);
    assert!(note(&dry, "relation").contains("need order 3 above the highest, 2"));
    let weak = flow(DUFFING, "1/1", "c:1,m:7,F:7", None);
    assert!(note(&weak, "relation").contains("need order 13 above the highest, 12"));
}

#[test]
fn damping_of_the_highest_order_is_part_of_the_relation_too() {
    for (small, order) in [("c:1,m:2,F:1", 3), ("c:2,m:3,F:1", 5)] {
        let slow_flow = flow(DUFFING, "1/1", small, None);
        assert_eq!(slow_flow.order, order, "{small}");
        assert!(slow_flow.steady_state.relation.as_ref().unwrap().contains("m^2"), "{small}");
        let lower = flow(DUFFING, "1/1", small, Some(order - 1));
        assert!(note(&lower, "peak_amplitude").contains(&format!("from order {order} on")), "{small}");
    }
}

/// Three states: A near F/(2σ) below the backbone, and two at the backbone, the lower of which is unstable.
#[test]
fn states_far_from_the_backbone_are_within_reach_where_drive_and_damping_are_of_the_second_order() {
    let slow_flow = flow(DUFFING, "1/1", "c:1,m:2,F:2", None);
    let options = SymbolicSlowFlowOptions {
        small: [("c", 1), ("m", 2), ("F", 2)].map(|(name, order)| (name.to_owned(), order)).to_vec(),
        resonance: Some((1, 1)),
        ..Default::default()
    };
    let next = next_slow_flow(&equation(DUFFING), &options, &slow_flow, &Quiet).unwrap();
    let of_name = |name: &str| {
        [("c", 0.05), ("m", 0.002), ("F", 0.003)].iter().find(|pair| pair.0 == name).map(|pair| pair.1)
    };
    let next = next.at(&of_name, Some(1.02)).unwrap();
    let states = slow_flow.at(&of_name, Some(1.02)).unwrap().judged_states(Some(&next)).unwrap();
    assert_eq!(states.left_out, []);
    let stable: Vec<Option<bool>> = states.found.iter().map(|state| state.is_stable).collect();
    assert_eq!(stable, [Some(true), Some(false), Some(true)], "{states:?}");
    for judged in &states.found {
        let text = "x'' + 0.002*x' + x + 0.05*x^3 = 0.003*cos(1.02*t)";
        let (amplitude, phase) = (judged.state.amplitude, judged.state.phase);
        let start = [amplitude * libm::cos(phase), -1.02 * amplitude * libm::sin(phase)];
        let orbit = Orbit::driven(&equation(text), &start, TAU / 1.02, &Quiet).unwrap();
        let exact = orbit.harmonics(0).terms[1].amplitude();
        let [error, _] = judged.errors.unwrap();
        assert!((amplitude - exact).abs() < 0.002 * exact.max(0.1) + 2.0 * error, "{judged:?} {exact}");
    }
}

/// The linear oscillator has its largest amplitude F/(m·√(1 − m²/4)), where F is of higher order than m.
#[test]
fn a_drive_of_higher_order_than_the_damping_has_a_peak() {
    // With c of the second order its term is of the fourth, as m⁴ is.
    for (small, detuning) in [("c:1,m:1,F:2", "-m^2/4 + 3*F^2*c/(8*m^2)"), ("c:2,m:1,F:2", "-m^2/4")] {
        let steady = flow(DUFFING, "1/1", small, None).steady_state;
        assert_eq!(steady.peak_amplitude.as_deref(), Some("F/m"), "{small}: {:?}", steady.notes);
        assert_eq!(steady.peak_detuning.as_deref(), Some(detuning), "{small}");
    }
    let linear = flow("x'' + m*x' + x = F*cos(W*t)", "1/1", "m:1,F:2", Some(5)).steady_state;
    assert_eq!(linear.peak_amplitude.as_deref(), Some("sqrt(F^2/4 + F^2/m^2)"));
    // A drive of lower order than the damping has its peak at amplitudes that are not reached.
    let steep = flow(DUFFING, "1/1", "c:1,m:3,F:1", None);
    assert_eq!(steep.steady_state.peak_amplitude, None);
}

/// The relation has the square of the drive's amplitude, whatever its symbols; at a steady state with numbers the rates vanish.
#[test]
fn a_drive_of_several_symbols_has_critical_value_and_phase() {
    let forced =
        |drive: &str| flow(&format!("x'' + eps*(m*x' + c*x^3) + x = eps*({drive})"), "1/1", "", None);
    let one = forced("H*cos(W*t)").steady_state;
    let drives = [
        ("F*G*cos(W*t)", "F*G"),
        ("(F + G)*cos(W*t)", "F + G"),
        ("(F - G/2)*cos(W*t)", "2*F - G"),
        ("F*cos(W*t) - G*sin(W*t)", "sqrt(F^2 + G^2)"),
        ("3*F*W^2*cos(W*t)", "F"),
    ];
    for (drive, amplitude) in drives {
        let slow_flow = forced(drive);
        let steady = &slow_flow.steady_state;
        assert_eq!(steady.drive_amplitude.as_deref(), Some(amplitude));
        let at = [("m", 0.2), ("c", 0.7)];
        let [critical, expected] =
            [steady, &one].map(|steady_state| value(steady_state.critical_drive.as_ref().unwrap(), &at));
        let factor = match amplitude {
            "F" => 3.0,
            "2*F - G" => 0.5,
            _ => 1.0,
        };
        assert!((factor * critical - expected).abs() < 1e-14, "{drive}: {critical} {expected}");
        let of_name = |name: &str| {
            [("eps", 0.1), ("m", 0.2), ("c", 0.7), ("F", 0.9), ("G", 0.4)]
                .iter()
                .find(|pair| pair.0 == name)
                .map(|pair| pair.1)
        };
        let at = slow_flow.at(&of_name, Some(1.01)).unwrap();
        let states = at.steady_states().unwrap();
        assert!(!states.is_empty(), "{drive}");
        for state in states {
            let [growth, turning] = at.rates(state.amplitude, state.phase);
            assert!(growth.abs() + turning.abs() < 1e-12, "{drive}: {state:?} {growth} {turning}");
        }
        let (_, [cosine, sine]) = steady.phase.as_ref().unwrap();
        let state = at.steady_states().unwrap()[0];
        let values = [("m", 0.2), ("c", 0.7), ("F", 0.9), ("G", 0.4), ("A", state.amplitude), ("sigma", 0.1)];
        assert!((value(cosine, &values) - libm::cos(state.phase)).abs() < 1e-12, "{drive}: {cosine}");
        assert!((value(sine, &values) - libm::sin(state.phase)).abs() < 1e-12, "{drive}: {sine}");
    }
}

/// A and Ω by the integrated cycle are missed by ε³ and ε⁴, as the next order of A is even and that of Ω odd in general.
#[test]
fn limit_cycles_have_amplitude_and_frequency_as_formulas() {
    let cycle = |text: &str, order| flow(text, "", "", Some(order)).steady_state;
    let plain = cycle("x'' + w0^2*x = eps*(1 - b*x^2)*x'", 2);
    assert_eq!(plain.cycle_amplitude.as_deref(), Some("2/sqrt(b)"));
    assert_eq!(plain.cycle_frequency.as_deref(), Some("w0 - eps^2/(16*w0)"));
    let irrational = cycle("x'' + 2*x = eps*(1 - x^2)*x'", 2);
    assert_eq!(irrational.cycle_frequency.as_deref(), Some("w0 - eps^2/(16*w0)"));
    let growing = cycle("x'' + w0^2*x = eps*(1 + x^2)*x'", 1);
    assert_eq!((growing.cycle_amplitude, growing.cycle_frequency), (None, None));
    let text = "x'' + w0^2*x = eps*(m*x' - c*x'^3 + a*x^2 + b*x^3)";
    let steady = cycle(text, 3);
    let missed = [0.08, 0.04].map(|eps: f64| {
        let at = [("eps", eps), ("w0", 1.3), ("m", 0.8), ("c", 0.5), ("a", 0.4), ("b", 0.3)];
        let numeric =
            "x'' + 1.69*x = EPS*(0.8*x' - 0.5*x'^3 + 0.4*x^2 + 0.3*x^3)".replace("EPS", &eps.to_string());
        let amplitude = value(steady.cycle_amplitude.as_ref().unwrap(), &at);
        let orbit = Orbit::limit_cycle(&equation(&numeric), &[amplitude, 0.0], &Quiet).unwrap();
        let frequency = value(steady.cycle_frequency.as_ref().unwrap(), &at);
        [amplitude - orbit.harmonics(0).terms[1].amplitude(), frequency - orbit.frequency()]
    });
    for (index, power) in [(0, 3.0), (1, 4.0)] {
        let exponent = libm::log2((missed[0][index] / missed[1][index]).abs());
        assert!(exponent > power - 0.3, "{missed:?} {exponent}");
    }
}
