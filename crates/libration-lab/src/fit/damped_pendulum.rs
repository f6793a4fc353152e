//! The equation of motion of a damped pendulum, whose parameters are open.

use super::damping_model::DampingModel;
use libration::decay::DampingKind;
use libration::expression::{Equation, Expression};

/// θ″ = −k sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′|, with zero for kinds of damping that are not there.
pub(super) fn equation(terms: DampingModel) -> Equation {
    let all = "theta'' = -k*sin(theta) - d*sign(theta') - b*theta' - c*theta'*abs(theta')";
    let all: Equation = all.parse().expect("this can be read");
    let kinds = [DampingKind::Dry, DampingKind::Linear, DampingKind::Quadratic];
    let absent = kinds.into_iter().filter(|&term| !terms.has(term));
    let zeros: Vec<_> = absent.map(|term| (symbol(term), Expression::from(0))).collect();
    all.with(&zeros).expect("these are parameters, and zero leaves the acceleration")
}

/// The coefficient of this kind of damping in the equation.
pub(super) fn symbol(term: DampingKind) -> &'static str {
    match term {
        DampingKind::Dry => "d",
        DampingKind::Linear => "b",
        DampingKind::Quadratic => "c",
    }
}
