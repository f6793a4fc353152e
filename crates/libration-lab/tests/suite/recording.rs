//! Files of instruments: inferred settings, and given ones.

use libration::quantity::{Angle, Dimension, parse};
use libration_lab::measurement::{
    Choices, Column, Format, MeasurementError, Observable, ReadOptions, Recording, Table, TimeStamps, Traces,
    Unit,
};
use libration_testing::sweep;
use std::f64::consts::TAU;

fn recording(file: &[u8]) -> Recording {
    Recording::read(file, &ReadOptions::default()).unwrap()
}

fn traces(file: &str, choices: &Choices) -> Result<Traces, MeasurementError> {
    recording(file.as_bytes()).traces(choices)
}

fn told(traces: &Traces) -> String {
    traces.findings.iter().map(|finding| finding.to_string() + "\n").collect()
}

fn named(name: &str) -> Option<Column> {
    Some(Column::Name(name.into()))
}

/// An angle in degrees as text on a command line is read, in radians.
fn radians(degrees: f64) -> f64 {
    format!("{degrees}deg").parse::<Angle>().unwrap().radians()
}

#[test]
fn degrees_in_a_file_are_those_of_the_command_line_to_the_last_bit() {
    let tenths = || {
        (-1800..=1800)
            .map(|n: i32| format!("{}{}.{}", if n < 0 { "-" } else { "" }, n.abs() / 10, n.abs() % 10))
    };
    for (heading, command) in
        [("angle (deg)", "deg"), ("velocity (deg/s)", "deg/s"), ("angle (mrad)", "mrad")]
    {
        let rows: String = tenths().zip(0..).map(|(angle, row)| format!("{row}.5,{angle}\n")).collect();
        let recording = traces(&format!("time (s),{heading}\n{rows}"), &Choices::default()).unwrap();
        for (value, text) in recording.traces[0].values().iter().zip(tenths()) {
            let text = format!("{text} {command}");
            let dimension = if command == "deg/s" { Dimension::AngularVelocity } else { Dimension::Angle };
            let meant = match command {
                "deg" => text.parse::<Angle>().unwrap().radians(),
                _ => parse(&text, dimension).unwrap().value,
            };
            assert_eq!(value.to_bits(), (meant + 0.0 * value).to_bits(), "{text}");
        }
    }
}

/// A swing from 1 rad, sampled 60 times a second.
fn swing(row: usize) -> (f64, f64) {
    let time = f64::from(u16::try_from(row).unwrap()) / 60.0;
    (time, libm::cos(3.0 * time))
}

/// Names and units as PASCO Capstone writes them in a country with decimal commas, with runs named by people.
#[test]
fn runs_side_by_side_are_read_with_their_names() {
    let file = "\u{feff}\"Time (s) Anna 0.02\";\"Light Intensity (% of scale max) Anna 0.02\";\"Angle (rad) Anna 0.02\";\
                \"Time (s) Run #2\";\"Light Intensity (% of scale max) Run #2\";\"Angle (rad) Run #2\"\r\n\
                0,000;0,02945;0,10000;0,000;0,03149;0,20000\r\n\
                0,050;0,02969;-7,85399E-4;0,050;0,03152;0,10000\r\n\
                ;;;0,100;0,03136;0,05000\r\n";
    let recording = traces(file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].values(), [0.1, -7.85399e-4]);
    assert_eq!(recording.traces[1].times(), [0.0, 0.05, 0.1]);
    assert_eq!([recording.traces[0].name(), recording.traces[1].name()], ["Anna 0.02", "Run #2"]);
    assert_eq!(recording.lines, [vec![2, 3], vec![2, 3, 4]]);
    assert!(!told(&recording).contains("incomplete"), "a shorter run just ends: {}", told(&recording));
    let second = traces(file, &Choices { run: Some("2".into()), ..Choices::default() }).unwrap();
    assert_eq!(second.traces, recording.traces[1..]);
    let missing = traces(file, &Choices { run: Some("3".into()), ..Choices::default() }).unwrap_err();
    assert_eq!(missing.to_string(), "there is no run `3`: the file has `Anna 0.02`, `Run #2`");
}

/// Tracker writes the name of the track above the header, and several tracks under their names.
#[test]
fn tracks_stand_under_their_names() {
    let mut one = "mass_A\r\nt\tx\ty\tθ\r\n".to_owned();
    let mut two = "#multi:\n\tbob\t\tstand\t\nt\tx\ty\tx\ty\n".to_owned();
    for row in 0..120 {
        let (time, angle) = swing(row);
        let (x, y) = (0.8 * libm::sin(angle), 1.3 - 0.8 * libm::cos(angle));
        one += &format!("{time:.6E}\t{x:.9E}\t{y:.9E}\t\r\n");
        two += &format!("{time}\t{x}\t{y}\t0.5\t{}\n", 0.1 + 1e-9 * time);
    }
    let chosen = Choices { x: named("x"), y: named("y"), ..Choices::default() };
    let recording = traces(&one, &chosen).unwrap();
    assert!(
        recording.traces[0]
            .values()
            .iter()
            .zip((0..).map(swing))
            .all(|(&angle, (_, truth))| (angle - truth).abs() < 1e-7)
    );
    assert!(
        told(&recording).contains("the pivot is at (0.00000") && told(&recording).contains("y grows upwards"),
        "{}",
        told(&recording)
    );
    let refused = traces(&two, &Choices::default()).unwrap_err();
    assert!(matches!(refused, MeasurementError::PivotUnknown(_)), "the stand does not swing: {refused}");
    let bob = traces(&two, &Choices { run: Some("bob".into()), ..Choices::default() }).unwrap();
    assert_eq!((bob.traces[0].name(), bob.traces[0].len()), ("bob", 120));
}

