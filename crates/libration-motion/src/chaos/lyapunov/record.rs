//! The measured growth of a deviation, and its evaluation.

use libration_kernels::elementary::count;

/// Number of blocks into which the record is divided.
pub(super) const BLOCKS: usize = 10;

/// The logarithm of a deviation's size after each interval; zero before the first.
#[derive(Clone, Debug)]
pub struct Record {
    interval: f64,
    /// The logarithm at the end of each interval.
    logarithms: Vec<f64>,
}

impl Record {
    pub fn new(interval: f64) -> Self {
        Self { interval, logarithms: vec![0.0] }
    }

    pub fn push(&mut self, growth: f64) {
        self.logarithms.push(self.last() + growth);
    }

    /// The number of intervals in the record.
    pub fn intervals(&self) -> usize {
        self.logarithms.len() - 1
    }

    fn last(&self) -> f64 {
        self.logarithms[self.intervals()]
    }

    /// The mean rate of growth between the ends of two intervals.
    fn rate(&self, from: usize, to: usize) -> f64 {
        (self.logarithms[to] - self.logarithms[from]) / (self.interval * count(to - from))
    }

    /// Number of initial intervals that are not counted, in which the deviation turns into the direction of growth.
    fn beginning(&self) -> usize {
        self.intervals() / (BLOCKS + 1)
    }

    /// The mean rate of growth: the estimate of the exponent.
    pub fn exponent(&self) -> f64 {
        self.rate(self.beginning(), self.intervals())
    }

    /// The estimate over increasing numbers of intervals, about a fifth more each time, with the time since the beginning.
    pub fn convergence(&self) -> impl Iterator<Item = (f64, f64)> {
        let all = self.intervals();
        let more =
            std::iter::successors(Some(1), |n: &usize| Some(n + 1 + n / 5)).take_while(move |n| *n < all);
        more.chain([all]).map(|n| (self.interval * count(n), self.rate(n / (BLOCKS + 1), n)))
    }

    /// The rate of growth in each block; empty as long as there are fewer intervals than blocks.
    pub fn blocks(&self) -> Vec<f64> {
        let (all, beginning) = (self.intervals(), self.beginning());
        let edge = |block: usize| beginning + (all - beginning) * block / BLOCKS;
        let blocks = if beginning == 0 { 0 } else { BLOCKS };
        (0..blocks).map(|block| self.rate(edge(block), edge(block + 1))).collect()
    }

    /// The variation of the rate; or the exponent itself, if that is larger and the deviation grows or shrinks no more than a power of the time
    /// does, for which the exponent is zero.
    pub fn uncertainty(&self) -> f64 {
        self.variation().max(self.algebraic())
    }

    /// The larger of the standard error of the mean over blocks and the change in the second half of the record.
    pub fn variation(&self) -> f64 {
        let blocks = self.blocks();
        if blocks.is_empty() {
            return f64::INFINITY;
        }
        let mean = blocks.iter().sum::<f64>() / count(BLOCKS);
        let squares = blocks.iter().map(|rate| (rate - mean) * (rate - mean)).sum::<f64>();
        let standard = (squares / count(BLOCKS * (BLOCKS - 1))).sqrt();
        let half = self.rate(self.beginning(), self.intervals().div_ceil(2));
        standard.max((self.exponent() - half).abs())
    }

    /// The magnitude of the exponent if the square of the time, whose factor since the beginning is at most the square of eleven, explains it.
    fn algebraic(&self) -> f64 {
        let by_square = 2.0 * libm::log(count(BLOCKS + 1));
        if self.growth().abs() <= by_square { self.exponent().abs() } else { 0.0 }
    }

    /// The growth of the logarithm since the beginning.
    pub fn growth(&self) -> f64 {
        self.last() - self.logarithms[self.beginning()]
    }

    /// The depth of the deepest valley of the logarithm, below the values before and after it.
    pub fn deepest_valley(&self) -> f64 {
        let running = |highest: &mut f64, now: &f64| {
            *highest = highest.max(*now);
            Some(*highest)
        };
        let before = self.logarithms.iter().scan(f64::NEG_INFINITY, running);
        let mut after: Vec<f64> = self.logarithms.iter().rev().scan(f64::NEG_INFINITY, running).collect();
        after.reverse();
        let rims = before.zip(after).map(|(before, after)| before.min(after));
        rims.zip(&self.logarithms).map(|(rim, now)| rim - now).fold(0.0, f64::max)
    }

    /// The rise of the largest logarithm from the first half of the record to the second, and from the first quarter to the second.
    pub fn rises(&self) -> [f64; 2] {
        let all = self.intervals();
        let highest = |from: usize, to: usize| {
            self.logarithms[from..=to].iter().copied().fold(f64::NEG_INFINITY, f64::max)
        };
        let (half, quarter) = (all / 2, all / 4);
        [highest(half, all) - highest(0, half), highest(quarter, half) - highest(0, quarter)]
    }

    /// The duration of the record.
    pub fn duration(&self) -> f64 {
        self.interval * count(self.intervals())
    }
}
