//! The verdicts follow from what is printed.

use super::*;
use statement::NOT_EVALUATED;

fn statement(document: Document, label: &str) -> Statement {
    let found =
        statements().into_iter().find(|statement| statement.document == document && statement.label == label);
    found.unwrap_or_else(|| panic!("{label} is missing"))
}

/// The texts with one of their numbers, which are not part of a name, made larger by one; all such texts.
fn with_another_number(printed: &[&str]) -> Vec<Vec<String>> {
    let mut changed = Vec::new();
    for (index, text) in printed.iter().enumerate() {
        for (from, to) in numbers_in(text) {
            let value: i64 = text[from..to].parse().unwrap();
            let mut texts: Vec<String> = printed.iter().map(|&text| text.to_owned()).collect();
            texts[index] = format!("{}{}{}", &text[..from], value + 1, &text[to..]);
            changed.push(texts);
        }
    }
    changed
}

fn numbers_in(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut start = None;
    let mut before = ' ';
    for (place, letter) in text.char_indices().chain([(text.len(), ' ')]) {
        if letter.is_ascii_digit() && !before.is_ascii_alphanumeric() {
            start = Some(place);
        }
        if let Some(from) = start.filter(|_| !letter.is_ascii_digit()) {
            found.push((from, place));
            start = None;
        }
        before = letter;
    }
    found
}

#[test]
fn every_statement_can_be_checked() {
    for row in rows() {
        assert_ne!(row.finding.evidence, NOT_EVALUATED, "{}", row.label);
    }
}

#[test]
fn no_number_of_a_verified_statement_can_be_changed() {
    let mut count = 0;
    for statement in statements() {
        if statement.finding(statement.printed).verdict != Verdict::Verified {
            continue;
        }
        for changed in with_another_number(statement.printed) {
            let texts: Vec<&str> = changed.iter().map(String::as_str).collect();
            let finding = statement.finding(&texts);
            if finding.verdict == Verdict::Verified {
                println!("SURVIVES {} {}: {texts:?}", statement.document.key(), statement.label);
            }
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
}
