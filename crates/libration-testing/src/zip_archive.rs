//! ZIP archives, written byte by byte so that each field can be wrong.
//!
//! PKWARE, *APPNOTE.TXT – .ZIP File Format Specification*, 4.3.

/// A file as its headers describe it, with its bytes in the archive.
#[derive(Clone, Debug)]
pub struct Packed {
    /// The name of the file.
    pub name: Vec<u8>,
    /// The general purpose flags.
    pub flags: u16,
    /// The compression method: 0 stored, 8 deflated.
    pub method: u16,
    /// The cyclic redundancy check.
    pub checksum: u32,
    /// The uncompressed size in bytes.
    pub size: u32,
    /// The bytes in the archive.
    pub bytes: Vec<u8>,
    /// Extra fields of the directory entry.
    pub extra: Vec<u8>,
}

impl Packed {
    /// The flag for a data descriptor after the bytes.
    pub const DESCRIPTOR: u16 = 8;

    /// An uncompressed file.
    pub fn stored(name: impl AsRef<[u8]>, bytes: &[u8]) -> Self {
        Self {
            name: name.as_ref().to_vec(),
            flags: 0,
            method: 0,
            checksum: checksum(bytes),
            size: u32::try_from(bytes.len()).unwrap(),
            bytes: bytes.to_vec(),
            extra: vec![],
        }
    }

    /// A deflated file.
    pub fn deflated(name: impl AsRef<[u8]>, bytes: &[u8]) -> Self {
        let packed = miniz_oxide::deflate::compress_to_vec(bytes, 6);
        Self { method: 8, bytes: packed, ..Self::stored(name, bytes) }
    }

    /// The common part of the local header and the directory entry, up to the lengths of the name and the extra fields.
    fn common(&self, is_local: bool) -> Vec<u8> {
        let later = is_local && self.flags & Self::DESCRIPTOR != 0;
        let numbers = [self.checksum, self.packed_size(), self.size];
        let short = [20, self.flags, self.method, 0, 0x21];
        let mut header: Vec<u8> = short.iter().flat_map(|number: &u16| number.to_le_bytes()).collect();
        header.extend(numbers.iter().flat_map(|&number| if later { 0 } else { number }.to_le_bytes()));
        header
    }

    fn packed_size(&self) -> u32 {
        u32::try_from(self.bytes.len()).unwrap()
    }

    fn name_size(&self) -> [u8; 2] {
        u16::try_from(self.name.len()).unwrap().to_le_bytes()
    }

    /// The local header, the bytes and, if its flag is set, the data descriptor after them.
    pub fn local(&self) -> Vec<u8> {
        let header =
            [&b"PK\x03\x04"[..], &self.common(true)[..], &self.name_size(), &[0, 0], &self.name].concat();
        let numbers = [self.checksum, self.packed_size(), self.size];
        let descriptor = numbers.iter().flat_map(|number| number.to_le_bytes());
        let descriptor: Vec<u8> = b"PK\x07\x08".iter().copied().chain(descriptor).collect();
        let descriptor = if self.flags & Self::DESCRIPTOR == 0 { &[] } else { &descriptor[..] };
        [&header[..], &self.bytes, descriptor].concat()
    }

    /// The directory entry for a local header at this position.
    pub fn entry(&self, position: u32) -> Vec<u8> {
        let extra = u16::try_from(self.extra.len()).unwrap().to_le_bytes();
        let (made_by, common) = ([20, 0], self.common(false));
        let before = [&b"PK\x01\x02"[..], &made_by[..], &common, &self.name_size(), &extra].concat();
        // No comment, first disk, no attributes.
        [&before[..], &[0; 10], &position.to_le_bytes(), &self.name, &self.extra].concat()
    }
}

/// The files one after the other, and the directory.
pub fn archive(files: &[Packed]) -> Vec<u8> {
    let (mut bytes, mut directory) = (vec![], vec![]);
    for file in files {
        directory.extend(file.entry(u32::try_from(bytes.len()).unwrap()));
        bytes.extend(file.local());
    }
    with_directory(bytes, &directory, files.len())
}

/// Local files followed by a directory that states `count` entries.
pub fn with_directory(files: Vec<u8>, directory: &[u8], count: usize) -> Vec<u8> {
    let offset = u32::try_from(files.len()).unwrap().to_le_bytes();
    let size = u32::try_from(directory.len()).unwrap().to_le_bytes();
    let count = u16::try_from(count).unwrap().to_le_bytes();
    let end = [&b"PK\x05\x06"[..], &[0; 4][..], &count, &count, &size, &offset, &[0; 2]].concat();
    [&files[..], directory, &end].concat()
}

/// The cyclic redundancy check with the reversed polynomial 0xedb88320, bit by bit.
pub fn checksum(bytes: &[u8]) -> u32 {
    let shifted = |rest: u32| (rest >> 1) ^ if rest & 1 == 1 { 0xedb8_8320 } else { 0 };
    !bytes.iter().fold(!0, |rest, &byte| (0..8).fold(rest ^ u32::from(byte), |rest, _| shifted(rest)))
}
