//! Every bound of the ledger on every golden vector.

use crate::promises::{
    ACTION, COMPLEMENT, COMPLETE, EXCESS, FOUR_ROUNDOFFS, HARMONICS, INCOMPLETE, JACOBI, NOME, OF_NOME,
    RATIO, STATE, SUBNORMAL, jacobi_allowance,
};
use libration::elliptic::{Jacobi, Modulus};
use libration::pendulum::{self, Amplitude, Pendulum, State};
use libration::quantity::Angle;
use libration_testing::golden::{Row, Table};
use libration_testing::ulp::Truth;

fn unit_pendulum() -> Pendulum {
    Pendulum::from_angular_frequency(1.0).unwrap()
}

fn angle_of(row: Row<'_>, column: &str) -> Angle {
    let value = row.input(column);
    if row.text("given") == "complement" { Angle::from_complement(value) } else { Angle::from_radians(value) }
        .unwrap()
}

#[test]
fn period_ratio_keeps_its_promise_on_the_golden_table() {
    for row in Table::read("period.csv").rows() {
        let value = row.input("value_hex");
        let near_top = row.text("given") == "complement";
        let plain =
            if near_top { pendulum::period_ratio_near_top(value) } else { pendulum::period_ratio(value) };
        let prepared = Amplitude::new(angle_of(row, "value_hex")).unwrap().period_ratio();
        RATIO.holds(row.truth("ratio").error(prepared), &(row.text("given"), value));
        if near_top && value < f64::MIN_POSITIVE {
            assert!(plain.is_nan(), "{value}: outside the domain");
        } else {
            RATIO.holds(row.truth("ratio").error(plain), &(row.text("given"), value));
        }
    }
}

#[test]
fn period_excess_keeps_its_promise_on_the_golden_table() {
    for row in Table::read("period.csv").rows() {
        let value = row.input("value_hex");
        if row.text("given") == "amplitude" && value >= 1e-150 {
            EXCESS.holds(row.truth("excess").error(pendulum::period_excess(value)), &value);
        }
        let prepared = Amplitude::new(angle_of(row, "value_hex")).unwrap();
        if prepared.radians() >= 1e-150 {
            EXCESS.holds(row.truth("excess").error(prepared.period_excess()), &(row.text("given"), value));
        }
    }
}

#[test]
fn nome_of_an_amplitude_keeps_its_promise_on_the_golden_table() {
    for row in Table::read("period.csv").rows() {
        let amplitude = Amplitude::new(angle_of(row, "value_hex")).unwrap();
        NOME.holds(row.truth("nome").error(amplitude.nome()), &(row.text("given"), row.input("value_hex")));
    }
}

#[test]
fn periods_in_seconds_are_right_to_an_ulp_however_close_to_the_top() {
    let small_angle = Truth::from_decimal("6.283185307179586476925286766559005768394");
    for row in Table::read("period.csv").rows() {
        let amplitude = Amplitude::new(angle_of(row, "value_hex")).unwrap();
        let ratio = row.truth("ratio");
        // 2π·R in two words: the product of the second words is below 1e-31.
        let product = small_angle.hi * ratio.hi;
        let lo = small_angle.hi.mul_add(ratio.hi, -product)
            + small_angle.hi * ratio.lo
            + small_angle.lo * ratio.hi;
        let error = Truth::from_words(product, lo).error(unit_pendulum().period(&amplitude));
        assert!(error <= 0.56, "{error} ulp at {} {}", row.text("given"), row.input("value_hex"));
    }
}

#[test]
fn condition_of_the_period_is_right_to_a_few_ulp() {
    for row in Table::read("period.csv").rows() {
        let got = Amplitude::new(angle_of(row, "value_hex")).unwrap().condition();
        let error = row.truth("condition").error(got);
        assert!(error <= 8.0, "{error} ulp at {} {}", row.text("given"), row.input("value_hex"));
    }
}

#[test]
fn complete_integrals_keep_their_promise_on_the_tables_of_boost() {
    for (table, answer) in
        [("boost/first.csv", Modulus::first as fn(&Modulus) -> f64), ("boost/second.csv", Modulus::second)]
    {
        for row in Table::read(table).rows() {
            let k = row.input("k_hex");
            let got = answer(&Modulus::from_modulus(k.abs()).unwrap());
            COMPLETE
                .holds(row.truth(table.trim_start_matches("boost/").trim_end_matches(".csv")).error(got), &k);
        }
    }
}

