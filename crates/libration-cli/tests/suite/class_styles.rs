//! Tables in the styles of other languages, spreadsheets and documents, g = 9.81 m/s².

use crate::command::{directory, json, libration, message, text, unfolded};
use std::f64::consts::TAU;

const LENGTHS: [f64; 6] = [0.24, 0.37, 0.52, 0.66, 0.81, 0.98];

/// 2π√(L/g), in seconds.
fn period(length: f64) -> f64 {
    TAU * (length / 9.81).sqrt()
}

/// The exact period at an amplitude in degrees, by the arithmetic-geometric mean, of a pendulum with T0 = 1.8 s.
fn period_at(degrees: f64) -> f64 {
    let (mut a, mut b) = (1.0, (degrees.to_radians() / 2.0).cos());
    for _ in 0..5 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    1.8 / a
}

fn comma(number: f64, decimals: usize) -> String {
    format!("{number:.decimals$}").replace('.', ",")
}

/// A row for each length.
fn rows(row: impl Fn(f64) -> String) -> String {
    LENGTHS.into_iter().map(|length| row(length) + "\n").collect()
}

/// Lengths in centimetres and times of ten swings to hundredths of a second, with decimal commas.
fn ten_swings() -> String {
    rows(|length| format!("{};{}", comma(100.0 * length, 0), comma(10.0 * period(length), 2)))
}

fn file(name: &str, bytes: impl AsRef<[u8]>) -> String {
    let path = directory(&format!("class-style-{name}")).join("table.csv");
    std::fs::write(&path, bytes).unwrap();
    path.display().to_string()
}

/// Checks g of a table, which is within its rounding, and returns what was read.
#[track_caller]
fn check(name: &str, bytes: impl AsRef<[u8]>) -> (serde_json::Value, String) {
    let answer = json(&format!("fit lengths {}", file(name, bytes)));
    let gravity = answer["gravity_m_per_s2"].as_f64().unwrap();
    assert!((gravity / 9.81 - 1.0).abs() < 0.01, "{name}: {gravity} {answer}");
    let told = answer["told_from_file"].to_string();
    (answer, told)
}

#[track_caller]
fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    let output = libration(&format!("fit lengths {}", file(name, bytes)));
    assert_eq!(output.status.code(), Some(1), "{name}");
    unfolded(&message(&output))
}

#[test]
fn headers_of_eight_languages_say_lengths_and_numbers_of_swings() {
    for (name, header) in [
        ("de", "Fadenlänge in Zentimetern;10 vollständige Schwingungen (s)"),
        ("de-words", "Länge in Zentimeter;Zehn Schwingungen in Sekunden"),
        ("de-subscript", "l/cm;t₁₀ / s"),
        ("fr", "Longueur (cm);Durée de 10 oscillations (s)"),
        ("es", "Longitud (centímetros);Tiempo de 10 oscilaciones (s)"),
        ("pt", "Comprimento (cm);Tempo de 10 oscilações (s)"),
        ("it", "Lunghezza in centimetri;Tempo di 10 oscillazioni (s)"),
        ("pl", "Długość wahadła (cm);Czas dziesięciu wahnięć (s)"),
        ("nl", "Lengte (cm);Tijd voor 10 slingeringen (s)"),
        ("sv", "Längd (cm);Tid för tio svängningar (s)"),
    ] {
        let (_, told) = check(name, format!("{header}\n{}", ten_swings()));
        assert!(told.contains("holds times of 10 periods"), "{name}: {told}");
    }
    let periods = rows(|length| format!("{};{}", comma(length, 2), comma(period(length), 3)));
    for (name, header) in [("T", "l in m;T = t/10 (s)"), ("fr-T", "Longueur en mètres;Période en secondes")]
    {
        check(name, format!("{header}\n{periods}"));
    }
}

