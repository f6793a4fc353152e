//! Rows out of the order of time: moved to their positions in time, left out, or the run divided if its clock was set back.

use libration_lab::internals::measurement::traces::sequence::Sequence;

fn even(rows: u32) -> Vec<f64> {
    (0..rows).map(|row| 0.01 * f64::from(row)).collect()
}

#[test]
fn rows_out_of_place_are_put_back_and_wrong_times_left_out() {
    let mut times = even(100);
    times.swap(40, 41);
    times[70] = 300.0;
    let sequence = Sequence::new(&times).unwrap();
    assert_eq!((sequence.moved.as_slice(), sequence.left_out.as_slice()), (&[40][..], &[70][..]));
    assert_eq!(sequence.pieces[0].len(), 99);
    assert!(sequence.pieces[0].windows(2).all(|pair| times[pair[0]] < times[pair[1]]));
}

#[test]
fn a_clock_that_is_set_back_cuts_the_run() {
    let mut times = even(100);
    times[60..].iter_mut().for_each(|time| *time -= 0.2);
    let sequence = Sequence::new(&times).unwrap();
    assert_eq!(sequence.cuts, [60]);
    assert_eq!(sequence.pieces.iter().map(Vec::len).collect::<Vec<_>>(), [60, 40]);
    assert!(sequence.moved.is_empty() && sequence.left_out.is_empty());
}

#[test]
fn times_that_go_back_once_in_twenty_rows_are_times_and_more_often_none() {
    let mut times = even(40);
    times.swap(10, 11);
    times.swap(30, 31);
    assert!(Sequence::new(&times).is_ok());
    assert_eq!(Sequence::new(&times[..39]), Err(11));
}
