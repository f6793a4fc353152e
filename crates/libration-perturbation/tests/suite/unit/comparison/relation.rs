use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::oscillator::NamedOscillator;
use libration::perturbation::{Gauge, expand};
use libration::progress::Quiet;

fn differs_by(key: &str, quantity: SeriesQuantity, amplitude: f64) -> f64 {
    let oscillator = NamedOscillator::by_key(key).unwrap().oscillator(&[]).unwrap();
    let expansion = expand(&oscillator, 31, &Gauge::Fundamental, &Quiet).unwrap();
    let relation = SeriesComparison::new(&oscillator, &expansion, quantity);
    let exact = relation.exact_at(amplitude, &Quiet).unwrap();
    let error = relation.evaluation_at(amplitude).value() - exact.value;
    f64::max(error.abs() - exact.uncertainty, 0.0)
}

/// Series to the 30th power and motions meet where (amplitude/radius)³⁰ is below the last digit.
#[test]
fn series_and_motions_agree_in_every_quantity() {
    let cases = [
        ("pendulum", 0.8),
        ("duffing", 0.25),
        ("quadratic", 0.1),
        ("relativistic", 0.5),
        ("toda", 0.5),
        ("morse", 0.15),
        ("double_well", 0.1),
        ("mathews_lakshmanan", 0.2),
        ("van_der_pol", 0.3),
        ("rayleigh", 0.3),
        ("rayleigh_cubic", 0.3),
    ];
    for (key, amplitude) in cases {
        for quantity in [
            SeriesQuantity::Period,
            SeriesQuantity::Frequency,
            SeriesQuantity::Cosine(1),
            SeriesQuantity::Cosine(3),
        ] {
            let missing = differs_by(key, quantity, amplitude);
            assert!(missing < 1e-13, "{key}, {quantity}: {missing:e}");
        }
    }
}

#[test]
fn approximants_of_harmonics_keep_their_leading_power() {
    let pendulum = NamedOscillator::by_key("pendulum").unwrap().oscillator(&[]).unwrap();
    let expansion = expand(&pendulum, 31, &Gauge::Fundamental, &Quiet).unwrap();
    let third = SeriesComparison::new(&pendulum, &expansion, SeriesQuantity::Cosine(3));
    let value = third.approximant(6).unwrap().value_at(2.0);
    assert!((value / third.exact_at(2.0, &Quiet).unwrap().value - 1.0).abs() < 1e-7, "{value}");
}
