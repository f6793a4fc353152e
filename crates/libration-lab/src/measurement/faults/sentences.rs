//! Sentences about faults, each with the treatment or a remedy.

use super::{Clock, Faults, Plateau};

/// Lines named in one sentence.
const NAMED: usize = 5;

impl Faults {
    /// A sentence for each kind of fault. `lines` has the line of each row in its file; if it is empty rows are
    /// counted from one. `unit` is that of the values.
    #[must_use]
    pub fn sentences(&self, lines: &[u64], unit: &str) -> Vec<String> {
        let named = |rows: &[usize]| places(rows, lines);
        let of = |rows: &[usize], say: fn(&str, &str) -> String| {
            (!rows.is_empty()).then(|| say(&count(rows.len(), "row"), &named(rows)))
        };
        let told = [
            of(&self.restarts, |_, places| {
                format!("the times restart at {places}: several runs in one table, to be read one at a time")
            }),
            of(&self.repeated, |rows, places| {
                format!("{rows} with the time of the row before ({places}): left out")
            }),
            of(&self.out_of_order, |rows, places| {
                format!("{rows} with a time out of order ({places}): left out")
            }),
            self.clock.as_ref().and_then(|clock| of_gaps(clock, lines)),
            self.clock.as_ref().and_then(|clock| of_rounding(clock, self.rounding_noise, unit)),
            self.clock.as_ref().and_then(of_coarse_times),
            self.clock.as_ref().filter(|clock| clock.is_uneven()).map(of_uneven_clock),
            of(&self.wraps, |rows, places| {
                format!("{rows} after a jump by a whole turn ({places}): the turns can be taken out")
            }),
            of_runs(
                &self.stuck,
                lines,
                "stay at one value while the motion goes on",
                "frames shown twice, or a sensor that hangs: leave them out",
            ),
            of_runs(
                &self.clipped,
                lines,
                "stay at the largest or smallest value",
                "the motion went beyond the scale: leave them out",
            ),
            of(&self.outliers, |rows, places| {
                format!(
                    "{rows} far off the smooth curve through their neighbours ({places}): kept, so fit robustly or leave them out"
                )
            }),
        ];
        told.into_iter().flatten().collect()
    }
}

fn of_gaps(clock: &Clock, lines: &[u64]) -> Option<String> {
    let longest = clock.gaps.iter().map(|gap| gap.duration).reduce(f64::max)?;
    let missing = clock.gaps.iter().fold(0_usize, |sum, gap| sum.saturating_add(gap.missing));
    let rows: Vec<usize> = clock.gaps.iter().map(|gap| gap.after).collect();
    let (gaps, missing) = (count(rows.len(), "gap"), count(missing, "row"));
    let longest = short(longest);
    Some(format!(
        "{gaps} of {missing} in all (after {}), the longest {longest} s: nothing is filled in",
        places(&rows, lines)
    ))
}

fn of_rounding(clock: &Clock, noise: Option<f64>, unit: &str) -> Option<String> {
    let (grid, resolution) = (clock.grid.as_ref()?, clock.resolution?);
    let interval = format!("{:.7}", grid.interval);
    let cost = noise
        .map_or_else(String::new, |noise| format!(", which acts as an error of {} {unit}", short(noise)));
    let (interval, off) = (interval.trim_end_matches('0'), short(grid.largest_deviation));
    let to = match clock.significant_digits {
        Some(digits) => format!("{digits} significant digits"),
        None => format!("{resolution} s"),
    };
    Some(format!(
        "the times are rounded to {to}{cost}: even times with an interval of {interval} s fit them within {off} s"
    ))
}

fn of_coarse_times(clock: &Clock) -> Option<String> {
    let digits = clock.significant_digits.filter(|_| clock.grid.is_none())?;
    Some(format!(
        "the times have {digits} significant digits, so several rows share one time, and no evenly spaced times round to them: export more digits"
    ))
}

fn of_uneven_clock(clock: &Clock) -> String {
    let percent = 100.0 * clock.jitter / clock.interval;
    format!(
        "the intervals vary by {percent:.0} % about {} s, not by rounding: the times are used as they are",
        short(clock.interval)
    )
}

fn of_runs(runs: &[Plateau], lines: &[u64], what: &str, hint: &str) -> Option<String> {
    let rows = runs.iter().map(|run| run.rows).sum();
    let firsts: Vec<usize> = runs.iter().map(|run| run.first).collect();
    let from = places(&firsts, lines);
    (!runs.is_empty()).then(|| format!("{} {what} (from {from}): {hint}", count(rows, "row")))
}

fn count(number: usize, what: &str) -> String {
    format!("{number} {what}{}", if number == 1 { "" } else { "s" })
}

/// `line 3`, `lines 3, 8, 9`, `lines 3, 8, 9, 11, 12 and 40 more`.
fn places(rows: &[usize], lines: &[u64]) -> String {
    let word = if lines.is_empty() { "row" } else { "line" };
    let name = |&row: &usize| lines.get(row).map_or_else(|| (row + 1).to_string(), ToString::to_string);
    let shown: Vec<String> = rows.iter().take(NAMED).map(name).collect();
    let more = rows.len() - shown.len();
    let plural = if rows.len() == 1 { "" } else { "s" };
    let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("{word}{plural} {}{rest}", shown.join(", "))
}

/// Two significant digits.
fn short(value: f64) -> String {
    let text = format!("{value:.1e}");
    text.parse::<f64>().map_or(text, |rounded| rounded.to_string())
}
