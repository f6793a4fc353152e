//! A file of an archive, unpacked.

/// Its name, with folders, and what it holds.
pub(super) struct Part {
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
}
