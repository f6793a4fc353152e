//! The largest errors of the catalogue up to 90°, computed once.

use super::formula::PeriodFormula;
use libration_numbers::quantity::Angle;
use std::f64::consts::FRAC_PI_2;

/// Keys, with the largest fractional error up to 90° as [`PeriodFormula::worst_error`] finds it; a test compares them.
const TO_90DEG: [(&str, f64); 34] = [
    ("small_angle", -0.1527869152060209),
    ("bernoulli", -0.022136009106909223),
    ("power_series_2", -0.003666998252399906),
    ("power_series_3", -0.0006807523498692445),
    ("denman", 0.0016855932215994439),
    ("black_vel_2", -0.0006560033716248641),
    ("black_vel_3", -0.00010329997510900397),
    ("sin2_series_1", -0.04688527960677352),
    ("sin2_series_2", -0.017100444594485197),
    ("sin2_series_3", -0.006758487992996196),
    ("sin2_series_4", -0.002799457731488688),
    ("pade_power_1", -0.0006263617824932769),
    ("pade_power_2", 1.7448410773777085e-6),
    ("pade_sin2_1", -0.005445509154894114),
    ("pade_sin2_2", -0.00016922231981259854),
    ("molina", 0.0035467493041692016),
    ("kidd_fogg", 0.007511828360403561),
    ("butikov", -0.40494407843590297),
    ("carvalhaes_suppes", -1.3949223487512621e-5),
    ("belendez", -2.1313252265849047e-6),
    ("cubic_force", 0.018762745400945087),
    ("ganley_parwani", -0.0007772350899894335),
    ("lima_arun", 0.0024871238696438716),
    ("cromer", -0.11745759938939362),
    ("two_term_log", -0.05597694232863737),
    ("lima_2008", -0.005818908782271608),
    ("chachiyo", 0.0005594126978985057),
    ("agm_a1", -0.007428130295268067),
    ("agm_a3", -4.864622683586236e-11),
    ("agm_a4", -5.916138463847134e-22),
    ("agm_a5", -8.750173580852882e-44),
    ("agm_b2", 1.3949515364873669e-5),
    ("nome_one_root", -1.01784084675292e-14),
    ("describing_function", -0.002728412677899023),
];

impl PeriodFormula {
    /// The fractional error of the largest magnitude up to 90°, with its sign: stored for the catalogue, searched for others.
    #[must_use]
    pub fn worst_error_to_90deg(&self) -> f64 {
        let stored = TO_90DEG.iter().find(|(key, _)| *key == self.key);
        stored.map_or_else(|| self.searched_to_90deg(), |&(_, error)| error)
    }

    fn searched_to_90deg(&self) -> f64 {
        let angle = |radians| Angle::from_radians(radians).ok();
        let worst = angle(0.0).zip(angle(FRAC_PI_2)).and_then(|(from, to)| self.worst_error(&from, &to));
        worst.map_or(f64::NAN, |worst| worst.error)
    }
}