#[test]
fn units_of_angles_and_lengths_of_other_languages_are_known() {
    let angles = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    let rows: String = angles.map(|it| format!("{};{}\n", comma(it, 0), comma(period_at(it), 4))).concat();
    for (name, header) in [
        ("grad", "Auslenkwinkel in Grad;Periodendauer in s"),
        ("graus", "ângulo (graus);período (s)"),
        ("graden", "hoek (graden);trillingstijd (s)"),
        ("grader", "vinkel (grader);svängningstid (s)"),
        ("no-unit", "angle;T (s)"),
    ] {
        let answer = json(&format!("fit periods {}", file(name, format!("{header}\n{rows}"))));
        let t0 = answer["laws"][0]["t0_s"].as_f64().unwrap();
        assert!((t0 / 1.8 - 1.0).abs() < 1e-4, "{name}: {answer}");
    }
    // An amplitude of 60 without a unit may be a length.
    let output = libration(&format!("fit periods {}", file("length", format!("amplitude;T (s)\n{rows}"))));
    assert!(
        unfolded(&message(&output)).contains("give the unit by --amplitude-unit"),
        "{}",
        message(&output)
    );
    let feet = self::rows(|length| format!("{:.3},{:.3}", length / 0.3048, period(length)));
    let (_, told) = check("feet", format!("Length (ft),Period (s)\n{feet}"));
    assert!(told.contains("is in ft"), "{told}");
}

/// In 1/s a frequency is in hertz, and an angular one in rad/s.
#[test]
fn an_angular_frequency_in_inverse_seconds_is_in_radians_per_second() {
    let response = |frequency: f64| {
        let ratio = frequency / 0.55;
        2.0 / ((1.0 - ratio * ratio) * (1.0 - ratio * ratio) + ratio * ratio / 64.0).sqrt()
    };
    let table = |factor: f64| -> String {
        let of = |number: i32| 0.3 + 0.025 * f64::from(number);
        (0..21).map(|it| format!("{:.4},{:.3}\n", factor * of(it), response(of(it)))).collect()
    };
    for (name, heading, factor) in [
        ("omega", "ω (1/s)", TAU),
        ("kreisfrequenz", "Kreisfrequenz in 1/s", TAU),
        ("angular", "angular frequency / s^-1", TAU),
        ("f", "f (1/s)", 1.0),
        ("rpm", "rpm", 60.0),
    ] {
        let table = file(name, format!("{heading},amplitude (cm)\n{}", table(factor)));
        let answer = json(&format!("fit response --model linear {table}"));
        let omega0 = answer["parameters"][0]["value"].as_f64().unwrap();
        assert!((omega0 / (TAU * 0.55) - 1.0).abs() < 1e-3, "{heading}: {omega0}");
    }
}

#[test]
fn utf16_without_a_mark_is_told_by_its_zeros() {
    let table = format!("\"“Länge” (cm)\";\"10 T (s)\"\n{}", ten_swings());
    let units = || table.encode_utf16();
    check("utf16-little", units().flat_map(u16::to_le_bytes).collect::<Vec<u8>>());
    check("utf16-big", units().flat_map(u16::to_be_bytes).collect::<Vec<u8>>());
}

#[test]
fn cells_of_spreadsheets_are_numbers_or_missing() {
    let long = [0.6405, 0.812, 1.0125, 1.2345, 1.455, 1.7025];
    let table = |grouped: &dyn Fn(f64) -> String| -> String {
        long.map(|length| format!("{};{}\n", grouped(1000.0 * length), comma(10.0 * period(length), 2)))
            .concat()
    };
    for (name, mark) in [("point", "."), ("blank", " "), ("thin-blank", "\u{202f}"), ("apostrophe", "'")] {
        let grouped = |number: f64| match number >= 1000.0 {
            true => format!("1{mark}{:0>5}", comma(number - 1000.0, 1)),
            false => comma(number, 1),
        };
        check(name, format!("Länge in mm;Zeit für 10 Schwingungen in s\n{}", table(&grouped)));
    }
    let broken = ten_swings().replacen("12,20", "#WERT!", 1);
    let (answer, _) = check("error", format!("L (cm);10 T (s)\n{broken}"));
    assert_eq!((&answer["rows"], &answer["rows_incomplete"]), (&5.into(), &1.into()));
    // Numbers of rows with points, and a comma after which three digits stand in all cells.
    let numbered = (1..).zip(LENGTHS).map(|(number, length)| {
        format!("{number}.;{};{}\n", comma(100.0 * length, 0), comma(period(length), 3))
    });
    let numbered: String = numbered.collect();
    check("numbers", format!("Nr.;L (cm);T (s)\n{numbered}"));
}