#[test]
fn incomplete_integrals_keep_their_promise_on_the_tables_of_boost() {
    for row in Table::read("boost/incomplete_first.csv").rows() {
        let (phi, k) = (row.input("phi_hex"), row.input("k_hex"));
        let got = Modulus::from_modulus(k.abs()).unwrap().incomplete_first(phi);
        INCOMPLETE.holds(row.truth("first").error(got), &(phi, k));
    }
    for row in Table::read("boost/incomplete_second.csv").rows() {
        let (phi, k) = (row.input("phi_hex"), row.input("k_hex"));
        let got = Modulus::from_modulus(k.abs()).unwrap().incomplete_second(phi);
        INCOMPLETE.holds(row.truth("second").error(got), &(phi, k));
    }
}

#[test]
fn incomplete_integrals_keep_their_promise_next_to_every_quarter_turn() {
    for row in Table::read("elliptic_angles.csv").rows() {
        let (modulus, phi) = (modulus_of(row), row.input("phi_hex"));
        let input = (row.text("given"), row.input("value_hex"), phi);
        INCOMPLETE.holds(row.truth("first").error(modulus.incomplete_first(phi)), &("F", input));
        INCOMPLETE.holds(row.truth("second").error(modulus.incomplete_second(phi)), &("E", input));
    }
}

#[test]
fn nomes_keep_their_promise_down_to_the_smallest_numbers() {
    for row in Table::read("elliptic_nomes.csv").rows() {
        let (given, value) = (row.text("given"), row.input("value_hex"));
        if given == "q" {
            let modulus = Modulus::from_nome(value).unwrap();
            OF_NOME.holds(row.truth("k").error(modulus.modulus()), &("k", value));
            OF_NOME.holds(row.truth("kc").error(modulus.complementary_modulus()), &("k′", value));
            // The moduli have two words, so that the inverse function rounds only once.
            NOME.holds(row.truth("q").error(modulus.nome()), &("q", value));
        } else {
            NOME.holds(row.truth("q").error(modulus_of(row).nome()), &(given, value));
        }
    }
}

fn modulus_of(row: Row<'_>) -> Modulus {
    let value = row.input("value_hex");
    let made = match row.text("given") {
        "m" => Modulus::from_parameter(value),
        "k" => Modulus::from_modulus(value),
        _ => Modulus::from_complementary_modulus(value),
    };
    made.unwrap()
}

fn check_jacobi(row: Row<'_>, got: Jacobi, allowance: f64, input: &dyn core::fmt::Debug) {
    for (name, value) in [("sn", got.sn), ("cn", got.cn), ("dn", got.dn)] {
        JACOBI.holds(row.truth(name).error_beyond(value, allowance), &(name, input));
    }
}

#[test]
fn jacobi_functions_keep_their_promise_on_the_table_of_boost() {
    for row in Table::read("boost/jacobi.csv").rows() {
        let (u, k) = (row.input("u_hex"), row.input("k_hex"));
        let got = Modulus::from_modulus(k.abs()).unwrap().jacobi(u);
        check_jacobi(row, got, jacobi_allowance(u), &(u, k));
    }
}

#[test]
fn jacobi_functions_keep_their_promise_at_extreme_arguments_and_next_to_the_smallest_modulus() {
    for row in Table::read("elliptic_arguments.csv").rows() {
        let (given, value, u) = (row.text("given"), row.input("value_hex"), row.input("u_hex"));
        let got = modulus_of(row).jacobi(u);
        check_jacobi(row, got, jacobi_allowance(u), &(given, value, u));
        JACOBI.holds(row.truth("am").error_beyond(got.am, jacobi_allowance(u)), &("am", given, value, u));
    }
}

#[test]
fn jacobi_functions_beyond_modulus_one_follow_by_the_reciprocal_modulus() {
    for row in Table::read("boost/jacobi_near_one.csv").rows() {
        let (u, k) = (row.input("u_hex"), row.input("k_hex").abs());
        // sn(u, k) = sn(ku, 1/k)/k; cn and dn are exchanged (DLMF 22.17.ii); ku and 1 − 1/k² are rounded.
        let reciprocal = Modulus::from_complementary_parameter((k - 1.0) * (k + 1.0) / (k * k)).unwrap();
        let Jacobi { sn, cn, dn, am } = reciprocal.jacobi(k * u);
        let swapped = Jacobi { sn: sn / k, cn: dn, dn: cn, am };
        check_jacobi(row, swapped, 4.0 * FOUR_ROUNDOFFS * u.abs(), &(u, k));
    }
}

#[test]
fn jacobi_functions_keep_their_promise_next_to_parameter_one() {
    for row in Table::read("separatrix/jacobi.csv").rows() {
        let (u, mc) = (row.input("u"), row.input("mc"));
        let got = Modulus::from_complementary_parameter(mc).unwrap().jacobi(u);
        check_jacobi(row, got, jacobi_allowance(u), &(u, mc));
        JACOBI.holds(row.truth("am").error_beyond(got.am, jacobi_allowance(u)), &("am", u, mc));
    }
}

