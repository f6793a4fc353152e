//! `libration paper`.

use crate::command::{json, libration, message, text};

#[test]
fn every_equation_of_both_documents_has_a_row() {
    let answer = json("paper");
    let rows = answer["equations"].as_array().unwrap();
    let with_label = |document: &str, label: &str| {
        rows.iter().filter(|row| row["document"] == document && row["label"] == label).count()
    };
    let appendices = [
        "(A1)", "(A2)", "(A3)", "(B1)", "(B2)", "(B3)", "(B4)", "(C1)", "(C2)", "(C3)", "(C4)", "(C5)",
        "Fig. 1",
    ];
    let numbers = (1..=54).map(|n| format!("({n})")).chain(appendices.map(str::to_owned));
    for label in numbers {
        assert_eq!(with_label("black-vel", &label), 1, "{label}");
    }
    for n in 1..=37 {
        assert_eq!(with_label("cote", &format!("({n})")), 1, "({n})");
    }
    for row in rows {
        for field in ["claim", "verdict", "correct", "evidence"] {
            assert!(row[field].is_string(), "{field} of {}", row["label"]);
        }
        let verdict = row["verdict"].as_str().unwrap();
        assert!(
            ["verified", "typo", "wrong", "not decided"].iter().any(|word| verdict.starts_with(word)),
            "{verdict}"
        );
    }
}

#[test]
fn a_wrong_equation_comes_with_its_correction() {
    let answer = json("paper --label 25 --document black-vel");
    let rows = answer["equations"].as_array().unwrap();
    assert_eq!(rows.len(), 1);
    assert_eq!(rows[0]["verdict"], "wrong");
    assert_eq!(rows[0]["correct"], "Delta^2 = 1 - a1^2/8 - a1*a3/8 - a3^2/4");
}

#[test]
fn claims_come_with_the_amplitudes_on_which_they_hold() {
    let answer = json("paper --label accurate");
    let claims = answer["equations"].as_array().unwrap();
    let range = |row: &serde_json::Value| row["holds_for_rad"][0][1].as_f64().unwrap().to_degrees();
    assert!((range(&claims[0]) - 129.4408075767761).abs() < 1e-11, "{}", claims[0]["label"]);
}

#[test]
fn the_rows_can_be_chosen_by_verdict() {
    let verdicts = |only: &str| {
        let answer = json(&format!("paper --only {only}"));
        answer["equations"].as_array().unwrap().len()
    };
    let all = json("paper")["equations"].as_array().unwrap().len();
    assert_eq!(verdicts("verified") + verdicts("typo") + verdicts("wrong"), all);
    assert!(text("paper --only typo").contains("r = cos(theta0/2)"));
}

#[test]
fn names_may_be_written_with_underscores() {
    assert_eq!(
        json("paper --document black_vel --only wrong"),
        json("paper --document black-vel --only wrong")
    );
}

#[test]
fn the_page_and_the_csv_say_the_same() {
    let page = text("paper --label B4");
    let table = text("paper --label B4 --csv");
    assert!(page.contains("(B4)  WRONG for n = 1") && table.contains("wrong for n = 1"), "{page}{table}");
    assert_eq!(table.lines().count(), 2);
    assert!(page.lines().all(|line| line.chars().count() <= 110), "{page}");
}

#[test]
fn what_the_document_says_in_words_is_called_a_paraphrase() {
    let answer = json("paper --label accurate");
    let rows = answer["equations"].as_array().unwrap();
    assert!(rows.iter().all(|row| row["paraphrase"] == true), "{rows:?}");
    assert!(text("paper --label accurate").contains("    paraphrase ratio = 10\n"));
    let answer = json("paper --label 53");
    let equation = &answer["equations"][0];
    assert_eq!((&equation["label"], &equation["paraphrase"]), (&"(53)".into(), &false.into()));
    assert!(equation["claim"].as_str().unwrap().contains("in the copy of the text that was read"));
    assert!(equation["read_from"].as_str().unwrap().starts_with("a copy of its text"));
    assert!(text("paper --label 53").contains("    printed T = "));
}

#[test]
fn what_is_not_there_is_refused() {
    let unknown = libration("paper --only maybe");
    assert_eq!(unknown.status.code(), Some(2));
    assert!(message(&unknown).contains("verified, typo, wrong or not-decided"));
    let undecided = libration("paper --only not-decided");
    assert_eq!(undecided.status.code(), Some(1), "{}", message(&undecided));
    let missing = libration("paper --label 99");
    assert_eq!(missing.status.code(), Some(1));
}
