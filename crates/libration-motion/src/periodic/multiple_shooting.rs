//! Orbits whose deviations grow too much in a period for a single integration
//! to close them: the equation is integrated piece by piece, from node to node.
//!
//! # References
//! J. Stoer and R. Bulirsch, *Introduction to Numerical Analysis*, Springer 2002, section 7.3.5.

use super::newton_step::CLOSED;
use super::norm::norm_of_map;
use libration_kernels::elementary::count;
use libration_numbers::internals::linear::least_squares;

/// Rounding error of a start, grown over a period, above which the end of a single integration no longer determines the start.
pub const LOST: f64 = 1e-6;

/// The end of a piece with its derivatives.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The state at the end.
    pub end: Vec<f64>,
    /// The derivatives by the components of the state at the start, as the rows of a matrix.
    pub by_start: Vec<Vec<f64>>,
    /// The derivatives by each further unknown, such as the period or a parameter.
    pub by_further: Vec<Vec<f64>>,
}

/// An orbit as the states at the beginnings of its pieces, and the values of the further unknowns.
#[derive(Clone, Debug)]
pub struct Nodes {
    /// The states.
    pub states: Vec<Vec<f64>>,
    /// The period, a parameter, or both.
    pub further: Vec<f64>,
}

/// The units of an orbit, the displacement of its end from its start, and the conditions that select the orbit.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The units of the components of a state, then those of the further unknowns.
    pub units: &'a [f64],
    /// The state at the end of the last piece minus the first state.
    pub shift: &'a [f64],
    /// Rows that multiply the changes of the first state and of the further unknowns, in scaled units; the products are to vanish.
    pub conditions: &'a [Vec<f64>],
}

impl Frame<'_> {
    /// The norm of the derivatives of a piece by its start, in scaled units.
    fn norm(&self, piece: &Piece) -> f64 {
        norm_of_map(self.shift.len(), self.units, |i, j| piece.by_start[i][j])
    }
}

/// An orbit whose deviations grow much, and which is to be checked piece by piece.
#[derive(Clone, Copy, Debug)]
pub struct Checked<'a> {
    /// Units and conditions.
    pub frame: Frame<'a>,
    /// The components of the first state, then the further unknowns.
    pub position: &'a [f64],
    /// The errors of these components and unknowns, in scaled units.
    pub errors: &'a [f64],
    /// The growth of deviations in a period.
    pub growth: f64,
}

impl Checked<'_> {
    /// Returns `true` if there is an orbit within the errors of this one: integrated from node to node, each
    /// piece ends at the beginning of the next one. `state_at` gives the state at a fraction of the period,
    /// and `piece` integrates a state between two fractions of the period for values of the further unknowns.
    pub fn closes(
        &self,
        state_at: impl Fn(f64) -> Option<Vec<f64>>,
        piece: impl Fn([f64; 2], &[f64], &[f64]) -> Option<Piece>,
    ) -> bool {
        /// The intended growth of deviations in a piece, and the maximum number of halvings of pieces in which the growth is uneven.
        const GROWTH: f64 = 1e3;
        const HALVINGS: u32 = 4;
        const MOST_PIECES: f64 = 128.0;
        let even = 2.0 * libm::ceil(libm::log(self.growth) / libm::log(GROWTH)).max(1.0);
        let counts = (0..HALVINGS).map(|halvings| even * libm::exp2(f64::from(halvings)));
        counts.take_while(|pieces| *pieces <= MOST_PIECES).any(|pieces| {
            let starts = std::iter::successors(Some(0.0), |k| Some(k + 1.0)).take_while(|k| *k < pieces);
            let states = starts.map(|k| state_at(k / pieces)).collect::<Option<Vec<_>>>();
            let further = self.position[self.frame.shift.len()..].to_vec();
            let between = |number: usize, state: &[f64], further: &[f64]| {
                piece([number, number + 1].map(|k| count(k) / pieces), state, further)
            };
            let nodes = states.map(|states| Nodes { states, further });
            nodes.and_then(|nodes| nodes.closed(self.frame, between)).is_some_and(|nodes| self.holds(&nodes))
        })
    }

    /// Returns `true` if the found orbit lies within the errors of this one.
    fn holds(&self, nodes: &Nodes) -> bool {
        let orbit = nodes.states[0].iter().chain(&nodes.further);
        let off = orbit.zip(self.position).map(|(a, b)| a - b);
        let allowed = self.errors.iter().zip(self.position).zip(self.frame.units);
        off.zip(allowed).all(|(off, ((error, x), unit))| {
            off.abs() <= CLOSED * (error * unit + f64::EPSILON * x.abs().max(*unit))
        })
    }
}