#[test]
fn positions_in_a_picture_grow_downwards_and_a_short_arc_needs_its_pivot() {
    let picture = |amplitude: f64| {
        let row = |row: usize| {
            let (time, shape) = swing(row);
            // A twentieth of a pixel of unevenness, as from rounding.
            let ripple = 0.05 * libm::sin(17.0 * time);
            let (sine, cosine) = (libm::sin(amplitude * shape), libm::cos(amplitude * shape));
            format!("{time},{},{}\n", 640.0 + (400.0 + ripple) * sine, 50.0 + (400.0 + ripple) * cosine)
        };
        format!("time (s),x (px),y (px)\n{}", (0..200).map(row).collect::<String>())
    };
    let recording = traces(&picture(2.5), &Choices::default()).unwrap();
    assert!(told(&recording).contains("y grows downwards"), "{}", told(&recording));
    let largest = recording.traces[0]
        .values()
        .iter()
        .zip((0..).map(swing))
        .map(|(&angle, (_, shape))| (angle - 2.5 * shape).abs());
    assert!(largest.fold(0.0, f64::max) < 1e-4);
    let refused = traces(&picture(0.02), &Choices::default()).unwrap_err();
    assert!(refused.to_string().contains("pivot=X,Y"), "{refused}");
    let chosen = Choices { pivot: Some((640.0, 50.0)), ..Choices::default() };
    let recording = traces(&picture(0.02), &chosen).unwrap();
    assert!((recording.traces[0].values()[0] - 0.02).abs() < 1e-6);
}

#[test]
fn counts_become_turns_and_jumps_are_taken_out() {
    let mut file = "packet,time_us, angle\n".to_owned();
    for row in 0..200 {
        let (time, shape) = swing(row);
        let counts = (4000.0 + 1500.0 * shape).round() % 4000.0;
        file += &format!("7, {}, {counts}\n", 492_306_565.0 + (1e6 * time).round());
    }
    let refused = traces(&file, &Choices::default()).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the unit of column 3 (`angle`) is not given: give angle-unit=rad or deg or counts-per-turn=4000"
    );
    let recording = traces(&file, &Choices { counts_per_turn: Some(4000.0), ..Choices::default() }).unwrap();
    let values = recording.traces[0].values();
    assert!(
        values
            .iter()
            .zip((0..).map(swing))
            .all(|(&angle, (_, shape))| (angle - 1500.0 / 4000.0 * TAU * shape).abs() < 1e-3)
    );
    assert_eq!((recording.traces[0].name(), recording.traces[0].times()[0]), ("packet 7", 492.306565));
    assert!(told(&recording).contains("jumps by a turn taken out"), "{}", told(&recording));
}

#[test]
fn numbers_of_frames_become_times() {
    for name in ["frame", "Frame number", "Bildnummer", "Fotograma"] {
        let rows = (0..200).map(|row| format!("{},{}\n", row + 40, swing(row).1));
        let file = format!("{name},angle (rad)\n{}", rows.collect::<String>());
        let refused = traces(&file, &Choices::default()).unwrap_err().to_string();
        assert!(
            refused.contains("counts the frames") && refused.ends_with("give frame-rate=30"),
            "{refused}"
        );
        let choices = Choices { frame_rate: Some(240.0), from: Some(0.25), ..Choices::default() };
        let recording = traces(&file, &choices).unwrap();
        let times = recording.traces[0].times();
        assert_eq!((times.len(), times[0], times[times.len() - 1]), (180, 0.25, 239.0 / 240.0), "{name}");
    }
    // Edges of a gate in a video, and dips of a signal.
    let gate = (0..40).map(|edge| format!("{},{}\n", 25 * edge + 3 * (edge % 2), (edge + 1) % 2));
    let file = format!("frame,gate\n{}", gate.collect::<String>());
    let frames = Choices { time: named("frame"), ..Choices::default() };
    let refused = recording(file.as_bytes()).gate_times(&frames).unwrap_err().to_string();
    assert!(refused.ends_with("give frame-rate=30"), "{refused}");
    let at_fifty = Choices { frame_rate: Some(50.0), ..frames };
    let gates = recording(file.as_bytes()).gate_times(&at_fifty).unwrap();
    assert_eq!(gates.times[..3], [0.0, 0.56, 1.0]);
}