#[test]
fn minutes_and_seconds_are_times() {
    let time = |length: f64| 50.0 * period(length);
    let parts = |length: f64| {
        let minutes = (time(length) / 60.0).floor();
        (minutes, time(length) - 60.0 * minutes)
    };
    for (name, of) in [
        ("colon", (|minutes, seconds| format!("{minutes}:{seconds:04.1}")) as fn(f64, f64) -> String),
        ("hours", |minutes, seconds| format!("00:{minutes:02}:{seconds:05.2}")),
        ("letters", |minutes, seconds| format!("{minutes}m {seconds:04.1}s")),
        ("words", |minutes, seconds| format!("{minutes} min {seconds:.1} sec")),
    ] {
        let rows = rows(|length| {
            let (minutes, seconds) = parts(length);
            format!("{:.0},{}", 100.0 * length, of(minutes, seconds))
        });
        check(name, format!("L (cm),time for 50 swings\n{rows}"));
    }
    // A time of day is not read as a duration, and the column of text is named.
    let clock = rows(|length| format!("{:.0},10:{:.0}", 100.0 * length, 100.0 * length));
    let said = refused("clock", format!("L (cm),time (s)\n{clock}"));
    assert!(said.contains("column 2 (`time (s)`) has `10:24` in line 2"), "{said}");
}

#[test]
fn tables_of_documents_are_read_as_tables() {
    let cells = |before: &str, between: &str, after: &str| {
        rows(|length| format!("{before}{:.0}{between}{:.2}{after}", 100.0 * length, 10.0 * period(length)))
    };
    let latex = rows(|length| format!("${length:.2} \\pm 0.002$ & ${:.3} \\pm 0.004$ \\\\", period(length)));
    let html = cells("<tr><td>", "</td><td>", "</td></tr>");
    for (name, table) in [
        ("markdown", format!("| L (cm) | 10 T (s) |\n|---|--:|\n{}", cells("| ", " | ", " |"))),
        ("open", format!("L (cm) | 10 T (s)\n--- | ---\n{}", cells("", " | ", ""))),
        (
            "box",
            format!("+---+---+\n| L (cm) | 10 T (s) |\n+---+---+\n{}+---+---+\n", cells("| ", " | ", " |")),
        ),
        (
            "latex",
            format!(
                "\\begin{{tabular}}{{cc}}\n\\hline\n$L$ (cm) & $10\\,T$ (s) \\\\ \\hline\n{}\\end{{tabular}}\n",
                cells("", " & ", " \\\\")
            ),
        ),
        ("latex-uncertain", format!("$L$ / m & $T$ / s \\\\\n\\midrule\n{latex}")),
        ("bars", format!("L (cm)|10 T (s)\n{}", cells("", "|", ""))),
        (
            "siunitx",
            format!(
                "{{$\\ell$ / \\si{{\\centi\\metre}}}} & {{$10\\,T$ / \\si{{\\second}}}} \\\\\n{}",
                cells("\\num{", "} & \\num{", "} \\\\")
            ),
        ),
        ("html", format!("<table>\n<tr><th>L (cm)</th><th>10&nbsp;T (s)</th></tr>\n{html}</table>\n")),
        ("aligned", format!("  L (cm)     10 T (s)\n{}", cells("   ", "        ", ""))),
    ] {
        let (answer, _) = check(name, table);
        assert_eq!(answer["rows"], 6, "{name}");
    }
    let said =
        refused("line", format!("| L (cm) | 10 T (s) |\n|---|---|\n{}| 50 | lost |\n", cells("|", "|", "|")));
    assert!(said.contains("line 9, column 2: `lost`"), "{said}");
}

