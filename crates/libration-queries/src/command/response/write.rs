//! A response as a sheet with its special points and words, JSON and CSV.

use super::ResponseResult;
use super::branch_fields::{NumberedBranch, ending, of_branch, of_special, origin};
use super::fields::{ResponseRow, of_answer, of_row};
use super::sweep_fields::{Jumping, of_swept};
use crate::output::number::at_most;
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use libration::continuation::{BranchPoint, Ending, OrderAnswers, OrderFinding, Origin};
use libration::orbit::Stability;
use std::f64::consts::PI;
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;

impl ResponseResult {
    /// Writes the result in the given form; the table lists the special points only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => {
                let fields = of_branch();
                let branches = self.numbered().map(|branch| fields.record(&branch));
                json::document_with_list(out, of_answer().record(self), "branches", branches)
            }
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        csv::line(out, &of_row().csv_names())?;
        for branch in self.numbered() {
            let fields = of_row();
            for point in branch.places() {
                csv::line(out, &fields.csv_cells(&ResponseRow::PointOfBranch(point)))?;
            }
        }
        let fields = of_row();
        self.swept().try_for_each(|swept| csv::line(out, &fields.csv_cells(&ResponseRow::Swept(swept))))
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        for (name, text) in of_answer().lines(self) {
            writeln!(out, "{}", paragraph(&format!("{name:<10}"), &text, COLUMNS))?;
        }
        for branch in self.numbered() {
            writeln!(
                out,
                "{}",
                paragraph(&format!("branch {:<3}", branch.number), &summary(&branch), COLUMNS)
            )?;
        }
        for (value, reason) in &self.response.missing {
            let text = format!("{}: {reason}", self.value_text(*value));
            writeln!(out, "{}", paragraph("no start  ", &text, COLUMNS))?;
        }
        for order in &self.response.orders {
            writeln!(out, "{}", paragraph("order     ", &sought(order), COLUMNS))?;
        }
        if listed && self.branches().iter().any(|branch| !branch.special.is_empty()) {
            writeln!(out)?;
            let mut table = Table::new(of_special().columns());
            for branch in self.numbered() {
                let fields = of_special();
                for point in branch.special() {
                    table.row(out, fields.cells(&point))?;
                }
            }
            table.finish(out)?;
        }
        if !self.precise.is_empty() {
            writeln!(out)?;
        }
        for branch in self.numbered() {
            for text in branch.special().filter_map(|point| point.digits_text()) {
                write_text(out, "", &text)?;
            }
        }
        if !self.response.jumps.is_empty() {
            writeln!(out)?;
        }
        self.jumps().try_for_each(|jump| write_text(out, "", &told(&jump)))?;
        if !self.response.driven || self.sweeps.is_empty() || !listed {
            return Ok(());
        }
        writeln!(out)?;
        let mut table = Table::new(of_swept().columns());
        for swept in self.swept() {
            table.row(out, of_swept().cells(&swept))?;
        }
        table.finish(out)
    }
}

/// The result of the search for an order.
fn sought(OrderAnswers { order, branches, finding }: &OrderAnswers) -> String {
    let came_to = match finding {
        OrderFinding::NoOscillation => {
            "no free oscillation has this fraction of the drive frequency".to_owned()
        }
        OrderFinding::NoWork => {
            "to first order the work of the drive on these oscillations does not depend on the phase: none is followed"
                .to_owned()
        }
        OrderFinding::TooWeak(share) => {
            let percent = at_most(100.0 * share);
            format!(
                "to first order, the drive supplies at most {percent} % of the energy lost to damping: none is followed"
            )
        }
        OrderFinding::NotReached => {
            "no balanced free oscillation could be continued to the given drive and damping"
                .to_owned()
        }
        OrderFinding::Found if *branches == 0 => {
            "its solutions are on branches that are followed already".to_owned()
        }
        OrderFinding::Found if *branches == 1 => "one branch found from free oscillations".to_owned(),
        OrderFinding::Found => format!("{branches} branches found from free oscillations"),
    };
    format!("{order}: {came_to}")
}

