//! Where a polynomial first changes its sign, none missed.
//!
//! A polynomial has no more zeros inside an interval than its coefficients in Bernstein's basis change sign: G. Farin,
//! *Curves and Surfaces for CAGD*, 5th ed., Morgan Kaufmann 2002, section 6.

/// The first place in 0 < x ≤ 1 behind which Σ cₙxⁿ has the other sign; `None` if there is none.
pub(super) fn first_sign_change(coefficients: &[f64]) -> Option<f64> {
    first_within(bernstein(coefficients), 0.0, 1.0)
}

/// Below this two zeros are one.
const NARROWEST: f64 = f64::EPSILON;

fn first_within(form: Vec<f64>, from: f64, to: f64) -> Option<f64> {
    let signs = || form.iter().filter(|c| **c != 0.0).map(|c| c.is_sign_positive());
    if signs().zip(signs().skip(1)).all(|(before, after)| before == after) {
        return None;
    }
    if to - from <= NARROWEST * to {
        return (signs().next() != signs().next_back()).then_some(to);
    }
    let middle = 0.5 * (from + to);
    let (left, right) = halves(form);
    first_within(left, from, middle).or_else(|| first_within(right, middle, to))
}

/// The coefficients βᵢ = Σⱼ (i over j)/(m over j)·cⱼ in Bernstein's basis.
fn bernstein(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.len().saturating_sub(1);
    let count = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    let coefficient = |i: usize| {
        let mut ratio = 1.0;
        let mut sum = 0.0;
        for (j, c) in coefficients.iter().enumerate().take(i + 1) {
            sum += ratio * c;
            ratio *= count(i - j) / count((degree - j).max(1));
        }
        sum
    };
    (0..coefficients.len()).map(coefficient).collect()
}

/// De Casteljau's division in the middle.
fn halves(mut form: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let mut left = Vec::with_capacity(form.len());
    for last in (0..form.len()).rev() {
        left.push(form[0]);
        for i in 0..last {
            form[i] = 0.5 * (form[i] + form[i + 1]);
        }
    }
    (left, form)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_several_zeros_is_found() {
        // (x − 0.2)(x − 0.2001)(x − 0.9).
        let cubic = [-0.2 * 0.2001 * 0.9, 0.2 * 0.2001 + 0.9 * 0.4001, -1.3001, 1.0];
        let first = first_sign_change(&cubic).unwrap();
        assert!((first - 0.2).abs() < 1e-11, "{first}");
    }

    #[test]
    fn touching_is_no_change_of_sign() {
        assert_eq!(first_sign_change(&[0.25, -1.0, 1.0]), None);
        assert_eq!(first_sign_change(&[1.0, -3.0, 3.0]), None);
        assert_eq!(first_sign_change(&[0.0, 0.0]), None);
        assert_eq!(first_sign_change(&[]), None);
    }
}
