use libration::double_double::DoubleDouble;
use libration::elementary::two_word;
use libration::internals::elliptic::{CircularSide, PhaseClock, ThetaSeries, ThetaZero};

/// Σ (±1)ⁿ q^(n(n+1)) f((2n+1)z); `ThetaSeries` has four terms of it.
fn sums(q: f64, z: f64) -> [DoubleDouble; 2] {
    let (mut first, mut second) = (DoubleDouble::ZERO, DoubleDouble::ZERO);
    let (mut power, mut ratio) = (DoubleDouble::ONE, DoubleDouble::from(q).square());
    for n in 0..6_u32 {
        let (sine, cosine) = two_word::sin_cos(DoubleDouble::from(z) * f64::from(2 * n + 1));
        first = first + (if n % 2 == 0 { sine } else { -sine }) * power;
        second = second + cosine * power;
        power = power * ratio;
        ratio = ratio * DoubleDouble::from(q).square();
    }
    [first, second]
}

/// The terms after the leading 1 are summed in one word: the error is a few times 2⁻⁵³ of these terms, which are of order q.
#[test]
fn the_values_at_zero_are_those_of_more_terms() {
    for q in [1e-3, 0.01, 0.03, libm::exp(-std::f64::consts::PI)] {
        let (series, exact) = (ThetaSeries::new(q), ThetaZero::in_two_words(DoubleDouble::from(q)));
        let pairs = [(series.second_at_zero(), exact.second), (series.fourth_at_zero(), exact.fourth)];
        for (value, exact) in pairs {
            assert!((value - exact).to_f64().abs() <= 4.0 * q * f64::EPSILON, "{q}");
        }
    }
}

#[test]
fn four_terms_suffice_at_the_largest_nome() {
    let q = libm::exp(-std::f64::consts::PI);
    let series = ThetaSeries::new(q);
    // 11z stays within the reduced range of the two-word sine.
    for z in [0.01, 0.05, 0.1, 0.14] {
        let (sine, cosine) = two_word::sin_cos(DoubleDouble::from(z));
        let values = series.at::<CircularSide>(sine, cosine);
        let [first, second] = sums(q, z);
        // The polynomials are below 0.1 of the sum, so that their rounding, 2⁻⁵³ of themselves, is about half of this bound.
        for (got, expected) in [(values.first, first), (values.second, second)] {
            let error = ((got - expected) / expected).to_f64().abs();
            assert!(error < 2e-17, "{z}: {error:e}");
        }
    }
}

#[test]
fn the_phase_is_known_to_two_to_the_ninety_seven_turns() {
    // The frequency ¼ + 2⁻⁶² gives whole turns at 2⁶² and at three times that time, and a quarter more at 2⁶⁰.
    let frequency = DoubleDouble::new(0.25, libm::exp2(-62.0));
    let clock = PhaseClock { frequency, quarter: 0.0, offset: DoubleDouble::ZERO };
    for (exponent, quarter) in [(60.0, 1.0), (61.0, 2.0), (62.0, 0.0), (80.0, 0.0)] {
        let phase = clock.phase(libm::exp2(exponent));
        assert!((phase.quarter.abs() - quarter).abs() < 0.5 && phase.rest.hi.abs() < 1e-15, "{phase:?}");
    }
    let later = PhaseClock { offset: DoubleDouble::new(0.1, 0.0), ..clock }.phase(libm::exp2(80.0));
    // 2⁻¹⁰⁴ of 2⁷⁸ turns.
    assert!((later.rest.hi - 0.1).abs() < 1.5e-8, "{later:?}");
    let last = libm::exp2(99.0) * (1.0 - f64::EPSILON);
    assert!(clock.phase(last).rest.hi.abs() <= 0.125);
    assert!(
        clock.phase(libm::exp2(99.0)).rest.hi.is_nan() && clock.phase(-libm::exp2(99.0)).rest.hi.is_nan()
    );
}