/// A serial connection begins within a row. A short table may have been typed.
#[test]
fn a_first_line_that_is_no_row_is_left_out_of_a_long_recording() {
    let rows = |number: usize| (0..number).map(|row| format!("{},{}\n", swing(row).0, swing(row).1));
    for first in ["12 0.3", "0.297", "3e,0.1"] {
        let file = format!("{first}\n{}", rows(200).collect::<String>());
        let angles = Choices { unit: Some(Unit::Radian), ..Choices::default() };
        assert_eq!(traces(&file, &angles).unwrap().traces[0].times().len(), 200, "{first}");
        let findings = recording(file.as_bytes()).findings();
        assert!(findings.iter().any(|finding| finding.to_string().contains("line 1 (`")), "{findings:?}");
    }
    let typed = format!("12 0.3\n{}", rows(40).collect::<String>());
    let short = Recording::read(typed.as_bytes(), &ReadOptions::default()).unwrap_err();
    assert!(matches!(short, MeasurementError::NeitherHeaderNorNumbers { line: 1 }), "{short}");
}

#[test]
fn a_gyroscope_is_read_about_the_axis_it_turns_about() {
    let mut file = "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\",\"Absolute (rad/s)\"\n".to_owned();
    for row in 0..100 {
        let (time, shape) = swing(row);
        file += &format!(
            "{time:.9E},{:.9E},{shape:.9E},{:.9E},{:.9E}\n",
            0.01 * shape,
            -0.02 * shape,
            shape.abs()
        );
    }
    let recording = traces(&file, &Choices::default()).unwrap();
    assert_eq!(
        (recording.traces[0].observable(), recording.traces[0].values()[0]),
        (Observable::AngularVelocity, 1.0)
    );
    assert!(told(&recording).contains("nearly all of the motion"), "{}", told(&recording));
    let other = Choices { angular_velocity: named("Gyroscope z"), ..Choices::default() };
    assert_eq!(traces(&file, &other).unwrap().traces[0].values()[0], -0.02);
}

#[test]
fn uncertainties_go_with_their_values_each_in_its_unit() {
    let file = "t (min),θ (deg),sigma_theta (rad)\n0,30,0.01\n0.001,20,0.02\n0.002,10,\n";
    let recording = traces(file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].uncertainties(), Some(&[0.01, 0.02][..]));
    assert_eq!(recording.traces[0].values(), [radians(30.0), radians(20.0)]);
    assert_eq!(recording.traces[0].times(), [0.0, 0.06]);
    assert!(told(&recording).contains("1 incomplete row left out"), "{}", told(&recording));
}

#[test]
fn every_guess_can_be_overridden() {
    let file = "t (s),clock (ms),θ (deg),φ\n0,0,30,0.1\n1,50,20,0.2\n2,100,10,0.3\n";
    let chosen = Choices {
        time: Some(Column::Number(2)),
        angle: named("φ"),
        unit: Some(Unit::Radian),
        ..Choices::default()
    };
    let recording = traces(file, &chosen).unwrap();
    assert_eq!(
        (recording.traces[0].times(), recording.traces[0].values()),
        (&[0.0, 0.05, 0.1][..], &[0.1, 0.2, 0.3][..])
    );
    let chosen = Choices { time_unit: Some(Unit::Minute), angle: named("θ"), ..chosen };
    let recording = traces(file, &Choices { unit: None, ..chosen.clone() }).unwrap();
    assert_eq!((recording.traces[0].times()[1], recording.traces[0].values()[0]), (3000.0, radians(30.0)));
    let wrong = traces(file, &Choices { unit: Some(Unit::Metre), ..chosen }).unwrap_err();
    assert_eq!(wrong.to_string(), "m is not a unit of an angle: give one such as rad, deg");
}

#[test]
fn a_file_without_a_header_says_what_must_be_said() {
    let file = "0.03 -1.148 0.1\n0.06 -1.159 0.2\n0.10 -1.204 0.1\n";
    let refused = traces(file, &Choices::default()).unwrap_err().to_string();
    assert!(
        refused.ends_with("column 2, column 3: give angle=2 or 3 and angle-unit=rad or deg, or x=2 and y=3"),
        "{refused}"
    );
    let chosen = Choices { angle: Some(Column::Number(2)), unit: Some(Unit::Radian), ..Choices::default() };
    let recording = traces(file, &chosen).unwrap();
    assert_eq!(recording.traces[0].values(), [-1.148, -1.159, -1.204]);
    assert!(
        told(&recording).contains("only it increases throughout")
            && told(&recording).contains("no unit is given")
    );
}

