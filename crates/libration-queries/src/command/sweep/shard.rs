//! A part of a sweep for one of several machines: `3/64`.

/// A part of a sweep: its number, from 1, and the number of parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    /// The number of shards.
    pub of: usize,
    /// The number of this part, from 1.
    pub number: usize,
}

impl Shard {
    /// The whole sweep.
    pub(crate) const WHOLE: Self = Self { of: 1, number: 1 };

    /// The chunks of this part out of `all`: every `of`th, so that parts take about the same time.
    pub fn chunks(self, all: usize) -> impl Iterator<Item = usize> {
        (self.number - 1..all).step_by(self.of)
    }

    /// The name of the file that records this part in its directory.
    pub fn note(self) -> String {
        format!("shard-{}-of-{}", self.number, self.of)
    }

    /// The shard of a note.
    pub fn of_note(name: &str) -> Option<Self> {
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
pub fn shard(text: &str) -> Result<Shard, String> {
    let parts = text
        .split_once('/')
        .and_then(|(number, of)| Some((number.trim().parse().ok()?, of.trim().parse().ok()?)));
    let shard = parts.map(|(number, of)| Shard { of, number });
    let shard = shard.filter(|shard| (1..=shard.of).contains(&shard.number));
    shard.ok_or_else(|| "give which of how many, such as 3/64; the first is 1/64".to_owned())
}
