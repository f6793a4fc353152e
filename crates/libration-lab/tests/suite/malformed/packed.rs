//! Workbooks and archives, made here and damaged.

use super::{Case, Expected};
use libration_testing::zip_archive::{self, Packed};

/// Written by the `xlwt` library from the header `Time (s)`, `Angle (rad)` and the rows of [`truth`], with a second
/// sheet of words.
const XLS: &[u8] = include_bytes!("../../data/workbook.xls");

pub(crate) fn truth() -> Vec<(f64, f64)> {
    let row = |n: u8| (f64::from(n) / 8.0, 0.5 - f64::from(n) / 16.0);
    (0..12).map(row).collect()
}

pub(crate) fn cases() -> Vec<Case> {
    [whole(), cut(), flipped(), archives(), workbooks()].into_iter().flatten().collect()
}

/// An archive of these files.
fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let files: Vec<Packed> = files.iter().map(|(name, bytes)| Packed::deflated(name, bytes)).collect();
    zip_archive::archive(&files)
}

pub(crate) fn csv() -> String {
    let rows = truth().into_iter().map(|(time, angle)| format!("{time},{angle}\n"));
    format!("\"Time (s)\",\"Angle (rad)\"\n{}", rows.collect::<String>())
}

const SPACE: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const RELATIONS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

/// A workbook whose one worksheet has these rows of cells as XML, with these parts next to it.
fn workbook_with(rows: &str, parts: &[(&str, &[u8])]) -> Vec<u8> {
    let types = "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
                 <Default Extension=\"xml\" ContentType=\"application/xml\"/></Types>";
    let book = format!(
        "<workbook xmlns=\"{SPACE}\" xmlns:r=\"{OFFICE}\"><sheets><sheet name=\"Raw Data\" sheetId=\"1\" r:id=\"rId1\"/></sheets></workbook>"
    );
    let office = format!(
        "<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"rId1\" Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
    );
    let relations = format!(
        "<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"rId1\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet1.xml\"/></Relationships>"
    );
    let sheet = format!("<worksheet xmlns=\"{SPACE}\"><sheetData>{rows}</sheetData></worksheet>");
    let required: [(&str, &[u8]); 5] = [
        ("[Content_Types].xml", types.as_bytes()),
        ("_rels/.rels", office.as_bytes()),
        ("xl/workbook.xml", book.as_bytes()),
        ("xl/_rels/workbook.xml.rels", relations.as_bytes()),
        ("xl/worksheets/sheet1.xml", sheet.as_bytes()),
    ];
    archive(&[&required, parts].concat())
}

/// A workbook with two styles: numbers, and times of day.
fn workbook(rows: &str) -> Vec<u8> {
    let styles = format!(
        "<styleSheet xmlns=\"{SPACE}\"><cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"21\"/></cellXfs></styleSheet>"
    );
    workbook_with(rows, &[("xl/styles.xml", styles.as_bytes())])
}

/// The rows of the truth as XML, each cell as `cell` writes it from its address and number.
fn rows(cell: impl Fn(&str, f64) -> String) -> String {
    let header = "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>Time (s)</t></is></c>\
                  <c r=\"B1\" t=\"inlineStr\"><is><t>Angle (rad)</t></is></c></row>";
    let row = |(index, (time, angle)): (usize, (f64, f64))| {
        let line = index + 2;
        format!(
            "<row r=\"{line}\">{}{}</row>",
            cell(&format!("A{line}"), time),
            cell(&format!("B{line}"), angle)
        )
    };
    header.to_owned() + &truth().into_iter().enumerate().map(row).collect::<String>()
}

fn number(address: &str, number: f64) -> String {
    format!("<c r=\"{address}\"><v>{number}</v></c>")
}

