//! Tables in the styles of other languages, spreadsheets and documents, g = 9.81 m/s².

use crate::command::{directory, json, libration, message, run as run_command, text, unfolded};
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
fn headers_of_many_languages_say_lengths_and_numbers_of_swings() {
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
        ("da", "Længde (cm);Tid for 10 svingninger (s)"),
        ("cs", "Délka (cm);Doba 10 kmitů (s)"),
        ("hu", "Hossz (cm);10 lengés ideje (s)"),
        ("el", "Μήκος (cm);Χρόνος 10 ταλαντώσεων (s)"),
        ("ru", "Длина (см);Время 10 колебаний (с)"),
        ("braces", "L {cm};10 T {s}"),
        ("colons", "Length in cm:;Time of 10 swings in s:"),
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
    let rows: String =
        angles.map(|angle| format!("{};{}\n", comma(angle, 0), comma(period_at(angle), 4))).concat();
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
        (0..21).map(|row| format!("{:.4},{:.3}\n", factor * of(row), response(of(row)))).collect()
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
        ("primes", |minutes, seconds| format!("{minutes}'{seconds:04.1}''")),
        ("tenths", |minutes, seconds| format!("{minutes}′{seconds:04.1}").replace('.', "″")),
        ("mn", |minutes, seconds| format!("{minutes} mn {seconds:.1} s")),
    ] {
        let rows = rows(|length| {
            let (minutes, seconds) = parts(length);
            format!("{:.0},{}", 100.0 * length, of(minutes, seconds))
        });
        check(name, format!("L (cm),time for 50 swings\n{rows}"));
    }
    // Whole seconds with a colon may be a time of day, unless the heading says minutes and seconds.
    let whole = |length: f64| (time(length).round() / 60.0).floor();
    let colons = rows(|length| {
        let minutes = whole(length);
        format!("{:.0},{minutes}:{:02.0}", 100.0 * length, time(length).round() - 60.0 * minutes)
    });
    check("min-s", format!("L (cm),50 T (min:s)\n{colons}"));
    let said = refused("bare-colons", format!("L (cm),50 T\n{colons}"));
    assert!(said.contains("column 2 (`50 T`) has `"), "{said}");
    // Shorter times may be plain seconds below a heading with this unit.
    let mixed = rows(|length| {
        let (minutes, seconds) = parts(length);
        let time = if minutes > 0.0 { format!("{minutes}:{seconds:04.1}") } else { format!("{seconds:.1}") };
        format!("{:.0},{time}", 100.0 * length)
    });
    check("plain-seconds", format!("L (cm),time for 50 swings (s)\n{mixed}"));
    let said = refused("no-unit", format!("L (cm),50 T\n{mixed}"));
    assert!(said.contains("numbers in s and numbers without a unit"), "{said}");
    // A time of day is not read as a duration, and the column of text is named.
    let clock = rows(|length| format!("{:.0},10:{:.0}", 100.0 * length, 100.0 * length));
    let said = refused("clock", format!("L (cm),time (s)\n{clock}"));
    assert!(said.contains("column 2 (`time (s)`) has `10:24` in line 2"), "{said}");
}

#[test]
fn columns_of_minutes_and_seconds_are_added() {
    let two = |swings: f64, end: &str| {
        rows(|length| {
            let time = swings * period(length);
            let minutes = (time / 60.0).floor();
            format!("{:.0},{minutes},{:.1}{end}", 100.0 * length, time - 60.0 * minutes)
        })
    };
    for (name, header, rows) in [
        ("names", "L (cm),t (min),t (s),swings", two(50.0, ",50")),
        ("title", "L (cm),time for 50 swings (min),(s)", two(50.0, "")),
        ("units", "L (cm),min,s,N", two(50.0, ",50")),
    ] {
        let (_, told) = check(name, format!("{header}\n{rows}"));
        assert!(told.contains("are min and s of one quantity, and are added"), "{name}: {told}");
    }
    let feet = rows(|length| {
        let inches = (length / 0.0254 * 10.0).round() / 10.0;
        let feet = (inches / 12.0).floor();
        format!("{feet},{:.1},{:.3}", inches - 12.0 * feet, period(length))
    });
    check("feet", format!("L (ft),L (in),T (s)\n{feet}"));
    // The same time in minutes and in seconds is not added.
    let both = rows(|length| format!("{:.2},{:.4},{:.2}", length, period(length) / 60.0, period(length)));
    let (_, told) = check("both", format!("L (m),T (min),T (s)\n{both}"));
    assert!(!told.contains("added"), "{told}");
}

