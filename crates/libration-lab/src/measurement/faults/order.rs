//! Times that repeat, go backwards, or begin anew.

/// Rows on either side of a step back that distinguish a new run from a wrong time. With 3 a packet of three rows that came late began a run (for
/// the recordings see `clock.rs`); with 8 a clock set back by eight rows did not, and its rows were left out.
const WITNESSES: usize = 5;

/// The rows with the time of the row before.
pub(in crate::measurement) fn repeated(times: &[f64]) -> Vec<usize> {
    (1..times.len()).filter(|&row| times[row].total_cmp(&times[row - 1]).is_eq()).collect()
}

/// The rows at which the times fall below all of the last ones and continue from there.
pub fn restarts(times: &[f64]) -> Vec<usize> {
    let begins_anew = |&row: &usize| {
        let before = &times[row.saturating_sub(WITNESSES)..row];
        let after = &times[row..times.len().min(row + WITNESSES)];
        after.len() >= WITNESSES.min(row)
            && after.len() > 2
            && before.iter().all(|&time| times[row] < time)
            && after.windows(2).all(|pair| pair[0] <= pair[1])
            && after[after.len() - 1] < before[before.len() - 1]
    };
    (1..times.len()).filter(begins_anew).collect()
}

/// The fewest rows without which the times increase, those that repeat left aside: all that are not on the
/// longest increasing subsequence, found by patience sorting.
pub(in crate::measurement) fn out_of_order(times: &[f64], repeated: &[usize]) -> Vec<usize> {
    let rows: Vec<usize> = (0..times.len()).filter(|row| repeated.binary_search(row).is_err()).collect();
    let mut before = vec![None; times.len()];
    // The last row of the best subsequence of each length.
    let mut ends: Vec<usize> = Vec::new();
    for &row in &rows {
        let length = ends.partition_point(|&end| times[end] < times[row]);
        before[row] = length.checked_sub(1).map(|shorter| ends[shorter]);
        match ends.get_mut(length) {
            Some(end) => *end = row,
            None => ends.push(row),
        }
    }
    let mut kept = vec![false; times.len()];
    let mut next = ends.last().copied();
    while let Some(row) = next {
        kept[row] = true;
        next = before[row];
    }
    rows.into_iter().filter(|&row| !kept[row]).collect()
}
