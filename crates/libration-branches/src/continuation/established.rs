//! Test whether a step along a branch may have skipped special points.
//!
//! # Method
//! The test functions are symmetric polynomials of the multipliers, and the slope of the parameter; they are smooth along a
//! branch. On a step each test function is interpolated by the parabola through the last two nodes and the new one. The third
//! derivative, and with it the interpolation error inside the step, is estimated from the error with which the parabola through
//! the three earlier nodes predicts the new node. A step is accepted if each interpolated test function stays farther from zero
//! than [`SAFETY`] times that error, or crosses zero once with a slope that the error cannot reverse; otherwise it is halved.
//!
//! This is an estimate, not a proof: it detects windows of any width in which a test function
//! varies on the scale of the steps, and misses those in which it varies only within a step.

use super::node::Tests;
use super::special::Test;

/// Multiple of the estimated interpolation error that a test function must stay away from zero. The estimate is not a bound: on the accepted
/// steps of the random oscillators of the tests, the error at the quarters of a step has a median of 2.6 to 3.3 times the estimate (87 times for
/// the slope of the parameter, which is usually far from zero). It exceeds this multiple in 9577 of 25 922 cases, and the value at the end of
/// the step in 25. With zero in place of this multiple, tongues within a step are skipped.
const SAFETY: f64 = 4.0;

/// The test functions at a node, and its distance along the branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Milestone {
    pub(super) at: f64,
    pub(super) tests: Tests,
}

/// `true` if no test function can have hidden zeros, which its signs do not show, between the last node and the next one. `before` are the nodes
/// up to the last one; `middle` is evaluated if there is only one of them.
pub(super) fn is_established(
    before: &[Milestone],
    next: &Milestone,
    middle: impl FnOnce() -> Option<Milestone>,
) -> bool {
    match before {
        [] => false,
        [start] => middle().is_some_and(|middle| {
            let turned = |milestone: &Milestone| Milestone { at: -milestone.at, ..*milestone };
            is_clear(&[*start, middle], next) && is_clear(&[turned(next), turned(&middle)], &turned(start))
        }),
        _ => is_clear(before, next),
    }
}

/// `true` if no test function can have hidden zeros between the last of two or more nodes and the next one.
fn is_clear(before: &[Milestone], next: &Milestone) -> bool {
    let Some(&[a, b]) = before.last_chunk::<2>() else { return false };
    let earlier = before.len().checked_sub(3).map(|index| before[index]);
    let is_clear_of = |test: Test| {
        let value = |milestone: &Milestone| (milestone.at, test.of(&milestone.tests));
        let three = [value(&a), value(&b), value(next)];
        // A test function without a sign, as in conservative systems, is pure rounding and cannot be tested.
        if [&b, next].iter().any(|milestone| !test.has_sign(&milestone.tests)) {
            return true;
        }
        let off = match &earlier {
            Some(earlier) => (three[2].1 - parabola([value(earlier), three[0], three[1]], next.at)).abs(),
            None => (three[2].1 - line([three[0], three[1]], next.at)).abs(),
        };
        let [first, step] = [b.at - a.at, next.at - b.at];
        let whole = earlier.map_or(first + step, |earlier| next.at - earlier.at);
        // The error t(t + first)(step − t) relative to step(step + first)·whole has its maximum at most at step²/4·(step + first).
        is_clear_of_zero(three, SAFETY * off * 0.25 * step / whole)
    };
    [Test::Fold, Test::Branching, Test::Flip, Test::Torus].into_iter().all(is_clear_of)
}

/// Returns `true` if the parabola through three points, between the last two of them, is farther
/// from zero than an error, or crosses zero once with such a slope that the error leaves one zero.
fn is_clear_of_zero(points: [(f64, f64); 3], error: f64) -> bool {
    let [_, (from, start), (to, end)] = points;
    let step = to - from;
    let slope = |at: f64| slope_of_parabola(points, at);
    if (start > 0.0) != (end > 0.0) {
        // Within the error of zero, the slope must exceed what an error of this size over a quarter of the step can change.
        let part = start / (start - end);
        return slope(from + part * step).abs() * step > 4.0 * error;
    }
    let [before, after] = [slope(from), slope(to)];
    let mut least = start.abs().min(end.abs());
    if before * start < 0.0 && after * end > 0.0 {
        let turn = from + step * before / (before - after);
        least = parabola(points, turn) * start.signum();
    }
    least > error
}

fn line([(x0, y0), (x1, y1)]: [(f64, f64); 2], x: f64) -> f64 {
    y1 + (x - x1) * (y1 - y0) / (x1 - x0)
}

/// The parabola through three points, by Newton's divided differences.
fn parabola(points: [(f64, f64); 3], x: f64) -> f64 {
    let [(x0, _), (x1, _), _] = points;
    line([points[0], points[1]], x) + (x - x0) * (x - x1) * bend(points)
}

fn slope_of_parabola(points: [(f64, f64); 3], x: f64) -> f64 {
    let [(x0, y0), (x1, y1), _] = points;
    (y1 - y0) / (x1 - x0) + ((x - x0) + (x - x1)) * bend(points)
}

/// Half the second derivative.
fn bend([(x0, y0), (x1, y1), (x2, y2)]: [(f64, f64); 3]) -> f64 {
    ((y2 - y1) / (x2 - x1) - (y1 - y0) / (x1 - x0)) / (x2 - x0)
}
