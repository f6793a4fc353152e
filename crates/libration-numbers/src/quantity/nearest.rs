//! Suggestions for an unknown word.

/// The three known words nearest to the requested one.
pub(crate) fn nearest<'a>(asked: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
    const SHOWN: usize = 3;
    let mut words: Vec<&str> = names.collect();
    words.sort_by_key(|word| edit_distance(asked, word));
    words.into_iter().take(SHOWN).map(str::to_owned).collect()
}

/// The smallest number of insertions, deletions and replacements of characters (V. I. Levenshtein, 1966).
fn edit_distance(from: &str, to: &str) -> usize {
    let mut row: Vec<usize> = (0..=to.chars().count()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, b) in to.chars().enumerate() {
            let replaced = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row.last().copied().unwrap_or(0)
}
