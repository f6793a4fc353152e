//! A file system within a file, the container of old Office documents: one stream of it.

/// Marks the end of a chain; larger numbers than this and some smaller ones are not sectors either.
const LAST_SECTOR: u32 = 0xffff_fff9;
/// Streams shorter than this are in the small sectors.
const SMALL_BELOW: usize = 4096;
/// Bytes of a sector of a short stream.
const SMALL_SECTOR: usize = 64;
/// Bytes of an entry of the directory.
const ENTRY: usize = 128;

/// The parts of the file that lead to its streams.
struct CompoundFile<'a> {
    bytes: &'a [u8],
    sector: usize,
    next: Vec<u32>,
    directory: Vec<u8>,
}

/// The bytes of the stream of this name, if the file is whole enough to have it.
pub(super) fn stream(bytes: &[u8], name: &str) -> Option<Vec<u8>> {
    let file = CompoundFile::open(bytes)?;
    let entry =
        file.entry(|entry| entry_name(entry).is_some_and(|entry_name| entry_name == name) && entry[66] == 2)?;
    let (start, size) = extent(entry)?;
    if size < SMALL_BELOW { file.small_stream(start, size) } else { file.chain(start, size) }
}

impl<'a> CompoundFile<'a> {
    fn open(bytes: &'a [u8]) -> Option<Self> {
        let sector =
            1_usize.checked_shl(u32::from(u16_at(bytes, 30)?)).filter(|size| [512, 4096].contains(size))?;
        let mut file = Self { bytes, sector, next: Vec::new(), directory: Vec::new() };
        for table in file.tables()? {
            file.next.extend(file.sector_at(table)?.chunks_exact(4).filter_map(|bytes| u32_at(bytes, 0)));
        }
        file.directory = file.chain(u32_at(bytes, 48)?, usize::MAX)?;
        Some(file)
    }

    /// The sectors of the allocation table: 109 are named in the header, the others in further sectors.
    fn tables(&self) -> Option<Vec<u32>> {
        let mut tables: Vec<u32> = (0..109).map_while(|index| u32_at(self.bytes, 76 + 4 * index)).collect();
        let mut more = u32_at(self.bytes, 68)?;
        for _ in 0..self.bytes.len() / self.sector {
            if more > LAST_SECTOR {
                break;
            }
            let sector = self.sector_at(more)?;
            tables.extend((0..self.sector / 4 - 1).filter_map(|index| u32_at(sector, 4 * index)));
            more = u32_at(sector, self.sector - 4)?;
        }
        tables.retain(|&table| table <= LAST_SECTOR);
        let whole = self.bytes.len() / self.sector;
        (tables.len() <= whole).then_some(tables)
    }

    fn sector_at(&self, number: u32) -> Option<&'a [u8]> {
        let start = (usize::try_from(number).ok()? + 1).checked_mul(self.sector)?;
        self.bytes.get(start..start.checked_add(self.sector)?)
    }

    /// The first bytes of a chain of sectors, which is never longer than the file.
    fn chain(&self, start: u32, size: usize) -> Option<Vec<u8>> {
        let (mut bytes, mut sector) = (Vec::new(), start);
        while sector <= LAST_SECTOR && bytes.len() < size {
            bytes.extend_from_slice(self.sector_at(sector)?);
            if bytes.len() > self.bytes.len() {
                return None;
            }
            sector = *self.next.get(usize::try_from(sector).ok()?)?;
        }
        if size != usize::MAX && bytes.len() < size {
            return None;
        }
        bytes.truncate(size);
        Some(bytes)
    }

    /// A short stream, in small sectors within the stream of the root.
    fn small_stream(&self, start: u32, size: usize) -> Option<Vec<u8>> {
        let root = self.entry(|entry| entry[66] == 5)?;
        let (root_start, root_size) = extent(root)?;
        let small = self.chain(root_start, root_size)?;
        let next = self.chain(u32_at(self.bytes, 60)?, usize::MAX)?;
        let (mut bytes, mut sector) = (Vec::new(), start);
        while bytes.len() < size {
            let number = usize::try_from(sector).ok()?;
            let from = number.checked_mul(SMALL_SECTOR)?;
            bytes.extend_from_slice(small.get(from..from.checked_add(SMALL_SECTOR)?)?);
            sector = u32_at(&next, number.checked_mul(4)?)?;
        }
        bytes.truncate(size);
        Some(bytes)
    }

    fn entry(&self, is_it: impl Fn(&[u8]) -> bool) -> Option<&[u8]> {
        self.directory.chunks_exact(ENTRY).find(|entry| is_it(entry))
    }
}

fn entry_name(entry: &[u8]) -> Option<String> {
    let letters = usize::from(u16_at(entry, 64)?).checked_sub(2)? / 2;
    let letters: Vec<u16> = (0..letters.min(31)).filter_map(|index| u16_at(entry, 2 * index)).collect();
    String::from_utf16(&letters).ok()
}

/// The first sector and the number of bytes.
fn extent(entry: &[u8]) -> Option<(u32, usize)> {
    Some((u32_at(entry, 116)?, usize::try_from(u32_at(entry, 120)?).ok()?))
}

pub(super) fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_le_bytes(bytes.get(at..at.checked_add(2)?)?.try_into().ok()?))
}

pub(super) fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}
