//! The places of axes in a question.

use libration_queries::QueryError;
use libration_queries::internals::sweep_axis::{Axis, axis};
use libration_queries::internals::sweep_question::Template;

fn template(words: &str, axes: &[&str]) -> Result<Vec<String>, QueryError> {
    let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
    let axes: Vec<Axis> = axes.iter().map(|text| axis(text).unwrap()).collect();
    Template::new(&words, &axes).map(|template| template.0)
}

#[test]
fn axes_go_where_the_question_has_their_name() {
    let words = |words, axes: &[&str]| template(words, axes).unwrap().join(" ");
    assert_eq!(words("period", &["amplitude=1deg,2deg"]), "period {amplitude}");
    assert_eq!(words("period {a} --length 2m", &["a=1,2"]), "period {a} --length 2m");
    assert_eq!(words("period 1", &["length=1m,2m"]), "period 1 --length {length}");
    assert_eq!(words("fit trace --length 1m", &["file=a,b"]), "fit trace {file} --length 1m");
    assert_eq!(
        words("lyapunov driven_pendulum --initial theta=0.2", &["A=1,2", "theta'=0,1", "tolerance=1e-9"]),
        "lyapunov driven_pendulum --initial theta=0.2,theta'={theta'} --tolerance {tolerance} --set A={A}"
    );
    assert_eq!(words("lyapunov x''=-k*x", &["x=1", "k=2"]), "lyapunov x''=-k*x --initial x={x} --set k={k}");
}

#[test]
fn options_stay_before_two_dashes() {
    let words = template("lyapunov --initial=theta=0.2 -- driven_pendulum", &["A=1,2", "theta'=1"]).unwrap();
    assert_eq!(
        words.join(" "),
        "lyapunov --initial=theta=0.2,theta'={theta'} --set A={A} -- driven_pendulum"
    );
}

#[test]
fn axes_without_a_place_are_refused() {
    let refused = |words, axes: &[&str]| template(words, axes).unwrap_err().to_string();
    assert!(refused("period 60deg", &["B=1,2"]).contains("`B` is not an option of `period`"));
    assert!(refused("completions bash", &["B=1,2"]).contains("not a query with numbers"));
    assert!(refused("nonsense", &["B=1,2"]).contains("not a query with numbers"));
}

#[test]
fn values_stand_at_every_place_of_their_name() {
    let axes = [axis("a=1,2").unwrap(), axis("b=x,y").unwrap()];
    let template = Template(["p", "{a}", "q={b}{a}", "{c}"].map(str::to_owned).to_vec());
    assert_eq!(template.at(&axes, &[1, 0]), ["p", "2", "q=x2", "{c}"]);
}
