//! Rows of a table that are used: a range of its first quantity, and runs.

use super::Wanted;
use crate::call::in_words;
use libration_lab::measurement::{Readings, Unit, is_run};

/// Options for the rows of a table.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct RowOptions {
    /// Ignore rows in which the first quantity (length, amplitude, frequency, time) is less than this, in the unit of its column unless it has one, such as 20cm
    #[arg(long, value_name = "VALUE", value_parser = bound)]
    from: Option<RowBound>,
    /// Ignore rows in which the first quantity is greater than this
    #[arg(long, value_name = "VALUE", value_parser = bound)]
    to: Option<RowBound>,
    /// Use only these groups of the table, by name or number; several as 1,2,6
    #[arg(long, value_name = "RUN,…")]
    run: Option<String>,
}

/// An end of a range, with its unit if one is given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowBound {
    value: f64,
    unit: Option<Unit>,
}

fn bound(text: &str) -> Result<RowBound, String> {
    let text = text.trim();
    let unit = text.trim_start_matches(|letter: char| letter.is_ascii_digit() || "+-.eE".contains(letter));
    let value = text[..text.len() - unit.len()].parse().ok().filter(|value: &f64| value.is_finite());
    let unit = match unit.trim() {
        "" => Ok(None),
        unit => unit.parse().map(Some),
    };
    match (value, unit) {
        (Some(value), Ok(unit)) => Ok(RowBound { value, unit }),
        _ => Err("give a number, or a number and a unit, such as 20cm".to_owned()),
    }
}

impl RowOptions {
    /// The rows that are used, by values in a unit and names of groups, with sentences about the others.
    pub(super) fn choose(
        &self,
        read: Readings,
        wanted: Wanted,
        unit: Unit,
        groups: Option<&[String]>,
    ) -> Result<(Readings, Vec<String>), String> {
        let is_of_run = self.of_run(groups, read.lines.len())?;
        let is_within = self.within(&read, wanted, unit)?;
        let kept: Vec<usize> =
            (0..read.lines.len()).filter(|&row| is_of_run[row] && is_within[row]).collect();
        let of_run = is_of_run.iter().filter(|is_of_run| **is_of_run).count();
        let sentence = |count: usize, options: &str| {
            let plural = if count == 1 { "row is" } else { "rows are" };
            (count > 0).then(|| in_words(&format!("{count} {plural} ignored ({options})")))
        };
        let sentences = [
            sentence(read.lines.len() - of_run, "<--run>"),
            sentence(of_run - kept.len(), "<--from>, <--to>"),
        ];
        match kept.is_empty() {
            true => Err(in_words("no row of the runs is in the range (<--run>, <--from>, <--to>)")),
            false => Ok((read.only(&kept), sentences.into_iter().flatten().collect())),
        }
    }

    fn of_run(&self, groups: Option<&[String]>, rows: usize) -> Result<Vec<bool>, String> {
        let Some(asked) = &self.run else { return Ok(vec![true; rows]) };
        let groups = groups.ok_or_else(|| {
            in_words("the table has no groups, which are its runs (<--run>): name their column by <--role>, such as 1=group")
        })?;
        let mut names: Vec<&String> = vec![];
        for name in groups.iter().filter(|name| !name.is_empty()) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let mut chosen: Vec<&String> = vec![];
        for asked in asked.split(',') {
            let named: Vec<&String> = names.iter().copied().filter(|name| is_run(name, asked)).collect();
            let numbered = || asked.trim().parse::<usize>().ok()?.checked_sub(1).and_then(|at| names.get(at));
            match (named.is_empty(), numbered()) {
                (false, _) => chosen.extend(named),
                (true, Some(name)) => chosen.push(name),
                (true, None) => {
                    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
                    let (asked, names) = (asked.trim(), names.join(", "));
                    return Err(format!("there is no run `{asked}`: the groups of the table are {names}"));
                }
            }
        }
        Ok(groups.iter().map(|name| chosen.contains(&name)).collect())
    }

    fn within(&self, read: &Readings, wanted: Wanted, unit: Unit) -> Result<Vec<bool>, String> {
        if self.from.is_none() && self.to.is_none() {
            return Ok(vec![true; read.lines.len()]);
        }
        if read.quantities[0].iter().all(Vec::is_empty) {
            let name = wanted.name;
            return Err(in_words(&format!(
                "no column holds the {name}, of which a range is given (<--from>, <--to>)"
            )));
        }
        let in_si = |bound: Option<RowBound>, otherwise: f64| match bound {
            None => Ok(otherwise),
            Some(bound) => {
                let of_bound = bound.unit.unwrap_or(unit);
                let is_alike = of_bound == unit || of_bound.measures_as(unit);
                is_alike.then(|| of_bound.to_si(bound.value)).ok_or_else(|| {
                    let name = wanted.name;
                    in_words(&format!(
                        "the range is given in {of_bound}, and the {name} is in {unit} (<--from>, <--to>)"
                    ))
                })
            }
        };
        let range = in_si(self.from, f64::NEG_INFINITY)?..=in_si(self.to, f64::INFINITY)?;
        let mean = |numbers: &Vec<f64>| {
            let values = numbers.iter().map(|number| unit.to_si(*number));
            values.clone().sum::<f64>() / values.map(|_| 1.0).sum::<f64>()
        };
        let is_within: Vec<bool> =
            read.quantities[0].iter().map(|numbers| range.contains(&mean(numbers))).collect();
        if is_within.contains(&true) {
            return Ok(is_within);
        }
        let all = read.quantities[0].iter().flatten().copied();
        let (least, largest) =
            (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max));
        // Numbers of swings have no unit.
        let unit = if wanted.option.is_some() { format!(" {unit}") } else { String::new() };
        Err(in_words(&format!(
            "no row is in this range (<--from>, <--to>): those of the file are from {least:?} to {largest:?}{unit}"
        )))
    }
}