#[test]
fn quantities_in_rows_are_columns() {
    let row = |of: &dyn Fn(f64) -> String| LENGTHS.map(of).join(";");
    let (lengths, times) = (row(&|it| comma(100.0 * it, 0)), row(&|it| comma(10.0 * period(it), 2)));
    let (_, told) = check("rows", format!("Messung;1;2;3;4;5;6\nl in cm;{lengths}\n10 T in s;{times}\n"));
    assert!(told.contains("the quantities stand in rows"), "{told}");
    let swings = "swing,0,10,20,30,40,50\namplitude (deg),20,13.5,9.1,6.2,4.2,2.8\n";
    let answer = json(&format!("fit amplitudes {}", file("swings-in-rows", swings)));
    assert!((answer["quality"].as_f64().unwrap() / 80.0 - 1.0).abs() < 0.02, "{answer}");
    // Rows of readings are no quantities.
    let readings =
        rows(|length| format!("{:.0} cm,{:.3},{:.3}", 100.0 * length, period(length), period(length)));
    assert!(refused("readings", readings).contains("no header"));
}

#[test]
fn headers_of_merged_and_broken_cells_name_their_columns() {
    let three = |first: &dyn Fn(f64) -> String, swings: f64, decimals: usize| {
        rows(|length| {
            let time = |error: f64| format!("{:.decimals$}", swings * period(length) + error);
            format!("{},{},{},{}", first(length), time(0.01), time(-0.01), time(0.004))
        })
    };
    let (metres, centimetres) = (|it: f64| format!("{it:.2}"), |it: f64| format!("{:.0}", 100.0 * it));
    for (name, header, rows) in [
        ("trials", ",Trial,,\nL (m),1,2,3", three(&metres, 1.0, 3)),
        ("no-title", "L (m),1,2,3", three(&metres, 1.0, 3)),
        (
            "measurements",
            "L in cm,10 T in s,,\n,1. Messung,2. Messung,3. Messung",
            three(&centimetres, 10.0, 2),
        ),
        (
            "runs",
            "L in cm,Messung 1: 10 T in s,Messung 2: 10 T in s,Messung 3: 10 T in s",
            three(&centimetres, 10.0, 2),
        ),
        ("ordinals", "L (m),1. Versuch (s),2. Versuch (s),3. Versuch (s)", three(&metres, 1.0, 3)),
        ("brackets", "L (m),T (1) in s,T (2) in s,T (3) in s", three(&metres, 1.0, 3)),
        ("blank", "L (cm),time for 10 swings (s),,", three(&centimetres, 10.0, 2)),
        (
            "lines",
            "\"L\n(cm)\",\"10 T\n1 (s)\",\"10 T\n2 (s)\",\"10 T\n3 (s)\"",
            three(&centimetres, 10.0, 2),
        ),
    ] {
        let (_, told) = check(name, format!("{header}\n{rows}"));
        assert!(told.contains("as repeated readings: column 2"), "{name}: {told}");
    }
    check("units", format!("Länge;Zeit für 10 Schwingungen\nin cm;in s\n{}", ten_swings()));
    let pairs = rows(|length| format!("{},{}", comma(length, 2), comma(period(length), 3)));
    check("commas", format!("L (m),T (s)\n{pairs}"));
    let (_, told) = check(
        "stated",
        format!("(L ± 0.2) cm,(10 T ± 0.05) s\n{}", ten_swings().replace(',', ".").replace(';', ",")),
    );
    assert!(told.contains("uncertainty of all rows"), "{told}");
}

