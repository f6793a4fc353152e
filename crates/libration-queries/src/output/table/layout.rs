//! Layout of the columns of a table in the width available: side by side, folded, or in several blocks.

use super::{Column, Side};
use crate::output::screen::{columns_of, folded, padded};

/// Width of the gap between two columns.
pub(super) const GAP: usize = 2;
/// Columns of words are not folded to less than this, unless all they hold is shorter.
const NARROWEST_WORDS: usize = 24;

/// The blocks of a table, one below the other, each with its columns and their widths. Each contains the first column; columns without title and
/// text are omitted.
#[derive(Clone, Debug)]
pub(super) struct TableLayout {
    pub(super) blocks: Vec<Vec<ColumnPlace>>,
}

/// A column in its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ColumnPlace {
    pub(super) column: usize,
    pub(super) width: usize,
}

/// The widths that a column needs.
#[derive(Clone, Copy, Debug)]
struct Demand {
    column: usize,
    /// Width without folding anything.
    natural: usize,
    /// Width with its title folded.
    without_title: usize,
    /// Width with its words folded too.
    least: usize,
}

impl TableLayout {
    /// The layout of these rows in `room` columns of the screen.
    pub(super) fn new(columns: &[Column], rows: &[Vec<String>], room: usize) -> Self {
        let demand = |(index, column)| Demand::new(index, column, rows);
        let demands: Vec<Demand> =
            columns.iter().enumerate().map(demand).filter(|demand| demand.natural > 0).collect();
        Self { blocks: grouped(&demands, room).iter().map(|block| shared(block, room)).collect() }
    }

    /// Returns `true` if rows can be written one by one.
    pub(super) fn is_one_block(&self) -> bool {
        self.blocks.len() == 1
    }

    /// Returns `true` if a row that was not seen before fits the widths.
    pub(super) fn holds(&self, columns: &[Column], cells: &[String]) -> bool {
        let block_of = |column| self.blocks.iter().flatten().find(|block| block.column == column);
        cells.iter().zip(columns).enumerate().all(|(index, (cell, column))| {
            match (block_of(index), &column.side) {
                (None, _) => cell.is_empty(),
                (Some(entry), Side::Right) => columns_of(cell) <= entry.width,
                (Some(entry), Side::Left) => longest_word(cell) <= entry.width,
            }
        })
    }
}

impl Demand {
    fn new(index: usize, column: &Column, rows: &[Vec<String>]) -> Self {
        let cells = || rows.iter().filter_map(|row| row.get(index));
        let widest = cells().map(|cell| columns_of(cell)).max().unwrap_or(0);
        let without_title = widest.max(longest_word(&column.title));
        let least = match column.side {
            Side::Right => without_title,
            Side::Left => {
                let words = cells().map(|cell| longest_word(cell)).max().unwrap_or(0);
                words.max(longest_word(&column.title)).max(NARROWEST_WORDS.min(without_title))
            }
        };
        Self { column: index, natural: widest.max(columns_of(&column.title)), without_title, least }
    }
}

fn longest_word(text: &str) -> usize {
    text.split_whitespace().map(columns_of).max().unwrap_or(0)
}

/// Groups as many columns side by side as there is room for; every block begins with the first one.
fn grouped(demands: &[Demand], room: usize) -> Vec<Vec<Demand>> {
    let Some((first, rest)) = demands.split_first() else { return vec![vec![]] };
    let mut blocks = vec![vec![*first]];
    let mut taken = first.least;
    for demand in rest {
        let block = blocks.last_mut().expect("there is a first block");
        if taken + GAP + demand.least <= room || block.len() == 1 {
            block.push(*demand);
            taken += GAP + demand.least;
        } else {
            blocks.push(vec![*first, *demand]);
            taken = first.least + GAP + demand.least;
        }
    }
    blocks
}

/// The widths of the columns of a block: titles are folded before words are, and of these the widest first.
fn shared(block: &[Demand], room: usize) -> Vec<ColumnPlace> {
    let mut widths: Vec<usize> = block.iter().map(|demand| demand.natural).collect();
    let floors: [fn(&Demand) -> usize; 2] = [|demand| demand.without_title, |demand| demand.least];
    for floor in floors {
        while taken(&widths) > room {
            let shrinkable = (0..block.len()).filter(|&index| widths[index] > floor(&block[index]));
            let Some(widest) = shrinkable.max_by_key(|&index| widths[index]) else { break };
            widths[widest] -= 1;
        }
    }
    block.iter().zip(widths).map(|(demand, width)| ColumnPlace { column: demand.column, width }).collect()
}

fn taken(widths: &[usize]) -> usize {
    widths.iter().sum::<usize>() + GAP * widths.len().saturating_sub(1)
}

/// The lines of a row: the cells side by side, each in as many lines as it needs.
pub(super) fn lines(widths: &[ColumnPlace], columns: &[Column], cells: &[String]) -> Vec<String> {
    let nothing = String::new();
    let cell = |column: &ColumnPlace| folded(cells.get(column.column).unwrap_or(&nothing), column.width);
    let stacks: Vec<Vec<String>> = widths.iter().map(cell).collect();
    let height = stacks.iter().map(Vec::len).max().unwrap_or(0);
    let line = |level: usize| {
        let aligned = widths.iter().zip(&stacks).map(|(column, stack)| {
            let text = stack.get(level).map_or("", String::as_str);
            match columns[column.column].side {
                Side::Left => padded(text, column.width),
                Side::Right => format!("{:1$}{text}", "", column.width.saturating_sub(columns_of(text))),
            }
        });
        aligned.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    (0..height).map(line).collect()
}
