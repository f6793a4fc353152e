//! The grid of a sweep in chunks: blocks of the grid that are runs of points, too, where the last axis varies fastest.

use std::ops::Range;

/// The points of all combinations of values, cut into chunks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Grid {
    /// How many values each axis has.
    pub(crate) shape: Vec<usize>,
    /// How many values of each axis a chunk has, but for the last chunks.
    pub(crate) block: Vec<usize>,
}

impl Grid {
    /// Without another wish there are about so many chunks.
    const CHUNKS: usize = 256;

    /// With chunks of at most so many points; `None` where there are too many points to count.
    pub(crate) fn new(shape: Vec<usize>, most: Option<usize>) -> Option<Self> {
        let points = shape.iter().try_fold(1_usize, |all, &length| all.checked_mul(length))?;
        let mut room = most.unwrap_or(points.div_ceil(Self::CHUNKS)).max(1);
        let mut block = vec![1; shape.len()];
        for (length, own) in shape.iter().zip(&mut block).rev() {
            let pieces = length.div_ceil(room.min(*length));
            *own = length.div_ceil(pieces);
            if pieces > 1 {
                break;
            }
            room /= length;
        }
        Some(Self { shape, block })
    }

    pub(crate) fn points(&self) -> usize {
        self.shape.iter().product()
    }

    pub(crate) fn chunks(&self) -> usize {
        self.pieces().product()
    }

    /// How many chunks there are along each axis.
    fn pieces(&self) -> impl Iterator<Item = usize> + '_ {
        self.shape.iter().zip(&self.block).map(|(length, own)| length.div_ceil(*own))
    }

    /// The points of a chunk.
    pub(crate) fn points_of(&self, chunk: usize) -> Range<usize> {
        let pieces: Vec<usize> = self.pieces().collect();
        let place = place_in(&pieces, chunk);
        let mut range = 0..1;
        for ((length, own), number) in self.shape.iter().zip(&self.block).zip(place) {
            // Along the axes behind the one that is cut a block has all values, so that it stays a run.
            let (first, end) = (number * own, ((number + 1) * own).min(*length));
            range = range.start * length + first..(range.end - 1) * length + end;
        }
        range
    }

    /// The place of a point on each axis.
    pub(crate) fn place(&self, point: usize) -> Vec<usize> {
        place_in(&self.shape, point)
    }

    /// Some points, far from each other, of which the first is the first of the grid.
    pub(crate) fn scattered(&self) -> Vec<usize> {
        const BITS: u32 = 4;
        let points = self.points();
        let mut found: Vec<usize> = vec![];
        for number in 0..1_usize << BITS {
            let part = number.reverse_bits() >> (usize::BITS - BITS);
            let point = points / (1 << BITS) * part + points % (1 << BITS) * part / (1 << BITS);
            if !found.contains(&point) {
                found.push(point);
            }
        }
        found
    }
}

fn place_in(lengths: &[usize], mut number: usize) -> Vec<usize> {
    let mut place = vec![0; lengths.len()];
    for (length, own) in lengths.iter().zip(&mut place).rev() {
        *own = number % length;
        number /= length;
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_are_runs_that_cover_the_grid() {
        let shapes: [&[usize]; 6] = [&[1], &[7], &[5, 4], &[3, 1, 8], &[100, 100], &[2, 3, 4, 5]];
        for shape in shapes {
            for most in [None, Some(1), Some(3), Some(4), Some(20), Some(33), Some(100_000)] {
                let grid = Grid::new(shape.to_vec(), most).unwrap();
                let mut next = 0;
                for chunk in 0..grid.chunks() {
                    let points = grid.points_of(chunk);
                    assert_eq!(points.start, next, "{shape:?} {most:?}");
                    assert!(points.len() <= most.unwrap_or(usize::MAX) && !points.is_empty());
                    // A block, too: the place of its last point is that of its first and the lengths of the block.
                    let (first, last) = (grid.place(points.start), grid.place(points.end - 1));
                    let lengths = first.iter().zip(&last).map(|(first, last)| last + 1 - first);
                    assert_eq!(lengths.product::<usize>(), points.len(), "{shape:?} {most:?}");
                    next = points.end;
                }
                assert_eq!(next, grid.points());
            }
        }
    }

    #[test]
    fn there_are_a_few_hundred_chunks_without_another_wish() {
        let chunks = |shape: &[usize]| Grid::new(shape.to_vec(), None).unwrap().chunks();
        assert_eq!([chunks(&[200]), chunks(&[1_000_000]), chunks(&[100, 100])], [200, 256, 300]);
        assert!(Grid::new(vec![usize::MAX, 2], None).is_none());
    }

    #[test]
    fn scattered_points_are_points_of_the_grid() {
        for points in [1, 2, 15, 16, 17, 1000, usize::MAX] {
            let grid = Grid::new(vec![points], None).unwrap();
            let found = grid.scattered();
            assert_eq!(found[0], 0);
            assert!(found.len() == points.min(16) && found.iter().all(|&point| point < points), "{found:?}");
        }
    }
}
