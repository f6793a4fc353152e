//! Names of coordinates and velocities as axes show them.

/// `θ₁` for theta1, `θ₁′` for its velocity.
pub(crate) fn symbol(name: &str) -> String {
    const LETTERS: [(&str, &str); 12] = [
        ("theta", "θ"),
        ("phi", "φ"),
        ("psi", "ψ"),
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ε"),
        ("kappa", "κ"),
        ("lambda", "λ"),
        ("mu", "μ"),
        ("omega", "ω"),
    ];
    if let Some(coordinate) = name.strip_suffix('\'') {
        return symbol(coordinate) + "′";
    }
    let word = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let letter = LETTERS.iter().find(|(known, _)| *known == word).map_or(word, |(_, letter)| letter);
    match name[word.len()..].parse() {
        Ok(number) => format!("{letter}{}", crate::output::series::subscript(number)),
        Err(_) => letter.to_owned(),
    }
}

/// What an axis shows, with its unit if it is known: `θ′ / (rad/s)`.
pub(crate) fn axis_label(name: &str, unit: &str) -> String {
    match unit {
        "" => symbol(name),
        compound if compound.contains('/') => format!("{} / ({compound})", symbol(name)),
        unit => format!("{} / {unit}", symbol(name)),
    }
}
