//! `libration fields` describes every field of every result, and no other fields.

use crate::command::{directory, json, libration, message, refusal, text};
use crate::examples::{
    clone_of_the_project, commands, commands_in, examples, help, in_shell, root, shown_in,
};
use crate::widths;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// The fields in `libration fields` of one kind of result.
pub(crate) struct Kind {
    command: String,
    option: String,
    json: Vec<String>,
    csv: Vec<String>,
}

pub(crate) fn kinds() -> Vec<Kind> {
    let of_form = |entry: &Value, form: &str| -> Vec<String> {
        let fields = entry[form].as_array().unwrap();
        fields.iter().map(|field| field["name"].as_str().unwrap().to_owned()).collect()
    };
    let text = |entry: &Value, name: &str| entry[name].as_str().unwrap().to_owned();
    let kind = |entry: &Value| Kind {
        command: text(entry, "command"),
        option: text(entry, "option"),
        json: of_form(entry, "json"),
        csv: of_form(entry, "csv"),
    };
    json("fields")["commands"].as_array().unwrap().iter().map(kind).collect()
}

/// The kind of result of a query.
fn kind_of<'a>(kinds: &'a [Kind], words: &[String]) -> &'a Kind {
    let of_command = |kind: &&Kind| words.starts_with(&words_of(&kind.command));
    let asked = |kind: &&Kind| !kind.option.is_empty() && words.contains(&kind.option);
    let usual = |kind: &&Kind| kind.option.is_empty();
    let mut of_question = kinds.iter().filter(of_command);
    let kind = of_question.clone().find(asked).or_else(|| of_question.find(usual));
    kind.unwrap_or_else(|| panic!("nothing is said of the answers to {words:?}"))
}

fn words_of(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

/// The paths to all values of a result, including lists and objects.
fn paths(value: &Value) -> BTreeSet<String> {
    let mut paths = BTreeSet::new();
    collect(value, "", &mut paths);
    paths
}

fn collect(value: &Value, parent: &str, paths: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                let path = if parent.is_empty() { name.clone() } else { format!("{parent}.{name}") };
                paths.insert(path.clone());
                collect(value, &path, paths);
            }
        }
        Value::Array(items) => {
            let path = format!("{parent}[]");
            paths.insert(path.clone());
            items.iter().for_each(|item| collect(item, &path, paths));
        }
        _ => {}
    }
}

/// All strings of a result, which placeholders in field names may represent.
fn strings(value: &Value) -> BTreeSet<String> {
    match value {
        Value::Object(fields) => fields.values().flat_map(strings).collect(),
        Value::Array(items) => items.iter().flat_map(strings).collect(),
        Value::String(text) => BTreeSet::from([text.clone()]),
        _ => BTreeSet::new(),
    }
}

/// Returns `true` for a text that a placeholder in capitals may represent.
type Known<'a> = &'a dyn Fn(&str) -> bool;

