use libration::decay::{Damping, PowerLawTerm};
use libration::expression::Equation;
use libration::internals::decay::{EFFORT, GrowingCoordinate, HalfSwing};
use libration::progress::Quiet;
use libration::taylor::{Moment, System, integrate};

#[test]
fn the_equation_is_that_of_its_text() {
    let terms = [(0.0, 0.25), (0.5, 0.1), (1.0, 1e-300), (2.0, 3.0), (2.7, 7.5)];
    let terms = terms.map(|(exponent, coefficient)| PowerLawTerm { exponent, coefficient });
    let damping = Damping::new(&terms).unwrap();
    let text: String =
        terms.iter().map(|term| format!(" - {:e}*(x')^{:e}", term.coefficient, term.exponent)).collect();
    let text: Equation = format!("x'' = sin(x){text}").parse().unwrap();
    let state = [0.7, 0.3];
    let start = Moment { time: 0.0, state: state.to_vec() };
    let HalfSwing { from_top: GrowingCoordinate { system, .. }, .. } = HalfSwing::new(&damping);
    let velocity = |system: &System| {
        let end = integrate(system, &start, &[0.01], &EFFORT, &Quiet).unwrap().end;
        end.state[1]
    };
    assert!(velocity(&system).is_finite());
    assert_eq!(velocity(&system).to_bits(), velocity(&System::new(&text).unwrap()).to_bits());
}
