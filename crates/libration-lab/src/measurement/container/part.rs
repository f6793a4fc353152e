//! A file of an archive, unpacked.

/// Its name, with folders, and its contents.
pub(super) struct ArchiveFile {
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
}