#[test]
fn text_below_a_table_is_left_out_and_named() {
    let table = format!("L (cm);10 T (s)\n{}", ten_swings());
    let (answer, told) = check("remarks", format!("{table}\n* measured twice\nthe string was long\n"));
    assert!(told.contains("line 9 (`* measured twice`) and further lines of text are left out"), "{told}");
    assert_eq!(answer["rows"], 6);
    // Wrong numbers are not taken for a remark.
    let said = refused("wrong-numbers", format!("{table}99 cm;19,98 s\n"));
    assert!(said.contains("line 8, column 1: `99 cm`"), "{said}");
    let (_, told) = check("results", format!("{table};\ng =;9,83\nMittelwert von g;9,79\n"));
    assert!(told.contains("line 9 (`g =`)") && told.contains("line 10 (`Mittelwert von g`)"), "{told}");
}

#[test]
fn tables_below_one_another_are_groups() {
    let block = |title: &str| format!("{title}\nL (cm);10 T (s)\n{}\n", ten_swings());
    let (answer, told) = check("blocks", format!("{}{}", block("Gruppe 1"), block("Gruppe 2")));
    assert_eq!((&answer["rows"], &answer["groups"][1]["group"]), (&12.into(), &"Gruppe 2".into()), "{told}");
    let spaced =
        |title: &str| format!("{title}\n{}\n", block("").replace(';', "   ").replace(',', ".").trim());
    let (answer, _) = check("spaced", ["Group A", "Group B", "Group C"].map(spaced).concat());
    assert_eq!((&answer["rows"], &answer["groups"][2]["group"]), (&18.into(), &"Group C".into()), "{answer}");
    // Another header is another table.
    let other = rows(|length| format!("{};{}", comma(length, 2), comma(period(length), 3)));
    let both = format!("L (cm);10 T (s)\n{}\nL (m);T (s)\n{other}", ten_swings());
    let said = refused("headers", &both);
    assert!(said.contains("a second table begins in line 9") && said.contains("--header 1 or 9"), "{said}");
    let path = file("headers", &both);
    for line in [1, 9] {
        let answer = json(&format!("fit lengths {path} --header {line}"));
        let gravity = answer["gravity_m_per_s2"].as_f64().unwrap();
        assert!((gravity / 9.81 - 1.0).abs() < 0.01 && answer["rows"] == 6, "{line}: {answer}");
    }
}

#[test]
fn several_swings_that_were_counted_as_one_are_named() {
    for swings in [2.0, 5.0, 10.0, 20.0] {
        let rows = rows(|length| format!("{:.0},{:.2}", 100.0 * length, swings * period(length)));
        let sheet =
            unfolded(&text(&format!("fit lengths {}", file("swings", format!("L (cm),t (s)\n{rows}")))));
        assert!(sheet.contains(&format!("--swings-per-reading {swings}")), "{swings}: {sheet}");
    }
    // The mean over ten swings says it.
    let means =
        rows(|length| format!("{:.0},{:.2},{:.4}", 100.0 * length, 10.0 * period(length), period(length)));
    check("means", format!("l/cm,t/s,T=t/10\n{means}"));
}

#[test]
fn amplitudes_against_numbers_of_swings_are_read_in_any_language() {
    let quality = 80.0;
    let amplitude = |swing: i32| 12.0 * (-std::f64::consts::PI * f64::from(swing) / quality).exp();
    let table: String = (0..15).map(|it| format!("{};{}\n", 4 * it, comma(amplitude(4 * it), 3))).collect();
    for (name, heading) in [
        ("de", "Schwingung Nr."),
        ("es", "número de oscilaciones"),
        ("pl", "numer wahnięcia"),
        ("nl", "aantal slingeringen"),
    ] {
        let path = file(&format!("swings-{name}"), format!("{heading};A (cm)\n{table}"));
        let found = json(&format!("fit amplitudes {path}"))["quality"].as_f64().unwrap();
        assert!((found / quality - 1.0).abs() < 0.01, "{heading}: {found}");
    }
    let path = file("no-unit-amplitudes", format!("swing;amplitude\n{table}"));
    let said = unfolded(&message(&libration(&format!("fit amplitudes {path}"))));
    assert!(said.contains("--amplitude-unit") && said.contains("have no unit"), "{said}");
}
