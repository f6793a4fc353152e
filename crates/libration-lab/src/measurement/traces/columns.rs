//! Columns of the time and of the measured quantity, for each run.

use super::super::choices::{Choice, Choices, Finding, Suggestion};
use super::super::heading::Measures;
use super::super::sheet::Sheet;
use super::super::two_levels::changes_between_two_levels;
use super::super::{Column, MeasurementError, Observable, QuantityKind};
use super::gyroscope;
use super::runs::Group;
use super::turns::take_out_jumps;
use super::value::Value;

/// The columns of one run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Columns {
    /// Run, as the header names it.
    pub(super) run: Option<String>,
    pub(super) time: usize,
    pub(super) value: Value,
    pub(super) uncertainty: Option<usize>,
    /// The column that numbers runs row by row.
    pub(super) numbering: Option<usize>,
}

impl Columns {
    /// The columns of every run of the sheet, or of the chosen one.
    pub(super) fn of_runs(
        sheet: &Sheet,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Vec<Self>, MeasurementError> {
        let groups = Group::all(sheet, choices)?;
        let several = groups.len() > 1;
        let (mut runs, mut first_error) = (Vec::new(), None);
        for group in groups {
            let mut told = Vec::new();
            match group.columns(choices, &mut told) {
                Ok(columns) => {
                    runs.push(columns);
                    findings.extend(told);
                }
                Err(error) if several => first_error = first_error.or(Some((group.run, error))),
                Err(error) => return Err(error),
            }
        }
        match first_error {
            Some((_, error)) if runs.is_empty() => Err(error),
            Some((run, error)) => {
                let run = run.unwrap_or_default();
                findings.push(Finding::new(format!("{run} is left out: {error}"), Choice::Run));
                Ok(runs)
            }
            None => Ok(runs),
        }
    }
}

impl Group<'_> {
    fn columns(&self, choices: &Choices, findings: &mut Vec<Finding>) -> Result<Columns, MeasurementError> {
        let time = self.time(choices, findings)?;
        let value = self.value(time, choices, findings)?;
        if let Value::Column(column, _) = value {
            self.no_gate_signal(column, choices)?;
        }
        let uncertainty = self.uncertainty(value, choices, findings)?;
        let numbering =
            self.members.iter().copied().find(|&column| self.heading_is(column, QuantityKind::Run));
        Ok(Columns { run: self.run.clone(), time, value, uncertainty, numbering })
    }

    fn heading_is(&self, column: usize, quantity: QuantityKind) -> bool {
        self.sheet.channels[column].heading.is(quantity)
    }

    fn all_of(&self, quantity: QuantityKind) -> Vec<usize> {
        self.members.iter().copied().filter(|&column| self.heading_is(column, quantity)).collect()
    }

    fn chosen(&self, column: Option<&Column>) -> Result<Option<usize>, MeasurementError> {
        column.map(|column| self.sheet.index_of(column)).transpose()
    }

    fn undecided(&self, question: &str, choice: Choice, indices: &[usize]) -> MeasurementError {
        const SHOWN: usize = 8;
        let shown = &indices[..indices.len().min(SHOWN)];
        let mut columns: Vec<String> = shown.iter().map(|&column| self.sheet.describe(column)).collect();
        columns.extend((indices.len() > SHOWN).then(|| "…".to_owned()));
        let question = question.replace("{}", &columns.join(", "));
        let choices = shown.iter().map(|column| Suggestion::new(choice, (column + 1).to_string())).collect();
        MeasurementError::Undecided { question, choices }
    }

    fn time(&self, choices: &Choices, findings: &mut Vec<Finding>) -> Result<usize, MeasurementError> {
        if let Some(time) = self.chosen(choices.time.as_ref())? {
            return Ok(time);
        }
        if let [time] = self.all_of(QuantityKind::Time)[..] {
            findings.push(Finding::new(format!("{} is the time", self.sheet.describe(time)), Choice::Time));
            return Ok(time);
        }
        let named = self.all_of(QuantityKind::Time);
        if !named.is_empty() {
            return Err(self.undecided("several columns are times: {}", Choice::Time, &named));
        }
        self.increasing(findings)
    }

