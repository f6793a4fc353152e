//! Corrections of g against periods of an independent program, and their uncertainties against repeated draws of the inputs.

use libration::quantity::Quantity;
use libration_lab::fit::{
    Apparatus, Bob, BobShape, BudgetError, Correction, Corrections, MeasuredPeriod, evaluate_budget,
};

use super::{about, exactly, small_swings};
use crate::random::Random;
use crate::synthetic_trace::normal;

const G: f64 = 9.81;

fn bob(shape: BobShape, radius: f64, height: f64, inner: f64) -> Option<Bob> {
    let given = |length: f64| (length > 0.0).then(|| exactly(length));
    Some(Bob { shape, radius: exactly(radius), height: given(height), inner_radius: given(inner) })
}

fn with_bob(shape: BobShape, radius: f64, height: f64, inner: f64) -> Corrections {
    Corrections { bob: bob(shape, radius, height, inner), ..Corrections::default() }
}

/// Corrections in vacuum, with a bob of 200 g.
fn with_mass(change: impl FnOnce(&mut Corrections)) -> Corrections {
    let mut corrections = Corrections { bob_mass: Some(exactly(0.2)), ..Corrections::default() };
    corrections.air_density = exactly(1e-12);
    change(&mut corrections);
    corrections
}

fn with_rod(corrections: &mut Corrections) {
    (corrections.rod_mass, corrections.rod_length) = (Some(exactly(0.03)), Some(exactly(0.55)));
}

fn warm(corrections: &mut Corrections) {
    (corrections.expansion, corrections.warming) = (Some(exactly(1.2e-5)), Some(exactly(5.0)));
}

/// T0 of a length of 0.6 m at 9.81 m/s² by `reference/corrections.py`.
fn cases() -> Vec<(&'static str, Corrections, f64)> {
    use BobShape::{Ball, Cap, Cylinder, Disc, Gyration, Ring};
    let stiffness = Some(exactly(400.0));
    let edge = Some(exactly(0.002));
    vec![
        ("ball", with_bob(Ball, 0.05, 0.0, 0.0), 1.5560492566176121),
        ("disc", with_bob(Disc, 0.05, 0.0, 0.0), 1.5565879615867083),
        ("cylinder", with_bob(Cylinder, 0.03, 0.08, 0.0), 1.555528331142937),
        ("ring", with_bob(Ring, 0.05, 0.0, 0.03), 1.5575571610063808),
        ("cap", with_bob(Cap, 0.05, 0.03, 0.0), 1.5548194688387019),
        ("gyration", with_bob(Gyration, 0.04, 0.0, 0.0), 1.557341835483681),
        ("support", with_mass(|corrections| corrections.support_stiffness = stiffness), 1.5602311768698379),
        (
            "support and rod",
            with_mass(|corrections| {
                corrections.support_stiffness = stiffness;
                with_rod(corrections);
            }),
            1.5413713347513706,
        ),
        (
            "support and disc",
            with_mass(|corrections| {
                corrections.support_stiffness = stiffness;
                corrections.bob = bob(Disc, 0.05, 0.0, 0.0);
            }),
            1.5628939628962169,
        ),
        ("knife edge", with_mass(|corrections| corrections.edge_radius = edge), 1.5513092048259973),
        (
            "knife edge and rod",
            with_mass(|corrections| {
                corrections.edge_radius = edge;
                with_rod(corrections);
            }),
            1.531588940099452,
        ),
        ("temperature", with_mass(warm), 1.5539391852326298),
        (
            "temperature and rod",
            with_mass(|corrections| {
                with_rod(corrections);
                warm(corrections);
            }),
            1.5343792200860117,
        ),
        (
            "all",
            with_mass(|corrections| {
                corrections.bob = bob(Cylinder, 0.03, 0.08, 0.0);
                (corrections.support_stiffness, corrections.edge_radius) = (stiffness, edge);
                with_rod(corrections);
                warm(corrections);
            }),
            1.5402115827598097,
        ),
    ]
}

#[test]
fn corrections_give_the_g_of_an_independent_program() {
    for (name, corrections, t0) in cases() {
        let apparatus = Apparatus { length: exactly(0.6), corrections };
        let budget = evaluate_budget(&apparatus, &small_swings(t0), &[]).unwrap();
        // Air of 1e-12 kg/m³ is 1e-15 of the bob.
        assert!((budget.g / G - 1.0).abs() < 1e-12, "{name}: {}", budget.g);
        let bare = evaluate_budget(&Apparatus::of_length(exactly(0.6)), &small_swings(t0), &[]).unwrap();
        assert!((bare.g / G - 1.0).abs() > 5e-5, "{name}");
    }
}

/// A hemisphere has κ = 83r²/320 (E. Hecht and others, tables of moments of inertia), a cap as high as its ball is the ball, and a low one a disc about
/// its diameter, b²/6 with b² = 2rh for the paraboloid that it nearly is.
#[test]
fn a_cap_is_between_disc_and_ball() {
    let gyration = |height: f64| bob(BobShape::Cap, 0.1, height, 0.0).unwrap().gyration();
    assert!((gyration(0.1) / (83.0 / 320.0 * 0.01) - 1.0).abs() < 1e-13);
    assert!((gyration(0.2) / (0.4 * 0.01) - 1.0).abs() < 1e-13);
    assert!((gyration(1e-6) / (2.0 * 0.1 * 1e-6 / 6.0) - 1.0).abs() < 1e-4);
}

