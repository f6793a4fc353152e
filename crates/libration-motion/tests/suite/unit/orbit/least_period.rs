use libration::internals::orbit::over_least_period;
use libration::orbit::{Orbit, OrbitError};
use libration::progress::Quiet;
use std::f64::consts::PI;

/// Newton's method, where errors are large, may lead from a part of the period back to the whole, again and again.
#[test]
fn an_orbit_that_newtons_method_leads_back_to_is_no_part_of_itself() {
    let equation = "x'' = -x - x'/3 + cos(2t)".parse().unwrap();
    let over = |periods: f64| Orbit::driven(&equation, &[-0.3, 0.1], periods * PI, &Quiet).unwrap();
    let four = over(4.0);
    assert!(four.repeats_after(2));
    let back = over_least_period(four.clone(), |_, _| Ok(four.clone())).unwrap();
    assert_eq!(back.period().to_bits(), four.period().to_bits());
    let least = over_least_period(four, |_, period| {
        assert!(period > 0.9 * PI, "{period}");
        Ok::<_, OrbitError>(over(period / PI))
    });
    assert!((least.unwrap().period() - PI).abs() < 1e-14);
}
