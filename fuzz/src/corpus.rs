//! Initial inputs: each notation of the documentation, and inputs that once failed.

use libration_testing::zip_archive::{Packed, archive};

fn bytes(texts: &[&str]) -> Vec<Vec<u8>> {
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}

/// Tokens of equations.
pub const EQUATION: &[&str] = &[
    "x", "x'", "x''", "theta", "θ", "θ̇", "ω0", "omega0", "eps", "sin(", "cos(", "sqrt(", "abs(", "sign(",
    "max(", "min(", "log(", "exp(", "tan(", "(", ")", "+", "-", "−", "*", "/", "^", "=", ";", ",", "'",
    "1/0", "0.1", "1e308", "1e-320", "2/3", "pi", "t", "d", "[0]", "[k]", "sum(", "k=1..n", "\u{202e}", "\0",
    "^-1", "^(1/2)", "^x", "''''", " ", "\n",
];

/// Equations.
pub fn equations() -> Vec<Vec<u8>> {
    let mut all = bytes(&[
        "theta'' + omega0^2*sin(theta) = 0",
        "x'' = -x - x^3",
        "x'' + 0.1*x' + x + 10*max(x-1,0) = 0.3*cos(w*t)",
        "x'' - mu*(1-x^2)*x' + x = 0",
        "v' = v - v^3/3 - w + I; w' = 0.08*(v + 0.7 - 0.8*w)",
        "x'' + x + c*x'*abs(x') = 0",
        "x'' + w^2*x + a*x^2 + b*x^3 = 0",
        "x'' = -x^(5/3)",
        "x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y-8*z/3",
        "x''=-sin(x) - 1e-7*x'",
        "theta'' = -sin(theta) + A*cos(omega*t) - c*theta'",
        "x'' + x*(1 - 2*h*cos(2*t)) = 0",
        // An input that once failed.
        "bla(,A=0,omega=2/3",
        "x'' + x = 0; y",
        "x''' = 0",
        "<b>x</b>",
        "'\"`$(ls)",
    ]);
    all.push([b"x'' - ".to_vec(), b"x^-".repeat(60), b"x".to_vec()].concat());
    all.push([b"(".repeat(20_000), b"x".to_vec()].concat());
    all.push([b"x''=-x".to_vec(), b"^2".repeat(3000)].concat());
    all
}

/// Tokens of quantities.
pub const QUANTITY: &[&str] = &[
    "deg", "°", "rad", "pi", "π", "turn", "m", "cm", "mm", "s", "m/s^2", "m/s²", "rad/s", "±", "+-", "(5)",
    "e", "E", "-", "−", "+", ".", ",", "/", "*", "sqrt(2)", "1e308", "1e-320", "inf", "nan", " ", "'", "\"",
    "180deg", "1e-9deg", "0x10", "½", "٣", "\u{200b}",
];

/// Angles.
pub fn angles() -> Vec<Vec<u8>> {
    bytes(&[
        "60deg",
        "60°",
        "1.2rad",
        "1.2",
        "pi-1e-6",
        "180deg-1e-9deg",
        "pi/2",
        "2/3pi",
        "-30deg",
        "1e308deg",
        "179.999999deg",
        "pi-1e-20",
        "1e-320",
        "−12.5 deg",
        "170deg30'",
        "1.5turn",
        "60degg",
        "12 345deg",
    ])
}

/// Lengths, accelerations, angular velocities.
pub fn quantities() -> Vec<Vec<u8>> {
    bytes(&[
        "57cm",
        "0.56m±0.002m",
        "0.9940(5) m",
        "9.81",
        "9.81 m/s^2",
        "9.80665m/s²",
        "1.2 rad/s",
        "30deg/s",
        "1m±1%",
        "1,5 ± 0,1 m",
        "1e308 km",
        "1e-320m",
        "-1m",
        "inf",
        "1.234(5)",
        "3ft",
        "1 s",
    ])
}

