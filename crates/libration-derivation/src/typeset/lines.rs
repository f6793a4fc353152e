//! Line breaks of statements.

use super::super::formula::{Formula, Relation, Statement};
use super::layout::{Layout, Style};

/// A statement in lines: the part left of the first relation, and the lines right of it, each with its sign.
pub(crate) struct Lines {
    pub(crate) left: Layout,
    pub(crate) right: Vec<Layout>,
}

/// Width of a line in characters, in print and inside folded blocks: with 60 the widest lines of the longest pages just fit.
const ROOM: usize = 60;
/// Least width of a line next to a long left side.
const LEAST_ROOM: usize = 36;

/// Breaks a statement: a chain of more than two formulas has a line for each, a long sum has several.
pub(crate) fn statement(statement: &Statement) -> Lines {
    let mut right = Vec::new();
    let first = broken(&statement.first, ROOM);
    let left = if first.len() > 1 { 0 } else { first.iter().map(width).sum() };
    let room = ROOM.saturating_sub(left).max(LEAST_ROOM);
    for (relation, formula) in &statement.rest {
        let mut sign = Some(sign_of(*relation));
        for line in broken(formula, room) {
            right.push(Layout::Row(vec![sign.take().unwrap_or(Layout::Indent), line]));
        }
    }
    if first.len() > 1 {
        return Lines { left: Layout::Row(vec![]), right: first.into_iter().chain(right).collect() };
    }
    Lines { left: Layout::Row(first), right }
}

/// A sum in as many lines as it needs.
fn broken(formula: &Formula, room: usize) -> Vec<Layout> {
    let Layout::Row(parts) = Style::Display.formula(formula) else {
        return vec![Style::Display.formula(formula)];
    };
    if !matches!(formula, Formula::Sum(_)) {
        return vec![Layout::Row(parts)];
    }
    let mut lines: Vec<Vec<Layout>> = vec![vec![]];
    let mut used = 0;
    for summand in summands(parts) {
        let width: usize = summand.iter().map(width).sum();
        if used > 0 && used + width > room {
            lines.push(vec![]);
            used = 0;
        }
        used += width;
        if let Some(line) = lines.last_mut() {
            line.extend(summand);
        }
    }
    lines.into_iter().map(Layout::Row).collect()
}

/// The parts of a sum, each with the sign before it.
fn summands(parts: Vec<Layout>) -> Vec<Vec<Layout>> {
    let mut summands: Vec<Vec<Layout>> = vec![];
    for part in parts {
        match summands.last_mut().filter(|_| !matches!(part, Layout::Sign(_))) {
            Some(summand) => summand.push(part),
            None => summands.push(vec![part]),
        }
    }
    summands
}

/// The approximate width in characters.
fn width(layout: &Layout) -> usize {
    match layout {
        Layout::Row(parts) => parts.iter().map(width).sum(),
        Layout::Letter(_) | Layout::Prefix(_) | Layout::Comma => 1,
        Layout::Word(text) => text.chars().count(),
        Layout::Digits(text) => text.len(),
        Layout::Suffix(text) => text.chars().count(),
        Layout::Sign(_) | Layout::Indent => 3,
        Layout::ThinSpace | Layout::Application => 0,
        Layout::Fraction(over, under) => width(over).max(width(under)),
        Layout::Root(inner) | Layout::Primed(inner, _) => 1 + width(inner),
        Layout::Scripts { base, below, above } => {
            let script = |part: &Option<Box<Layout>>| part.as_ref().map_or(0, |part| width(part));
            width(base) + script(below).max(script(above)).div_ceil(2)
        }
        Layout::Large { from, to, .. } => width(from).max(width(to)).max(2),
        Layout::Brackets(inner) | Layout::Bars(inner) => 2 + width(inner),
    }
}

fn sign_of(relation: Relation) -> Layout {
    Layout::Sign(match relation {
        Relation::Equal => '=',
        Relation::Defined => '≔',
        Relation::Rounded => '≈',
        Relation::Less => '<',
    })
}
