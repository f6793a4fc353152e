//! The periods of many swings with related quantities, stage by stage.

use super::amplitude::{SMALLEST_HALVED, condition_of, period_of_quarter, slope_of};
use super::period::{Excess, Nearer, Ratio, Rounding, amplitude_above, ratio_above};
use super::period_stages::Stages;
use super::{Amplitude, LengthMismatch, Pendulum, SwingPeriod};
use libration_kernels::dispatch::{Kernel, dispatch_slices};
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::double_double::{DoubleDouble, pick};
use libration_kernels::elementary::two_word;
use libration_kernels::internals::elliptic::SwingStages;

impl Pendulum {
    /// [`swing_period`](Self::swing_period) of each amplitude, bit for bit, several times as fast.
    ///
    /// # Errors
    /// The slices have different lengths.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::{Amplitude, Pendulum};
    /// let pendulum = Pendulum::new(1.0, 9.81)?;
    /// let amplitudes = [Amplitude::new("60deg".parse()?)?, Amplitude::new("pi-1e-9".parse()?)?];
    /// let mut periods = amplitudes.map(|_| Default::default());
    /// pendulum.swing_periods(&amplitudes, &mut periods)?;
    /// assert_eq!(periods[1], pendulum.swing_period(&amplitudes[1]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn swing_periods(
        &self,
        amplitudes: &[Amplitude],
        periods: &mut [SwingPeriod],
    ) -> Result<(), LengthMismatch> {
        LengthMismatch::check_lengths(amplitudes.len(), periods.len())?;
        let frequency = self.angular_frequency_words();
        dispatch_slices(Each { amplitudes, frequency, periods });
        for (amplitude, period) in amplitudes.iter().zip(periods) {
            if !is_regular(amplitude) {
                *period = self.swing_period(amplitude);
            }
        }
        Ok(())
    }
}

/// Returns `true` if half of the amplitude's complement is a normal number.
#[inline(always)]
fn is_regular(amplitude: &Amplitude) -> bool {
    amplitude.angle.complement_words().to_f64() >= SMALLEST_HALVED
}

struct Each<'a> {
    amplitudes: &'a [Amplitude],
    frequency: DoubleDouble,
    periods: &'a mut [SwingPeriod],
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let mut block = Block::ZERO;
        let mut all = [SwingPeriod::default(); BLOCK];
        for (amplitudes, periods) in self.amplitudes.chunks(BLOCK).zip(self.periods.chunks_mut(BLOCK)) {
            block.load(amplitudes);
            block.halves();
            block.modulus.block(&block.sine, &block.cosine);
            block.ratios();
            block.write(self.frequency, &mut all);
            periods.copy_from_slice(&all[..periods.len()]);
        }
    }
}

/// Results of each stage for the next.
#[repr(align(64))]
struct Block {
    amplitude: Words,
    complement: Words,
    /// Sine and cosine of half the amplitude, k and k′.
    sine: Words,
    cosine: Words,
    modulus: SwingStages,
    period: Stages,
}

impl Block {
    const ZERO: Self = Self {
        amplitude: Words::ZERO,
        complement: Words::ZERO,
        sine: Words::ZERO,
        cosine: Words::ZERO,
        modulus: SwingStages::ZERO,
        period: Stages::ZERO,
    };

    /// Loads the block. One radian stands in for amplitudes that are not regular and for unused elements.
    #[inline(always)]
    fn load(&mut self, amplitudes: &[Amplitude]) {
        for i in 0..BLOCK {
            let one = (DoubleDouble::ONE, DoubleDouble::PI - DoubleDouble::ONE);
            let regular = amplitudes.get(i).filter(|amplitude| is_regular(amplitude));
            let (amplitude, complement) = regular
                .map_or(one, |regular| (regular.angle.in_turn_words(), regular.angle.complement_words()));
            self.amplitude.set(i, amplitude);
            self.complement.set(i, complement);
        }
    }

    #[inline(always)]
    fn halves(&mut self) {
        let is_low = |complement: DoubleDouble| complement.hi > std::f64::consts::FRAC_PI_2;
        let (mut halves, mut sines, mut cosines) = (Words::ZERO, Words::ZERO, Words::ZERO);
        for i in 0..BLOCK {
            let (amplitude, complement) = (self.amplitude.get(i), self.complement.get(i));
            halves.set(i, pick(is_low(complement), amplitude, complement).scaled(0.5));
        }
        two_word::sin_cos_series_of_block(&halves, &mut sines, &mut cosines);
        for i in 0..BLOCK {
            let (sine, cosine) = (sines.get(i), cosines.get(i));
            let low = is_low(self.complement.get(i));
            self.sine.set(i, pick(low, sine, cosine));
            self.cosine.set(i, pick(low, cosine, sine));
        }
    }

    #[inline(always)]
    fn ratios(&mut self) {
        for i in 0..BLOCK {
            let (amplitude, complement) = (self.amplitude.get(i), self.complement.get(i));
            let Nearer { s, u } = Nearer::new(amplitude_above(amplitude.hi), amplitude, complement);
            self.period.s.set(i, s);
            self.period.u.set(i, u);
        }
        self.period.excess();
        self.period.log();
    }

    #[inline(always)]
    fn write(&self, frequency: DoubleDouble, all: &mut [SwingPeriod; BLOCK]) {
        for (i, period) in all.iter_mut().enumerate() {
            let (amplitude, first) = (self.amplitude.get(i), self.modulus.first.get(i));
            let (above, below) = (amplitude_above(amplitude.hi), self.period.excess.get(i));
            let ratio = ratio_above(below, self.period.log.get(i));
            let twice = self.cosine.get(i).scaled(2.0);
            let slope = slope_of(self.sine.get(i), self.modulus.cosine_part.get(i), first, twice);
            *period = SwingPeriod {
                period: period_of_quarter(first, frequency),
                ratio: Ratio::round(above, below, ratio),
                excess: Excess::round(above, below, ratio),
                nome: self.modulus.nome[i],
                condition: condition_of(amplitude, slope),
            };
        }
    }
}
