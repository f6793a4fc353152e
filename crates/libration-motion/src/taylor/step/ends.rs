//! States at the ends of steps.

/// One state component at the ends of the steps, in two words.
#[derive(Clone, Copy, Debug)]
pub struct Ends<const N: usize> {
    pub(in crate::taylor) high: [f64; N],
    pub(in crate::taylor) low: [f64; N],
}
