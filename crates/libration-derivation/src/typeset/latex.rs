//! Layouts as LaTeX.

use super::escape::letter_name;
use super::layout::Layout;

/// The layout in mathematics mode.
pub(super) fn latex(layout: &Layout) -> String {
    match layout {
        Layout::Row(parts) => parts.iter().map(latex).collect(),
        Layout::Letter(letter) => letter_latex(letter),
        Layout::Word(word) => word_latex(word),
        Layout::Digits(digits) => digits.clone(),
        Layout::Sign(sign) => sign_latex(*sign).to_owned(),
        Layout::Prefix(sign) => sign_latex(*sign).to_owned(),
        Layout::Suffix(text) => suffix_latex(text).to_owned(),
        Layout::Comma => ",\\,".to_owned(),
        Layout::ThinSpace => "\\,".to_owned(),
        Layout::Indent => "\\quad ".to_owned(),
        Layout::Application => " ".to_owned(),
        Layout::Fraction(over, under) => format!("\\frac{{{}}}{{{}}}", latex(over), latex(under)),
        Layout::Root(under) => format!("\\sqrt{{{}}}", latex(under)),
        Layout::Primed(base, primes) => latex(base).trim_end().to_owned() + &"'".repeat(usize::from(*primes)),
        Layout::Scripts { base, below, above } => {
            let script = |mark: char, part: &Option<Box<Layout>>| {
                part.as_ref().map_or_else(String::new, |part| format!("{mark}{{{}}}", latex(part)))
            };
            format!("{}{}{}", latex(base), script('_', below), script('^', above))
        }
        Layout::Large { sign, from, to } => {
            let name = if *sign == '∑' { "\\sum" } else { "\\int" };
            format!("{name}_{{{}}}^{{{}}}", latex(from), latex(to))
        }
        Layout::Brackets(inner) => format!("\\left({}\\right)", latex(inner)),
        Layout::Bars(inner) => format!("\\left|{}\\right|", latex(inner)),
    }
}

/// Commands end with a space, so that the next letter does not join them.
fn letter_latex(letter: &str) -> String {
    match letter.chars().next().and_then(letter_name).filter(|_| letter.chars().count() == 1) {
        Some(name) => format!("\\{name} "),
        None => super::escape::latex_text(letter),
    }
}

fn word_latex(word: &str) -> String {
    match word {
        "sin" | "cos" | "tan" | "arcsin" | "arccos" | "arctan" | "sinh" | "cosh" | "tanh" | "ln" => {
            format!("\\{word}")
        }
        "agm" => "\\operatorname{agm}".to_owned(),
        _ => format!("\\mathrm{{{}}}", super::escape::latex_text(word)),
    }
}

fn sign_latex(sign: char) -> &'static str {
    match sign {
        '+' => "+",
        '−' => "-",
        '=' => "=",
        '≔' => ":=",
        '≈' => "\\approx ",
        '<' => "<",
        '·' => "\\cdot ",
        _ => "\\;",
    }
}

fn suffix_latex(text: &'static str) -> &'static str {
    match text {
        "°" => "^{\\circ}",
        text => text,
    }
}
