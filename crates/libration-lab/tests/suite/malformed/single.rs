//! Files that are unusual in individual ways.

use super::Case;

/// Times and angles in radians.
fn rows(rows: &[(f64, f64)]) -> Vec<(f64, f64)> {
    rows.to_vec()
}

pub(crate) fn cases() -> Vec<Case> {
    [nothing_in_it(), commas(), headers(), uncertainties(), runs(), accelerations(), units(), quotes()]
        .into_iter()
        .flatten()
        .collect()
}

fn nothing_in_it() -> Vec<Case> {
    [
        "",
        "\n\n\n",
        "\u{feff}",
        "# a remark\n",
        "Time (s),Angle (rad)\n",
        ",,,\n,,,\n",
        "only words\nand more words\n",
        "\t\t\n",
    ]
    .map(|text| Case::refused(format!("{text:?}"), text, &["no rows"]))
    .into()
}

fn commas() -> Vec<Case> {
    vec![
        Case::refused(
            "commas everywhere",
            "0,5,1,2\n1,0,1,3\n1,5,1,4\n",
            &["line 1", "decimal=point or comma"],
        ),
        Case::refused("one column or two", "0,5\n1,5\n2,5\n", &["decimal=point or comma"]),
        Case::read(
            "commas everywhere below a header",
            "t/s,θ/rad\n0,5,1,2\n1,0,1,3\n",
            rows(&[(0.5, 1.2), (1.0, 1.3)]),
        ),
        Case::refused(
            "thousands or decimals",
            "t/ms\tθ/rad\n1,000\t0.5\n1,050\t0.4\n1,100\t0.3\n",
            &["lines 2, 3, 4: `1,000` has a comma", "without marks of thousands"],
        ),
        Case::refused(
            "all thousands",
            "t/ms\tθ/counts\n1,000\t2,500\n1,050\t2,400\n1,100\t2,300\n",
            &["1,000", "decimal=comma"],
        ),
        Case::refused(
            "a point in one column, a comma in the other",
            "t/s;θ/rad\n0.05;0,5\n0.10;0,4\n0.15;0,3\n",
            &["lines 2, 3, 4: `0,5` has a comma", "have a decimal point"],
        ),
        Case::read("whole numbers", "t/s,θ/deg\n0,180\n1,90\n2,0\n", {
            use std::f64::consts::PI;
            rows(&[(0.0, 180.0 * (PI / 180.0)), (1.0, 90.0 * (PI / 180.0)), (2.0, 0.0)])
        }),
        Case::read(
            "three decimals that begin with zero",
            "t/s;θ/rad\n0,050;0,512\n0,100;0,498\n0,150;0,466\n",
            rows(&[(0.05, 0.512), (0.1, 0.498), (0.15, 0.466)]),
        ),
    ]
}

fn headers() -> Vec<Case> {
    let preamble = "MIN=0\t-1\nMAX=10\t1\nDEC=1\t3\nDEF=\"Zeit\" t / s\t\"Winkel\" w / rad\n0\t0,5\n0,1\t0,4\n0,2\t0,2\n";
    let vernier = "Vernier Format 2\nswing.cmbl 3/1/2024 10:00:00 .\nRun 1\nTime\tAngle\nt\tA\ns\trad\n\n0\t0.5\n0.1\t0.4\n0.2\t0.2\n";
    let same = rows(&[(0.0, 0.5), (0.1, 0.4), (0.2, 0.2)]);
    vec![
        Case::read("a preamble of limits", preamble, same.clone()),
        Case::read("a preamble of a format", vernier, same.clone()),
        Case::read(
            "a commented header",
            "# swing of Monday\n# t/s theta/rad\n0 0.5\n0.1 0.4\n0.2 0.2\n",
            same.clone(),
        ),
        Case::read("a title", "Swing of Monday\nt/s,theta/rad\n0,0.5\n0.1,0.4\n0.2,0.2\n", same.clone()),
        Case::read("a line of units", "t,theta\n(s),(rad)\n0,0.5\n0.1,0.4\n0.2,0.2\n", same.clone()),
        Case::read("units torn off", "t / s   theta / rad\n0   0.5\n0.1 0.4\n0.2 0.2\n", same.clone()),
        Case::read(
            "Windows-1252",
            b"t/s;Winkel/\xb0\n0,0;0,0\n0,1;0,0\n0,2;0,0\n",
            rows(&[(0.0, 0.0), (0.1, 0.0), (0.2, 0.0)]),
        ),
        Case::refused(
            "a broken letter beside a whole one",
            b"t/s;\xce\xb8/\xb0\n0;1\n".as_slice(),
            &["broken UTF-8"],
        ),
        Case::refused("a bad first row", "t/s,theta/rad\nO.0,0.5\n0.1,0.4\n0.2,0.2\n", &["line 2"]),
        Case::refused(
            "another table above",
            "L,T\n1,2.0\n\nt/s,theta/rad,x\n0,0.5,1\n0.1,0.4,1\n0.2,0.2,1\n",
            &["line 2"],
        ),
        Case::refused("a number alone above", "500\nt/s,theta/rad\n0,0.5\n0.1,0.4\n", &["line 1"]),
        Case::refused("a header that is not closed", "t/s,\"theta/rad\n0,0.5\n0.1,0.4\n", &["no rows"]),
    ]
}

