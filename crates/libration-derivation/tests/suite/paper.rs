//! The verdicts follow from the printed formulas.

use libration::progress::Quiet;
use libration_derivation::internals::paper::{
    Expansion, NOT_EVALUATED, PrintedStatement as Statement, statements,
};
use libration_derivation::paper::{Document, Row, StatementVerdict, rows, rows_where};
use std::collections::BTreeSet;

fn statement(document: Document, label: &str) -> Statement {
    let of_document = statements().into_iter().filter(|(source, _)| *source == document);
    let statement =
        of_document.map(|(_, statement)| statement).find(|statement| statement.label.starts_with(label));
    statement.unwrap_or_else(|| panic!("{label} is missing"))
}

fn row(document: Document, label: &str) -> Row {
    statement(document, label).row(document)
}

#[test]
fn every_statement_can_be_checked() {
    for row in rows() {
        assert_ne!(row.finding.verdict, StatementVerdict::NotDecided, "{}", row.label);
    }
}

/// Formulas that these checks cannot evaluate: with unknown symbols, without a value, or not parsable.
#[test]
fn what_cannot_be_evaluated_is_not_decided() {
    let cases: [(Document, &str, &[&str]); 6] = [
        (Document::BlackVel, "(25)", &["Delta^2 = 1 - unknown(a1)"]),
        (Document::BlackVel, "(12)", &["theta' = sqrt(-1)*omega0"]),
        (Document::BlackVel, "(54)", &["theta'' + c*ln(theta')^n + omega0^2*sin(theta) = 0"]),
        (Document::Cote, "(7)", &["theta' = sqrt(2*g/l)*sqrt(-2)"]),
        (Document::Cote, "(37)", &["T = T0*(1 + x)"]),
        (Document::Cote, "(34)", &[]),
    ];
    for (document, label, printed) in cases {
        let finding = statement(document, label).finding(printed);
        assert_eq!(finding.verdict, StatementVerdict::NotDecided, "{label}: {}", finding.evidence);
        assert_eq!((finding.evidence.as_str(), finding.summary().as_str()), (NOT_EVALUATED, "not decided"));
    }
}

#[test]
fn only_what_is_chosen_is_checked() {
    let chosen = rows_where(|document, label| document == Document::Cote && label.starts_with("(3"));
    assert_eq!(chosen.iter().map(|row| row.label.as_str()).collect::<Vec<_>>()[..2], ["(3)", "(30)"]);
    assert_eq!(chosen.len(), 9);
    assert!(rows_where(|_, _| false).is_empty());
}

/// Statements about numbers for which the documents have words and no formula.
#[test]
fn formulas_of_ours_are_not_called_printed() {
    for row in rows().into_iter().filter(|row| row.paraphrase) {
        assert!(row.label.starts_with("text: ") && !row.printed.is_empty(), "{}", row.label);
    }
    let printed = |document, label| !row(document, label).paraphrase;
    for label in ["text: the even harmonics", "text: there is a gauge", "text: c2(0)", "text: (13) is"] {
        assert!(printed(Document::BlackVel, label), "{label}");
    }
    for label in ["text: 5!!", "text: u = sin(psi)", "text: at small angles", "text: the result"] {
        assert!(printed(Document::Cote, label), "{label}");
    }
    let paraphrases = rows().into_iter().filter(|row| row.paraphrase).count();
    assert_eq!(paraphrases, 25);
}

#[test]
fn every_numbered_equation_has_a_row_of_its_own() {
    let rows = rows();
    let numbered = |from: u32, to: u32, letter: &str| {
        (from..=to).map(move |n| format!("({letter}{n})")).collect::<Vec<_>>()
    };
    let black_vel = [
        numbered(1, 54, ""),
        numbered(1, 3, "A"),
        numbered(1, 4, "B"),
        numbered(1, 5, "C"),
        vec!["Fig. 1".to_owned()],
    ];
    for (document, labels) in
        [(Document::BlackVel, black_vel.concat()), (Document::Cote, numbered(1, 37, ""))]
    {
        for label in labels {
            let count = rows.iter().filter(|row| row.document == document && row.label == label).count();
            assert_eq!(count, 1, "{} {label}", document.key());
        }
    }
    let labels: BTreeSet<_> = rows.iter().map(|row| (row.document.key(), &row.label)).collect();
    assert_eq!(labels.len(), rows.len(), "no label twice");
}

#[test]
fn the_equations_that_are_not_verified_are_these() {
    let labels = |document: Document, verdict: StatementVerdict| {
        let rows =
            rows().into_iter().filter(move |row| row.document == document && row.finding.verdict == verdict);
        rows.map(|row| row.label).filter(|label| label.starts_with('(')).collect::<Vec<_>>()
    };
    assert_eq!(labels(Document::BlackVel, StatementVerdict::Wrong), ["(25)", "(27)", "(54)", "(B4)"]);
    assert_eq!(labels(Document::BlackVel, StatementVerdict::Typo), ["(53)", "(C1)"]);
    assert_eq!(labels(Document::Cote, StatementVerdict::Wrong), ["(24)", "(25)", "(35)"]);
    assert_eq!(labels(Document::Cote, StatementVerdict::Typo), ["(22)", "(34)"]);
}