/// Checks θ and θ′ at `time` against the truth, within the bound of the ledger.
fn check_state(got: State, time: f64, angle: Truth, velocity: Truth, input: &dyn core::fmt::Debug) {
    let scale = FOUR_ROUNDOFFS * time.abs();
    let acceleration = libm::sin(angle.hi).abs();
    let (late, slow) = (scale * velocity.hi.abs() + SUBNORMAL, scale * acceleration + SUBNORMAL);
    STATE.holds(angle.error_beyond(got.angle, late), &("angle", input, time));
    STATE.holds(velocity.error_beyond(got.velocity, slow), &("velocity", input, time));
}

#[test]
fn actions_and_energies_keep_their_promise_in_every_regime_at_any_frequency() {
    for row in Table::read("action.csv").rows() {
        let (given, value, frequency) = (row.text("given"), row.input("value_hex"), row.input("omega_hex"));
        let pendulum = Pendulum::from_angular_frequency(frequency).unwrap();
        let made = match given {
            "ratio" => pendulum.with_energy_ratio(value),
            _ => pendulum.released_from(angle_of(row, "value_hex")),
        };
        let Ok(motion) = made else {
            assert!(2.0 * frequency * libm::sqrt(value) > 1e307, "{given} {value} {frequency}: refused");
            continue;
        };
        let (action, energy) = (row.truth("action"), row.truth("energy"));
        let input = (given, value, frequency);
        ACTION.holds(action.error_beyond(motion.action(), SUBNORMAL), &("action", input));
        ACTION.holds(energy.error_beyond(motion.specific_energy(), SUBNORMAL), &("energy", input));
    }
}

#[test]
fn states_keep_their_promise_on_the_golden_table() {
    for row in Table::read("motion.csv").rows() {
        let (start, velocity, time) =
            (row.input("start_hex"), row.input("velocity_hex"), row.input("time_hex"));
        let motion = unit_pendulum().launched(angle_of(row, "start_hex"), velocity).unwrap();
        let (given, truths) = (row.text("given"), (row.truth("angle"), row.truth("velocity")));
        for (way, state) in [("direct", motion.state_at(time)), ("prepared", motion.prepare().state_at(time))]
        {
            check_state(state, time, truths.0, truths.1, &(way, given, start, velocity));
            let late = FOUR_ROUNDOFFS * (time * truths.1.hi).abs() + SUBNORMAL;
            let error = row.truth("complement").error_beyond(state.complement, late);
            COMPLEMENT.holds(error, &(way, given, start, velocity, time));
        }
    }
}

#[test]
fn periods_of_motions_are_rounded_from_two_words() {
    for row in Table::read("motion.csv").rows() {
        let velocity = row.input("velocity_hex");
        let motion = unit_pendulum().launched(angle_of(row, "start_hex"), velocity).unwrap();
        let error = row.truth("period").error(motion.period());
        assert!(
            error <= 0.56,
            "{error} ulp from {} {} {velocity}",
            row.text("given"),
            row.input("start_hex")
        );
    }
}

#[test]
fn states_released_next_to_the_top_keep_their_promise() {
    for row in Table::read("separatrix/pendulum.csv").rows() {
        let (delta, time) = (row.input("delta"), row.input("tau"));
        let motion = unit_pendulum().released_from(Angle::from_complement(delta).unwrap()).unwrap();
        check_state(motion.state_at(time), time, row.truth("theta"), row.truth("dtheta_dtau"), &delta);
        RATIO.holds(row.truth("T_over_T0").error(pendulum::period_ratio_near_top(delta)), &delta);
    }
}

#[test]
fn harmonics_keep_their_promise_on_the_golden_table() {
    for row in Table::read("fourier.csv").rows() {
        let (regime, value) = (row.text("regime"), row.input("value_hex"));
        let n: usize = row.text("n").parse().unwrap();
        let truth = row.truth("angle");
        let motion = match regime {
            "libration" => unit_pendulum().released_from(Angle::from_radians(value).unwrap()),
            "rotation" => unit_pendulum().launched(Angle::from_radians(0.0).unwrap(), value),
            _ => unit_pendulum().released_from(Angle::from_complement(value).unwrap()),
        };
        if truth.hi.abs() >= 1e-12 {
            let harmonics = motion.unwrap().harmonics(1e-13, 10_000);
            let computed = harmonics.terms.iter().find(|term| term.n == n).unwrap();
            HARMONICS.holds(truth.error(computed.angle), &(regime, value, n));
            assert!(
                row.truth("fundamental").error(harmonics.fundamental) <= 2.0,
                "fundamental of {regime} {value}"
            );
        }
    }
}
