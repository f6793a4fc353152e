//! Archives as other programs write them, and hostile ones.

use super::Case;
use super::packed::{csv, truth};
use libration_testing::zip_archive::{Packed, archive, checksum, with_directory};

pub(crate) fn cases() -> Vec<Case> {
    [kinds(), names(), refused(), crowded(), misplaced()].into_iter().flatten().collect()
}

fn table() -> Packed {
    Packed::deflated("table.csv", csv().as_bytes())
}

fn kinds() -> Vec<Case> {
    let plain = csv();
    let streamed = Packed { flags: Packed::DESCRIPTOR, ..table() };
    let remark = |remark: &[u8]| {
        let mut bytes = archive(&[table()]);
        let end = bytes.len() - 2;
        bytes[end..].copy_from_slice(&u16::try_from(remark.len()).unwrap().to_le_bytes());
        [&bytes, remark].concat()
    };
    let folders = [Packed::stored("run/", b""), Packed::deflated("run/table.csv", plain.as_bytes())];
    vec![
        Case::read("not packed", archive(&[Packed::stored("table.csv", plain.as_bytes())]), truth()),
        Case::read("sizes behind the file", archive(&[streamed]), truth()),
        Case::read("a folder", archive(&folders), truth()),
        Case::read("a remark", remark(b"exported by hand"), truth()),
        Case::refused("a remark that is cut off", &remark(b"exported")[..table_size() + 4], &["ZIP archive"]),
        Case::read("sizes of eight bytes", large(1), truth()),
        Case::refused("and more files than it has", large(2), &["lists 1 files and not 2"]),
    ]
}

/// The size of an archive with the table alone.
fn table_size() -> usize {
    archive(&[table()]).len()
}

/// The table in an archive of the form for more than four gigabytes, which states a number of files.
fn large(count: u64) -> Vec<u8> {
    let table = table();
    let sizes = [u64::from(table.size), table.bytes.len() as u64, 0];
    let field = [1_u16, 24].iter().flat_map(|number| number.to_le_bytes());
    let extra = field.chain(sizes.iter().flat_map(|number| number.to_le_bytes())).collect();
    let mut entry = Packed { extra, ..table.clone() }.entry(u32::MAX);
    entry[20..28].fill(0xff);
    let files = table.local();
    let offset = files.len() as u64;
    let end = offset + entry.len() as u64;
    let long = |numbers: &[u64]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let record = [
        &b"PK\x06\x06"[..],
        &long(&[44])[..],
        &[45, 0, 45, 0],
        &[0; 8],
        &long(&[count, count, entry.len() as u64, offset]),
    ];
    let locator = [&b"PK\x06\x07"[..], &[0; 4][..], &long(&[end]), &[1, 0, 0, 0]];
    let short = [&b"PK\x05\x06"[..], &[0; 4][..], &[0xff; 12], &[0; 2]];
    [files, entry, record.concat(), locator.concat(), short.concat()].concat()
}

fn names() -> Vec<Case> {
    let plain = csv();
    let named = |name: &[u8]| Packed::deflated(name, plain.as_bytes());
    let both = |first: Packed, second: Packed| archive(&[first, second]);
    // `Zähler.csv` in the code page 437, in UTF-8, and in UTF-8 with a name without the letter.
    let of_code_page = named(b"Z\x84hler.csv");
    let of_unicode = named("Zähler.csv".as_bytes());
    let beside = |checksum: u32| {
        let unicode = [&[1], &checksum.to_le_bytes()[..], "Zähler.csv".as_bytes()].concat();
        let size = u16::try_from(unicode.len()).unwrap().to_le_bytes();
        Packed { extra: [&[0x75, 0x70], &size[..], &unicode].concat(), ..named(b"Z_hler.csv") }
    };
    let other = || named(b"other.csv");
    let first = Packed::deflated("table.csv", b"1,2\n");
    vec![
        Case::refused("a name of the code page", both(of_code_page, other()), &["Zähler or other"]),
        Case::refused("a name in Unicode", both(of_unicode, other()), &["Zähler or other"]),
        Case::refused("a second name", both(beside(checksum(b"Z_hler.csv")), other()), &["Zähler or other"]),
        Case::refused("that of another file", both(beside(0), other()), &["Z_hler or other"]),
        Case::read("a name that leads out", archive(&[named(b"../../table.csv")]), truth()),
        Case::read("a name twice", both(first, table()), truth()),
    ]
}

