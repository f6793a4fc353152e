//! Oscillators and systems in the catalogue.

use crate::command::{json, refusal, text};
use serde_json::Value;

#[test]
fn every_system_is_listed_with_equations_parameters_energy_and_source() {
    let answer = json("list systems");
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
        // The energy of a chain is a sum, and equations of first order have none.
        let key = system["key"].as_str().unwrap();
        let has_none =
            ["lorenz", "roessler", "lotka_volterra", "fermi_pasta_ulam", "pendulum_chain"].contains(&key);
        for field in ["energy", "energy_unit", "power"] {
            assert_eq!(system[field].is_null(), has_none, "{key}: {field}");
            assert!(system[field] != "", "{key}: {field}");
        }
        let coordinates = system["coordinates"].as_array().unwrap();
        // The further equations state the members beyond the ends of a chain.
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
    let answer = json("list kapitza");
    assert_eq!(answer["systems"][0]["key"], "vertically_driven_pendulum");
    assert_eq!(answer["systems"].as_array().map(Vec::len), Some(1));
    let sheet = text("list damped");
    assert!(sheet.contains("c = 0, in s^(n-2): strength of the damping"), "{sheet}");
    let refused = refusal("list penduum");
    assert!(refused.contains("the nearest oscillators are pendulum"), "{refused}");
}

#[test]
fn one_table_holds_both_catalogues() {
    let table = text("list --csv");
    let answer = json("list");
    let count = |name: &str| answer[name].as_array().map_or(0, Vec::len);
    let (oscillators, systems) = (count("oscillators"), count("systems"));
    assert!(oscillators >= 14 && systems >= 14);
    let rows_of = |catalogue: &str| table.lines().filter(|line| line.starts_with(catalogue)).count();
    assert_eq!([rows_of("oscillators,"), rows_of("systems,")], [oscillators, systems]);
    assert!(matches!(answer["systems"][0]["drive_frequency"], Value::Null));
}

#[test]
fn one_catalogue_leaves_the_other_empty() {
    for (asked, other) in [("oscillators", "systems"), ("systems", "oscillators")] {
        let answer = json(&format!("list {asked}"));
        assert_eq!(answer[asked], json("list")[asked]);
        assert_eq!(answer[other].as_array().map(Vec::len), Some(0));
        assert!(text(&format!("list {asked}")).lines().all(|line| !line.starts_with(&other[..6])));
    }
}

#[test]
fn a_key_of_both_catalogues_shows_both_entries_and_none_twice() {
    let answer = json("list pendulum simple_pendulum duffing");
    let keys = |name: &str| {
        let entries = answer[name].as_array().unwrap().iter();
        entries.map(|entry| entry["key"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(keys("oscillators"), ["pendulum", "duffing"]);
    assert_eq!(keys("systems"), ["pendulum"]);
    let sheets = text("list pendulum duffing");
    assert_eq!(sheets.matches("simple pendulum").count(), 2);
    assert!(sheets.contains("parameter   epsilon = 1"), "{sheets}");
}

#[test]
fn the_former_names_are_hidden_and_show_full_entries() {
    let help = text("--help");
    for (former, key) in [("oscillators", "duffing"), ("systems", "double_pendulum")] {
        assert!(!help.contains(&format!("\n  {former} ")), "{help}");
        assert_eq!(json(former)[former], json(&format!("list {former}"))[former]);
        assert_eq!(text(&format!("{former} {key}")), text(&format!("list {key}")));
        let rows = text(&format!("{former} --csv")).lines().count();
        assert_eq!(rows, 1 + json(former)[former].as_array().map_or(0, Vec::len));
    }
}