#[test]
fn a_photogate_gives_its_times_and_states() {
    let vernier = "Latest: Time (s),Latest: GateState,Latest: Pulse Time (s)\n0.5125,1,\n0.5375,0,0.025\n1.5150,1,\n1.5401,0,0.0251\n";
    let gates = recording(vernier.as_bytes()).gate_times(&Choices::default()).unwrap();
    assert_eq!(gates.times, [0.5125, 0.5375, 1.515, 1.5401]);
    assert_eq!(gates.blocked, Some(vec![true, false, true, false]));
    let words = "t/ms\tgate\n512\tBlocked\n537\tUnblocked\n\tBlocked\n";
    let gates = recording(words.as_bytes()).gate_times(&Choices::default()).unwrap();
    assert_eq!(
        (gates.times, gates.blocked, gates.incomplete),
        (vec![0.512, 0.537], Some(vec![true, false]), 1)
    );
    let alone = recording(b"0.512\n1.034\n1.556\n").gate_times(&Choices::default()).unwrap();
    assert_eq!((alone.times, alone.blocked), (vec![0.512, 1.034, 1.556], None));
    let odd = recording(b"t (s),gate\n1,2\n").gate_times(&Choices::default()).unwrap_err();
    assert_eq!(odd.to_string(), "line 2: 2 is not a state of a photogate: give 1 or blocked, 0 or unblocked");
}

/// A recording with these values every 5 ms, as a file.
fn sampled(heading: &str, value: impl Fn(f64) -> f64) -> String {
    let row = |row: u16| format!("{:.3},{:.3}\n", 0.005 * f64::from(row), value(0.005 * f64::from(row)));
    format!("t (s),{heading}\n{}", (0..2000).map(row).collect::<String>())
}

/// A light barrier is dark for 30 ms twice in a period of 1.4 s; the flanks of the last one take two rows.
#[test]
fn a_signal_of_two_levels_is_one_of_a_gate_and_no_angle() {
    let phase = |t: f64| (t + 0.3) % 0.7;
    let dark = |t: f64, [out, dark]: [f64; 2]| if phase(t) < 0.03 { dark } else { out };
    let flank = |t: f64| 5.0 * (phase(t) / 0.01).clamp(0.0, 1.0) * ((0.3 - phase(t)) / 0.01).clamp(0.0, 1.0);
    for file in [
        sampled("Voltage (V)", |t| dark(t, [5.0, 0.0])),
        sampled("signal", |t| dark(t, [0.0, 1.0])),
        sampled("Angle (deg)", |t| dark(t, [5.0, 0.1]) + 0.1 * libm::sin(40.0 * t)),
        sampled("U (V)", flank),
    ] {
        let error = traces(&file, &Choices::default()).unwrap_err();
        assert!(matches!(error, MeasurementError::GateSignal { number: 2, .. }), "{error}");
    }
    let chosen = Choices { angle: Some(Column::Number(2)), unit: Some(Unit::Degree), ..Choices::default() };
    let error = traces(&sampled("Voltage (V)", |t| dark(t, [5.0, 0.0])), &chosen).unwrap_err();
    assert!(matches!(error, MeasurementError::GateSignal { .. }), "{error}");
}

/// Swings about the end of the scale, ±180° or 0° and 360°, jump by a turn at each passage.
#[test]
fn angles_that_jump_by_a_turn_at_rest_are_no_signals_of_gates() {
    let swing = |t: f64| 40.0 * libm::sin(TAU * t / 1.4);
    let to_180 = |t: f64| swing(t).rem_euclid(360.0) - 180.0;
    let to_360 = |t: f64| swing(t).rem_euclid(360.0);
    for (file, choices) in [
        (sampled("Angle (deg)", to_180), Choices::default()),
        (sampled("Angle (deg)", to_360), Choices::default()),
        (sampled("signal", to_180), Choices { unit: Some(Unit::Degree), ..Choices::default() }),
    ] {
        let recording = traces(&file, &choices).unwrap();
        let values = recording.traces[0].values();
        let ends =
            values.iter().fold((f64::MAX, f64::MIN), |(low, high), value| (value.min(low), value.max(high)));
        assert!((ends.1 - ends.0 - 80_f64.to_radians()).abs() < 1e-3, "{ends:?}");
    }
}

/// A swing, one that is cut off at a third of its height, one to 179.9°, and a small one with few steps of its encoder.
#[test]
fn angles_that_rest_at_their_ends_are_no_signals_of_gates() {
    use libration::pendulum::Pendulum;
    let sine = |t: f64| 20.0 * libm::sin(TAU * t / 1.4);
    let high = Pendulum::new(0.2, 9.81).unwrap().released_from("179.9deg".parse().unwrap()).unwrap();
    for file in [
        sampled("angle (deg)", sine),
        sampled("angle (deg)", |t| sine(t).clamp(-6.7, 6.7)),
        sampled("angle (deg)", |t| high.state_at(t).angle.to_degrees()),
        sampled("angle (deg)", |t| (sine(t) / 20.0).round()),
    ] {
        assert_eq!(traces(&file, &Choices::default()).unwrap().traces.len(), 1);
    }
}

#[test]
fn an_old_workbook_is_read_by_its_sheets() {
    let book = recording(include_bytes!("../data/workbook.xls"));
    assert_eq!(book.format(), Format::Xls);
    let recording = book.traces(&Choices::default()).unwrap();
    assert_eq!(recording.traces[0].values()[..3], [0.5, 0.4375, 0.375]);
    assert_eq!((recording.traces[0].len(), recording.lines[0][0]), (12, 2));
    assert!(book.findings()[0].text.contains("`Metadata Device` is left out"));
    let table = Table::read(include_bytes!("../data/workbook.xls"), &ReadOptions::default()).unwrap();
    assert_eq!(table.select(&["Time (s)".parse().unwrap()]).unwrap().columns[0][1], 0.125);
}

