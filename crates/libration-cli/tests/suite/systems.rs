//! The systems known by name.

use crate::command::{json, libration, message, text};
use serde_json::Value;

#[test]
fn every_system_is_listed_with_equations_parameters_energy_and_source() {
    let answer = json("systems");
    let systems = answer["systems"].as_array().unwrap();
    let keys: Vec<&str> = systems.iter().map(|system| system["key"].as_str().unwrap()).collect();
    for key in
        ["damped_pendulum", "driven_pendulum", "spring_pendulum", "double_pendulum", "coupled_pendulums"]
    {
        assert!(keys.contains(&key), "{key} is not in {keys:?}");
    }
    for system in systems {
        for field in ["title", "description", "domain", "source"] {
            assert!(!system[field].as_str().unwrap().is_empty(), "{}: {field}", system["key"]);
        }
        // A chain's is a sum, and equations of the first order have none.
        let key = system["key"].as_str().unwrap();
        let has_none =
            ["lorenz", "roessler", "lotka_volterra", "fermi_pasta_ulam", "pendulum_chain"].contains(&key);
        for field in ["energy", "energy_unit", "power"] {
            assert_eq!(system[field].is_null(), has_none, "{key}: {field}");
            assert!(system[field] != "", "{key}: {field}");
        }
        let coordinates = system["coordinates"].as_array().unwrap();
        // The others say what lies beyond the ends of a chain.
        let equations = system["equations"].as_array().unwrap().iter();
        let of_motion = equations.filter(|equation| equation.as_str().unwrap().contains('\''));
        assert_eq!(of_motion.count(), coordinates.len(), "{}", system["key"]);
        for parameter in system["parameters"].as_array().unwrap() {
            let damps_or_drives = ["damping", "dry friction, which", "torque over", "pivot's motion"]
                .iter()
                .any(|word| parameter["meaning"].as_str().unwrap().contains(word));
            assert!(!damps_or_drives || parameter["default"] == "0", "{parameter}");
        }
    }
}

#[test]
fn one_system_can_be_asked_for_by_any_of_its_names() {
    let answer = json("systems kapitza");
    assert_eq!(answer["systems"][0]["key"], "vertically_driven_pendulum");
    assert_eq!(answer["systems"].as_array().map(Vec::len), Some(1));
    let sheet = text("systems damped");
    assert!(sheet.contains("c = 0, in s^(n-2): strength of the damping"), "{sheet}");
    let output = libration("systems penduum");
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).contains("the nearest are pendulum"), "{}", message(&output));
}

#[test]
fn the_table_of_systems_is_comma_separated_too() {
    let table = text("systems --csv");
    let answer = json("systems");
    assert_eq!(table.lines().count(), 1 + answer["systems"].as_array().map_or(0, Vec::len));
    assert!(matches!(answer["systems"][0]["drive_frequency"], Value::Null));
}
