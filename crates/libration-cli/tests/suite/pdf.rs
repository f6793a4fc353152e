//! Pictures as PDF: the same lines and words as in the SVG, the words as text, read back from the file.

use crate::command::{directory, libration, message, text};
use crate::drawing::{Drawing, Place};
use miniz_oxide::inflate::decompress_to_vec_zlib;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

const PICTURES: [&str; 4] = [
    "figure errors --near-top --output",
    "figure phase --curve-labels --output",
    "motion 150deg --compare small-angle,fourier-3 --figure",
    "section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --points 20 --skip 1 --figure",
];

/// The picture as SVG and the bytes of the PDF.
fn both(number: usize, question: &str) -> (Drawing, Vec<u8>) {
    let [svg, pdf] = ["svg", "pdf"].map(|ending| {
        let file = directory(&format!("pdf-{number}")).join(format!("picture.{ending}"));
        text(&format!("{question} {}", file.display()));
        fs::read(file).unwrap()
    });
    (Drawing::read(&String::from_utf8(svg).unwrap()), pdf)
}

/// The streams of a file, unpacked.
fn streams(pdf: &[u8]) -> Vec<Vec<u8>> {
    let (begin, end) = (b"\nstream\n", b"\nendstream");
    let find = |from: usize, what: &[u8]| {
        pdf[from..].windows(what.len()).position(|part| part == what).map(|at| from + at)
    };
    let mut streams = vec![];
    let mut at = 0;
    while let Some(start) = find(at, begin) {
        let start = start + begin.len();
        at = find(start, end).unwrap();
        streams.push(decompress_to_vec_zlib(&pdf[start..at]).unwrap());
    }
    streams
}

/// The characters by their glyphs, from the lines `<0001> <0041>` of the table of characters.
fn characters(table: &str) -> BTreeMap<u16, char> {
    let pairs = table.lines().filter_map(|line| line.strip_prefix('<')?.strip_suffix('>')?.split_once("> <"));
    let hexadecimal = |digits: &str| u16::from_str_radix(digits, 16).unwrap();
    pairs
        .filter(|(glyph, _)| *glyph != "0000")
        .map(|(glyph, letter)| (hexadecimal(glyph), char::from_u32(u32::from(hexadecimal(letter))).unwrap()))
        .collect()
}

/// The operations of the page, each with its operands; texts are operands of their own.
fn operations(content: &[u8]) -> Vec<(Vec<Vec<u8>>, String)> {
    let mut operations = vec![];
    let (mut operands, mut at) = (vec![], 0);
    while at < content.len() {
        match content[at] {
            b' ' | b'\n' | b'[' | b']' => at += 1,
            b'(' => {
                let (operand, end) = literal(content, at + 1);
                operands.push(operand);
                at = end;
            }
            b'<' => {
                let end = at + content[at..].iter().position(|byte| *byte == b'>').unwrap();
                let digits = std::str::from_utf8(&content[at + 1..end]).unwrap();
                let byte = |position: usize| u8::from_str_radix(&digits[position..position + 2], 16).unwrap();
                operands.push((0..digits.len()).step_by(2).map(byte).collect());
                at = end + 1;
            }
            _ => {
                let rest = &content[at..];
                let length = rest.iter().position(|byte| b" \n[]".contains(byte)).unwrap_or(rest.len());
                let word = rest[..length].to_vec();
                if word[0].is_ascii_alphabetic() {
                    operations.push((std::mem::take(&mut operands), String::from_utf8(word).unwrap()));
                } else {
                    operands.push(word);
                }
                at += length;
            }
        }
    }
    operations
}

/// A text in parentheses, with its escapes resolved, and the position after it.
fn literal(content: &[u8], mut at: usize) -> (Vec<u8>, usize) {
    let (mut bytes, mut depth) = (vec![], 1);
    loop {
        match content[at] {
            b'\\' => {
                at += 1;
                bytes.push(match content[at] {
                    b'n' => b'\n',
                    b'r' => b'\r',
                    b't' => b'\t',
                    b'b' => 8,
                    b'f' => 12,
                    b'0'..=b'7' => {
                        let digits = std::str::from_utf8(&content[at..at + 3]).unwrap();
                        at += 2;
                        u8::from_str_radix(digits, 8).unwrap()
                    }
                    other => other,
                });
            }
            b')' if depth == 1 => return (bytes, at + 1),
            byte => {
                depth += i32::from(byte == b'(') - i32::from(byte == b')');
                bytes.push(byte);
            }
        }
        at += 1;
    }
}