fn refused() -> Vec<Case> {
    let table = table();
    let with = |change: &dyn Fn(&mut Packed)| {
        let mut changed = table.clone();
        change(&mut changed);
        archive(&[changed])
    };
    vec![
        Case::refused("with a password", with(&|entry| entry.flags = 1), &["Password required"]),
        Case::refused("packed otherwise", with(&|entry| entry.method = 12), &["method not supported: 12"]),
        Case::refused("a wrong checksum", with(&|entry| entry.checksum ^= 1), &["checksum"]),
        Case::refused("a wrong size", with(&|entry| entry.size -= 1), &["size"]),
        Case::refused("cut off within", with(&|entry| entry.bytes.truncate(20)), &["ZIP archive"]),
        Case::refused("not packed at all", with(&|entry| entry.bytes.fill(0xff)), &["ZIP archive"]),
        Case::refused("nothing packed", with(&|entry| entry.bytes.clear()), &["ZIP archive"]),
    ]
}

/// More files, and larger contents, than allowed.
fn crowded() -> Vec<Case> {
    let many = |count: usize| {
        let files = (0..count).map(|n| Packed::stored(format!("{n}.png"), b""));
        archive(&files.chain([table()]).collect::<Vec<_>>())
    };
    let large = |name: &str| Packed::deflated(name, &vec![b'0'; 400_000]);
    let hidden = Packed { size: 10, checksum: 0, ..Packed::deflated("a.csv", &vec![b'0'; 1 << 21]) };
    let stored = Packed { method: 0, ..Packed::stored("b.png", &vec![0; 400_000]) };
    let together = [large("a.png"), large("c.png"), stored, table()];
    vec![
        Case::read("a thousand files", many(999), truth()),
        Case::refused("a thousand and one", many(1000), &["1001 files"]),
        Case::refused("too much together", archive(&together), &["limit"]),
        Case::refused("more than it says", archive(&[hidden]), &["limit"]),
    ]
}

/// A directory that lists wrong files, or one position for several.
fn misplaced() -> Vec<Case> {
    let (table, picture) = (table(), Packed::stored("a.png", b"\x89PNG"));
    let files = [table.local(), picture.local()].concat();
    let offset = u32::try_from(table.local().len()).unwrap();
    let directory = [table.entry(0), picture.entry(offset)].concat();
    let counted = |count| with_directory(files.clone(), &directory, count);
    let placed =
        |start: u32| with_directory(files.clone(), &[table.entry(0), picture.entry(start)].concat(), 2);
    let beyond = Packed { bytes: vec![0; 5], size: 5, ..picture.clone() };
    let beyond = with_directory(files.clone(), &[table.entry(0), beyond.entry(offset)].concat(), 2);
    let same = Packed { name: b"b.png".to_vec(), ..table.clone() };
    let same = with_directory(files.clone(), &[table.entry(0), same.entry(0)].concat(), 2);
    vec![
        Case::read("two files", counted(2), truth()),
        Case::refused("one less than it lists", counted(1), &["lists 2 files and not 1"]),
        Case::refused("one more than it lists", counted(3), &["lists 2 files and not 3"]),
        Case::refused("two files in one place", same, &["overlap"]),
        Case::refused("a file that reaches into the directory", beyond, &["overlap"]),
        Case::refused("no file where one is listed", placed(offset - 1), &["ZIP archive"]),
        Case::refused("a place beyond the end", placed(1 << 30), &["ZIP archive"]),
    ]
}
