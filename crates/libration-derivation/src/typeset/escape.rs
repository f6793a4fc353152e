//! Escaping: every character represents itself in the output format.

/// Escapes text for HTML and MathML.
pub(crate) fn html(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut escaped, letter| {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            letter => escaped.push(letter),
        }
        escaped
    })
}

/// Escapes text for LaTeX with Unicode by inputenc and T1 fonts; characters that these lack are spelt out.
pub(crate) fn latex_text(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut escaped, letter| {
        match letter {
            '\\' => escaped.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '_' | '%' => escaped.extend(['\\', letter]),
            '^' => escaped.push_str("\\textasciicircum{}"),
            '~' => escaped.push_str("\\textasciitilde{}"),
            '–' => escaped.push_str("--"),
            '’' => escaped.push('\''),
            '“' => escaped.push_str("``"),
            '”' => escaped.push_str("''"),
            '…' => escaped.push_str("\\ldots{}"),
            '°' => escaped.push_str("\\ensuremath{^\\circ}"),
            '−' => escaped.push_str("\\ensuremath{-}"),
            '′' => escaped.push_str("\\ensuremath{'}"),
            letter => match (letter_name(letter), raised_digit(letter)) {
                (Some(name), _) => escaped.push_str(&format!("\\ensuremath{{\\{name}}}")),
                (_, Some(digit)) => escaped.push_str(&format!("\\ensuremath{{^{{{digit}}}}}")),
                _ => escaped.push(letter),
            },
        }
        escaped
    })
}

/// The LaTeX name of a letter that is not in ASCII.
pub(crate) fn letter_name(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' => "varepsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' => "theta",
        'ϑ' => "vartheta",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'φ' => "varphi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Δ' => "Delta",
        'Ω' => "Omega",
        '∞' => "infty",
        'ℓ' => "ell",
        _ => return None,
    })
}

/// The digit for a superscript.
fn raised_digit(letter: char) -> Option<usize> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|character| character == letter)
}

/// Escapes text for Markdown, so that nothing becomes emphasis, a link, a heading or HTML.
pub(crate) fn markdown(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut escaped, letter| {
        match letter {
            '<' => escaped.push_str("&lt;"),
            '&' => escaped.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '$' | '#' | '|' => escaped.extend(['\\', letter]),
            letter => escaped.push(letter),
        }
        escaped
    })
}