/// 30 frames a second for 55 s as a table on a screen shows them: 0.0333, 0.0667, …, 10.0, 10.0, 10.1.
#[test]
fn times_with_three_significant_digits_are_the_even_times_they_come_from() {
    let table = |missing: Option<u32>, rate: f64| {
        let row = |row: u32| {
            let time = f64::from(row) / rate;
            let shown = format!("{time:.2e}").parse::<f64>().unwrap();
            format!("{shown},{:.5}\n", 0.7 * libm::cos(4.2 * time))
        };
        let rows = (0..1650).filter(|&row| Some(row) != missing).map(row);
        format!("t (s),theta (rad)\n{}", rows.collect::<String>())
    };
    for rate in [30.0, 29.97] {
        let recording = traces(&table(None, rate), &Choices::default()).unwrap();
        let trace = &recording.traces[0];
        assert_eq!(trace.len(), 1650);
        assert!(
            told(&recording).contains("with 3 significant digits (times-as-written overrides it)"),
            "{}",
            told(&recording)
        );
        assert!(
            !told(&recording).contains("not by rounding") && !told(&recording).contains("left out"),
            "{}",
            told(&recording)
        );
        let span = trace.times()[1649] - trace.times()[0];
        let error = (span * rate / 1649.0 - 1.0).abs();
        assert!(
            error < 2.0 * trace.clock_uncertainty() && trace.clock_uncertainty() < 1.5e-4,
            "{rate}: {error:e}"
        );
    }
    let written = Choices { stamps: Some(TimeStamps::AsWritten), ..Choices::default() };
    assert!(traces(&table(None, 30.0), &written).unwrap().traces[0].len() < 800);
    let gap = traces(&table(Some(1200), 30.0), &Choices::default()).unwrap_err();
    assert!(matches!(gap, MeasurementError::CoarseTimes { digits: 3, .. }), "{gap}");
    // Where the digits still tell the frames apart, so do they tell the one that is missing.
    let early = traces(&table(Some(20), 30.0), &Choices::default()).unwrap();
    assert_eq!(early.traces[0].len(), 1649);
    assert!(told(&early).contains("1 gap of 1 row in all (after line 21)"), "{}", told(&early));
}

/// A 200 Hz record with times to a hundredth of a second: every time stands twice.
#[test]
fn rows_that_share_times_are_kept_with_even_ones() {
    let row = |row: u32| {
        let time = f64::from(row) / 200.0;
        format!("{:.2},{:.4}\n", (100.0 * time).floor() / 100.0, 0.5 * libm::cos(4.0 * time))
    };
    let file = format!("t (s),theta (rad)\n{}", (0..800).map(row).collect::<String>());
    let recording = traces(&file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].len(), 800);
    let steps = recording.traces[0].times().windows(2).map(|pair| pair[1] - pair[0]);
    assert!(steps.into_iter().all(|step| (step - 0.005).abs() < 1e-5));
    assert!(told(&recording).contains("so coarse that rows share them"), "{}", told(&recording));
    let uneven = file.replace("0.03,", "0.031,");
    let asked = Choices { stamps: Some(TimeStamps::Even), ..Choices::default() };
    assert!(matches!(traces(&uneven, &asked), Err(MeasurementError::NotEven { .. })));
}

/// A swing of 400 rows at 100 Hz, its times changed.
fn timed(change: impl Fn(usize, f64) -> f64) -> String {
    let row = |row: usize| {
        let time = 0.01 * f64::from(u16::try_from(row).unwrap());
        format!("{:.2},{:.6}\n", change(row, time), libm::cos(4.0 * time))
    };
    format!("Time (s),Angle (rad)\n{}", (0..400).map(row).collect::<String>())
}

#[test]
fn one_time_out_of_order_costs_one_row_and_a_clock_set_back_cuts_the_run() {
    let stray = timed(|row, time| if row == 200 { 0.005 } else { time });
    let recording = traces(&stray, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].len(), 399);
    assert!(
        told(&recording).contains("line 202: the time is out of order and belongs nowhere: left out"),
        "{}",
        told(&recording)
    );
    let set_back = timed(|row, time| if row < 150 { time } else { time - 0.5 });
    let recording = traces(&set_back, &Choices::default()).unwrap();
    assert_eq!(recording.traces.iter().map(|trace| trace.len()).collect::<Vec<_>>(), [150, 250]);
    assert_eq!([recording.traces[0].name(), recording.traces[1].name()], ["run 1", "run 2"]);
    assert!(told(&recording).contains("line 152: the time goes back and restarts: cut there into 2 runs"));
    let second = traces(&set_back, &Choices { run: Some("2".into()), ..Choices::default() }).unwrap();
    assert_eq!(second.traces, recording.traces[1..]);
    for run in ["3", "Anna"] {
        let missing = traces(&set_back, &Choices { run: Some(run.into()), ..Choices::default() });
        assert!(matches!(missing, Err(MeasurementError::NoSuch { .. })));
    }
    let none = traces(&timed(|_, time| time), &Choices { run: Some("1".into()), ..Choices::default() });
    assert_eq!(none.unwrap_err().to_string(), "there is no run `1`: the file has one run only");
}