    /// Column of the times if none is named so: the only one that increases throughout, as no swing does.
    fn increasing(&self, findings: &mut Vec<Finding>) -> Result<usize, MeasurementError> {
        let may = |column: &usize| {
            !self.heading_is(*column, QuantityKind::Run) && self.sheet.channels[*column].increases()
        };
        let increasing: Vec<usize> = self.members.iter().copied().filter(may).collect();
        match increasing[..] {
            [time] => {
                let text =
                    format!("{} is the time, since only it increases throughout", self.sheet.describe(time));
                findings.push(Finding::new(text, Choice::Time));
                Ok(time)
            }
            [] => {
                let question = "no column is named a time, and none increases throughout";
                Err(self.undecided(question, Choice::Time, &self.members))
            }
            _ => Err(self.undecided("several columns may be times: {}", Choice::Time, &increasing)),
        }
    }

    fn value(
        &self,
        time: usize,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Value, MeasurementError> {
        for (chosen, observable) in
            [(&choices.angle, Observable::Angle), (&choices.angular_velocity, Observable::AngularVelocity)]
        {
            if let Some(column) = self.chosen(chosen.as_ref())? {
                return self.no_acceleration(column).map(|()| Value::Column(column, observable));
            }
        }
        if choices.x.is_some() || choices.y.is_some() {
            return self.positions(time, choices);
        }
        // What never changes is not the angle of anything that swings, where another column is.
        let varies =
            |column: &usize| self.sheet.channels[*column].range().is_none_or(|(low, high)| low < high);
        let named = self.all_of(QuantityKind::Angle);
        let varying: Vec<usize> = named.iter().copied().filter(varies).collect();
        let angles = if varying.is_empty() { named } else { varying };
        let has_positions = [QuantityKind::X, QuantityKind::Y]
            .iter()
            .all(|&axis| self.all_of(axis).iter().any(|&column| column != time));
        match angles[..] {
            [angle] => {
                findings.push(Finding::new(
                    format!("{} is the angle", self.sheet.describe(angle)),
                    Choice::Angle,
                ));
                Ok(Value::Column(angle, Observable::Angle))
            }
            [] if has_positions => self.positions(time, choices),
            [] => self.velocity(time, choices, findings),
            _ => Err(self.undecided("several columns are angles: {}", Choice::Angle, &angles)),
        }
    }

    fn no_acceleration(&self, column: usize) -> Result<(), MeasurementError> {
        match self.heading_is(column, QuantityKind::Acceleration) {
            true => Err(MeasurementError::Accelerations { column: self.sheet.describe(column) }),
            false => Ok(()),
        }
    }

    /// Refuses a column that changes between two levels.
    fn no_gate_signal(&self, column: usize, choices: &Choices) -> Result<(), MeasurementError> {
        let mut numbers: Vec<f64> = self.sheet.channels[column].numbers().flatten().collect();
        let unit = choices.unit.or(self.sheet.channels[column].heading.unit);
        // Angles that jump by a turn at the position of rest are at two levels too.
        if let Some(unit) = unit.filter(|unit| unit.measures() == Measures::Angle) {
            numbers.iter_mut().for_each(|number| *number = unit.to_si(*number));
            take_out_jumps(&mut numbers);
        }
        match changes_between_two_levels(&numbers) {
            true => {
                Err(MeasurementError::GateSignal { column: self.sheet.describe(column), number: column + 1 })
            }
            false => Ok(()),
        }
    }

    fn positions(&self, time: usize, choices: &Choices) -> Result<Value, MeasurementError> {
        let axis = |chosen: Option<&Column>, quantity, choice| match self.chosen(chosen)? {
            Some(index) => Ok(index),
            None => {
                match self.all_of(quantity).into_iter().filter(|&index| index != time).collect::<Vec<_>>()[..]
                {
                    [index] => Ok(index),
                    ref several => Err(self.undecided("the positions are not decided", choice, several)),
                }
            }
        };
        let x = axis(choices.x.as_ref(), QuantityKind::X, Choice::X)?;
        let y = axis(choices.y.as_ref(), QuantityKind::Y, Choice::Y)?;
        Ok(Value::Positions { x, y })
    }

    fn velocity(
        &self,
        time: usize,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Value, MeasurementError> {
        let mut velocities = self.all_of(QuantityKind::AngularVelocity);
        // The absolute value has lost the sign.
        let is_absolute = |column: usize| {
            let name = self.sheet.channels[column].heading.name.to_lowercase();
            ["abs", "betrag", "magnitude", "norm", "módulo", "modulo"].iter().any(|word| name.contains(word))
        };
        velocities.retain(|&column| !is_absolute(column));
        let (value, why) = match velocities[..] {
            [] => return self.unnamed(time, choices, findings),
            [column] => (Some(Value::Column(column, Observable::AngularVelocity)), ""),
            _ => match gyroscope::strongest(self.sheet, &velocities) {
                Some(column) => (
                    Some(Value::Column(column, Observable::AngularVelocity)),
                    ", since it has nearly all of the motion",
                ),
                None => (gyroscope::about_one_axis(self.sheet, &velocities), ""),
            },
        };
        let question =
            "several columns are angular velocities, and they are not those of a turning about one axis: {}";
        let value = value.ok_or_else(|| self.undecided(question, Choice::AngularVelocity, &velocities))?;
        let text = match value {
            Value::Axes(axes, axis) => {
                let [x, y, z] = axis.map(|part| format!("{part:.3}"));
                let columns = axes.map(|column| (column + 1).to_string()).join(", ");
                format!(
                    "columns {columns} are the angular velocity about the axis ({x}, {y}, {z}) of the device, about which nearly all \
                     of the motion is"
                )
            }
            _ => format!("{} is the angular velocity{why}", self.sheet.describe(value.places()[0])),
        };
        findings.push(Finding::new(text, Choice::AngularVelocity));
        Ok(value)
    }

    /// The columns of numbers whose quantity is unknown.
    fn open(&self, time: usize) -> Vec<usize> {
        let may = |column: &usize| {
            let channel = &self.sheet.channels[*column];
            *column != time
                && matches!(channel.heading.quantity, QuantityKind::Other | QuantityKind::X | QuantityKind::Y)
                && !channel.heading.is_uncertainty
                && channel.heading.unit_text.is_none()
                && channel.range().is_some_and(|(low, high)| low < high)
        };
        self.members.iter().copied().filter(may).collect()
    }

    /// The only column of unknown quantity, if its unit is given; otherwise the error with suggestions.
    fn unnamed(
        &self,
        time: usize,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Value, MeasurementError> {
        let is_velocity = choices.unit.is_some_and(|unit| unit.measures() == Measures::AngularVelocity);
        let is_said = choices.unit.is_some() || choices.counts_per_turn.is_some();
        match self.open(time)[..] {
            [column] if is_said => {
                let text =
                    format!("{} is what was measured, since there is no other", self.sheet.describe(column));
                findings.push(Finding::new(text, Choice::Angle));
                Ok(Value::Column(
                    column,
                    if is_velocity { Observable::AngularVelocity } else { Observable::Angle },
                ))
            }
            [column] => {
                self.no_gate_signal(column, choices)?;
                let question = format!("it is not clear what {} holds", self.sheet.describe(column));
                Err(MeasurementError::Undecided { question, choices: what_it_holds() })
            }
            [] => Err(self.nothing_known(time, choices)),
            ref several => Err(self.which_and_in_which_unit(several)),
        }
    }

    /// The error if no column is known to be an angle, with suggestions for the others.
    fn nothing_known(&self, time: usize, choices: &Choices) -> MeasurementError {
        if let Some(column) = self.all_of(QuantityKind::Acceleration).first() {
            return MeasurementError::Accelerations { column: self.sheet.describe(*column) };
        }
        let may_be = |&column: &usize| column != time && !self.heading_is(column, QuantityKind::Gate);
        let others: Vec<usize> = self.members.iter().copied().filter(may_be).collect();
        let is_length = |column: &usize| {
            let unit = self.sheet.channels[*column].heading.unit;
            unit.is_some_and(|unit| unit.measures() == Measures::Length)
        };
        match (&others[..], &others.iter().copied().filter(is_length).collect::<Vec<_>>()[..]) {
            ([], _) => MeasurementError::OnlyTimes(self.sheet.describe(time)),
            (_, &[x, y]) => {
                let [first, second] = [x, y].map(|column| self.sheet.describe(column));
                MeasurementError::Undecided {
                    question: format!(
                        "it is not clear which of {first} and {second} is the horizontal position"
                    ),
                    choices: vec![at(Choice::X, x), at(Choice::Y, y)],
                }
            }
            (&[only], _) if self.no_gate_signal(only, choices).is_err() => {
                MeasurementError::GateSignal { column: self.sheet.describe(only), number: only + 1 }
            }
            (others, _) => {
                let question = "no column is named an angle, an angular velocity or a position";
                self.undecided(question, Choice::Angle, others)
            }
        }
    }

    fn which_and_in_which_unit(&self, open: &[usize]) -> MeasurementError {
        let question = "it is not clear which of these is the angle, nor in which unit: {}";
        let mut error = self.undecided(question, Choice::Angle, open);
        if let MeasurementError::Undecided { choices, .. } = &mut error {
            choices.extend(["rad", "deg"].map(|unit| Suggestion::new(Choice::Unit, unit)));
        }
        if let (MeasurementError::Undecided { choices, .. }, &[x, y]) = (&mut error, open) {
            choices.extend([at(Choice::X, x), at(Choice::Y, y)]);
        }
        error
    }

    fn uncertainty(
        &self,
        value: Value,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<usize>, MeasurementError> {
        if let Some(column) = self.chosen(choices.uncertainty.as_ref())? {
            return Ok(Some(column));
        }
        let Value::Column(column, _) = value else { return Ok(None) };
        let quantity = self.sheet.channels[column].heading.quantity;
        let belongs = |other: &usize| {
            let heading = &self.sheet.channels[*other].heading;
            let is_of_it = heading.quantity == quantity && quantity != QuantityKind::Other;
            let follows = *other == column + 1 && heading.is_bare_uncertainty();
            heading.is_uncertainty && (is_of_it || follows) && self.sheet.channels[*other].count() > 0
        };
        let uncertainties: Vec<usize> = self.members.iter().copied().filter(belongs).collect();
        if let [uncertainty] = uncertainties[..] {
            let text = format!("{} holds the uncertainties", self.sheet.describe(uncertainty));
            findings.push(Finding::new(text, Choice::Uncertainty));
            return Ok(Some(uncertainty));
        }
        Ok(None)
    }
}

fn at(choice: Choice, column: usize) -> Suggestion {
    Suggestion::new(choice, (column + 1).to_string())
}

/// Suggestions for a column of unknown quantity.
pub(super) fn what_it_holds() -> Vec<Suggestion> {
    [
        (Choice::Unit, "rad"),
        (Choice::Unit, "deg"),
        (Choice::Unit, "rad/s"),
        (Choice::Unit, "deg/s"),
        (Choice::CountsPerTurn, "4000"),
    ]
    .map(|(choice, value)| Suggestion::new(choice, value))
    .to_vec()
}