/// Statements with the printed error corrected, which changes the verdict.
const MENDED: [(Document, &str, &[&str]); 13] = [
    (Document::BlackVel, "text: the Fourier integrals", &["1/pi"]),
    (Document::BlackVel, "text: a1 is not much greater", &["a1 = 4"]),
    (Document::Cote, "text: the pendulum has two", &["freedom = 1"]),
    (Document::BlackVel, "(25)", &["Delta^2 = 1 - (a1^2 + a1*a3 + 2*a3^2)/8"]),
    (Document::BlackVel, "(27)", &["a3 = (-a1^3 + 21*a1^2*a3 - 27/32*a1^4*a3 - 3*a3^3)/192"]),
    (Document::BlackVel, "(53)", &["T = 64*T0/(16*(1 + sqrt(r))^2 - (1 - sqrt(r))^4)", "r = cos(theta0/2)"]),
    (Document::BlackVel, "(54)", &["theta'' + c*theta'*abs(theta')^(n - 1) + omega0^2*sin(theta) = 0"]),
    (Document::BlackVel, "text: the even harmonics", &["theta = 0"]),
    (
        Document::BlackVel,
        "text: the freedom",
        &["free = 3", "theta'' + omega0^2*(theta - theta^3/6 + theta^5/120)"],
    ),
    (Document::Cote, "(22)", &["1/sqrt(1 - m*sin(psi)^2)", "m = 9/10"]),
    (Document::Cote, "(24)", &["n = 0", "odd/even*m^n*s^(2*n)"]),
    (Document::Cote, "(34)", &["I = odd/even*pi/2"]),
    (Document::Cote, "(35)", &["n = 0", "pi/2*(odd/even)^2*m^n"]),
];

#[test]
fn mended_statements_are_verified() {
    for (document, label, printed) in MENDED {
        let statement = statement(document, label);
        assert_ne!(
            statement.finding(statement.printed).verdict,
            StatementVerdict::Verified,
            "{label} as it is"
        );
        let finding = statement.finding(printed);
        assert_eq!(finding.verdict, StatementVerdict::Verified, "{label} mended: {}", finding.evidence);
    }
}

#[test]
fn the_corrections_come_out_of_the_computation() {
    let correct = |label: &str| row(Document::BlackVel, label).finding.correct;
    assert_eq!(correct("(25)"), "Delta^2 = 1 - a1^2/8 - a1*a3/8 - a3^2/4");
    assert_eq!(correct("(27)"), "a3 = (-a1^3 + 21*a1^2*a3 - 3*a3^3 - 27*a1^4*a3/32)/192");
    assert!(row(Document::BlackVel, "(27)").finding.evidence.contains("the 1/16 was lost"));
    assert_eq!(correct("(53)"), "r = cos(theta0/2)");
}

/// Limits in degrees, computed by mpmath with 50 digits.
const LIMITS: [(&str, f64); 7] = [
    ("text: a3 is much smaller", 132.645495643899385),
    ("text: a1*a3", 166.029730504519802),
    ("text: the 3-term", 129.440807576776102),
    ("text: the 1-term", 129.440807576776102),
    ("text: (53)", 63.8418417019207508),
    ("text: for a measurement", 77.7855077753874626),
    ("text: (7)", 172.438827552837791),
];

#[test]
fn the_claims_hold_where_an_independent_computation_says() {
    for (label, degrees) in LIMITS {
        let ranges = row(Document::BlackVel, label).finding.holds_for;
        let ends = ranges.iter().flat_map(|range| [range.0, range.1]);
        let nearest = ends.map(|end| (end.to_degrees() - degrees).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-11, "{label}: {ranges:?}");
    }
}

/// The perturbation engine of the library is a second method for the constants of appendix C.
#[test]
fn the_orders_agree_with_the_perturbation_engine() {
    use libration::algebra::Rational;
    use libration::perturbation::{EpsilonPowers, OpenGauge};
    let sine = ["1", "0", "-1/6", "0", "1/120", "0", "-1/5040"].map(|text| text.parse().unwrap());
    let engine = OpenGauge::new(&sine, 7, EpsilonPowers::OneParity, &Quiet).unwrap();
    let ours = Expansion::odd_gauge(7).unwrap();
    for (name, polynomial) in engine.solution() {
        assert_eq!(ours.named(&name.to_string()).as_ref(), Some(polynomial), "{name}");
    }
    let named = |name: &str| ours.named(name).unwrap();
    assert_eq!(named("D7").value(|_| Some(Rational::from(1))).unwrap().to_string(), "-1/1835008");
}