/// Returns `true` if a name in a result matches a described name, whose capitals represent strings of the result or numbers.
fn is_name(name: &str, described: &str, words: &BTreeSet<String>) -> bool {
    let stands_for = |placeholder: &str, matches: Known<'_>| {
        let (before, after) = described.split_once(placeholder)?;
        let middle = name.strip_prefix(before)?.strip_suffix(after)?;
        Some(matches(middle))
    };
    let is_word = |text: &str| words.contains(text);
    let is_number = |text: &str| text.parse::<f64>().is_ok();
    let kinds: [(&str, Known<'_>); 4] =
        [("NAME", &is_word), ("KEY", &is_word), ("TOLERANCE", &is_number), ("K", &is_number)];
    let placeholder = kinds.iter().find(|(placeholder, _)| described.contains(placeholder));
    match placeholder {
        Some((placeholder, matches)) => stands_for(placeholder, matches).unwrap_or(false),
        None => name == described,
    }
}

/// Returns `true` if the path leads to a described field, or to a list or object of such fields.
fn leads_to(path: &str, described: &str, words: &BTreeSet<String>) -> bool {
    // The names of parameters are words of the query; the result chooses those of constants and symbols.
    let is_parameter =
        |before: &str| ["parameters", "constants", "letters", "small_orders"].contains(&before);
    let (path, described) = (steps(path), steps(described));
    if described == ["note"] {
        return path.last() == Some(&"note");
    }
    let mut pairs = path.iter().zip(&described).enumerate();
    path.len() <= described.len()
        && pairs.all(|(index, (name, described))| {
            let open = index > 0 && is_parameter(path[index - 1]) && *described == "NAME";
            open || is_name(name, described, words)
        })
}

/// `a.b[].c` as `a`, `b`, `[]`, `c`.
fn steps(path: &str) -> Vec<&str> {
    path.split('.')
        .flat_map(|part| {
            let lists = part.matches("[]").count();
            std::iter::once(&part[..part.len() - 2 * lists]).chain(std::iter::repeat_n("[]", lists))
        })
        .filter(|step| !step.is_empty())
        .collect()
}

/// Fields of results: described ones, and others.
#[derive(Default)]
struct Shown {
    described: BTreeSet<(String, String, &'static str, String)>,
    undescribed: BTreeSet<String>,
}

impl Shown {
    fn add(&mut self, kind: &Kind, form: &'static str, name: &str) {
        self.described.insert((kind.command.clone(), kind.option.clone(), form, name.to_owned()));
    }

    fn has(&self, kind: &Kind, form: &'static str, name: &str) -> bool {
        self.described.contains(&(kind.command.clone(), kind.option.clone(), form, name.to_owned()))
    }

    fn lacks(&mut self, kind: &Kind, name: &str) {
        let Kind { command, option, .. } = kind;
        self.undescribed.insert(format!("libration fields {command} {option}: {name}"));
    }

    /// Checks that every path in a JSON result is described.
    fn json(&mut self, kind: &Kind, answer: &Value) {
        let words = strings(answer);
        for path in paths(answer) {
            let described: Vec<&String> =
                kind.json.iter().filter(|field| leads_to(&path, field, &words)).collect();
            if described.is_empty() {
                self.lacks(kind, &path);
            }
            let is_whole =
                |string: &&String| string.as_str() == "note" || steps(string).len() == steps(&path).len();
            described.into_iter().filter(is_whole).for_each(|field| self.add(kind, "json", field));
        }
    }

    /// Checks that every name in the first line of CSV is described; capitals represent strings of the JSON result.
    fn csv(&mut self, kind: &Kind, table: &str, words: &BTreeSet<String>) {
        for name in table.lines().next().unwrap_or_default().split(',').map(|name| name.trim_matches('"')) {
            let described: Vec<&String> =
                kind.csv.iter().filter(|field| is_name(name, field, words)).collect();
            if described.is_empty() {
                self.lacks(kind, name);
            }
            described.into_iter().for_each(|field| self.add(kind, "csv", field));
        }
    }

    /// Adds the fields in the result of a command.
    fn question(&mut self, kinds: &[Kind], words: &[String]) {
        let kind = kind_of(kinds, words);
        let answer: Value = serde_json::from_str(&answer(words, "--json")).unwrap();
        self.json(kind, &answer);
        self.csv(kind, &self::answer(words, "--csv"), &strings(&answer));
    }
}

/// The result of a command, even of one that stopped early.
fn answer(words: &[String], form: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_libration"));
    let output = command.args(words).arg(form).current_dir(root()).output().unwrap();
    assert!(!output.stdout.is_empty(), "{words:?}: {}", message(&output));
    String::from_utf8(output.stdout).unwrap()
}

/// Asserts that every field of a result of the command is described.
pub(crate) fn assert_described(command: &str, answer: &Value) {
    let (kinds, mut shown) = (kinds(), Shown::default());
    shown.json(kind_of(&kinds, &words_of(command)), answer);
    assert_eq!(shown.undescribed, BTreeSet::new());
}

/// Queries whose results have rare fields; the results are compared with those of other tests.
const FURTHER: &[&str] = &[
    "formulas|molina",
    // Groups have results and a mean.
    "fit|lengths|examples/class/groups.csv",
    "fit|periods|examples/class/amplitudes.csv|--group|4",
    // A place has its normal gravity.
    "fit|trace|examples/swing_synthetic.csv|--to|6s|--model|linear|--length|0.56m|--latitude|48deg",
    // A limit cycle has its distance from the orbit.
    "expand|van_der_pol|--order|3|--evaluate|0.5",
    // A motion that never returns has no period.
    "motion|pi-1e-6|--velocity|0|--times|0,1",
    "motion|0|--velocity|7rad/s|--times|0,1",
    "motion|180deg|--times|0,1",
    "period|179deg",
    "period|60deg|--length|57cm",
    "period|--period|2.10(1)s",
    "fourier|0|--velocity|7rad/s",
    "formulas|--amplitude|90deg|--tolerance|1e-3",
    "decay|1|--quadratic|0.1|--omega0|1|--cycles|2",
    "decay|1|--quadratic|0.1|--omega0|1|--cycles|2|--order|3",
    // Expansions without a key, without a series, without orbits.
    "expand|x''=-x-x^2-x^3|--order|4",
    "expand|m*x''+sqrt(2)*k*x+b*x^3=0|--order|3",
    "expand|x''+x*x'+x=0|--order|3",
    "expand|x''+x+abs(x)^3=0|--order|3",
    "expand|pure_cubic",
    "expand|quadratic|--order|3|--evaluate|0.2",
    "expand|x''+c*(x'+x'*abs(x'))+2*x=0|--order|2|--damping-order|1",
    "expand|x''+x=k*((1-x^2)*x'-x^3)|--order|5|--damping-order|1",
    // A slow flow with symbols, and one with numbers.
    "resonance|x''+k*x+c*x+eps*x*y=0;y''+w2^2*y+eps*x^2=eps*F*cos(W*t)|--ratios|1:2|--resonance|2/1",
    "expand|x''+2*eps*mu*x'+k*x+eps*a*x^3=eps*F*cos(W*t)|--resonance|1/1",
    "expand|x''+eps*x'/5+x+eps*x^3=eps*cos(W*t)/2|--resonance|1/1|--set|eps=0.1|--evaluate|1.03",
    "expand|x''+eps*(x'/5+x^3)+x=eps*cos(W*t)|--resonance|1/1|--order|3|--set|eps=0.1|--evaluate|1.3",
    // A map with places that are not resolved: the damping jumps at a = 0.
    "stability|x''+0.1*sign(a)*x'+(0.8+m*cos(t))*x+x^3=0|--map|a=-1:2,m=0:0.3|--lines|0",
    "backbone|x''=-x-x^2|--amplitudes|0.1,0.2,3",
    "backbone|x''=-x-x^3|--amplitudes|1",
    "orbit|x''=(1-x^2)*x'-x|--initial|x=0.5",
    "response|x''=-0.5*x'-x-x^3+0.1*cos(w*t)|--over|w=2.5:4|--orders|1/3,1/2|--generations|0",
    "response|driven_pendulum|--set|A=0.15,c=0.1|--over|omega=0.9:1|--sweeps|2",
    "stability|driven_pendulum|--set|c=0.1|--map|omega=0.85:1,A=0.05:0.2|--lines|1",
    "modes|pendulum|--about|theta=180deg",
    "modes|x''=-x-0.1*x'",
    "modes|x''=-x;y''=-4*y",
    // The energy of damped motions is not conserved; a motion into a pole stops.
    "simulate|damped_pendulum|--set|c=0.1|--initial|theta=1|--times|0,1",
    "simulate|damped_pendulum|--set|c=0.1|--initial|theta=1|--times|0,1|--no-errors",
    "simulate|pendulum|--initial|theta=179.999999deg|--times|0,90|--events|turning",
    "simulate|x''=-x*abs(x)|--initial|x=1|--times|0,1,5",
    "simulate|x''=-x|--initial|x=1|--times|0,5|--columns|e=x'^2+x^2|--until|x=0",
    "simulate|x''=-1/x^2|--initial|x=1|--times|0:10:1",
    "simulate|pendulum|--each|examples/starts.csv|--times|0,1|--events|turning|--columns|e=theta'^2",
    "simulate|pendulum|--each|examples/starts.csv|--times|0,9|--until|theta=0",
    "simulate|pendulum|--each|examples/starts.csv|--times|0,1|--sensitivity|theta,omega0",
    "simulate|pendulum|--initial|theta=1|--times|0,1|--columns|e=theta'^2|--sensitivity|theta,omega0",
    "simulate|x''=-x;y''=-9*y|--initial|x=1|--times|0,1|--tolerance|y=1e-6",
    "paper",
    "figure|spectrum|--amplitudes|60deg|--output|FILE",
    "plan|--g-to|1e-3|--length|1.00(1)m|--angle-noise|0.2deg|--rate|60",
    "inspect|examples/period_table_synthetic.csv",
    "inspect|WEIGHTED|--values",
    "inspect|examples/light_synthetic.csv",
    "fit|periods|examples/period_table_synthetic.csv",
    "fit|periods|examples/period_table_synthetic.csv|--length|1m±0.01m|--bob-radius|50mm±10mm|--correlation|length,bob-radius=1|--latitude|48deg",
    "fit|gates|examples/gate_synthetic.csv",
    "fit|gates|examples/gate_synthetic.csv|--amplitude|0.9|--length|0.958m±0.001m|--latitude|48deg",
    "fit|lengths|examples/lengths_synthetic.csv|--amplitude|10deg|--half-periods|--latitude|48deg",
    "fit|response|examples/response_synthetic.csv|--model|duffing|--amplitude-unit|counts|--columns|1,2",
    "fit|response|examples/response_synthetic.csv|--columns|1,2,-,3",
    "fit|trace|examples/swing_synthetic.csv|LATER|--model|linear|--length|0.56m±0.002m|--bob-radius|20mm±1mm|--correlation|length,bob-radius=0.5",
    "response|x'' + 0.05*x' + 3*max(x - 0.2,0) - 3*max(-x - 0.2,0) = 0.2*cos(w*t)|--over|w=0.5:2",
    "response|x'' + x = cos(w*t)|--over|w=0.5:0.9",
    "fields",
    "sweep|join|SWEEP",
    "sweep|status|SWEEP",
];

/// Fields that no result of this test has, with the reasons. The tests named here call [`assert_described`].
const UNSEEN: &[(&str, &str, &str)] = &[
    ("expand", "interrupted", "needs Ctrl-C: interrupts.rs"),
    ("expand", "interrupted", "with --evaluate, needs Ctrl-C: interrupts.rs"),
    ("expand", "parameters.NAME", "of a scaling law: pure_cubic has none"),
    ("backbone", "interrupted", "needs Ctrl-C: interrupts.rs"),
    ("simulate", "interrupted", "needs Ctrl-C: resume.rs"),
    ("simulate", "motions[].interrupted", "needs Ctrl-C: interrupts.rs"),
    ("fit trace", "rms_residual_rad_per_s", "needs a file of angular velocities: fit_trace.rs"),
];

fn questions() -> Vec<Vec<String>> {
    let directory = directory("fields-questions");
    let file = directory.join("figure.svg").display().to_string();
    // The later part of the same swing serves as another recording.
    let later = directory.join("later.csv");
    let swing = std::fs::read_to_string(root().join("examples/swing_synthetic.csv")).unwrap();
    let lines: Vec<&str> = swing.lines().collect();
    std::fs::write(&later, [&lines[..3], &lines[300..]].concat().join("\n")).unwrap();
    let later = later.display().to_string();
    let sweep = directory.join("sweep").display().to_string();
    libration(&format!("sweep period --over amplitude=1,4 --output {sweep}"));
    let weighted = directory.join("weighted.csv");
    std::fs::write(&weighted, "t (s),theta (deg),u(theta) (deg)\n0,61,0.5\n0.1,55,0.5\n0.2,38,0.5\n")
        .unwrap();
    let weighted = weighted.display().to_string();
    let places = [("FILE", &file), ("LATER", &later), ("SWEEP", &sweep), ("WEIGHTED", &weighted)];
    let in_place =
        |word: &str| places.iter().fold(word.to_owned(), |word, (name, path)| word.replace(name, path));
    let question = |text: &&str| text.split('|').map(in_place).collect();
    widths::QUESTIONS.iter().chain(FURTHER).map(question).collect()
}

#[test]
fn every_field_of_every_answer_is_described_and_none_in_vain() {
    let (kinds, mut shown) = (kinds(), Shown::default());
    for words in questions() {
        shown.question(&kinds, &words);
    }
    assert_eq!(shown.undescribed, BTreeSet::new(), "not described");
    let mut unseen = vec![];
    for kind in &kinds {
        for (form, described) in [("json", &kind.json), ("csv", &kind.csv)] {
            let missing = described.iter().filter(|name| *name != "note" && !shown.has(kind, form, name));
            unseen.extend(missing.map(|name| (kind.command.as_str(), name.as_str())));
        }
    }
    let expected: Vec<(&str, &str)> = UNSEEN.iter().map(|(command, name, _)| (*command, *name)).collect();
    assert_eq!(unseen, expected, "described, and shown by no answer");
}

/// The examples that request a format with fields and print it.
fn examples_with_fields() -> Vec<String> {
    let of_help = commands().iter().flat_map(|words| examples(&help(words))).collect::<Vec<_>>();
    let readmes = ["README.md", "examples/README.md"];
    let of_readmes = readmes.iter().flat_map(|name| {
        let text = std::fs::read_to_string(root().join(name)).unwrap();
        [commands_in(&text), shown_in(&text).into_iter().map(|example| example.command).collect()].concat()
    });
    let has_form = |line: &String| line.contains("--json") || line.contains("--csv");
    of_help.into_iter().chain(of_readmes).filter(has_form).collect()
}

#[test]
fn the_fields_of_the_examples_are_described() {
    let (kinds, mut shown) = (kinds(), Shown::default());
    let folder = clone_of_the_project("fields-examples");
    let examples = examples_with_fields();
    assert!(examples.len() > 10, "{examples:?}");
    for example in examples {
        let line = example.split(" > ").next().unwrap().split("  #").next().unwrap();
        let words = question_in(line);
        let text = in_example(line, &folder);
        let kind = kind_of(&kinds, &words);
        if words.contains(&"--json".to_owned()) {
            shown.json(kind, &serde_json::from_str(&text).unwrap());
        } else {
            let json = in_example(&line.replace("--csv", "--json"), &folder);
            shown.csv(kind, &text, &strings(&serde_json::from_str(&json).unwrap()));
        }
    }
    assert_eq!(shown.undescribed, BTreeSet::new(), "not described");
}

/// The words after `libration` that determine the kind of result.
fn question_in(line: &str) -> Vec<String> {
    words_of(line.split("libration ").nth(1).unwrap())
}

fn in_example(line: &str, folder: &Path) -> String {
    let output = in_shell(line, folder);
    assert!(output.status.success(), "{line}: {}", message(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_field_without_a_description_would_be_seen() {
    let kind = |json: &[&str], csv: &[&str]| Kind {
        command: "x".to_owned(),
        option: String::new(),
        json: json.iter().map(|field| (*field).to_owned()).collect(),
        csv: csv.iter().map(|field| (*field).to_owned()).collect(),
    };
    let described = kind(&["a[].b", "c.K.d[]", "parameters.NAME", "note"], &["b", "KEY_ratio"]);
    let undescribed = |answer: Value, table: &str| {
        let mut shown = Shown::default();
        shown.json(&described, &answer);
        shown.csv(&described, table, &strings(&answer));
        shown.undescribed.len()
    };
    let answer = json!({"a": [{"b": "key", "note": ""}], "c": {"1": {"d": [1]}}, "parameters": {"m": 1}});
    assert_eq!(undescribed(answer.clone(), "b,key_ratio"), 0);
    assert_eq!(undescribed(answer.clone(), "b,other_ratio,more"), 2);
    for (pointer, name) in [("/a/0", "new"), ("", "new"), ("/c/1", "e"), ("/c", "m")] {
        let mut more = answer.clone();
        more.pointer_mut(pointer).unwrap()[name] = json!(1);
        assert_eq!(undescribed(more, "b"), 1, "{pointer}/{name}");
    }
    assert_eq!(undescribed(json!({"a": 1, "c": {"1": [1]}}), "b"), 1);
}

#[test]
fn a_command_is_named_by_its_words_and_an_unknown_one_refused() {
    let all = json("fields fit")["commands"].as_array().unwrap().len();
    assert_eq!(all, 6);
    assert!(text("fields fit trace").starts_with("libration fit trace --json\n"));
    let refused = refusal("fields derive");
    assert!(refused.contains("`derive` has no result with fields"), "{refused}");
}

#[test]
fn descriptions_are_fragments_with_units_apart() {
    let answer = json("fields");
    for kind in answer["commands"].as_array().unwrap() {
        for form in ["json", "csv"] {
            let fields = kind[form].as_array().unwrap();
            let names: BTreeSet<&str> = fields.iter().map(|field| field["name"].as_str().unwrap()).collect();
            assert_eq!(names.len(), fields.len(), "{} {form}: described twice", kind["command"]);
            for field in fields {
                let meaning = field["meaning"].as_str().unwrap();
                assert!(!meaning.is_empty() && !meaning.ends_with('.'), "{field}");
            }
        }
    }
}

/// Endings of field names and their units.
const ENDINGS: &[(&str, &str)] = &[
    ("s", "_s"),
    ("rad", "_rad"),
    ("rad/s", "_rad_per_s"),
    ("m", "_m"),
    ("m/s²", "_m_per_s2"),
    ("m²", "_m2"),
    ("1/s", "_per_s"),
    ("Hz", "_hz"),
    ("rad²/s", "_rad2_per_s"),
    ("rad²/s²", "_rad2_per_s2"),
    ("rad²/s³", "_rad2_per_s3"),
];
/// Settled names without a unit.
const SETTLED: &[&str] = &["exact", "exact_uncertainty"];
/// A unit that depends on the exponent of the damping.
const OPEN: &str = "rad¹⁻ⁿ sⁿ⁻²";

#[test]
fn names_of_fields_end_in_their_units() {
    let mut wrong = vec![];
    for entry in json("fields")["commands"].as_array().unwrap() {
        for field in ["json", "csv"].iter().flat_map(|form| entry[*form].as_array().unwrap()) {
            let [path, unit] = ["name", "unit"].map(|key| field[key].as_str().unwrap());
            let name = path.rsplit('.').next().unwrap().trim_end_matches("[]");
            let of_unit = ENDINGS.iter().find(|pair| pair.0 == unit).map(|pair| pair.1);
            let longest = ENDINGS
                .iter()
                .map(|pair| pair.1)
                .filter(|ending| name.ends_with(ending))
                .max_by_key(|ending| ending.len());
            let is_right = match (unit, of_unit) {
                ("" | "1" | OPEN, _) => longest.is_none(),
                (_, Some(ending)) => longest == Some(ending) || SETTLED.contains(&name),
                (_, None) => false,
            };
            let is_hertz =
                !name.contains("frequency") || name.contains("angular_frequency") || unit != "rad/s";
            if !is_right || !is_hertz {
                wrong.push(format!("{} {}: {path} in `{unit}`", entry["command"], entry["option"]));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
