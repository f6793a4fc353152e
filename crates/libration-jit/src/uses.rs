//! The steps at which values are needed.

use crate::StraightLine;

/// The steps that need each value.
#[derive(Debug)]
pub(crate) struct Uses {
    /// Steps that use the first value, the second, ….
    steps: Vec<u32>,
    /// Index of the first use of each value in `steps`, and the total number of uses.
    first: Vec<u32>,
}

impl Uses {
    /// Collects the uses; `None` if there are more steps than a `u32` counts.
    pub(crate) fn of(line: &StraightLine) -> Option<Self> {
        let all = line.steps();
        let mut first = vec![0_u32; all.len() + 1];
        for operand in all.iter().flat_map(|step| step.operands()) {
            first[operand + 1] = first[operand + 1].checked_add(1)?;
        }
        for value in 0..all.len() {
            first[value + 1] = first[value + 1].checked_add(first[value])?;
        }
        let mut next = first.clone();
        let mut steps = vec![0; usize::try_from(first[all.len()]).ok()?];
        for (number, step) in (0_u32..).zip(all) {
            for operand in step.operands() {
                steps[usize::try_from(next[operand]).ok()?] = number;
                next[operand] += 1;
            }
        }
        Some(Self { steps, first })
    }

    fn of_value(&self, value: usize) -> &[u32] {
        let bound = |at: usize| usize::try_from(self.first[at]).unwrap_or(usize::MAX);
        &self.steps[bound(value)..bound(value + 1)]
    }

    /// The first step after `step` that needs a value.
    pub(crate) fn after(&self, step: usize, value: usize) -> Option<usize> {
        let uses = self.of_value(value);
        let later = uses.partition_point(|&needs| usize::try_from(needs).is_ok_and(|needs| needs <= step));
        uses.get(later).and_then(|&needs| usize::try_from(needs).ok())
    }
}
