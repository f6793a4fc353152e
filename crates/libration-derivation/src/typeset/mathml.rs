//! Layouts as MathML, which browsers render directly.

use super::escape::html;
use super::layout::Layout;

/// The layout as the content of a `math` element.
pub(crate) fn mathml(layout: &Layout) -> String {
    match layout {
        Layout::Row(parts) => format!("<mrow>{}</mrow>", row(parts)),
        Layout::Letter(letter) => element("mi", letter),
        Layout::Word(word) => format!("<mi mathvariant=\"normal\">{}</mi>", html(word)),
        Layout::Digits(digits) => element("mn", digits),
        Layout::Sign(sign) => element("mo", &sign.to_string()),
        Layout::Prefix(sign) => format!("<mo form=\"prefix\">{sign}</mo>"),
        Layout::Suffix(text) => {
            format!("<mo form=\"postfix\" lspace=\"0em\" rspace=\"0em\">{}</mo>", html(text))
        }
        Layout::Comma => "<mo>,</mo>".to_owned(),
        Layout::Indent => "<mspace width=\"1.5em\"/>".to_owned(),
        Layout::Application => "<mo>&#x2061;</mo><mspace width=\"0.17em\"/>".to_owned(),
        Layout::ThinSpace => "<mspace width=\"0.17em\"/>".to_owned(),
        Layout::Fraction(over, under) => format!("<mfrac>{}{}</mfrac>", mathml(over), mathml(under)),
        Layout::Root(under) => format!("<msqrt>{}</msqrt>", mathml(under)),
        Layout::Primed(base, primes) => {
            format!("<msup>{}<mo>{}</mo></msup>", mathml(base), primes_text(*primes))
        }
        Layout::Scripts { base, below, above } => {
            scripts("msub", "msup", "msubsup", &mathml(base), below.as_deref(), above.as_deref())
        }
        Layout::Large { sign, from, to } => {
            let tag = if *sign == '∑' { "munderover" } else { "msubsup" };
            format!("<{tag}><mo largeop=\"true\">{sign}</mo>{}{}</{tag}>", mathml(from), mathml(to))
        }
        Layout::Brackets(inner) => fenced("(", inner, ")"),
        Layout::Bars(inner) => fenced("|", inner, "|"),
    }
}

fn primes_text(primes: u8) -> String {
    match primes {
        1 => "′".to_owned(),
        2 => "″".to_owned(),
        more => "′".repeat(usize::from(more)),
    }
}

fn row(parts: &[Layout]) -> String {
    parts.iter().map(mathml).collect()
}

fn element(tag: &str, text: &str) -> String {
    format!("<{tag}>{}</{tag}>", html(text))
}

/// Brackets stretch around tall content and keep their size around a line of text.
fn fenced(open: &str, inner: &Layout, close: &str) -> String {
    let stretchy = is_tall(inner);
    let fence = |form: &str, sign: &str| {
        format!("<mo stretchy=\"{stretchy}\" form=\"{form}\" lspace=\"0em\" rspace=\"0em\">{sign}</mo>")
    };
    format!("<mrow>{}{}{}</mrow>", fence("prefix", open), mathml(inner), fence("postfix", close))
}

fn is_tall(layout: &Layout) -> bool {
    match layout {
        Layout::Fraction(..) | Layout::Root(_) | Layout::Large { .. } => true,
        Layout::Row(parts) => parts.iter().any(is_tall),
        Layout::Scripts { base, .. } => is_tall(base),
        Layout::Brackets(inner) | Layout::Bars(inner) => is_tall(inner),
        Layout::Primed(..)
        | Layout::Letter(_)
        | Layout::Word(_)
        | Layout::Digits(_)
        | Layout::Sign(_)
        | Layout::Prefix(_)
        | Layout::Suffix(_)
        | Layout::Comma
        | Layout::ThinSpace
        | Layout::Indent
        | Layout::Application => false,
    }
}

fn scripts(
    sub: &str,
    sup: &str,
    both: &str,
    base: &str,
    below: Option<&Layout>,
    above: Option<&Layout>,
) -> String {
    match (below, above) {
        (None, None) => base.to_owned(),
        (Some(below), None) => format!("<{sub}>{base}{}</{sub}>", mathml(below)),
        (None, Some(above)) => format!("<{sup}>{base}{}</{sup}>", mathml(above)),
        (Some(below), Some(above)) => format!("<{both}>{base}{}{}</{both}>", mathml(below), mathml(above)),
    }
}
