//! The words that name quantities, in the languages that instruments speak.

use super::QuantityKind;

/// Names in lower case without units. Of the letters that are angles in equations (`quantity::is_angle_name`) only θ and φ: in a
/// header α is as often an acceleration, and β and γ are anything.
const NAMES: [(QuantityKind, &[&str]); 7] = [
    (
        QuantityKind::Time,
        &[
            "t",
            "time",
            "zeit",
            "temps",
            "tempo",
            "tiempo",
            "tijd",
            "tid",
            "czas",
            "elapsed time",
            "timestamp",
            "time stamp",
            "zeit t",
            "time t",
        ],
    ),
    (
        QuantityKind::Angle,
        &[
            "θ",
            "ϑ",
            "theta",
            "φ",
            "ϕ",
            "phi",
            "vartheta",
            "varphi",
            "angle",
            "winkel",
            "angolo",
            "ángulo",
            "angulo",
            "hoek",
            "ângulo",
            "vinkel",
            "kąt",
            "angular position",
            "angular displacement",
            "rotation angle",
            "pendulum angle",
            "deflection",
            "auslenkung",
        ],
    ),
    (
        QuantityKind::AngularVelocity,
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
    (
        QuantityKind::X,
        &["x", "x position", "position x", "x pos", "pos x", "horizontal", "horizontal position"],
    ),
    (QuantityKind::Y, &["y", "y position", "position y", "y pos", "pos y", "vertical", "vertical position"]),
    (
        QuantityKind::Gate,
        &["gatestate", "gate state", "gate", "state", "blocked", "photogate", "photogate state"],
    ),
    (QuantityKind::Run, &["packet", "run", "trial", "run number", "run id", "trial number", "measurement"]),
];

/// Meaning of the words of a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Words {
    /// The quantity that they name.
    pub quantity: QuantityKind,
    /// `true` if they name the uncertainty of the quantity.
    pub(super) is_uncertainty: bool,
    /// The number after the symbol, as in `t_{1}` or `theta2`.
    pub index: Option<String>,
}

impl Words {
    /// Interprets a name.
    pub fn read(name: &str) -> Self {
        let (plain, is_uncertainty) = without_uncertainty(name);
        let (symbol, index) = without_index(&plain);
        match (named(&plain), named(&symbol)) {
            (QuantityKind::Other, QuantityKind::Other) => match named_as_acceleration(&plain) {
                true => Self { quantity: QuantityKind::Acceleration, is_uncertainty, index: None },
                false => Self { quantity: QuantityKind::Other, is_uncertainty, index: None },
            },
            (QuantityKind::Other, quantity) => Self { quantity, is_uncertainty, index },
            (quantity, _) => Self { quantity, is_uncertainty, index: None },
        }
    }
}

/// Notations for the uncertainty of the quantity that follows, as one word.
const UNCERTAINTY: [&str; 29] = [
    "uncertainty",
    "uncertainties",
    "uncert",
    "unc",
    "error",
    "errors",
    "err",
    "sigma",
    "std",
    "stdev",
    "stddev",
    "sd",
    "sem",
    "se",
    "stderr",
    "unsicherheit",
    "messunsicherheit",
    "fehler",
    "incertezza",
    "errore",
    "incertitude",
    "incertidumbre",
    "σ",
    "±",
    "standardabweichung",
    "incerteza",
    "onzekerheid",
    "osäkerhet",
    "niepewność",
];

/// Notations of several words or abbreviations.
const STANDARD: [&str; 10] = [
    "standard deviation",
    "standard error",
    "standard uncertainty",
    "deviazione standard",
    "desviación estándar",
    "desviación típica",
    "écart-type",
    "écart type",
    "s.e.m.",
    "s.d.",
];