/// Tokens of tables.
pub const TABLE: &[&str] = &[
    "\t",
    ",",
    ";",
    "\n",
    "\r\n",
    "\"",
    "\"\"",
    "1,5",
    "1.5",
    "1e400",
    "nan",
    "inf",
    "deg",
    "(s)",
    "t (s)",
    "angle (rad)",
    "T (s)",
    "±",
    "\u{feff}",
    "\0",
    "#",
    "=1+1",
    "<row>",
    "</c>",
    "t=\"s\"",
    "r=\"XFD1048576\"",
    "<v>1</v>",
    "&amp;",
    "&#x0;",
    "10cm",
    "\u{202e}",
    "\u{1b}[2J",
    "|",
    "--",
    "1/2",
    "2026-11-26",
    "12:30:01.5",
];

/// Tables.
pub fn tables() -> Vec<Vec<u8>> {
    let mut all = bytes(&[
        "t (s),angle (deg)\n0,60\n0.1,55\n0.2,38\n0.3,12\n",
        "amplitude (deg),period (s),u\n10,2.01,0.01\n30,2.04,0.01\n50,2.1,0.01\n70,2.21,0.02\n",
        "length (m),run A,run B,run C\n0.2,0.90,0.91,0.89\n0.4,1.27,1.26,1.28\n",
        "10cm,0.68s\n20cm,0.92s\n",
        "t;x\n0,0;1,5\n0,1;1,4\n",
        "t\tangle 1 (rad)\n0\t0.5\n1\t0.4\n",
        "L T^2\n0.1 0.4\n0.2 0.8\n",
        "",
        "\u{feff}t,x\n0,1\n",
        "time,x\n0,1\n\n0,2\n",
    ]);
    for file in [
        &include_bytes!("../../examples/period_table_synthetic.csv")[..],
        include_bytes!("../../examples/lengths_synthetic.csv"),
        include_bytes!("../../examples/gate_synthetic.csv"),
        include_bytes!("../../examples/light_synthetic.csv"),
    ] {
        all.push(file[..file.len().min(3000)].to_vec());
    }
    // Columns of zeros, each of which was compared with all others.
    all.push(format!("10cm{},0.68s\n", ",0".repeat(1500)).into_bytes());
    all
}

/// Complete workbooks and archives.
pub fn archives() -> Vec<Vec<u8>> {
    let sheet = br#"<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData><row r="1"><c r="A1" t="inlineStr"><is><t>Time (s)</t></is></c><c r="B1" t="inlineStr"><is><t>Angle (rad)</t></is></c></row><row r="2"><c r="A2"><v>0</v></c><c r="B2"><v>0.5</v></c></row></sheetData></worksheet>"#;
    vec![
        workbook(sheet, |name, bytes| Packed::stored(name, bytes)),
        workbook(sheet, |name, bytes| Packed::deflated(name, bytes)),
        archive(&[Packed::stored("a/swing.csv", b"t (s),angle (deg)\n0,60\n0.1,55\n0.2,38\n")]),
        include_bytes!("../../crates/libration-lab/tests/data/workbook.xls").to_vec(),
        b"PK\x05\x06".to_vec(),
        vec![],
    ]
}

/// A workbook with this worksheet.
pub fn workbook(sheet: &[u8], packed: fn(&str, &[u8]) -> Packed) -> Vec<u8> {
    let book = br#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="Raw Data" sheetId="1" r:id="rId1"/></sheets></workbook>"#;
    let office = br#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#;
    let relations = br#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>"#;
    archive(&[
        packed("_rels/.rels", office),
        packed("xl/workbook.xml", book),
        packed("xl/_rels/workbook.xml.rels", relations),
        packed("xl/worksheets/sheet1.xml", sheet),
    ])
}

/// Tokens of files that runs continue from.
pub const RESUME: &[&str] = &[
    "null",
    "true",
    "{",
    "}",
    "[",
    "]",
    ":",
    ",",
    "\"",
    "1e400",
    "-1",
    "0",
    "1e308",
    "\"time_s\"",
    "\"state\"",
    "\"schema\":1",
    "\"known\"",
    "\"steps\"",
    "\"question\"",
    "\"resume\"",
    "NaN",
    "[[[[[[[[",
    "\\u0000",
    "18446744073709551616",
];

/// Files of interrupted runs.
pub fn resumes() -> Vec<Vec<u8>> {
    let mut all = bytes(&[
        "{}",
        "{\"schema\":2,\"resume\":{}}",
        "{\"schema\":1,\"samples\":[{\"time\":0.0,\"state\":[1.0,0.0]}]}",
        "[]",
        "",
    ]);
    all.push(include_bytes!("../run.json").to_vec());
    all
}
