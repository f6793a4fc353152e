//! Names of systems, coordinates and velocities as titles and axes show them.

use libration::systems::Model;

/// The name of a system in a title: the equations as typed, or their coordinates if they are long.
pub(crate) fn name(model: &Model) -> String {
    const SHORT: usize = 70;
    let equation = model.equation().to_string();
    match model.key() {
        Some(_) => model.title().to_owned(),
        None if equation.chars().count() <= SHORT => equation.replace('\'', "′"),
        None => model
            .coordinates()
            .iter()
            .map(|coordinate| symbol(&coordinate.name))
            .collect::<Vec<_>>()
            .join(", "),
    }
}

/// The name of a model in the middle of a sentence.
pub(crate) fn subject(model: &Model) -> String {
    let name = name(model);
    // "Lorenz's convection" has its article.
    if model.key().is_some() && !name.contains("'s ") { format!("the {name}") } else { name }
}

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
    let letter = LETTERS.iter().find(|(spelling, _)| *spelling == word).map_or(word, |(_, letter)| letter);
    match name[word.len()..].parse() {
        Ok(number) => format!("{letter}{}", crate::output::series::subscript(number)),
        Err(_) => letter.to_owned(),
    }
}

/// A formula as printed at an axis: `θ₁` for theta1; a text that is not a name stays as it is.
pub(crate) fn formula(written: &str) -> String {
    let is_name = written.chars().all(|letter| letter.is_alphanumeric() || letter == '\'');
    if is_name { symbol(written) } else { written.replace('\'', "′") }
}

/// The label of an axis, with its unit if it is known: `θ′ / (rad/s)`.
pub(crate) fn axis_label(name: &str, unit: &str) -> String {
    match unit {
        "" => symbol(name),
        compound if compound.contains('/') => format!("{} / ({compound})", symbol(name)),
        unit => format!("{} / {unit}", symbol(name)),
    }
}