/// Changes that leave a true statement, with the reasons.
const STILL_TRUE: [(&str, &str, &str); 24] = [
    ("(2)", "theta = theta0*cos(sqrt(g/l)*t - phi)", "any phase will do"),
    ("(2)", "theta = theta0*sin(sqrt(g/l)*t + phi)", "any phase will do"),
    ("text: (6)", "theta0 = pi/(3)", "weaker"),
    ("text: (7)", "error = (2)/1000", "another tolerance"),
    ("text: (7)", "error = 1/(1001)", "another tolerance"),
    ("text: (7)", "error = 1/(999)", "another tolerance"),
    ("(35)", "a5 = epsilon*C1 - epsilon^3*C3 + epsilon^5*C5", "C3 = 0"),
    ("(46)", "A5 = (1)", "A5 enters at the seventh order"),
    ("(46)", "A5 = (-1)", "A5 enters at the seventh order"),
    ("text: the 3-term", "theta0 = pi/(3)", "weaker"),
    ("text: the error of the 1-term", "theta0 = pi/(3)", "weaker"),
    ("text: (implicit) the 1/T form", "corrections = (2)", "true of two corrections as well"),
    ("text: the approximations are", "theta0 = pi/(3)", "true there as well"),
    ("text: the approximations are", "theta0 = pi/(1)", "true there as well"),
    ("text: (52)", "ratio = (11)", "about"),
    ("text: (52)", "ratio = (9)", "about"),
    ("(A2)", "Omega = omega0*(1 - epsilon*d1 + epsilon^2*d2)", "d1 = 0"),
    ("(21)", "1/sqrt(1 - sin(theta0/2)^2*cos(psi)^2)", "the same from the other end"),
    ("text: 5!!", "5*3/1", "the same number"),
    ("(30)", "(2*n - 1)*(cos(psi)^(2*(n - 1)) - sin(psi)^(2*n))", "the same integrals"),
    ("(30)", "(2*n - 1)*(sin(psi)^(2*(n - 1)) - cos(psi)^(2*n))", "the same integrals"),
    ("text: the larger", "error = (2)/1000000", "another tolerance"),
    ("text: the larger", "error = 1/(1000001)", "another tolerance"),
    ("text: the larger", "error = 1/(999999)", "another tolerance"),
];

#[test]
fn no_number_or_sign_of_a_verified_statement_can_be_changed() {
    let mut count = 0;
    for (document, statement) in statements() {
        if statement.finding(statement.printed).verdict != StatementVerdict::Verified {
            continue;
        }
        for (changed, texts) in changes(statement.printed) {
            let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
            let survives = statement.finding(&texts).verdict == StatementVerdict::Verified;
            let true_still = STILL_TRUE
                .iter()
                .any(|(label, text, _)| statement.label.starts_with(label) && *text == changed);
            assert_eq!(survives, true_still, "{} {}: `{changed}`", document.key(), statement.label);
            count += 1;
        }
    }
    assert!(count > 900, "{count}");
}

/// Variants of the texts, with one number increased or decreased by one, or
/// one sign, sine or cosine exchanged: the change, and all texts with it.
fn changes(printed: &[&str]) -> Vec<(String, Vec<String>)> {
    let mut all = Vec::new();
    for (index, text) in printed.iter().enumerate() {
        for changed in with_another_number(text).into_iter().chain(with_another_sign(text)) {
            let mut texts: Vec<String> = printed.iter().map(|&text| text.to_owned()).collect();
            texts[index].clone_from(&changed);
            all.push((changed, texts));
        }
    }
    all
}

fn with_another_number(text: &str) -> Vec<String> {
    let with = |(from, to): (usize, usize), value: i64| format!("{}({value}){}", &text[..from], &text[to..]);
    let both = |range: (usize, usize)| {
        let value: i64 = text[range.0..range.1].parse().unwrap();
        [with(range, value + 1), with(range, value - 1)]
    };
    numbers_in(text).into_iter().flat_map(both).collect()
}

/// The byte ranges of the numbers that are not part of a name.
fn numbers_in(text: &str) -> Vec<(usize, usize)> {
    let (mut numbers, mut start, mut before) = (Vec::new(), None, ' ');
    for (index, letter) in text.char_indices().chain([(text.len(), ' ')]) {
        if letter.is_ascii_digit() && !before.is_ascii_alphanumeric() {
            start = Some(index);
        }
        if let Some(from) = start.filter(|_| !letter.is_ascii_digit()) {
            numbers.push((from, index));
            start = None;
        }
        before = letter;
    }
    numbers
}

fn with_another_sign(text: &str) -> Vec<String> {
    const EXCHANGED: [(&str, &str); 5] =
        [(" + ", " - "), (" - ", " + "), ("sin(", "cos("), ("cos(", "sin("), ("*", "/")];
    let exchange = |(from, to): (&'static str, &'static str)| {
        let places = text.match_indices(from).map(|(start, _)| start);
        places.map(move |start| format!("{}{to}{}", &text[..start], &text[start + from.len()..]))
    };
    EXCHANGED.into_iter().flat_map(exchange).collect()
}