#[test]
fn impossible_corrections_are_refused() {
    let refused = |corrections: Corrections| {
        evaluate_budget(&Apparatus { length: exactly(0.6), corrections }, &small_swings(1.55), &[])
            .unwrap_err()
    };
    for (shape, height, inner) in
        [(BobShape::Cap, 0.11, 0.0), (BobShape::Cylinder, 0.0, 0.0), (BobShape::Ring, 0.0, 0.05)]
    {
        let error = refused(with_bob(shape, 0.05, height, inner));
        assert!(
            matches!(error, BudgetError::Bob { shape: refused, .. } if refused == shape.name()),
            "{error}"
        );
    }
    let weak =
        |stiffness: f64| with_mass(|corrections| corrections.support_stiffness = Some(exactly(stiffness)));
    // mω² = 0.2 kg (2π/1.55 s)² = 3.2865 N/m.
    assert_eq!(refused(weak(3.28)), BudgetError::SupportTooWeak);
    let outcome = evaluate_budget(
        &Apparatus { length: exactly(0.6), corrections: weak(3.29) },
        &small_swings(1.55),
        &[],
    );
    assert!(outcome.is_ok_and(|budget| budget.g > 100.0));
    let support = Corrections { support_stiffness: Some(exactly(400.0)), ..Corrections::default() };
    assert_eq!(refused(support), BudgetError::SupportWithoutBob);
    let warming = Corrections { warming: Some(exactly(1.0)), ..Corrections::default() };
    assert_eq!(refused(warming), BudgetError::WarmingWithoutExpansion);
    let nan = with_mass(|corrections| {
        (corrections.expansion, corrections.warming) = (Some(exactly(1e-5)), Some(exactly(f64::NAN)));
    });
    assert!(matches!(refused(nan), BudgetError::NotFinite { .. }));
}

/// A temperature difference of zero with an uncertainty: the correction is zero, and its uncertainty α·u(Δt).
#[test]
fn a_temperature_that_may_differ_is_an_uncertainty() {
    let corrections = with_mass(|corrections| {
        (corrections.expansion, corrections.warming) = (Some(exactly(1.9e-5)), Some(about(0.0, 2.0)));
    });
    let apparatus = Apparatus { length: about(0.6, 0.0), corrections };
    let budget = evaluate_budget(&apparatus, &small_swings(1.55), &[]).unwrap();
    let row = budget.rows.iter().find(|row| row.name == "temperature").unwrap();
    assert_eq!(row.correction, Correction::Applied(0.0));
    assert!((row.uncertainty.unwrap() / (budget.g * 3.8e-5) - 1.0).abs() < 1e-9, "{row:?}");
    assert!((budget.uncertainty / (budget.g * 3.8e-5) - 1.0).abs() < 1e-9);
}

/// A cylinder on a rod, each size with its own uncertainty: u(g) is the scatter of g over 20 000 draws of all inputs, whose own standard uncertainty is
/// 0.5 %; the effects are not quite linear.
#[test]
fn the_budget_is_the_scatter_of_drawn_inputs() {
    let apparatus = |draw: &mut dyn FnMut(f64, f64) -> f64| -> Apparatus {
        let mut one = |value: f64, uncertainty: f64| about(draw(value, uncertainty), uncertainty);
        let bob = Bob {
            shape: BobShape::Cylinder,
            radius: one(0.03, 0.002),
            height: Some(one(0.08, 0.004)),
            inner_radius: None,
        };
        let corrections = Corrections {
            bob: Some(bob),
            bob_mass: Some(one(0.2, 0.01)),
            rod_mass: Some(one(0.03, 0.004)),
            rod_length: Some(one(0.55, 0.01)),
            air_density: one(1.2, 0.1),
            expansion: Some(one(1.2e-5, 2e-6)),
            warming: Some(one(5.0, 20.0)),
            support_stiffness: Some(one(2000.0, 100.0)),
            edge_radius: Some(one(0.002, 0.0003)),
            ..Corrections::default()
        };
        Apparatus { length: one(0.6, 2e-4), corrections }
    };
    let period = |t0: f64| MeasuredPeriod::of_small_swings(Quantity { value: t0, uncertainty: Some(0.0) });
    let budget = evaluate_budget(&apparatus(&mut |value, _| value), &period(1.55), &[]).unwrap();
    let mut random = Random::seeded(38);
    let draws: Vec<f64> = (0..20_000)
        .map(|_| {
            let drawn = apparatus(&mut |value, uncertainty| value + uncertainty * normal(&mut random));
            evaluate_budget(&drawn, &period(1.55), &[]).unwrap().g
        })
        .collect();
    let mean = draws.iter().sum::<f64>() / 20_000.0;
    let scatter = (draws.iter().map(|g| (g - mean) * (g - mean)).sum::<f64>() / 19_999.0).sqrt();
    // The added mass, 0.58 of k = 1/2 and 2.3e-3 of air over bob, is not drawn.
    let added = 9.8 * 0.5 / 3.0_f64.sqrt() * 1.2 * std::f64::consts::PI * 0.03 * 0.03 * 0.08 / 0.2;
    let wanted = libm::hypot(scatter, added);
    assert!((budget.uncertainty / wanted - 1.0).abs() < 0.025, "{} {wanted}", budget.uncertainty);
    assert!(budget.uncertainty > 3.0 * 9.8 * 2e-4 / 0.6, "the corrections matter");
}
