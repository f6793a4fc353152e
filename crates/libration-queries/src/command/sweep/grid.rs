//! The grid of a sweep in chunks: blocks of the grid that are runs of points, too, where the last axis varies fastest.

use std::ops::Range;

/// The points of all combinations of values, divided into chunks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Number of values of each axis.
    pub(crate) shape: Vec<usize>,
    /// Number of values of each axis in a chunk, except the last chunks.
    pub(crate) block: Vec<usize>,
}

impl Grid {
    /// Approximate number of chunks by default.
    const CHUNKS: usize = 256;

    /// Creates a grid with chunks of at most `most` points; `None` if there are too many points to count.
    pub fn new(shape: Vec<usize>, most: Option<usize>) -> Option<Self> {
        let points = shape.iter().try_fold(1_usize, |all, &length| all.checked_mul(length))?;
        let mut room = most.unwrap_or(points.div_ceil(Self::CHUNKS)).max(1);
        let mut block = vec![1; shape.len()];
        for (length, side) in shape.iter().zip(&mut block).rev() {
            let pieces = length.div_ceil(room.min(*length));
            *side = length.div_ceil(pieces);
            if pieces > 1 {
                break;
            }
            room /= length;
        }
        Some(Self { shape, block })
    }

    /// The number of points.
    pub fn points(&self) -> usize {
        self.shape.iter().product()
    }

    /// The number of chunks.
    pub fn chunks(&self) -> usize {
        self.pieces().product()
    }

    /// Number of chunks along each axis.
    fn pieces(&self) -> impl Iterator<Item = usize> + '_ {
        self.shape.iter().zip(&self.block).map(|(length, side)| length.div_ceil(*side))
    }

    /// The points of a chunk.
    pub fn points_of(&self, chunk: usize) -> Range<usize> {
        let pieces: Vec<usize> = self.pieces().collect();
        let indices = place_in(&pieces, chunk);
        let mut range = 0..1;
        for ((length, size), number) in self.shape.iter().zip(&self.block).zip(indices) {
            // Along the axes behind the one that is cut a block has all values, so that it stays a run.
            let (first, end) = (number * size, ((number + 1) * size).min(*length));
            range = range.start * length + first..(range.end - 1) * length + end;
        }
        range
    }

    /// The index of a point on each axis.
    pub fn indices_of(&self, point: usize) -> Vec<usize> {
        place_in(&self.shape, point)
    }

    /// Some points far from each other, beginning with the first of the grid.
    pub fn scattered(&self) -> Vec<usize> {
        const BITS: u32 = 4;
        let points = self.points();
        let mut scattered: Vec<usize> = vec![];
        for number in 0..1_usize << BITS {
            let part = number.reverse_bits() >> (usize::BITS - BITS);
            let point = points / (1 << BITS) * part + points % (1 << BITS) * part / (1 << BITS);
            if !scattered.contains(&point) {
                scattered.push(point);
            }
        }
        scattered
    }
}

fn place_in(lengths: &[usize], mut number: usize) -> Vec<usize> {
    let mut indices = vec![0; lengths.len()];
    for (length, index) in lengths.iter().zip(&mut indices).rev() {
        *index = number % length;
        number /= length;
    }
    indices
}
