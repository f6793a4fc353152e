//! Nonlinear least squares problems with certified solutions.
//!
//! National Institute of Standards and Technology, *Statistical Reference Datasets*, nonlinear regression, doi:10.18434/T43G6C: the
//! measurements, both starting values and the certified parameters. Newton's method with forty digits confirms all the digits here.

use libration_lab::internals::statistics::levenberg_marquardt::{
    Effort, Linearised, ResidualsError, minimum,
};
use nalgebra::{DMatrix, DVector};

const EFFORT: Effort = Effort { tolerance: 1e-14, patience: 1000 };

/// A model with its derivatives by the parameters.
type Model = fn(&DVector<f64>, f64) -> (f64, Vec<f64>);

struct Dataset {
    measured: Vec<(f64, f64)>,
    model: Model,
    starts: [&'static [f64]; 2],
    certified: &'static [f64],
    sum_of_squares: f64,
}

fn linearised(model: Model, measured: &[(f64, f64)], parameters: &DVector<f64>) -> Linearised {
    let rows: Vec<(f64, Vec<f64>)> = measured.iter().map(|&(x, _)| model(parameters, x)).collect();
    Linearised {
        residuals: DVector::from_fn(rows.len(), |i, _| rows[i].0 - measured[i].1),
        jacobian: DMatrix::from_fn(rows.len(), parameters.len(), |i, k| rows[i].1[k]),
    }
}

fn check(dataset: &Dataset) {
    for start in dataset.starts {
        let evaluate = |parameters: &DVector<f64>| {
            let linearised = linearised(dataset.model, &dataset.measured, parameters);
            let finite = linearised
                .residuals
                .iter()
                .chain(linearised.jacobian.iter())
                .all(|number| number.is_finite());
            if finite { Ok(linearised) } else { Err(ResidualsError::OutOfDomain) }
        };
        let minimum = minimum(DVector::from_row_slice(start), EFFORT, evaluate).unwrap();
        assert!(minimum.converged, "{start:?}: {}", minimum.parameters);
        for (parameter, certified) in minimum.parameters.iter().zip(dataset.certified) {
            assert!((parameter / certified - 1.0).abs() < 1e-7, "{start:?}: {parameter} is not {certified}");
        }
        let sum = minimum.linearised.residuals.norm_squared();
        assert!((sum / dataset.sum_of_squares - 1.0).abs() < 1e-9, "{start:?}: {sum}");
    }
}

fn pairs(x: &[f64], y: &[f64]) -> Vec<(f64, f64)> {
    assert_eq!(x.len(), y.len());
    x.iter().copied().zip(y.iter().copied()).collect()
}

/// Dental research, the adsorption of a monomolecular layer: b₁(1 − e^(−b₂x)).
#[test]
fn misra1a() {
    let x = [77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0];
    let y =
        [10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78];
    check(&Dataset {
        measured: pairs(&x, &y),
        model: |b, x| {
            let fallen = libm::exp(-b[1] * x);
            (b[0] * (1.0 - fallen), vec![1.0 - fallen, b[0] * x * fallen])
        },
        starts: [&[500.0, 0.0001], &[250.0, 0.0005]],
        certified: &[2.3894212918e2, 5.5015643181e-4],
        sum_of_squares: 1.2455138894e-1,
    });
}

/// The semiconductor electron mobility against the logarithm of density: a quotient of two cubics.
#[test]
fn thurber() {
    let x = [
        -3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481, -2.363, -2.322,
        -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714, -0.566, -0.545, -0.400, -0.309,
        -0.109, -0.103, 0.010, 0.119, 0.377, 0.790, 0.963, 1.006, 1.115, 1.572, 1.841, 2.047, 2.200,
    ];
    let y = [
        80.574, 84.248, 87.264, 87.195, 89.076, 89.608, 89.868, 90.101, 92.405, 95.854, 100.696, 101.060,
        401.672, 390.724, 567.534, 635.316, 733.054, 759.087, 894.206, 990.785, 1090.109, 1080.914, 1122.643,
        1178.351, 1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384, 1442.962,
        1464.350, 1468.705, 1447.894, 1457.628,
    ];
    check(&Dataset {
        measured: pairs(&x, &y),
        model: |b, x| {
            let powers = [1.0, x, x * x, x * x * x];
            let upper: f64 = (0..4).map(|k| b[k] * powers[k]).sum();
            let lower: f64 = 1.0 + (1..4).map(|k| b[3 + k] * powers[k]).sum::<f64>();
            let of_upper = powers.iter().map(|power| power / lower);
            let of_lower = powers[1..].iter().map(|power| -power * upper / (lower * lower));
            (upper / lower, of_upper.chain(of_lower).collect())
        },
        starts: [
            &[1000.0, 1000.0, 400.0, 40.0, 0.7, 0.3, 0.03],
            &[1300.0, 1500.0, 500.0, 75.0, 1.0, 0.4, 0.05],
        ],
        certified: &[
            1.2881396800e3,
            1.4910792535e3,
            5.8323836877e2,
            7.5416644291e1,
            9.6629502864e-1,
            3.9797285797e-1,
            4.9727297349e-2,
        ],
        sum_of_squares: 5.6427082397e3,
    });
}

/// An enzyme's reaction after J. S. Kowalik and M. R. Osborne; its first start is far away: b₁(x² + b₂x)/(x² + b₃x + b₄).
#[test]
fn mgh09() {
    let x = [4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625];
    let y = [0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246];
    check(&Dataset {
        measured: pairs(&x, &y),
        model: |b, x| {
            let (upper, lower) = (x * x + b[1] * x, x * x + b[2] * x + b[3]);
            let by_lower = -b[0] * upper / (lower * lower);
            (b[0] * upper / lower, vec![upper / lower, b[0] * x / lower, by_lower * x, by_lower])
        },
        starts: [&[25.0, 39.0, 41.5, 39.0], &[0.25, 0.39, 0.415, 0.39]],
        certified: &[1.9280693458e-1, 1.9128232873e-1, 1.2305650693e-1, 1.3606233068e-1],
        sum_of_squares: 3.0750560385e-4,
    });
}

/// The transmission of an interference filter: (b₁/b₂)·e^(−((x − b₃)/b₂)²/2).
#[test]
fn eckerle4() {
    let x = [
        400.0, 405.0, 410.0, 415.0, 420.0, 425.0, 430.0, 435.0, 436.5, 438.0, 439.5, 441.0, 442.5, 444.0,
        445.5, 447.0, 448.5, 450.0, 451.5, 453.0, 454.5, 456.0, 457.5, 459.0, 460.5, 462.0, 463.5, 465.0,
        470.0, 475.0, 480.0, 485.0, 490.0, 495.0, 500.0,
    ];
    let y = [
        0.0001575, 0.0001699, 0.0002350, 0.0003102, 0.0004917, 0.0008710, 0.0017418, 0.0046400, 0.0065895,
        0.0097302, 0.0149002, 0.0237310, 0.0401683, 0.0712559, 0.1264458, 0.2073413, 0.2902366, 0.3445623,
        0.3698049, 0.3668534, 0.3106727, 0.2078154, 0.1164354, 0.0616764, 0.0337200, 0.0194023, 0.0117831,
        0.0074357, 0.0022732, 0.0008800, 0.0004579, 0.0002345, 0.0001586, 0.0001143, 0.0000710,
    ];
    check(&Dataset {
        measured: pairs(&x, &y),
        model: |b, x| {
            let distance = (x - b[2]) / b[1];
            let shape = libm::exp(-0.5 * distance * distance) / b[1];
            let value = b[0] * shape;
            (value, vec![shape, value * (distance * distance - 1.0) / b[1], value * distance / b[1]])
        },
        starts: [&[1.0, 10.0, 500.0], &[1.5, 5.0, 450.0]],
        certified: &[1.5543827178, 4.0888321754, 4.5154121844e2],
        sum_of_squares: 1.4635887487e-3,
    });
}

/// A line through points by two slopes of which only the sum matters: the sum is found, and the search ends.
#[test]
fn parameters_that_only_count_together_do_not_stop_the_search() {
    let points = [(1.0, 2.1), (2.0, 3.9), (3.0, 6.0), (4.0, 8.1)];
    let model: Model = |b, x| ((b[0] + b[1]) * x, vec![x, x]);
    let evaluate = |parameters: &DVector<f64>| Ok(linearised(model, &points, parameters));
    let minimum = minimum(DVector::from_row_slice(&[5.0, -1.0]), EFFORT, evaluate).unwrap();
    // (2.1 + 2·3.9 + 3·6 + 4·8.1)/30.
    assert!(minimum.converged && (minimum.parameters.sum() - 2.01).abs() < 1e-12, "{}", minimum.parameters);
}

/// The logarithm of the parameter, to be 3: the first steps from far above lead below zero, where there is none.
#[test]
fn the_search_turns_back_from_where_there_are_no_residuals() {
    let mut outside = 0;
    let evaluate = |parameters: &DVector<f64>| {
        let value = libm::log(parameters[0]) - 3.0;
        if !value.is_finite() {
            outside += 1;
            return Err(ResidualsError::OutOfDomain);
        }
        Ok(Linearised {
            residuals: DVector::from_row_slice(&[value]),
            jacobian: DMatrix::from_element(1, 1, 1.0 / parameters[0]),
        })
    };
    let minimum = minimum(DVector::from_row_slice(&[1e3]), EFFORT, evaluate).unwrap();
    assert!(minimum.converged && (minimum.parameters[0] / libm::exp(3.0) - 1.0).abs() < 1e-9);
    assert!(outside > 0);
}