impl Piece {
    /// The derivative of the end of a piece by the duration of an orbit; `parts` are start
    /// and end of the piece as fractions of the duration, `rates` the rates of change there.
    pub fn by_duration(by_start: &[Vec<f64>], rates: [&[f64]; 2], parts: [f64; 2]) -> Vec<f64> {
        let grown = |row: &Vec<f64>| row.iter().zip(rates[0]).map(|(x, rate)| x * rate).sum::<f64>();
        let rows = by_start.iter().zip(rates[1]);
        rows.map(|(row, rate)| parts[1] * rate - parts[0] * grown(row)).collect()
    }
}

impl Nodes {
    /// The orbit next to these nodes whose pieces, integrated separately, all end at the beginning of the next one within the rounding error of
    /// a state, grown over the piece; `None` if Newton's method finds none. `piece` integrates the piece with a given number from a state.
    pub fn closed(
        mut self,
        frame: Frame<'_>,
        piece: impl Fn(usize, &[f64], &[f64]) -> Option<Piece>,
    ) -> Option<Self> {
        const MOST_ROUNDS: usize = 6;
        for _ in 0..MOST_ROUNDS {
            let numbered = self.states.iter().enumerate();
            let pieces: Vec<Piece> =
                numbered.map(|(number, state)| piece(number, state, &self.further)).collect::<Option<_>>()?;
            let missed: Vec<Vec<f64>> =
                pieces.iter().enumerate().map(|(number, part)| self.missed(frame, number, part)).collect();
            let rounding = f64::EPSILON * (1.0 + self.size(frame));
            let joins = |(missed, piece): (&Vec<f64>, &Piece)| {
                largest(missed) <= CLOSED * (1.0 + frame.norm(piece)) * rounding
            };
            if missed.iter().zip(&pieces).all(joins) {
                return Some(self);
            }
            self.improve(frame, &pieces, missed)?;
        }
        None
    }

    /// The state at the beginning of the piece after a numbered one.
    fn next(&self, frame: Frame<'_>, number: usize) -> Vec<f64> {
        match self.states.get(number + 1) {
            Some(next) => next.clone(),
            None => self.states[0].iter().zip(frame.shift).map(|(x, shift)| x + shift).collect(),
        }
    }

    /// The end of a piece minus the beginning of the next one, in scaled units.
    fn missed(&self, frame: Frame<'_>, number: usize, piece: &Piece) -> Vec<f64> {
        let next = self.next(frame, number);
        piece.end.iter().zip(next).zip(frame.units).map(|((end, next), unit)| (end - next) / unit).collect()
    }

    /// The largest component of a state in scaled units.
    fn size(&self, frame: Frame<'_>) -> f64 {
        let parts = self.states.iter().map(|state| {
            largest(&state.iter().zip(frame.units).map(|(x, unit)| x / unit).collect::<Vec<_>>())
        });
        parts.fold(0.0, f64::max)
    }

    /// One step of Newton's method for all states and the further unknowns together.
    fn improve(&mut self, frame: Frame<'_>, pieces: &[Piece], missed: Vec<Vec<f64>>) -> Option<()> {
        let (count, numbers) = (pieces.len(), frame.shift.len());
        let unknowns = count * numbers + self.further.len();
        let units = frame.units;
        let mut rows = vec![];
        for (number, piece) in pieces.iter().enumerate() {
            let after = (number + 1) % count;
            for i in 0..numbers {
                let mut row = vec![0.0; unknowns];
                row[after * numbers + i] -= 1.0;
                for j in 0..numbers {
                    row[number * numbers + j] += piece.by_start[i][j] * units[j] / units[i];
                }
                for (k, column) in piece.by_further.iter().enumerate() {
                    row[count * numbers + k] = column[i] * units[numbers + k] / units[i];
                }
                rows.push(row);
            }
        }
        for condition in frame.conditions {
            let mut row = vec![0.0; unknowns];
            row[..numbers].copy_from_slice(&condition[..numbers]);
            row[count * numbers..].copy_from_slice(&condition[numbers..]);
            rows.push(row);
        }
        let mut right: Vec<f64> = missed.iter().flatten().map(|x| -x).collect();
        right.resize(rows.len(), 0.0);
        /// Largest step of a further unknown, in its unit. Next to a separatrix a step may make the period a million times as long.
        const FARTHEST: f64 = 0.5;
        let change = least_squares(&rows, &right)?;
        let (of_states, of_further) = change.split_at(count * numbers);
        if largest(of_further) > FARTHEST {
            return None;
        }
        for (x, (change, unit)) in
            self.states.iter_mut().flatten().zip(of_states.iter().zip(units[..numbers].iter().cycle()))
        {
            *x += change * unit;
        }
        for (x, (change, unit)) in self.further.iter_mut().zip(of_further.iter().zip(&units[numbers..])) {
            *x += change * unit;
        }
        Some(())
    }
}

fn largest(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0, |largest: f64, x| if x.is_nan() { f64::INFINITY } else { largest.max(x.abs()) })
}
