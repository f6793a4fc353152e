//! One description gives every form of an answer.

use libration_queries::internals::field::{Description, Field, Fields};
use serde_json::Value;

struct Swing {
    period: f64,
    amplitude: Option<f64>,
}

fn fields() -> Fields<Swing> {
    type Of = Field<Swing>;
    Fields::from([
        Of::number("period_s", "s", "period", |swing| swing.period).rounded("T / s", 3).line("period", 5),
        Of::known("amplitude_rad", "rad", "amplitude", |swing| {
            swing.amplitude.ok_or_else(|| "it rotates".to_owned())
        })
        .degrees("θ₀ / °", 3),
        Of::present("KEY_rad", "rad", "the same", |swing| swing.amplitude).in_csv_as("KEY_angle"),
        Of::unnamed().words("kind", |_| "swing".to_owned()),
    ])
}

#[test]
fn one_description_gives_every_form() {
    let (fields, swing) = (fields(), Swing { period: 2.0, amplitude: Some(1.0) });
    let record = Value::from(fields.record(&swing)).to_string();
    assert_eq!(record, r#"{"period_s":2.0,"amplitude_rad":1.0,"KEY_rad":1.0}"#);
    assert_eq!(fields.csv_names_for("a"), ["period_s", "amplitude_rad", "a_angle"]);
    assert_eq!(fields.csv_cells(&swing), ["2.0", "1.0", "1.0"]);
    assert_eq!(fields.cells(&swing), ["2.00", "57.3", "swing"]);
    assert_eq!(fields.lines(&swing), [("period", "2.0000 s".to_owned())]);
    let titles: Vec<String> = fields.columns().into_iter().map(|column| column.title).collect();
    assert_eq!(titles, ["T / s", "θ₀ / °", "kind"]);
    assert_eq!(fields.described("x[].")[0], Description::new("x[].period_s", "s", "period"));
    assert_eq!(fields.described_in_csv()[2].name, "KEY_angle");
}

#[test]
fn what_is_not_there_is_null_left_out_or_empty() {
    let (fields, swing) = (fields(), Swing { period: f64::NAN, amplitude: None });
    let record = Value::from(fields.record(&swing)).to_string();
    let note = "period_s is not defined; amplitude_rad is null: it rotates";
    assert_eq!(record, format!(r#"{{"period_s":null,"amplitude_rad":null,"note":"{note}"}}"#));
    assert_eq!(fields.csv_cells(&swing), ["", "", ""]);
    assert_eq!(fields.cells(&swing), ["nan", "", "swing"]);
    assert_eq!(fields.lines(&swing), [("period", "none".to_owned())]);
}
