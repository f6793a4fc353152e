//! The words that name quantities, in the languages that instruments speak.

use super::Quantity;

/// Names in lower case without units.
const NAMES: [(Quantity, &[&str]); 7] = [
    (
        Quantity::Time,
        &[
            "t",
            "time",
            "zeit",
            "temps",
            "tempo",
            "tiempo",
            "tijd",
            "tid",
            "elapsed time",
            "timestamp",
            "time stamp",
            "zeit t",
            "time t",
        ],
    ),
    (
        Quantity::Angle,
        &[
            "θ",
            "ϑ",
            "theta",
            "φ",
            "ϕ",
            "phi",
            "angle",
            "winkel",
            "angolo",
            "ángulo",
            "angulo",
            "hoek",
            "angular position",
            "angular displacement",
            "rotation angle",
            "pendulum angle",
            "deflection",
            "auslenkung",
        ],
    ),
    (
        Quantity::AngularVelocity,
        &[
            "ω",
            "omega",
            "angular velocity",
            "angular speed",
            "winkelgeschwindigkeit",
            "velocità angolare",
            "vitesse angulaire",
            "velocidad angular",
            "θ'",
            "theta'",
        ],
    ),
    (Quantity::X, &["x", "x position", "position x", "x pos", "pos x"]),
    (Quantity::Y, &["y", "y position", "position y", "y pos", "pos y"]),
    (
        Quantity::Gate,
        &["gatestate", "gate state", "gate", "state", "blocked", "photogate", "photogate state"],
    ),
    (Quantity::Run, &["packet", "run", "trial", "run number", "run id", "trial number", "measurement"]),
];

/// The words of a name in lower case, and whether they speak of an uncertainty.
pub(super) fn without_uncertainty(name: &str) -> (String, bool) {
    const WORDS: [&str; 14] = [
        "uncertainty",
        "uncert",
        "error",
        "err",
        "sigma",
        "std",
        "stdev",
        "unsicherheit",
        "fehler",
        "incertezza",
        "errore",
        "incertitude",
        "σ",
        "±",
    ];
    let lower = name.to_lowercase().replace('σ', "σ ").replace('±', "± ");
    let parts: Vec<&str> =
        lower.split(|letter: char| letter.is_whitespace() || "_-.".contains(letter)).collect();
    let is_uncertainty = parts.iter().any(|part| WORDS.contains(part));
    let kept = parts.into_iter().filter(|part| !part.is_empty() && *part != "of" && !WORDS.contains(part));
    (kept.collect::<Vec<_>>().join(" "), is_uncertainty)
}

/// The quantity of this name.
pub(super) fn named(words: &str) -> Quantity {
    NAMES.iter().find(|(_, names)| names.contains(&words)).map_or(Quantity::Other, |(quantity, _)| *quantity)
}