fn uncertainties() -> Vec<Case> {
    let with = |names: &str| format!("{names}\n0,0.5,0.01\n0.1,0.4,0.01\n0.2,0.2,0.01\n");
    let same = rows(&[(0.0, 0.5), (0.1, 0.4), (0.2, 0.2)]);
    ["±", "+/-", "σ", "u(θ)", "σ_θ (rad)", "Δθ", "err", "uncertainty (rad)", "Fehler"]
        .map(|name| {
            let names = format!("t/s,θ/rad,{name}");
            Case::read(format!("an uncertainty headed {name}"), with(&names), same.clone())
        })
        .into_iter()
        .chain([Case::refused("angles headed as uncertainties", with("t/s,±,u(θ)"), &[])])
        .collect()
}

/// A whole swing is two periods of what an accelerometer along the string shows: no angle is to be taken from it.
fn accelerations() -> Vec<Case> {
    let with = |names: &str| format!("{names}\n0,9.5\n0.1,9.9\n0.2,9.5\n0.3,9.1\n");
    [
        "Time (s),Acceleration x (m/s^2)",
        "\"Time (s)\",\"Linear Acceleration y (m/s²)\"",
        "t/s,a/m/s²",
        "t/s,Beschleunigung",
        "Time (s),Absolute acceleration (m/s^2)",
    ]
    .map(|names| Case::refused(names, with(names), &["accelerations", "gyroscope", "distance"]))
    .into()
}

fn runs() -> Vec<Case> {
    let pasco = "Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2\n\
                 0.00,0.5,0.00,0.3\n0.05,0.4,0.05,0.2\n,,0.10,0.1\n";
    vec![
        Case::read(
            "runs of two lengths",
            pasco,
            rows(&[(0.0, 0.5), (0.05, 0.4), (0.0, 0.3), (0.05, 0.2), (0.1, 0.1)]),
        ),
        Case::read(
            "numbered runs",
            "packet,t/s,θ/rad\n0,1,0.5\n0,2,0.4\n1,0,0.3\n1,1,0.2\n",
            rows(&[(1.0, 0.5), (2.0, 0.4), (0.0, 0.3), (1.0, 0.2)]),
        ),
        Case::read(
            "runs between each other",
            "packet,t/s,θ/rad\n0,1,0.5\n1,2,0.4\n0,3,0.3\n1,4,0.2\n",
            rows(&[(1.0, 0.5), (3.0, 0.3), (2.0, 0.4), (4.0, 0.2)]),
        ),
        Case::refused("a run twice", "packet,t/s,θ/rad\n0,1,0.5\n0,2,0.4\n1,1,0.3\n0,1,0.2\n", &["line 5"]),
        Case::read(
            "runs told by numbers behind symbols",
            "t_{1};theta_{1};t_{2};theta_{2}\n0;1.0;0.01;2.0\n0.1;1.1;0.11;2.1\n"
                .replace("theta_{1}", "theta_{1}/rad")
                .replace("theta_{2}", "theta_{2}/rad"),
            rows(&[(0.0, 1.0), (0.1, 1.1), (0.01, 2.0), (0.11, 2.1)]),
        ),
        Case::refused(
            "two angles of one double pendulum",
            "t/s,theta1/rad,theta2/rad\n0,0.5,0.4\n0.1,0.4,0.3\n",
            &["angles", "angle=2 or 3"],
        ),
        Case::refused("times of one run back", pasco.replace("\n0.05,", "\n-0.05,"), &["line 3"]),
    ]
}

