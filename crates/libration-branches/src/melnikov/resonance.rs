//! Resonances of a pendulum with its drive: positions, widths, and overlap of neighbours.

use super::perturbation::PerturbedPendulum;
use libration_kernels::elementary::count;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress, Stage};
use libration_numbers::roots::{Tolerance, zero_between};
use libration_pendulum::pendulum::{Amplitude, Motion, Pendulum, Regime};
use std::f64::consts::TAU;

/// A motion of the unperturbed pendulum whose frequency is p/q of the drive frequency, and the effect of the drive on it.
///
/// Near this motion the phase relative to the drive moves like a pendulum:
/// to first order of the perturbation it is locked within the half-width.
#[derive(Clone, Debug)]
pub struct DriveResonance {
    /// The number p of periods, or turns, of the motion.
    pub motion_periods: u32,
    /// The number q of drive periods in the same time.
    pub drive_periods: u32,
    /// 1 or −1 for rotation, 0 for libration.
    pub direction: f64,
    /// The unperturbed motion, passing upwards through the bottom at t = 0.
    pub motion: Motion,
    /// Mean power of the perturbation averaged over the phase of the motion, per m·l², in rad²/s³: negative for damping.
    pub mean_power: f64,
    /// Amplitude of the power that depends on the phase relative to the drive, per m·l², in rad²/s³.
    pub resonant_power: f64,
    /// Bound on the errors of both powers.
    pub error: f64,
    /// Half the width of the resonance in the action, per m·l², in rad²/s, without damping.
    pub half_width: f64,
}

impl DriveResonance {
    /// Half the width in the frequency, in rad/s.
    #[must_use]
    pub fn half_width_in_frequency(&self) -> f64 {
        self.half_width * self.motion.frequency_slope().abs()
    }

    /// Bound on the error of the half-width from that of the power; the error of the first-order theory is not included.
    #[must_use]
    pub fn half_width_error(&self) -> f64 {
        0.5 * self.half_width * self.error / self.resonant_power + 8.0 * f64::EPSILON * self.half_width
    }

    /// Factor by which the drive must be multiplied to maintain such a motion
    /// against the damping: the threshold of the subharmonic Melnikov function.
    #[must_use]
    pub fn threshold_factor(&self) -> f64 {
        self.mean_power.abs() / self.resonant_power
    }

    /// The sum of the half-widths of two resonances over their distance, in the action. By Chirikov's criterion motions between them are chaotic
    /// from 1 on, by experience from about 2/3. `None` between libration and rotation, and between rotations of opposite directions.
    #[must_use]
    pub fn overlap(&self, other: &Self) -> Option<f64> {
        let distance = (self.motion.action() - other.motion.action()).abs();
        (self.direction.total_cmp(&other.direction).is_eq() && distance > 0.0)
            .then(|| (self.half_width + other.half_width) / distance)
    }
}

impl PerturbedPendulum {
    /// The resonances p:q of the perturbation to first order, up to a largest q, for the harmonics p of the drive: librations, then rotations in
    /// either direction, each by ascending action. Empty without a drive.
    ///
    /// # Errors
    /// The call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::melnikov::PerturbedPendulum;
    /// use libration::progress::Quiet;
    /// // A wave that moves with the angle: the half-width of its resonance in the velocity is 2·√0.01.
    /// let driven = PerturbedPendulum::new(&"x'' + 1e-6 sin(x) = -0.01 sin(x - t)".parse()?)?;
    /// let resonances = driven.resonances(1, &Quiet)?;
    /// let rotation = resonances.iter().find(|it| it.direction > 0.0).ok_or("none")?;
    /// assert!((rotation.half_width - 0.2).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    /// B. V. Chirikov, Physics Reports 52 (1979) 263, doi:10.1016/0370-1573(79)90023-1.
    pub fn resonances(
        &self,
        largest: u32,
        progress: &dyn Progress,
    ) -> Result<Vec<DriveResonance>, Interrupted> {
        let watch = &Watch::new(progress);
        let Some(drive) = self.frequency() else { return Ok(vec![]) };
        let harmonics = u32::try_from(self.harmonics()).unwrap_or(0);
        let pairs = || (1..=harmonics).flat_map(move |p| (1..=largest).map(move |q| (p, q)));
        watch.begin(Stage::Whole, Some(pairs().count()));
        let mut resonances = vec![];
        for (done, (p, q)) in pairs().filter(|(p, q)| gcd(*p, *q) == 1).enumerate() {
            watch.reached(done)?;
            let frequency = drive * f64::from(p) / f64::from(q);
            let motions = [self.libration(frequency), self.rotation(frequency), self.rotation(frequency)];
            let directions = motions.into_iter().zip([0.0, 1.0, -1.0]);
            for (motion, direction) in directions {
                let Some(motion) = motion else { continue };
                resonances.extend(self.resonance([p, q], direction, motion, watch)?);
            }
        }
        // 0, 1, −1.
        let regime = |resonance: &DriveResonance| (resonance.direction - 0.4).abs();
        resonances.put_in_order(|a, b| {
            regime(a).total_cmp(&regime(b)).then(a.motion.action().total_cmp(&b.motion.action()))
        });
        Ok(resonances)
    }

    fn pendulum(&self) -> Option<Pendulum> {
        Pendulum::from_angular_frequency(self.omega0()).ok()
    }