#[test]
fn what_is_not_asked_for_is_not_judged() {
    // Nonsense before one second and after three.
    let file =
        timed(
            |row, time| {
                if (100..=300).contains(&row) { time } else { 0.2 + 0.3 * f64::from(u8::from(row % 2 == 0)) }
            },
        );
    assert!(matches!(traces(&file, &Choices::default()), Err(MeasurementError::TimeGoesBack { .. })));
    let part = Choices { from: Some(1.0), to: Some(3.0), ..Choices::default() };
    let recording = traces(&file, &part).unwrap();
    let times = recording.traces[0].times();
    assert_eq!((times.len(), times[0], times[200]), (201, 1.0, 3.0));
    assert!(!told(&recording).contains("out of order"), "{}", told(&recording));
    let nothing = traces(&file, &Choices { from: Some(7.0), ..Choices::default() }).unwrap_err();
    assert!(matches!(nothing, MeasurementError::NothingBetween { last, .. } if last == 3.0), "{nothing}");
}

#[test]
fn a_tilted_gyroscope_is_read_about_the_axis_that_it_turns_about() {
    let mut file = "Time (s),Gyroscope x (deg/s),Gyroscope y (deg/s),Gyroscope z (deg/s)\n".to_owned();
    for row in 0..400 {
        let (time, rate) = (0.01 * f64::from(row), 90.0 * libm::sin(0.04 * f64::from(row)));
        file += &format!("{time:.2},{:.6},{:.6},{:.6}\n", -0.36 * rate, 0.48 * rate, 0.8 * rate);
    }
    let recording = traces(&file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].observable(), Observable::AngularVelocity);
    for (row, value) in (0..).zip(recording.traces[0].values()) {
        assert!((value - radians(90.0 * libm::sin(0.04 * f64::from(row)))).abs() < 1e-7);
    }
    assert!(told(&recording).contains("(-0.360, 0.480, 0.800)"), "{}", told(&recording));
}

#[test]
fn an_acceleration_is_no_angle_whatever_is_said() {
    let file = "Time (s),Acceleration x (m/s^2)\n0,9.5\n0.1,9.9\n0.2,9.5\n";
    for choices in [
        Choices::default(),
        Choices { unit: Some(Unit::Radian), ..Choices::default() },
        Choices { angle: Some(Column::Number(2)), unit: Some(Unit::Radian), ..Choices::default() },
        Choices { angular_velocity: Some(Column::Number(2)), ..Choices::default() },
    ] {
        let refused = traces(file, &choices).unwrap_err();
        assert!(matches!(refused, MeasurementError::Accelerations { .. }), "{refused}");
    }
    let with_gyroscope =
        file.replace("(m/s^2)\n", "(m/s^2),Gyroscope z (rad/s)\n").replace("9.5\n", "9.5,1\n");
    let recording = traces(&with_gyroscope.replace("9.9\n", "9.9,2\n"), &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].values(), [1.0, 2.0, 1.0]);
}

#[test]
fn the_column_behind_the_angles_holds_their_uncertainties() {
    let file = "t (s),±,θ (deg),± (deg)\n0,0.001,30,0.5\n0.1,0.001,20,0.5\n";
    let recording = traces(file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].uncertainties(), Some(&[radians(0.5); 2][..]));
    let without_unit = "t (s),θ (deg),±,height\n0,30,0.5,1\n0.1,20,0.5,1\n";
    let recording = traces(without_unit, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].uncertainties(), Some(&[radians(0.5); 2][..]));
    let empty = "t (s),θ (deg),±\n0,30,\n0.1,20,\n";
    assert_eq!(traces(empty, &Choices::default()).unwrap().traces[0].uncertainties(), None);
}

#[test]
fn nanoseconds_and_turns_are_units_of_headings() {
    let file = "timestamp (ns),angle (turns)\n0,0.25\n20000000,0.125\n40000000,0\n";
    let recording = traces(file, &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].times(), [0.0, 0.02, 0.04]);
    assert_eq!(recording.traces[0].values(), [0.25 * TAU, 0.125 * TAU, 0.0]);
}

#[test]
fn degrees_under_a_header_of_radians_are_doubted_at_once() {
    let swing = |header: &str, degrees: f64| {
        let row =
            |n: u8| format!("{:.2},{:.3}\n", 0.05 * f64::from(n), degrees * libm::cos(0.4 * f64::from(n)));
        format!("t (s),{header}\n{}", (0..120).map(row).collect::<String>())
    };
    let doubtful = |header: &str, degrees: f64| {
        told(&traces(&swing(header, degrees), &Choices::default()).unwrap())
            .contains("these are degrees (angle-unit overrides it)")
    };
    assert!(doubtful("θ (rad)", 47.3));
    assert!(!doubtful("θ (deg)", 47.3) && !doubtful("θ (rad)", 2.9));
}