/// The words of a name in lower case, and `true` if they refer to an uncertainty.
pub(in crate::measurement) fn without_uncertainty(name: &str) -> (String, bool) {
    let lower = name.to_lowercase().replace(['\\', '$'], "").replace('σ', "σ ").replace('±', "± ");
    let lower = STANDARD.iter().fold(lower, |lower, words| lower.replace(words, "sd"));
    if let Some(of) = difference(&lower) {
        return (of, true);
    }
    let parts: Vec<&str> =
        lower.split(|letter: char| letter.is_whitespace() || "_-.".contains(letter)).collect();
    // A capital U is a voltage.
    let is_sign = |part: &str| UNCERTAINTY.contains(&part) || part == "u" && !name.contains('U');
    let is_uncertainty = parts.iter().any(|part| is_sign(part));
    let kept = parts.into_iter().filter(|part| !part.is_empty() && *part != "of" && !is_sign(part));
    (kept.collect::<Vec<_>>().join(" "), is_uncertainty)
}

/// Returns `true` if a heading refers to the standard deviation of readings, `sd`, `σ(T)`, `Standardabweichung`, and not to that of a mean.
pub(in crate::measurement) fn is_deviation(heading: &str) -> bool {
    const DEVIATION: [&str; 8] =
        ["sd", "std", "stdev", "stddev", "σ", "sigma", "standardabweichung", "deviation"];
    const OF_MEAN: [&str; 12] = [
        "mean",
        "error",
        "err",
        "uncertainty",
        "unc",
        "u",
        "se",
        "sem",
        "mittelwert",
        "mittelwerts",
        "moyenne",
        "media",
    ];
    let lower = heading.to_lowercase().replace('σ', "σ ").replace("s.d.", "sd").replace("s.e.m.", "sem");
    let phrases =
        ["deviazione standard", "desviación estándar", "desviación típica", "écart-type", "écart type"];
    let lower = phrases.iter().fold(lower, |lower, words| lower.replace(words, "sd"));
    let words: Vec<&str> = lower.split(|letter: char| !letter.is_alphabetic()).collect();
    let has = |list: &[&str]| words.iter().any(|word| list.contains(word));
    has(&DEVIATION) && !has(&OF_MEAN)
}

/// `Δθ`, `delta theta`, `u_theta` → θ. A Δ of times is as often an interval, which is neither time nor uncertainty.
fn difference(lower: &str) -> Option<String> {
    let rest = ["δ", "∆", "delta", "u_", "u "].iter().find_map(|sign| lower.strip_prefix(sign))?;
    let of = rest.trim_start_matches([' ', '_']).trim_end();
    let (symbol, _) = without_index(of);
    let quantity = [of, &symbol].map(named).into_iter().find(|quantity| *quantity != QuantityKind::Other)?;
    (quantity != QuantityKind::Time || lower.starts_with('u')).then(|| of.to_owned())
}

/// `t_{1}`, `theta 1`, `x₂` → the symbol, and the number.
fn without_index(words: &str) -> (String, Option<String>) {
    let subscript = |letter: char| match letter {
        '₀'..='₉' => char::from_digit(u32::from(letter) - u32::from('₀'), 10).unwrap_or(letter),
        other => other,
    };
    let plain: String = words.chars().filter(|letter| !"{}".contains(*letter)).map(subscript).collect();
    let symbol = plain.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let index = &plain[symbol.len()..];
    let index = (!index.is_empty()).then(|| index.to_owned());
    (symbol.trim_end_matches([' ', '_']).to_owned(), index)
}

/// The quantity of this name.
pub(in crate::measurement) fn named(words: &str) -> QuantityKind {
    NAMES
        .iter()
        .find(|(_, names)| names.contains(&words))
        .map_or(QuantityKind::Other, |(quantity, _)| *quantity)
}

/// Returns `true` for names of accelerations; an angular acceleration is not one of an accelerometer.
fn named_as_acceleration(words: &str) -> bool {
    const STEMS: [&str; 6] = ["accel", "beschleunigung", "accél", "aceler", "accelerazione", "versnelling"];
    const ANGULAR: [&str; 3] = ["angul", "winkel", "ángul"];
    STEMS.iter().any(|stem| words.contains(stem)) && !ANGULAR.iter().any(|stem| words.contains(stem))
}

/// Returns `true` if a text is a unit of accelerations as instruments spell them.
pub fn is_of_acceleration(unit: &str) -> bool {
    let plain: String = unit.to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
    ["m/s²", "m/s^2", "m/s2", "m/s/s", "m·s⁻²", "ms⁻²", "ms^-2", "m*s^-2", "cm/s²", "cm/s^2"]
        .contains(&plain.as_str())
}
