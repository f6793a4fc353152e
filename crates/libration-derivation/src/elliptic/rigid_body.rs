//! The physical pendulum: a rigid body that rotates about a horizontal axis.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, cos, derivative, integral, letter, number, sin, sqrt, tenths,
};
use super::super::trials::Trials;
use super::super::words::{omega_0, period_ratio, small_swing_period};

fn mass() -> Formula {
    letter("M")
}

/// The distance of the centre of mass from the axis.
fn distance() -> Formula {
    letter("d")
}

/// The moment of inertia about the axis.
fn inertia() -> Formula {
    letter("I")
}

/// The moment of inertia about the parallel axis through the centre of mass.
fn own_inertia() -> Formula {
    Name::new("I").word("C").into()
}

/// The length of the simple pendulum with the same period.
fn reduced_length(distance: Formula) -> Formula {
    distance.clone() + own_inertia() / (mass() * distance)
}

pub(super) fn step(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let velocity = || Formula::from(Name::new("θ").prime());
    let acceleration = || Formula::from(Name::new("θ").prime().prime());
    let trials = trials
        .with(&Name::new("M"), tenths(3))?
        .with(&Name::new("d"), tenths(4))?
        .with(&Name::new("L"), tenths(9))?
        .with(&Name::new("I").word("C"), tenths(1) / 5)?
        .with(&Name::new("I"), own_inertia() + mass() * distance().squared())?;
    let weight = || mass() * letter("g") * distance();
    let energy = inertia() * velocity().squared() / 2 - weight() * cos(letter("θ"));
    let rate = velocity() * (inertia() * acceleration() + weight() * sin(letter("θ")));
    let conserved = Statement::equal(derivative(energy, "t"), rate);
    let law = Statement::equal(acceleration(), -(weight() / inertia() * sin(letter("θ"))));
    let frequency = Statement::defined(omega_0().squared(), weight() / inertia());
    let parallel = Statement::equal(inertia(), own_inertia() + mass() * distance().squared());
    let length = Statement::equal(inertia() / (mass() * distance()), reduced_length(distance()));
    let other = own_inertia() / (mass() * distance());
    let reversed = Statement::equal(reduced_length(other), reduced_length(distance()));
    let rod = || letter("L");
    let of_rod = integral("s", 0, rod(), mass() / rod() * letter("s").squared());
    let of_rod = Statement::equal(of_rod, mass() * rod().squared() / 3);
    let length_of_rod =
        Statement::equal((mass() * rod().squared() / 3) / (mass() * (rod() / 2)), number(2) * rod() / 3);
    Ok(DerivationStep::new("rigid-body", "Any rigid body")
        .say(
            "Nothing in this needs the mass to be at the end of a rod. A rigid body of mass {} turns about a horizontal axis; its centre of \
             mass is at the distance {} from it, and its moment of inertia about it is {}. Its energy changes at the rate",
            [mass(), distance(), inertia()],
        )
        .show(trials.compare(conserved)?)
        .say("which is zero, so that between its turning points", [])
        .show(CheckedEquation::premise(law))
        .say("This is the equation above, with", [])
        .show(CheckedEquation::definition(frequency))
        .say(
            "So {} is the same function of the amplitude for every body, and all of the above holds; only {} is the body’s own. The centre \
             of mass alone does not give it: the moment of inertia is needed too. With that about the centre of mass, {}, the \
             theorem of parallel axes says",
            [period_ratio(), small_swing_period(), own_inertia()],
        )
        .show(CheckedEquation::premise(parallel))
        .say("and the simple pendulum of the same period has the length", [])
        .show(trials.compare_once(length)?)
        .say(
            "which is always more than {}. Hung from a parallel axis at this distance from the first, beyond the centre of mass, the body \
             swings with the same period: Kater’s pendulum is turned over to find this length.",
            [distance()],
        )
        .show(trials.compare_once(reversed)?)
        .say("A uniform rod of length {} that hangs by its end has the moment of inertia", [rod()])
        .show(trials.compare_once(of_rod)?)
        .say("and swings like a simple pendulum of two thirds of its length,", [])
        .show(trials.compare_once(length_of_rod)?)
        .say("with {} for very small swings.", [2 * Formula::Pi * sqrt(2 * rod() / (3 * letter("g")))]))
}
