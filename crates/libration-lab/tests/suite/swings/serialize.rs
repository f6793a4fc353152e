//! What is found as data, with the feature `serde`.

use super::{SWING, found, of_length, trace};
use serde_json::{json, to_value};

#[test]
fn a_fit_of_swings_is_its_numbers_names_and_doubts() {
    let swings = found(&[trace(&SWING)], &of_length(1.2, Some(1e-4)));
    let value = to_value(&swings).unwrap();
    let parameter = &value["fit"]["parameters"][0];
    assert_eq!(parameter["name"], json!(swings.fit.parameters[0].name));
    assert_eq!(parameter["estimate"]["value"], json!(swings.fit.parameters[0].estimate.value));
    assert_eq!(value["fit"]["damping"], json!("linear"));
    assert_eq!(value["cycles"][0]["t0"]["value"], json!(swings.cycles[0].as_ref().unwrap().t0.value));
    assert_eq!(value["comparison"], json!(null));
    assert_eq!(value["warnings"].as_array().unwrap().len(), swings.warnings.len());
    assert!(value["pendulum"]["gravity"]["budget"]["g"].is_f64(), "{}", value["pendulum"]);
}
