//! The motion of a damped pendulum, with its derivatives with respect to all its parameters.

use libration::decay::DampingKind;
use libration_lab::fit::DampingModel;
use libration_lab::internals::fit::trace::swing::{Course, EXACT, Seen, Swing};
use libration_lab::measurement::Observable;

/// Predicted measurements at the times with parameters ω0, coefficients, first angle and velocity.
fn seen(swing: &Swing, observable: Observable, all: &[f64], times: &[f64]) -> Seen {
    let (coefficients, start) = all[1..].split_at(all.len() - 3);
    let course = Course { omega0: all[0], coefficients, start: [start[0], start[1]], times, observable };
    swing.seen(&[course], &EXACT).unwrap().remove(0)
}

#[test]
fn derivatives_are_the_limit_of_differences() {
    for terms in DampingModel::all() {
        let swing = Swing::new(terms);
        let coefficients = terms.iter().map(|term| match term {
            DampingKind::Dry => 0.05,
            DampingKind::Linear => 0.03,
            DampingKind::Quadratic => 0.04,
        });
        let coefficients: Vec<f64> = coefficients.collect();
        // A release, a push at the bottom, and neither.
        for (observable, start) in both().flat_map(|seen| STARTS.map(|start| (seen, start))) {
            let all: Vec<f64> = [2.0].into_iter().chain(coefficients.clone()).chain(start).collect();
            compare_with_differences(&swing, observable, &all, &[0.0, 3.1, 9.0]);
        }
    }
}

/// The states of a step after a turn are those of the next leg, whose deviations have jumped: tested with angles alone, since differences of
/// velocities are there those of two branches.
#[test]
fn derivatives_jump_where_dry_friction_turns_the_motion() {
    let swing = Swing::new(DampingModel::only(DampingKind::Dry));
    let times: Vec<f64> = (0..900).map(|row| 0.01 * f64::from(row)).collect();
    for start in STARTS {
        let all = [2.0, 0.2, start[0], start[1]];
        compare_with_differences(&swing, Observable::Angle, &all, &times);
    }
}

fn compare_with_differences(swing: &Swing, observable: Observable, all: &[f64], times: &[f64]) {
    let columns = seen(swing, observable, all, times);
    for (index, derivatives) in columns.derivatives.iter().enumerate() {
        let step = 1e-5;
        let shifted = |by: f64| {
            let mut all = all.to_vec();
            all[index] += by;
            seen(swing, observable, &all, times).values
        };
        let (more, less) = (shifted(step), shifted(-step));
        for row in 0..times.len() {
            let difference = (more[row] - less[row]) / (2.0 * step);
            // The third derivative times step²/6; between the turns of both the jump of the acceleration times step.
            let error = (difference - derivatives[row]).abs();
            assert!(
                error < 3e-6 * (1.0 + difference.abs()),
                "{} {all:?} {index} {row}: {difference} {}",
                swing.terms,
                derivatives[row]
            );
        }
    }
}

const STARTS: [[f64; 2]; 3] = [[1.2, -0.4], [0.0, 2.1], [-2.5, 1e-3]];

fn both() -> impl Iterator<Item = Observable> {
    [Observable::Angle, Observable::AngularVelocity].into_iter()
}

/// Many motions together, some of which are stopped by friction, and some of which have one row.
#[test]
fn motions_side_by_side_are_as_alone() {
    for terms in DampingModel::all() {
        let swing = Swing::new(terms);
        let coefficients: Vec<f64> = terms.iter().map(|_| 0.04).collect();
        let times: Vec<f64> = (0..200).map(|row| 0.1 * f64::from(row)).collect();
        let course = |number: u32| Course {
            omega0: 2.0 + 0.01 * f64::from(number),
            coefficients: &coefficients,
            start: [0.1 + 0.2 * f64::from(number), 0.1],
            times: if number == 5 { &times[..1] } else { &times[..200 - number as usize] },
            observable: if number.is_multiple_of(3) {
                Observable::AngularVelocity
            } else {
                Observable::Angle
            },
        };
        let courses: Vec<Course<'_>> = (0..11).map(course).collect();
        let together = swing.seen(&courses, &EXACT).unwrap();
        for (course, together) in courses.iter().zip(together) {
            let alone = swing.seen(std::slice::from_ref(course), &EXACT).unwrap().remove(0);
            assert_eq!((alone.values, alone.derivatives), (together.values, together.derivatives), "{terms}");
        }
    }
}

#[test]
fn dry_friction_holds_the_pendulum_in_the_end() {
    let swing = Swing::new(DampingModel::only(DampingKind::Dry));
    let times: Vec<f64> = (0..100).map(f64::from).collect();
    for observable in both() {
        let seen = seen(&swing, observable, &[1.0, 0.1, 1.0, 1e-9], &times);
        let [last, before] = [99, 98].map(|row| seen.values[row]);
        assert!((last - before).abs() == 0.0 && last.abs() < 0.1001, "{last}");
        if observable == Observable::AngularVelocity {
            assert!(last == 0.0 && seen.derivatives.iter().all(|column| column[99].abs() == 0.0));
        }
    }
}
