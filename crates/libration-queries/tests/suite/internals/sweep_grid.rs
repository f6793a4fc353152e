//! The points of a sweep in chunks.

use libration_queries::internals::sweep_grid::Grid;

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
                let (first, last) = (grid.indices_of(points.start), grid.indices_of(points.end - 1));
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
        let scattered = grid.scattered();
        assert_eq!(scattered[0], 0);
        assert!(
            scattered.len() == points.min(16) && scattered.iter().all(|&point| point < points),
            "{scattered:?}"
        );
    }
}