fn units() -> Vec<Case> {
    let swing = |header: &str, scale: f64| {
        let row = |n: u8| format!("{},{:.3}\n", 0.05 * f64::from(n), scale * libm::cos(0.4 * f64::from(n)));
        format!("{header}\n{}", (0..60).map(row).collect::<String>())
    };
    vec![
        Case::refused("a small swing without a unit", swing("t/s,angle", 1.4), &["angle-unit=rad or deg"]),
        Case::refused(
            "whole numbers may be counts",
            "t/s,angle\n0,100\n0.1,-100\n0.2,100\n0.3,-100\n0.4,100\n0.5,-100\n",
            &["counts-per-turn"],
        ),
        Case::refused("counts", swing("t/s,angle/counts", 500.0), &["counts-per-turn"]),
        Case::refused("radians per second as an angle", swing("t/s,θ (rad/s²)", 1.0), &[]),
        Case::refused(
            "milliseconds without a unit",
            "t,θ/rad\n0,0.1\n33,0.2\n67,0.1\n",
            &["time-unit=s, ms"],
        ),
        Case::refused(
            "positions without a name",
            "t/s,right/m,up/m\n0,0.1,0.2\n0.1,0.2,0.1\n0.2,0.3,0.1\n",
            &["x=2 and y=3"],
        ),
        Case::refused(
            "positions in two units",
            "t/s,x/m,y/cm\n0,0.1,0.2\n0.1,0.2,0.1\n0.2,0.3,0.1\n",
            &["m", "cm"],
        ),
        Case::refused(
            "positions on a line",
            "t/s,x/m,y/m\n0,0.1,0.2\n0.1,0.2,0.2\n0.2,0.3,0.2\n0.3,0.4,0.2\n",
            &["pivot=X,Y"],
        ),
        Case::refused(
            "three axes of one strength",
            three_axes(|n| [libm::sin(n), libm::cos(n), libm::sin(1.7 * n)]),
            &["angular-velocity=2"],
        ),
        Case::refused(
            "three axes and two rows",
            "t/s,gx (rad/s),gy (rad/s),gz (rad/s)\n0,1,1,1\n0.1,2,2,2\n",
            &["angular-velocity=2"],
        ),
    ]
}

/// A gyroscope with these rates.
fn three_axes(rates: impl Fn(f64) -> [f64; 3]) -> String {
    let row = |n: u8| {
        let [x, y, z] = rates(f64::from(n));
        format!("{},{x:.4},{y:.4},{z:.4}\n", 0.05 * f64::from(n))
    };
    format!("t/s,gx (rad/s),gy (rad/s),gz (rad/s)\n{}", (0..60).map(row).collect::<String>())
}

fn quotes() -> Vec<Case> {
    vec![
        Case::refused("a quote that is not closed", "t/s,θ/rad\n0,0.5\n0.1,\"0.4\n0.2,0.3\n", &["line 3"]),
        Case::refused("a quote among whole numbers", "t/s,θ/deg\n\"0,180\n1,90\n2,0\n3,90\n", &["line 2"]),
        Case::refused(
            "a quote in a remark",
            "t/s,θ/rad,remark\n0,0.5,a\n0.1,0.4,\"b\n0.2,0.3,c\n0.3,0.2,d\n",
            &["line 3", "quote"],
        ),
        Case::read(
            "a remark with a comma",
            "t/s,θ/rad,remark\n0,0.5,\"a, b\"\n0.1,0.4,c\n",
            rows(&[(0.0, 0.5), (0.1, 0.4)]),
        ),
        Case::refused(
            "a cell of a megabyte",
            format!("t/s,θ/rad\n0,{}x\n0.1,0.4\n", "1".repeat(1 << 19)),
            &["line 2"],
        ),
        Case::refused("more than the limit", "1,2\n".repeat(1 << 19), &["limit"]),
    ]
}