#[test]
fn times_that_rounding_has_kept_apart_stay_as_they_are_written() {
    let written = |row: u32| (1e3 * f64::from(row) / 60.0).round() / 1e3;
    let row = |row: u32| format!("{:.3},{:.4}\n", written(row), 0.5 * libm::cos(0.07 * f64::from(row)));
    let file = format!("t (s),theta (rad)\n{}", (0..300).map(row).collect::<String>());
    let recording = traces(&file, &Choices::default()).unwrap();
    assert!(
        recording.traces[0]
            .times()
            .iter()
            .zip((0..).map(written))
            .all(|(time, truth)| (time - truth).abs() < 1e-15)
    );
    assert!(recording.traces[0].clock_uncertainty().abs() < 1e-300);
    let even = Choices { stamps: Some(TimeStamps::Even), ..Choices::default() };
    let recording = traces(&file, &even).unwrap();
    assert!(recording.traces[0].times().windows(2).all(|pair| (pair[1] - pair[0] - 1.0 / 60.0).abs() < 1e-6));
}

/// The strongest axis has 99.5 % of the mean square, and alone would make all rates 0.25 % too small.
#[test]
fn a_gyroscope_tilted_by_four_degrees_loses_nothing() {
    let mut file = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n".to_owned();
    for row in 0..300 {
        let rate = libm::sin(0.04 * f64::from(row));
        file += &format!(
            "{:.2},0,{:.8},{:.8}\n",
            0.01 * f64::from(row),
            rate * 0.995_f64.sqrt(),
            rate * 0.005_f64.sqrt()
        );
    }
    let recording = traces(&file, &Choices::default()).unwrap();
    let values = recording.traces[0].values();
    assert!(
        values.iter().zip(0..).all(|(value, row)| (value - libm::sin(0.04 * f64::from(row))).abs() < 1e-7)
    );
}

/// A pendulum that goes round passes no side twice.
#[test]
fn a_rotation_without_a_unit_is_not_taken_for_degrees() {
    let file = format!(
        "t (s),angle\n{}",
        timed(|_, time| time)
            .lines()
            .skip(1)
            .zip(0..)
            .map(|(line, row)| {
                format!("{},{:.3}\n", line.split(',').next().unwrap_or_default(), 0.1 * f64::from(row))
            })
            .collect::<String>()
    );
    let refused = traces(&file, &Choices::default()).unwrap_err();
    assert!(refused.to_string().contains("give angle-unit=rad or deg"), "{refused}");
}

/// Twenty thousand rows know the radius to a few hundredths, but an arc no higher than twice its scatter may be bent by anything.
#[test]
fn an_arc_lost_in_its_scatter_has_no_pivot_however_many_rows_there_are() {
    let row = |row: u32| {
        let angle = 0.2 * libm::sin(0.01 * f64::from(row));
        let radius = 1.0 + if row.is_multiple_of(2) { 0.01 } else { -0.01 };
        format!(
            "{:.2},{:.6},{:.6}\n",
            0.01 * f64::from(row),
            radius * libm::sin(angle),
            -radius * libm::cos(angle)
        )
    };
    let file = format!("t (s),x (m),y (m)\n{}", (0..20_000).map(row).collect::<String>());
    let refused = traces(&file, &Choices::default()).unwrap_err();
    assert!(matches!(refused, MeasurementError::PivotUnknown(_)), "{refused}");
}

#[test]
fn edges_without_a_unit_are_seconds_by_the_time_between_passages() {
    let edges: String =
        (1..20).map(|n| format!("{:.2}\n{:.2}\n", 0.76 * f64::from(n), 0.76 * f64::from(n) + 0.02)).collect();
    assert_eq!(recording(edges.as_bytes()).gate_times(&Choices::default()).unwrap().times.len(), 38);
}

#[test]
fn a_clock_of_a_gate_goes_back_in_one_row_of_ten_at_most() {
    let back = |rows: &[u32]| {
        let time = |n: u32| if rows.contains(&n) { f64::from(n) - 1.5 } else { f64::from(n) };
        let file: String = (1..=20).map(|n| format!("{}\n", time(n))).collect();
        recording(file.as_bytes()).gate_times(&Choices::default())
    };
    assert_eq!(back(&[5, 10]).unwrap().times.len(), 20);
    assert!(matches!(back(&[5, 10, 15]), Err(MeasurementError::NotGateTimes { goes_back: 3, rows: 20 })));
}