#[test]
fn feet_and_inches_with_fractions_are_lengths() {
    let eighths = |length: f64| (length / 0.0254 * 8.0).round();
    let of = |eighths: f64| {
        let feet = (eighths / 96.0).floor();
        let inches = ((eighths - 96.0 * feet) / 8.0).floor();
        (feet, inches, eighths - 96.0 * feet - 8.0 * inches)
    };
    for (name, heading, text) in [
        (
            "primes",
            "Length",
            (|feet, inches, part| format!("{feet}' {inches} {part}/8\"")) as fn(f64, f64, f64) -> String,
        ),
        ("words", "Length", |feet, inches, part| format!("{feet} ft {inches} {part}/8 in")),
        ("inches", "L (in)", |feet, inches, part| format!("{} {part}/8", 12.0 * feet + inches)),
        ("fraction", "L (ft);L (in)", |feet, inches, part| {
            if feet > 2.5 {
                format!("{feet};{inches} {part}/8")
            } else {
                format!("{feet};{}", inches + part / 8.0)
            }
        }),
    ] {
        let rows = rows(|length| {
            let (feet, inches, part) = of(eighths(length));
            format!("{};{:.3}", text(feet, inches, part), period(eighths(length) / 8.0 * 0.0254))
        });
        check(name, format!("{heading};T (s)\n{rows}"));
    }
    let sevenths = "L (ft);L (in);T (s)\n1;6;1.3602\n2;0;1.5706\n2;6;1.7560\n3;3 3/7;2.0123\n";
    let told = json(&format!("fit lengths {}", file("sevenths", sevenths)))["told_from_file"].to_string();
    assert!(
        told.contains("is not added to column 1 (`L (ft)`), since `3 3/7` is not read as a number"),
        "{told}"
    );
    let decimetres = rows(|length| format!("{:.1} dm;{:.3}", 10.0 * length, period(length)));
    check("dm", format!("L;T (s)\n{decimetres}"));
    // A Swiss mark of thousands is not a foot.
    let thousands = [1005.0, 1205.0, 1410.0, 1605.0];
    let rows = thousands
        .map(|thousand| format!("1'{:03.0};{:.4}\n", thousand - 1000.0, period(thousand / 1000.0)))
        .concat();
    check("thousands", format!("L (mm);T (s)\n{rows}"));
}

#[test]
fn mixed_decimal_marks_and_formulas_are_named() {
    let marks = |with_comma: &dyn Fn(f64) -> bool| {
        rows(|length| {
            let time = format!("{:.3}", period(length));
            format!(
                "{:.0};{}",
                100.0 * length,
                if with_comma(length) { time.replace('.', ",") } else { time }
            )
        })
    };
    let said = refused("one", format!("L (cm);T (s)\n{}", marks(&|length| length > 0.9)));
    assert!(
        said.contains("line 7: `1,986` has a comma, and other numbers of the table have a decimal point"),
        "{said}"
    );
    let said = refused("some", format!("L (cm);T (s)\n{}", marks(&|length| length < 0.7)));
    assert!(said.contains("lines 6, 7: `1.805` has a point"), "{said}");
    let said = refused(
        "column",
        format!("L (m);T (s)\n{}", rows(|length| format!("{length:.2};{}", comma(period(length), 3)))),
    );
    assert!(said.contains("numbers of other columns have another decimal mark"), "{said}");
    let formulas = rows(|length| format!("{:.0};={:.2}/10", 100.0 * length, 10.0 * period(length)));
    let said = refused("formulas", format!("L (cm);T (s)\n{formulas}"));
    assert!(said.contains("in line 2, a formula without its value: save the table with values"), "{said}");
    let some = rows(|length| match length < 0.9 {
        true => format!("{:.0};{:.3}", 100.0 * length, period(length)),
        false => format!("{:.0};=19.9/10", 100.0 * length),
    });
    let said = refused("some-formulas", format!("L (cm);T (s)\n{some}"));
    assert!(said.contains("line 7, column 2: `=19.9/10` is a formula without its value"), "{said}");
}

#[test]
fn rows_are_chosen_by_a_range_and_by_runs() {
    let table = file("range", format!("L (cm);10 T (s)\n{}", ten_swings()));
    let rows = |options: &str| {
        let answer = json(&format!("fit lengths {table} {options}"));
        (answer["rows"].as_u64().unwrap(), answer["told_from_file"].to_string())
    };
    let (number, told) = rows("--from 37 --to 0.81m");
    assert!(number == 4 && told.contains("2 rows are ignored (--from, --to)"), "{told}");
    for (options, expected) in [
        ("--from 100", "those of the file are from 24.0 to 98.0 cm"),
        ("--to 2s", "the range is given in s, and the length is in cm"),
        ("--run 1", "the table has no groups, which are its runs (--run)"),
    ] {
        let said = unfolded(&message(&libration(&format!("fit lengths {table} {options}"))));
        assert!(said.contains(expected), "{options}: {said}");
    }
    let block = |title: &str, error: f64| {
        let rows = self::rows(|length| format!("{:.0};{:.2}", 100.0 * length, 10.0 * period(length) * error));
        format!("{title}\nL (cm);10 T (s)\n{rows}\n")
    };
    let groups = file("runs", format!("{}{}", block("Gruppe A", 1.0), block("Gruppe B", 1.1)));
    for (run, factor) in [("A", 1.0), ("gruppe b", 1.21), ("2", 1.21)] {
        let output = run_command(&["fit", "lengths", &groups, "--json", "--run", run]);
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!((answer["gravity_m_per_s2"].as_f64().unwrap() * factor / 9.81 - 1.0).abs() < 0.01, "{run}");
    }
    let said = unfolded(&message(&libration(&format!("fit lengths {groups} --run C"))));
    assert!(
        said.contains("there is no run `C`: the groups of the table are `Gruppe A`, `Gruppe B`"),
        "{said}"
    );
    let angles = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    let angles = angles.map(|angle| format!("{angle},{:.4}\n", period_at(angle))).concat();
    let angles = file("angles", format!("theta (deg),T (s)\n{angles}"));
    let answer = json(&format!("fit periods {angles} --from 20 --to 0.9rad"));
    assert_eq!(answer["rows"], 4, "{answer}");
}

