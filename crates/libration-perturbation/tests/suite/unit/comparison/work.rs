use libration::expression::{Equation, Expression};
use libration::internals::comparison::WorkOverOrbits;
use libration::progress::Quiet;
use libration_numbers::internals::progress::Watch;

/// Forces that take what they give: of the place alone, and even in the velocity about a centre that is one for both.
#[test]
fn forces_without_work_have_none_within_what_is_stated() {
    for equation in ["x'' + sin(x) = 0", "x'' + x + x^3 = 0", "x'' + x + x^2/10 = 0", "x'' + 4*x - x^5 = 0"] {
        let equation: Equation = equation.parse().unwrap();
        for force in ["x^2", "x^3 + 1", "x'^2", "x*x'^2 + x'^4"] {
            let force: Expression = force.parse().unwrap();
            let work = WorkOverOrbits::new(&equation, &force, 0.0).unwrap();
            for step in 1..40 {
                let computed = work.at(0.03 * f64::from(step), &Watch::new(&Quiet)).unwrap();
                assert!(computed.value.abs() <= computed.uncertainty, "{computed:?}");
            }
        }
    }
}
