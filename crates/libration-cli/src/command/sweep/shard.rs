//! A part of a sweep for one of several machines: `3/64`.

/// Which of how many parts, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Shard {
    pub(crate) of: usize,
    pub(crate) number: usize,
}

impl Shard {
    /// The whole sweep.
    pub(crate) const WHOLE: Self = Self { of: 1, number: 1 };

    /// The chunks of this part out of so many: every `of`th, so that parts take about as long.
    pub(crate) fn chunks(self, all: usize) -> impl Iterator<Item = usize> {
        (self.number - 1..all).step_by(self.of)
    }

    /// The name of the file that says that this part is written beside it.
    pub(crate) fn note(self) -> String {
        format!("shard-{}-of-{}", self.number, self.of)
    }

    pub(crate) fn of_note(name: &str) -> Option<Self> {
        let (number, of) = name.strip_prefix("shard-")?.split_once("-of-")?;
        shard(&format!("{number}/{of}")).ok()
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

/// Reads `3/64`.
pub(crate) fn shard(text: &str) -> Result<Shard, String> {
    let parts = text
        .split_once('/')
        .and_then(|(number, of)| Some((number.trim().parse().ok()?, of.trim().parse().ok()?)));
    let shard = parts.map(|(number, of)| Shard { of, number });
    let shard = shard.filter(|shard| (1..=shard.of).contains(&shard.number));
    shard.ok_or_else(|| "give which of how many, such as 3/64; the first is 1/64".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_share_all_chunks() {
        for (of, all) in [(1, 7), (3, 7), (9, 7), (7, 7)] {
            let mut chunks: Vec<usize> =
                (1..=of).flat_map(|number| Shard { of, number }.chunks(all)).collect();
            chunks.sort_unstable();
            assert_eq!(chunks, (0..all).collect::<Vec<_>>());
        }
    }

    #[test]
    fn shards_are_read_as_they_are_written() {
        let third = Shard { of: 64, number: 3 };
        assert_eq!((shard("3/64"), Shard::of_note(&third.note())), (Ok(third), Some(third)));
        for text in ["3", "0/4", "5/4", "a/4", "1/0", "-1/4", ""] {
            assert!(shard(text).is_err(), "{text}");
        }
    }
}