fn numbers(operands: &[Vec<u8>]) -> Vec<f64> {
    operands.iter().map(|operand| std::str::from_utf8(operand).unwrap().parse().unwrap()).collect()
}

/// Digits and signs in subscripts and superscripts, as they are drawn.
fn as_drawn(text: &str) -> String {
    libration_report::runs(text).into_iter().map(|run| run.letters).collect()
}

#[test]
fn a_pdf_has_the_lines_of_the_svg() {
    for (number, question) in PICTURES.into_iter().enumerate() {
        let (svg, pdf) = both(number, question);
        let content = &streams(&pdf)[2];
        let mut drawn: Vec<Place> = vec![];
        for (operands, operator) in operations(content) {
            if ["m", "l"].contains(&operator.as_str()) {
                let position = numbers(&operands);
                drawn.push((position[0], position[1]));
            }
        }
        drawn.dedup();
        let mut expected: Vec<Place> = svg.shapes.iter().flat_map(|shape| shape.points.clone()).collect();
        expected.dedup();
        assert_eq!(drawn.len(), expected.len(), "{question}");
        let apart = |(a, b): (&Place, &Place)| (a.0 - b.0).abs().max((a.1 - b.1).abs());
        let most = drawn.iter().zip(&expected).map(apart).fold(0.0, f64::max);
        // Both are rounded to hundredths; dots of an SVG are offsets from each other.
        assert!(most < 0.011, "{question}: {most}");
    }
}

#[test]
fn the_words_of_a_pdf_are_text_in_a_font_of_their_letters() {
    for (number, question) in PICTURES.into_iter().enumerate() {
        let (svg, pdf) = both(10 + number, question);
        let streams = streams(&pdf);
        let [table, font, content] = &streams[..] else { panic!("{}", streams.len()) };
        let letters = characters(std::str::from_utf8(table).unwrap());
        let (mut words, mut places) = (vec![], vec![]);
        for (operands, operator) in operations(content) {
            match operator.as_str() {
                "Tm" => {
                    words.push(String::new());
                    places.push(numbers(&operands));
                }
                "Tj" => {
                    let glyphs = operands[0].chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
                    words.last_mut().unwrap().extend(glyphs.map(|glyph| letters[&glyph]));
                }
                _ => {}
            }
        }
        let expected: Vec<String> = svg.texts.iter().map(|text| as_drawn(&text.content)).collect();
        assert_eq!(words, expected, "{question}");
        let used: BTreeSet<char> = expected.concat().chars().collect();
        assert_eq!(letters.values().copied().collect::<BTreeSet<char>>(), used, "{question}");
        // All letters of the command take 60 900 bytes.
        assert!(font.starts_with(&[0, 1, 0, 0]) && font.len() < 20_000, "{question}: {}", font.len());
        for (text, matrix) in svg.texts.iter().zip(places) {
            let [left, _, _, bottom] = text.extent();
            // A turned text begins at its lower end.
            let is_level = matrix[0] > 0.5;
            let apart = if is_level { matrix[4] - left } else { matrix[5] - bottom }.abs();
            assert!(apart < 0.02, "{question}: {text:?} at {matrix:?}");
        }
    }
}

#[test]
fn equal_pictures_are_equal_files_that_programs_can_read() {
    let (_, pdf) = both(20, PICTURES[0]);
    assert_eq!(pdf, both(21, PICTURES[0]).1);
    let text = String::from_utf8_lossy(&pdf);
    assert!(text.starts_with("%PDF-1."), "{}", &text[..20]);
    let start: usize = text.rsplit_once("startxref\n").unwrap().1.lines().next().unwrap().parse().unwrap();
    assert!(pdf[start..].starts_with(b"xref"));
    assert!(text.contains("/Title (Fractional error of formulas for the period)"), "{text}");
}

#[test]
fn what_moves_is_refused() {
    let file = directory("pdf-moving").join("swing.pdf");
    let output = libration(&format!("motion 60deg --animate --figure {}", file.display()));
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).contains("give a file name ending in .svg"), "{}", message(&output));
    assert!(!file.exists());
}
