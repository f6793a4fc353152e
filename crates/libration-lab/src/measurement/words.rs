//! Words and numbers of a heading, in several languages.

/// Numbers in words.
const IN_WORDS: [(f64, &[&str]); 10] = [
    (1.0, &["one", "eine", "einer"]),
    (2.0, &["two", "zwei", "deux", "due", "dos"]),
    (3.0, &["three", "drei", "trois", "tre", "tres"]),
    (4.0, &["four", "vier", "quatre", "quattro", "cuatro"]),
    (5.0, &["five", "fünf", "cinq", "cinque", "cinco", "vijf", "fem", "pięciu"]),
    (10.0, &["ten", "zehn", "dix", "dieci", "diez", "dez", "tien", "tio", "dziesięciu"]),
    (12.0, &["twelve", "zwölf", "dozen", "dutzend"]),
    (20.0, &["twenty", "zwanzig", "vingt", "venti", "veinte", "vinte", "twintig", "tjugo", "dwudziestu"]),
    (50.0, &["fifty", "fünfzig", "cinquante", "cinquanta", "cincuenta"]),
    (100.0, &["hundred", "hundert", "cent", "cento", "cien"]),
];
/// Units of time.
pub(super) const UNITS_OF_TIME: [&str; 4] = ["s", "sec", "ms", "min"];

/// Returns `true` if a word is one of these.
pub(super) fn is(list: &[&str], word: &str) -> bool {
    list.contains(&word)
}

/// The positive number that a word is, in digits or not.
pub(super) fn number(word: &str) -> Option<f64> {
    let of_word =
        |word: &str| IN_WORDS.iter().find(|(_, words)| words.contains(&word)).map(|(number, _)| *number);
    let multiple =
        ["fold", "fache", "fachen", "fach"].iter().find_map(|end| of_word(word.strip_suffix(end)?));
    let digits = word.trim_matches(['.', ',']).replace(',', ".").parse().ok();
    digits.or(of_word(word)).or(multiple).filter(|number| *number > 0.0 && number.is_finite())
}

/// Letters, numbers and strokes in lower case, each separate: `10T/s` is `10`, `t`, `/`, `s`.
pub(super) fn words(text: &str) -> Vec<String> {
    let digit = |letter: char| match letter {
        '₀'..='₉' => char::from_digit(u32::from(letter) - u32::from('₀'), 10).unwrap_or(letter),
        other => other,
    };
    let text: String = text.to_lowercase().replace('°', " deg ").chars().map(digit).collect();
    let kind = |letter: char| match letter {
        '0'..='9' | '.' | ',' => 1,
        letter if letter.is_alphabetic() => 2,
        '/' | '½' => 3,
        _ => 0,
    };
    let letters: Vec<char> = text.chars().collect();
    let pieces = letters.chunk_by(|&a, &b| kind(a) == kind(b) && kind(a) != 3);
    let is_word = |piece: &&[char]| kind(piece[0]) != 0 && piece.iter().any(|letter| !".,".contains(*letter));
    pieces.filter(is_word).map(|piece| piece.iter().collect()).collect()
}
