//! Non-ASCII letters, marks and digits of formulas.

/// The Greek letters with their names in text and in LaTeX; the first name of a letter is the one for output.
const GREEK: &[(char, &str)] = &[
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ϵ', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Ξ', "Xi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

/// The Greek letter with this name: θ for `theta`.
#[must_use]
pub fn greek_letter(name: &str) -> Option<char> {
    GREEK.iter().find(|(_, greek)| *greek == name).map(|(letter, _)| *letter)
}

/// The name of a Greek letter.
pub(super) fn greek_name(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(greek, _)| *greek == letter).map(|(_, name)| *name)
}

/// Returns `true` if a Greek letter has this name.
pub(super) fn is_greek(name: &str) -> bool {
    GREEK.iter().any(|(_, greek)| *greek == name)
}

/// A precomposed dotted letter, as the letter and the number of dots.
pub(super) fn dotted(letter: char) -> Option<(char, u8)> {
    match letter {
        'ẋ' => Some(('x', 1)),
        'ẏ' => Some(('y', 1)),
        'ż' => Some(('z', 1)),
        'ẍ' => Some(('x', 2)),
        'ÿ' => Some(('y', 2)),
        _ => None,
    }
}

/// Number of time derivatives that a mark after or above a letter denotes.
pub(super) fn primes(mark: char) -> Option<u8> {
    match mark {
        '\'' | '′' | '’' | '‘' | 'ʹ' | '´' | '\u{307}' => Some(1),
        '"' | '″' | '”' | '“' | 'ʺ' | '\u{308}' => Some(2),
        '‴' => Some(3),
        _ => None,
    }
}

/// The digit for ₀ … ₉.
pub(super) fn subscript(c: char) -> Option<char> {
    let digit = u32::from(c).checked_sub(u32::from('₀'))?;
    char::from_digit(digit, 10)
}

/// The digit for ⁰ … ⁹.
pub(super) fn superscript(c: char) -> Option<char> {
    match c {
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        '⁰' => Some('0'),
        '⁴'..='⁹' => char::from_digit(u32::from(c) - u32::from('⁰'), 10),
        _ => None,
    }
}
