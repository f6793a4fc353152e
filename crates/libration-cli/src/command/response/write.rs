//! A response as a sheet with its special points and words, JSON and CSV.

use super::Answer;
use super::fields::{Numbered, ending, of_answer, of_branch, of_row, of_special, origin};
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use libration::continuation::{Ending, Jump};
use std::f64::consts::PI;
use std::io::{self, Write};

/// Where lines are broken.
const COLUMNS: usize = 100;

impl Answer {
    /// In the form asked for; the table lists the special points only if that is wanted.
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
            for place in branch.places() {
                csv::line(out, &fields.csv_cells(&place))?;
            }
        }
        Ok(())
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
        if listed && self.branches().iter().any(|branch| !branch.special.is_empty()) {
            writeln!(out)?;
            let mut table = Table::new(of_special().columns());
            for branch in self.numbered() {
                let fields = of_special();
                for place in branch.special() {
                    table.row(out, fields.cells(&place))?;
                }
            }
            table.finish(out)?;
        }
        if !self.jumps.is_empty() {
            writeln!(out)?;
        }
        self.jumps.iter().try_for_each(|jump| write_text(out, "", &self.told(jump)))
    }

    fn told(&self, jump: &Jump) -> String {
        let way = if jump.rising { "Upwards" } else { "Downwards" };
        let to: Vec<String> = jump.to.iter().map(|it| self.amplitude_text(*it)).collect();
        let where_to = match &to[..] {
            [] => "to no other stable answer that was found".to_owned(),
            some => format!("to {}", some.join(" or ")),
        };
        let up = jump.to.iter().all(|it| *it > jump.from);
        let verb = if to.is_empty() {
            "leaves"
        } else if up {
            "jumps up"
        } else {
            "jumps down"
        };
        let (value, from) = (self.value_text(jump.parameter), self.amplitude_text(jump.from));
        match to.is_empty() {
            true => format!("{way} in {} the answer {verb} {from} at {value}, {where_to}.", self.parameter),
            false => {
                format!("{way} in {} the answer {verb} at {value}, from {from} {where_to}.", self.parameter)
            }
        }
    }
}

/// Where a branch comes from and goes, and how much of it is stable.
fn summary(branch: &Numbered<'_>) -> String {
    let (answer, points) = (branch.answer, &branch.branch.points);
    let amplitude =
        |point: &libration::continuation::BranchPoint| point.amplitude(answer.coordinate, answer.is_angle());
    let largest = points.iter().map(amplitude).fold(0.0, f64::max);
    let stable = points.iter().filter(|point| point.stable).count();
    let periods = match branch.branch.space.drive_periods() {
        1 => "period of the drive".to_owned(),
        more => format!("{more} periods of the drive"),
    };
    let symmetric = if branch.branch.space.mirrored { "symmetric, " } else { "" };
    let over_the_top = match answer.is_angle() && largest > PI {
        true => ", beyond the top",
        false => "",
    };
    let end = points.last().filter(|_| branch.branch.ending == Ending::RangeEnd);
    let at = end.map_or_else(String::new, |point| {
        format!(" at {} with {}", answer.value_text(point.parameter), answer.amplitude_text(amplitude(point)))
    });
    format!(
        "{}, {symmetric}{periods}: {} points, {stable} of them stable, up to {}{over_the_top}; {}{at}",
        origin(branch.branch.origin)[1],
        points.len(),
        answer.amplitude_text(largest),
        ending(branch.branch.ending)[1],
    )
}