/// 2³² microseconds after its start a clock of 32 bits begins anew, and two runs in one file have a clock each.
#[test]
fn times_of_a_gate_that_begin_anew_are_refused() {
    let file: String = (0..20).map(|n| format!("{}\n", (8.0 + 0.7 * f64::from(n)) % 12.0)).collect();
    let refused = recording(file.as_bytes()).gate_times(&Choices::default()).unwrap_err();
    assert!(matches!(refused, MeasurementError::GateClockRestarts { line: 7, .. }), "{refused}");
    let part = Choices { to: Some(7.5), ..Choices::default() };
    assert_eq!(recording(file.as_bytes()).gate_times(&part).unwrap().times.len(), 11);
}

#[test]
fn one_numbered_symbol_names_no_run() {
    let recording = traces("t_{1},theta_{1} (rad)\n0,0.5\n0.1,0.4\n", &Choices::default()).unwrap();
    assert_eq!(recording.traces[0].name(), "");
}

#[test]
fn samples_of_a_swing_are_no_times_of_a_gate() {
    let gates = |file: &str, choices: &Choices| recording(file.as_bytes()).gate_times(choices);
    let swing = timed(|_, time| time);
    let refused = gates(&swing, &Choices::default()).unwrap_err();
    assert!(refused.to_string().ends_with("if these are: give time=1"), "{refused}");
    let unnamed = gates(&swing.replace("Angle (rad)", "channel A"), &Choices::default());
    assert!(matches!(unnamed, Err(MeasurementError::Undecided { .. })));
    let said = Choices { time: Some(Column::Number(1)), ..Choices::default() };
    assert_eq!(gates(&swing, &said).unwrap().times.len(), 400);
    let speeds = "Time (s),Speed (m/s)\n0.1,1.0\n0.9,0.9\n2.1,1.0\n2.9,0.9\n4.1,1.0\n4.9,0.9\n";
    assert_eq!(gates(speeds, &Choices::default()).unwrap().times.len(), 6);
    let part = Choices { from: Some(0.5), to: Some(4.5), ..Choices::default() };
    assert_eq!(gates(speeds, &part).unwrap().times, [0.9, 2.1, 2.9, 4.1]);
}

#[test]
fn passages_without_a_unit_are_seconds_only_where_a_pendulum_has_such_periods() {
    let passages =
        |unit: f64| (1..20).map(|n| format!("{}\n", unit * 0.76 * f64::from(n))).collect::<String>();
    let gates = |file: &str, choices: &Choices| recording(file.as_bytes()).gate_times(choices);
    assert_eq!(gates(&passages(1.0), &Choices::default()).unwrap().times[0], 0.76);
    for unit in [1e3, 1e6, 1.0 / 60.0] {
        let refused = gates(&passages(unit), &Choices::default()).unwrap_err();
        assert!(refused.to_string().contains("time-unit=s, ms, us or min"), "{refused}");
    }
    let said = Choices { time_unit: Some(Unit::Millisecond), ..Choices::default() };
    assert_eq!(gates(&passages(1e3), &said).unwrap().times[0], 0.76);
}

#[test]
fn no_bytes_make_a_reader_panic_in_a_sweep() {
    const PIECES: [&[u8]; 25] = [
        b"1",
        b"2,5",
        b"-3.5e2",
        b",",
        b";",
        b"\t",
        b" ",
        b"\n",
        b"\r\n",
        b"\r",
        b"\"",
        b"#",
        b"A",
        b"x",
        b"t",
        b"angle",
        b"(s)",
        b"[deg]",
        b"/rad",
        b"Run #1",
        b"packet",
        b"nan",
        b"\xc3\xa9",
        b"\xff",
        b"\0",
    ];
    let mut seed = 1_u64;
    let mut next = |below: usize| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        usize::try_from(seed >> 33).unwrap() % below
    };
    let choices = [
        Choices::default(),
        Choices { unit: Some(Unit::Degree), time: Some(Column::Number(1)), ..Choices::default() },
        Choices { x: Some(Column::Number(1)), y: Some(Column::Number(2)), ..Choices::default() },
    ];
    let (mut read, mut tables) = (0, 0);
    let files = sweep::number(6_000, 30_000);
    for _ in 0..files {
        let length = 12 + next(5);
        let bytes: Vec<u8> = (0..length).flat_map(|_| PIECES[next(PIECES.len())]).copied().collect();
        let table = Table::read(&bytes, &ReadOptions::default());
        tables += usize::from(table.is_ok_and(|table| table.select(&[Column::Number(1)]).is_ok()));
        let Ok(recording) = Recording::read(&bytes, &ReadOptions::default()) else { continue };
        let traces = choices.iter().filter(|choices| recording.traces(choices).is_ok()).count();
        read += traces + usize::from(recording.gate_times(&choices[0]).is_ok());
    }
    assert!(
        read > files / 300 && tables > files / 300,
        "only {read} recordings and {tables} tables were read at all"
    );
    let book = include_bytes!("../data/workbook.xls");
    for _ in 0..sweep::number(500, 2_000) {
        let mut bytes = book.to_vec();
        for _ in 0..4 {
            let at = next(bytes.len());
            bytes[at] = u8::try_from(next(256)).unwrap();
        }
        let _ =
            Recording::read(&bytes, &ReadOptions::default()).map(|recording| recording.traces(&choices[0]));
    }
}