    /// The libration with this frequency, beginning upwards at the bottom.
    fn libration(&self, frequency: f64) -> Option<Motion> {
        let amplitude = Amplitude::from_period_ratio(self.omega0() / frequency).ok()?;
        let sine = libm::sin(0.5 * amplitude.radians());
        let motion = match amplitude.radians() < 2.0 {
            true => self.pendulum()?.with_energy_ratio(sine * sine),
            false => {
                let cosine = libm::sin(0.5 * amplitude.complement());
                self.pendulum()?.with_energy_excess(-cosine * cosine)
            }
        };
        motion.ok().filter(|motion| motion.regime() == Regime::Libration)
    }

    /// The rotation with this frequency towards growing angles; the other one is its mirror image.
    fn rotation(&self, frequency: f64) -> Option<Motion> {
        let pendulum = self.pendulum()?;
        let of = |log: f64| pendulum.with_energy_excess(libm::exp(log));
        let excess = |log: f64| of(log).map_or(f64::NAN, |motion| motion.frequency() - frequency);
        /// Range of the logarithm of the energy excess: from motions next to the separatrix to those without an effect of gravity.
        const ENDS: [f64; 2] = [-600.0, 60.0];
        let log = zero_between(ENDS.map(|log| (log, excess(log))), Tolerance::LAST_BIT, excess)?;
        of(log).ok().filter(|motion| motion.regime() == Regime::Rotation)
    }

    /// The resonance; `None` if the perturbation has none of this order to first order.
    fn resonance(
        &self,
        [p, q]: [u32; 2],
        direction: f64,
        motion: Motion,
        watch: &Watch<'_>,
    ) -> Result<Option<DriveResonance>, Interrupted> {
        let mirror = if direction < 0.0 { -1.0 } else { 1.0 };
        let (powers, error) = self.mean_powers(&motion, p, mirror, watch)?;
        // The strongest multiple j, whose wave has jq periods of the phase.
        let multiples = (1..).zip(powers.iter().skip(p as usize).step_by(p as usize));
        let strongest = multiples
            .map(|(multiple, power)| (multiple, 2.0 * power.abs()))
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|(_, power)| *power > 4.0 * error);
        let Some((multiple, power)) = strongest else { return Ok(None) };
        let wave = count(multiple) * f64::from(q);
        let half_width = 2.0 * (power / (motion.frequency() * wave * motion.frequency_slope().abs())).sqrt();
        Ok(Some(DriveResonance {
            motion_periods: p,
            drive_periods: q,
            direction,
            motion,
            mean_power: powers[0].re,
            resonant_power: power,
            error,
            half_width,
        }))
    }

    /// Means of θ′·gₖ·e^{ikΩt} over a period of the motion for each harmonic k that is a
    /// multiple of p, and a bound on their errors: by equal steps, halved until nothing changes. A force with kinks, whose changes fall by a power of the
    /// steps, is known as well as its half-widths are shown long before.
    fn mean_powers(
        &self,
        motion: &Motion,
        p: u32,
        mirror: f64,
        watch: &Watch<'_>,
    ) -> Result<(Vec<Complex>, f64), Interrupted> {
        /// Rounding error relative to the sum of the magnitudes.
        const ROUNDING: f64 = 4e-15;
        /// Error relative to that sum with which a force with kinks is known well enough: half-widths have six digits.
        const KINKED: f64 = 1e-12;
        /// Ratio of a change to the last one from which there is a kink: a jump of the nth derivative has 2^−(n + 1).
        const SLOW: f64 = 1.0 / 256.0;
        const FEWEST: u32 = 64;
        const DOUBLINGS: u32 = 9;
        let mut steps = FEWEST;
        let (mut means, mut size) = self.means(motion, p, mirror, [0.0, f64::from(steps)], watch)?;
        let mut change = f64::INFINITY;
        for _ in 0..DOUBLINGS {
            let between = self.means(motion, p, mirror, [0.5, f64::from(steps)], watch)?;
            steps *= 2;
            let half_the_differences: Vec<Complex> =
                between.0.iter().zip(&means).map(|(a, b)| (*a - *b).scaled(0.5)).collect();
            let last = change;
            change = half_the_differences.iter().map(|half| half.abs()).fold(0.0, f64::max);
            means = means.iter().zip(&half_the_differences).map(|(mean, half)| *mean + *half).collect();
            size = 0.5 * (size + between.1);
            if change <= if change > SLOW * last { KINKED } else { ROUNDING } * size {
                break;
            }
        }
        Ok((means, change + ROUNDING * size))
    }

    /// Means over equal steps, of which the first begins at this part of a step.
    fn means(
        &self,
        motion: &Motion,
        p: u32,
        mirror: f64,
        [first, steps]: [f64; 2],
        watch: &Watch<'_>,
    ) -> Result<(Vec<Complex>, f64), Interrupted> {
        let mut sums = vec![Complex::default(); self.harmonics() + 1];
        let mut size = 0.0;
        let drive = self.frequency().unwrap_or(0.0);
        let mut step = first;
        while step < steps {
            watch.go_on()?;
            let time = step / steps * motion.period();
            let state = motion.state_at(time);
            let (angle, velocity) = (mirror * state.angle, mirror * state.velocity);
            let (values, left) = self.harmonics_at(angle, velocity);
            let weight = velocity / steps;
            for ((k, value), sum) in (0_u32..).zip(&values).zip(&mut sums) {
                if k % p == 0 {
                    *sum = *sum + (*value * Complex::unit(f64::from(k) * drive * time)).scaled(weight);
                    size += value.abs() * weight.abs();
                }
            }
            size += left * weight.abs() * TAU;
            step += 1.0;
        }
        Ok((sums, size))
    }
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}
