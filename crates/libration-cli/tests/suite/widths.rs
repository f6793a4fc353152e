//! Text output fits into the width of the screen.

use crate::command::directory;
use std::process::Command;

/// The output on a screen with this number of columns; `None` means a pipe.
fn answer(arguments: &[&str], screen: Option<usize>) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_libration"));
    command.args(arguments).current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).env_remove("COLUMNS");
    if let Some(columns) = screen {
        command.env("COLUMNS", columns.to_string());
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn widest(text: &str) -> (usize, &str) {
    text.lines().map(|line| (line.chars().count(), line)).max().unwrap_or((0, ""))
}

pub(crate) const QUESTIONS: &[&str] = &[
    "period|60deg",
    "period|10deg,60deg,150deg",
    "period|10deg,60deg|--formulas|bernoulli,kidd_fogg,denman,black_vel_2,black_vel_3",
    "motion|150deg|--times|0,1,2",
    "motion|90deg|--compare|small-angle,fourier-3,fourier-5,fourier-7|--times|0,1",
    "fourier|150deg|--harmonics|5",
    "formulas|--formulas|bernoulli,carvalhaes_suppes,describing_function,ganley_parwani",
    "formulas|--tolerance|1e-3|--formulas|denman,black_vel_3,butikov",
    "formulas|--crossovers|--formulas|denman,butikov",
    "formulas|pade_power_2|lima_2008",
    "decay|60deg|--linear|0.1|--cycles|3",
    "decay|60deg|--linear|0.1|--cycles|3|--order|5",
    "decay|60deg|--dry|0.5|--quadratic|0.1|--power|1.5:0.1|--cycles|3",
    "expand|pendulum",
    "expand|quadratic|--order|9",
    "expand|van_der_pol|--order|4",
    "expand|damped_pendulum|--set|n=2|--order|5|--damping-order|2",
    "expand|pendulum|--evaluate|40deg",
    "expand|duffing|--evaluate|0.5|--quantity|a3",
    "expand|x''+x+sqrt(2)*x^3=0|--order|5",
    "expand|x''+eps*x'/5+w0^2*x+eps*x^3=eps*cos(W*t)/2|--resonance|1/1|--order|2|--set|eps=0.1|--set|w0=1|--evaluate|1.03",
    "list",
    "list|duffing|double_pendulum",
    "oscillators",
    "systems",
    "backbone|pendulum|--amplitudes|10deg,170deg,190deg",
    "backbone|helmholtz_duffing|--set|alpha=1/2|--amplitudes|0.1,0.5",
    "backbone|x''=-x^3|--amplitudes|0.5,1",
    "simulate|pendulum|--initial|theta=60deg|--times|0:2:0.5|--events|turning",
    "simulate|double_pendulum|--initial|theta1=120deg,theta2=120deg|--times|0,1",
    "simulate|coupled_pendulums|--initial|theta1=20deg|--times|0,1|--events|crossing",
    "simulate|pendulum|--each|examples/starts.csv|--times|0,1|--events|turning,crossing",
    "modes|double_pendulum",
    "modes|double_pendulum|--follow|2|--amplitudes|20deg:60deg:40deg",
    "modes|spring_pendulum",
    "modes|x''=y-2*x-x^3;y''=x-2*y",
    "orbit|driven_pendulum|--set|A=0.15,c=0.1,omega=0.82",
    "orbit|pendulum|--initial|theta=60deg",
    "resonance|x''=-x-x*y;y''=-4*y-x^2/2|--order|2|--initial|x=0.1,y=0.02",
    "resonance|double_pendulum",
    "resonance|x''+w1^2*x+eps*a*x*y=0;y''+w2^2*y+eps*b*x^2=eps*F*cos(W*t)|--ratios|1:2|--resonance|2/1|--order|2",
    "melnikov|driven_pendulum|--set|c=0.1,omega=1|--over|A=0:1",
    "response|driven_pendulum|--set|A=0.15,c=0.1|--over|omega=0.7:0.95|--sweeps|3",
    "stability|kapitza|--set|c=0.1|--map|omega=5:6,a=0.1:0.4|--initial|theta=180deg|--lines|0",
    "section|driven_pendulum|--set|A=1.5,c=1/2|--initial|theta=0.2|--points|3|--skip|1",
    "section|x''=-x-2 x y;y''=-y-x^2+y^2|--at|x|--initial|y=0.1,x'=0.4|--points|3",
    "bifurcation|driven_pendulum|--set|c=1/2|--over|A=1:1.2:0.1|--initial|theta=0.2|--points|2|--skip|2",
    "lyapunov|double_pendulum|--initial|theta1=1,theta2=1|--intervals|4|--transient|1",
    "lyapunov|x''=-x|--initial|x=1|--intervals|8|--transient|1",
    "plan|--g-to|1e-3|--length|1.0000(5)m|--angle-noise|0.2deg|--rate|60",
    "fields|period",
    "paper|--label|25",
    "paper|--document|cote",
    "figure|errors|--formulas|bernoulli,describing_function|--output|FILE",
    "figure|phase|--output|FILE",
    "inspect|examples/swing_synthetic.csv",
    "inspect|examples/gate_synthetic.csv",
    "inspect|examples/phone/swing.txt|--angle-unit|rad|--spectrum",
    "fit|periods|examples/period_table_synthetic.csv|--length|0.994m±0.001m|--bob-radius|20mm|--bob-mass|42g",
    "fit|amplitudes|examples/amplitudes_synthetic.csv",
    "fit|amplitudes|examples/amplitudes_synthetic.csv|--columns|time,2|--model|linear",
    "fit|lengths|examples/bar_synthetic.csv",
    "fit|lengths|examples/reversible_synthetic.csv|--model|reversible|--edges|0.9935m±0.0001m",
    "fit|lengths|examples/lengths_synthetic.csv|--amplitude|10deg",
    "fit|response|examples/response_synthetic.csv",
    "fit|gates|examples/gate_synthetic.csv|--length|0.958m±0.001m|--diameter|25.0(1)mm",
    "fit|trace|examples/swing_synthetic.csv",
    "fit|trace|examples/swing_synthetic.csv|--model|linear|--length|0.56m±0.002m|--bob-radius|20mm|--bob-mass|42g",
];

fn question(text: &str) -> Vec<String> {
    let file = directory("widths").join("figure.svg").display().to_string();
    text.split('|').map(|word| if word == "FILE" { file.clone() } else { word.to_owned() }).collect()
}

#[test]
fn no_line_of_any_answer_is_wider_than_eighty_columns() {
    for text in QUESTIONS {
        let words = question(text);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let answer = answer(&words, None);
        let (columns, line) = widest(&answer);
        let is_path = line.contains("figure.svg");
        assert!(columns <= 80 || is_path, "{text}: {columns} columns:\n{line}");
    }
}

#[test]
fn a_wider_screen_is_used_and_a_narrower_one_heeded() {
    let question = ["motion", "90deg", "--compare", "small-angle,fourier-3", "--times", "0,1"];
    let on = |columns| answer(&question, Some(columns));
    assert!(widest(&on(200)).0 > 100);
    for columns in [60, 80, 120] {
        assert!(widest(&on(columns)).0 <= columns, "{columns}");
    }
    assert_eq!(answer(&question, None), on(80));
}

#[test]
fn nothing_is_lost_on_a_narrow_screen() {
    let words = |columns| {
        let answer = answer(&["decay", "60deg", "--linear", "0.1", "--cycles", "4"], Some(columns));
        let mut words: Vec<String> = answer.split_whitespace().map(str::to_owned).collect();
        words.sort();
        words.dedup();
        words
    };
    assert_eq!(words(60), words(200));
}