fn told(Jumping { answer, jump }: &Jumping<'_>) -> String {
    let way = if jump.rising { "Upwards" } else { "Downwards" };
    let left = answer.amplitude(&jump.from);
    let (value, from) = (answer.value_text(jump.from.parameter), answer.amplitude_text(left));
    let begin = format!("{way} in {} the solution", answer.parameter);
    let mut to: Vec<String> =
        jump.to.iter().map(|point| answer.amplitude_text(answer.amplitude(point))).collect();
    to.dedup();
    if to.is_empty() {
        return format!("{begin} leaves {from} at {value}, and no other stable periodic motion was found.");
    }
    let rises = jump.to.iter().all(|point| answer.amplitude(point) > left);
    let verb = if rises { "jumps up" } else { "jumps down" };
    format!("{begin} {verb} at {value}, from {from} to {}.", to.join(" or "))
}

fn rotating(turns: i32, periods: u32) -> String {
    let times = match turns.abs() {
        1 => "one turn".to_owned(),
        more => format!("{more} turns"),
    };
    let back = if turns < 0 { " backwards" } else { "" };
    match periods {
        1 => format!("{times}{back} in a period of the drive"),
        more => format!("{times}{back} in {more} periods of the drive"),
    }
}

/// `12 points, 11 of them stable, 1 undetermined`.
fn counts(points: &[BranchPoint]) -> String {
    let number =
        |wanted: &[Stability]| points.iter().filter(|point| wanted.contains(&point.stability)).count();
    let stable = number(&[Stability::Attracting, Stability::Neutral]);
    let open = match number(&[Stability::Undetermined]) {
        0 => String::new(),
        open => format!(", {open} undetermined"),
    };
    format!("{} points, {stable} of them stable{open}", points.len())
}

/// The ends of a branch, and the number of its points that are stable.
fn summary(branch: &NumberedBranch<'_>) -> String {
    let (answer, points) = (branch.answer, &branch.branch.points);
    let largest = points.iter().map(|point| answer.amplitude(point)).fold(0.0, f64::max);
    let periods = match (answer.response.driven, branch.branch.space.drive_periods()) {
        (true, periods) => match (answer.turns(branch.branch), periods) {
            (0, 1) => "period of the drive".to_owned(),
            (0, more) => format!("{more} periods of the drive"),
            (turns, periods) => rotating(turns, periods),
        },
        (false, 1) => "limit cycle".to_owned(),
        (false, more) => format!("limit cycle of {more} turns"),
    };
    let symmetric = if branch.branch.space.mirrored { "symmetric, " } else { "" };
    let rotates = answer.turns(branch.branch) != 0;
    let over_the_top = match answer.is_angle() && largest > PI && !rotates {
        true => ", beyond the top",
        false => "",
    };
    let even = if rotates { " from uniform rotation" } else { "" };
    let is_at_a_value = matches!(
        branch.branch.ending,
        Ending::RangeEnd | Ending::Lost | Ending::Sensitive | Ending::Unbounded | Ending::InfinitePeriod
    );
    let end = points.last().filter(|_| is_at_a_value);
    let at = end.map_or_else(String::new, |point| {
        format!(
            " at {} with {}",
            answer.value_text(point.parameter),
            answer.amplitude_text(answer.amplitude(point))
        )
    });
    let before = match (branch.branch.origin, branch.branch.beginning) {
        (Origin::SymmetryBreaking | Origin::PeriodDoubling, _) | (_, Ending::RangeEnd | Ending::Closed) => {
            String::new()
        }
        (_, other) => format!("; before its first point it {}", ending(other)[1]),
    };
    let unresolved = match &branch.branch.unresolved[..] {
        [] => String::new(),
        ranges => {
            let low = ranges.iter().map(|range| range[0]).fold(f64::INFINITY, f64::min);
            let high = ranges.iter().map(|range| range[1]).fold(f64::NEG_INFINITY, f64::max);
            let width: f64 = ranges.iter().map(|[low, high]| high - low).sum();
            let (from, to) = (answer.value_text(low), answer.value_text(high));
            let range = if from == to { format!("near {from}") } else { format!("between {from} and {to}") };
            let (name, width) = (&answer.parameter, at_most(width));
            format!(
                "; further special points cannot be excluded {range}, on a total width of {width} in {name}"
            )
        }
    };
    format!(
        "{}, {symmetric}{periods}: {}, up to {}{over_the_top}{even}; {}{at}{before}{unresolved}",
        origin(branch.branch.origin)[1],
        counts(points),
        answer.amplitude_text(largest),
        ending(branch.branch.ending)[1],
    )
}