/// One container of each kind, undamaged.
fn kinds() -> [(&'static str, Vec<u8>); 3] {
    let archive = archive(&[
        ("Raw Data.csv", csv().as_bytes()),
        ("meta/device.csv", b"\"property\",\"value\"\n\"deviceModel\",\"7\"\n"),
    ]);
    [("archive", archive), ("xlsx", workbook(&rows(number))), ("xls", XLS.to_vec())]
}

fn whole() -> Vec<Case> {
    kinds().map(|(kind, bytes)| Case::read(format!("{kind}, whole"), bytes, truth())).into()
}

/// Files cut off at forty positions each.
fn cut() -> Vec<Case> {
    let cut = |(kind, bytes): (&str, Vec<u8>)| {
        let piece = move |part: usize| {
            let length = 8 + (bytes.len() - 9) * part / 40;
            Case::refused(format!("{kind}, the first {length} bytes"), &bytes[..length], &[])
        };
        (0..40).map(piece).collect::<Vec<_>>()
    };
    kinds().into_iter().flat_map(cut).collect()
}

/// One byte changed: checksums find it, or it does not matter.
fn flipped() -> Vec<Case> {
    let flip = |(kind, bytes): (&str, Vec<u8>)| {
        let one = move |part: usize| {
            let (at, mut bytes) = (bytes.len() * part / 80, bytes.clone());
            bytes[at] ^= 0x15;
            Case { name: format!("{kind}, byte {at}"), bytes, expected: Expected::ReadOrRefused(truth()) }
        };
        (0..80).map(one).collect::<Vec<_>>()
    };
    let with_checksums = kinds().into_iter().take(2);
    with_checksums.flat_map(flip).collect()
}

fn archives() -> Vec<Case> {
    let (table, bomb) = (csv(), vec![b'0'; 1 << 21]);
    vec![
        Case::refused(
            "two tables",
            archive(&[("a.csv", table.as_bytes()), ("b.csv", table.as_bytes())]),
            &["sheet=a or b"],
        ),
        Case::refused("nothing in it", archive(&[]), &[]),
        Case::refused(
            "pictures only",
            archive(&[("a.png", b"\x89PNG")]),
            &["without a workbook or text file"],
        ),
        Case::refused("OpenDocument", archive(&[("content.xml", b"<office/>")]), &["OpenDocument"]),
        Case::refused("more than it seems", archive(&[("a.csv", &bomb)]), &["limit"]),
        Case::refused("a binary table", archive(&[("a.csv", b"1,2\n\0\n")]), &["NUL"]),
    ]
}

fn workbooks() -> Vec<Case> {
    let times_as_dates = |address: &str, value: f64| match address.starts_with('A') {
        true => format!("<c r=\"{address}\" s=\"1\"><v>{value}</v></c>"),
        false => number(address, value),
    };
    let far = rows(number) + "<row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row>";
    let beyond = rows(number) + "<row r=\"20\"><c r=\"XFE20\"><v>1</v></c></row>";
    let words =
        |address: &str, value: f64| format!("<c r=\"{address}\" t=\"inlineStr\"><is><t>{value}</t></is></c>");
    let broken = |address: &str, value: f64| match address {
        "B5" => "<c r=\"B5\" t=\"e\"><v>#DIV/0!</v></c>".to_owned(),
        _ => number(address, value),
    };
    let book = b"<workbook/>".as_slice();
    vec![
        Case::refused("times as times of day", workbook(&rows(times_as_dates)), &["line 2", "date"]),
        Case::refused("a cell far away", workbook(&far), &["limit"]),
        Case::refused("a cell beyond any worksheet", workbook(&beyond), &["XFE20"]),
        Case::read("an error in a cell", workbook(&rows(broken)), [&truth()[..3], &truth()[4..]].concat()),
        Case::read("numbers as words", workbook(&rows(words)), truth()),
        Case::refused("no sheets", workbook(""), &["no rows"]),
        Case::refused("not a workbook within", archive(&[("xl/workbook.xml", b"<<<")]), &["workbook"]),
        Case::refused("a workbook of nothing", archive(&[("xl/workbook.xml", book)]), &[]),
        Case::refused(
            "cut off within",
            workbook(&(rows(number) + "<row>").replace("</row>", "")),
            &["workbook"],
        ),
    ]
    .into_iter()
    .chain(other_writers())
    .collect()
}

/// Workbooks as other programs write them: strings in the cells, prefixes, cells without addresses, formulas.
fn other_writers() -> Vec<Case> {
    // The count is wrong, and a string is in two letterings, with an entity and how to pronounce it.
    let strings = "<sst uniqueCount=\"99999999999999\"><si><r><t>Angle (</t></r><rPh sb=\"0\" eb=\"1\"><t>m</t></rPh>\
                   <r><t xml:space=\"preserve\">&#114;ad)</t></r></si><si><t>Time_x0020_(s)</t></si></sst>";
    let plain = rows(number);
    let data = &plain[plain.find("<row r=\"2\"").unwrap()..];
    let with_strings = |time: usize| {
        let cell = |column, string| format!("<c r=\"{column}1\" t=\"s\"><v>{string}</v></c>");
        let header = format!("<row r=\"1\">{}{}</row>", cell("A", time), cell("B", 0));
        workbook_with(&(header + data), &[("xl/sharedStrings.xml", strings.as_bytes())])
    };
    let cut_strings = workbook_with(&plain, &[("xl/sharedStrings.xml", b"<sst><si><t>Time</t></si>")]);
    let formula = |address: &str, value: f64| format!("<c r=\"{address}\"><f>2*7</f><v>{value:e}</v></c>");
    let prefixed = rows(formula).replace('<', "<x:").replace("<x:/", "</x:");
    let nowhere = (1..=13).fold(plain.clone(), |rows, line| {
        rows.replace(&format!(" r=\"A{line}\""), "").replace(&format!(" r=\"B{line}\""), "")
    });
    vec![
        Case::read("strings beside the cells", with_strings(1), truth()),
        Case::refused("a string that is not there", with_strings(2), &["string 2"]),
        Case::read("names with prefixes", workbook(&prefixed), truth()),
        Case::read("cells that do not say where they are", workbook(&nowhere), truth()),
        Case::read("nor a row", workbook(&nowhere.replace("<row r=\"9\">", "<row>")), truth()),
        Case::refused("an unknown entity", workbook(&plain.replacen("Time", "&time;", 1)), &["&time;"]),
        Case::refused("a string that is cut off", cut_strings, &["sharedStrings.xml is cut off"]),
        Case::refused("a format of hours", with_formats([0, 164]), &["date"]),
        Case::read("hours in styles that no cell has", with_formats([0, 0]), truth()),
    ]
}

/// Angles in the first of two styles of cells and times in the second, which have these formats; 164 shows hours.
fn with_formats([first, second]: [u8; 2]) -> Vec<u8> {
    let styles = format!(
        "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"[h]:mm\"/></numFmts>\
         <cellStyleXfs><xf numFmtId=\"164\"/></cellStyleXfs>\
         <cellXfs><xf numFmtId=\"{first}\"/><xf numFmtId=\"{second}\"/></cellXfs></styleSheet>"
    );
    let cell = |address: &str, value: f64| {
        let style = u8::from(address.starts_with('A'));
        format!("<c r=\"{address}\" s=\"{style}\"><v>{value}</v></c>")
    };
    workbook_with(&rows(cell), &[("xl/styles.xml", styles.as_bytes())])
}