#[test]
fn half_swings_are_halves_and_periods_of_drives_frequencies() {
    let amplitudes: String = (0..11)
        .map(|row| 4.0 * f64::from(row))
        .map(|number| format!("{number};{}\n", comma(10.0 * (-number * TAU / 4.0 / 80.0).exp(), 3)))
        .collect();
    for (name, heading) in
        [("de", "Halbschwingungen"), ("en", "number of half swings"), ("no", "Halbschwingung Nr.")]
    {
        let table = file(&format!("half-{name}"), format!("{heading};Amplitude (cm)\n{amplitudes}"));
        let answer = json(&format!("fit amplitudes {table}"));
        assert!((answer["quality"].as_f64().unwrap() / 80.0 - 1.0).abs() < 0.01, "{heading}: {answer}");
    }
    let response = |frequency: f64| {
        let ratio = frequency / 0.55;
        2.0 / ((1.0 - ratio * ratio) * (1.0 - ratio * ratio) + ratio * ratio / 64.0).sqrt()
    };
    let of = |number: i32| 0.3 + 0.025 * f64::from(number);
    for (heading, swings) in [("T drive (s)", 1.0), ("Erregerperiode in s", 1.0), ("10 T (s)", 10.0)] {
        let rows: String =
            (0..21).map(|row| format!("{:.4};{:.3}\n", swings / of(row), response(of(row)))).collect();
        let table = file("drive", format!("{heading};amplitude (cm)\n{rows}"));
        let answer = json(&format!("fit response --model linear {table} --from 0.1"));
        let omega0 = answer["parameters"][0]["value"].as_f64().unwrap();
        assert!((omega0 / (TAU * 0.55) - 1.0).abs() < 1e-3, "{heading}: {omega0}");
    }
    // Groups that the fit does not distinguish, and one of them.
    let block = |title: &str, factor: f64| {
        let rows = (0..21).map(|row| format!("{:.4};{:.3}\n", factor * of(row), response(of(row))));
        format!("{title}\nf (Hz);amplitude (cm)\n{}\n", rows.collect::<String>())
    };
    let table = file("drives", format!("{}{}", block("run 1", 1.0), block("run 2", 1.01)));
    let answer = json(&format!("fit response --model linear {table} --run 2"));
    let omega0 = answer["parameters"][0]["value"].as_f64().unwrap();
    assert!((omega0 / (TAU * 0.55 * 1.01) - 1.0).abs() < 1e-3, "{omega0}");
    let told = json(&format!("fit response --model linear {table}"))["told_from_file"].to_string();
    assert!(told.contains("all groups are fitted together (--run chooses some)"), "{told}");
    // Times are not periods.
    let rows: String = (0..21).map(|row| format!("{row};{:.3}\n", response(of(row)))).collect();
    let table = file("no-drive", format!("t (s);amplitude (cm)\n{rows}"));
    let output = libration(&format!("fit response --model linear {table}"));
    assert!(message(&output).contains("where frequencies are needed"), "{}", message(&output));
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
    let (lengths, times) =
        (row(&|length| comma(100.0 * length, 0)), row(&|length| comma(10.0 * period(length), 2)));
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
    let (metres, centimetres) =
        (|length: f64| format!("{length:.2}"), |length: f64| format!("{:.0}", 100.0 * length));
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
    let table: String =
        (0..15).map(|row| format!("{};{}\n", 4 * row, comma(amplitude(4 * row), 3))).collect();
    for (name, heading) in [
        ("de", "Schwingung Nr."),
        ("es", "número de oscilaciones"),
        ("pl", "numer wahnięcia"),
        ("nl", "aantal slingeringen"),
    ] {
        let path = file(&format!("swings-{name}"), format!("{heading};A (cm)\n{table}"));
        let computed = json(&format!("fit amplitudes {path}"))["quality"].as_f64().unwrap();
        assert!((computed / quality - 1.0).abs() < 0.01, "{heading}: {computed}");
    }
    let path = file("no-unit-amplitudes", format!("swing;amplitude\n{table}"));
    let said = unfolded(&message(&libration(&format!("fit amplitudes {path}"))));
    assert!(said.contains("--amplitude-unit") && said.contains("have no unit"), "{said}");
}
