//! The systems of the comparison as Rust functions.

/// The time derivatives of a state.
pub(crate) trait Rates<const N: usize> {
    fn at(&self, time: f64, state: &[f64; N]) -> [f64; N];
}

#[derive(Clone, Copy)]
pub(crate) struct Pendulum;

impl Rates<2> for Pendulum {
    fn at(&self, _: f64, &[angle, velocity]: &[f64; 2]) -> [f64; 2] {
        [velocity, -angle.sin()]
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Driven;

impl Rates<2> for Driven {
    fn at(&self, time: f64, &[angle, velocity]: &[f64; 2]) -> [f64; 2] {
        [velocity, 1.2 * (2.0 / 3.0 * time).cos() - angle.sin() - velocity / 2.0]
    }
}

/// The driven pendulum with the time as a third component. `Dop853` of `ode_solvers` 0.6.2 has 0 instead of 1 as its last node, so that rates
/// that depend on the time come out wrong.
#[derive(Clone, Copy)]
pub(crate) struct DrivenWithClock;

impl Rates<3> for DrivenWithClock {
    fn at(&self, _: f64, &[angle, velocity, clock]: &[f64; 3]) -> [f64; 3] {
        let [velocity, acceleration] = Driven.at(clock, &[angle, velocity]);
        [velocity, acceleration, 1.0]
    }
}

/// Two equal rods without mass and two equal bobs, g = l = 1.
#[derive(Clone, Copy)]
pub(crate) struct Double;

impl Rates<4> for Double {
    fn at(&self, _: f64, &[a, b, u, w]: &[f64; 4]) -> [f64; 4] {
        let (sine, cosine) = (a - b).sin_cos();
        let p = sine * w * w + 2.0 * a.sin();
        let q = sine * u * u - b.sin();
        let acceleration = -(p + cosine * q) / (1.0 + sine * sine);
        [u, w, acceleration, q - cosine * acceleration]
    }
}
