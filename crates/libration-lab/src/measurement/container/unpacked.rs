//! A ZIP archive → its files, unpacked and checked.
//!
//! Sizes are counted, since those stated in the archive may be wrong. The directory at its end lists the files with their positions; files that
//! share bytes, with each other or with the directory, are refused.

use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive, ZipVerification, crc32};

use super::super::MeasurementError;
use super::entry_name::entry_name;
use super::part::ArchiveFile;

/// More files than any export has.
const MOST_FILES: usize = 1000;

/// All files, which together have at most `limit` bytes. Of files with one name the last one counts.
pub(super) fn parts(bytes: &[u8], limit: usize) -> Result<Vec<ArchiveFile>, MeasurementError> {
    let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
    let entries = entries(&archive)?;
    check_places(&archive, &entries)?;
    let (mut parts, mut size): (Vec<ArchiveFile>, usize) = (Vec::new(), 0);
    for entry in &entries {
        let name = entry_name(entry);
        let bytes = unpacked(&archive, entry, limit - size)?;
        size += bytes.len();
        if size > limit {
            return Err(MeasurementError::TooLarge { size, limit });
        }
        match parts.iter_mut().find(|part| part.name == name) {
            Some(earlier) => earlier.bytes = bytes,
            None => parts.push(ArchiveFile { name, bytes }),
        }
    }
    Ok(parts)
}

/// Entries of the directory, if their number is as stated and within the limit.
fn entries<'a>(
    archive: &'a ZipSliceArchive<&[u8]>,
) -> Result<Vec<ZipFileHeaderRecord<'a>>, MeasurementError> {
    let told = usize::try_from(archive.entries_hint()).unwrap_or(usize::MAX);
    if told > MOST_FILES {
        return Err(damaged(format!("it has {told} files")));
    }
    let listed = archive.entries().take(MOST_FILES + 1);
    let entries: Vec<_> = listed.collect::<Result<_, _>>().map_err(damaged)?;
    if entries.len() != told {
        return Err(damaged(format!("its directory lists {} files and not {told}", entries.len())));
    }
    Ok(entries)
}

/// Refuses files that share bytes: a small archive of them would unpack to far too much.
fn check_places(
    archive: &ZipSliceArchive<&[u8]>,
    entries: &[ZipFileHeaderRecord<'_>],
) -> Result<(), MeasurementError> {
    let extent = |entry: &ZipFileHeaderRecord<'_>| {
        let (_, end) = archive.get_entry(entry.wayfinder())?.compressed_data_range();
        Ok((entry.local_header_offset(), end))
    };
    let mut extents: Vec<(u64, u64)> =
        entries.iter().map(extent).collect::<Result<_, rawzip::Error>>().map_err(damaged)?;
    extents.push((archive.directory_offset(), u64::MAX));
    extents.sort_unstable();
    if extents.windows(2).any(|pair| pair[0].1 > pair[1].0) {
        return Err(damaged("its files overlap"));
    }
    Ok(())
}

/// The bytes of a file, compared with the checksum in the directory; one byte more than the room if there are more.
fn unpacked(
    archive: &ZipSliceArchive<&[u8]>,
    entry: &ZipFileHeaderRecord<'_>,
    room: usize,
) -> Result<Vec<u8>, MeasurementError> {
    if entry.flags().is_encrypted() {
        return Err(damaged("unsupported Zip archive: Password required to decrypt file"));
    }
    let packed = archive.get_entry(entry.wayfinder()).map_err(damaged)?;
    let most = room.saturating_add(1);
    let bytes = match entry.compression_method() {
        CompressionMethod::STORE => packed.data()[..packed.data().len().min(most)].to_vec(),
        CompressionMethod::DEFLATE => inflated(packed.data(), most)?,
        other => return Err(damaged(format!("compression method not supported: {}", other.as_u16()))),
    };
    if bytes.len() <= room {
        let actual = ZipVerification { crc: crc32(&bytes), uncompressed_size: bytes.len() as u64 };
        packed.claim_verifier().valid(actual).map_err(damaged)?;
    }
    Ok(bytes)
}

/// Decompresses data to at most `most` bytes.
fn inflated(packed: &[u8], most: usize) -> Result<Vec<u8>, MeasurementError> {
    decompress_to_vec_with_limit(packed, most).or_else(|error| match error.status {
        TINFLStatus::HasMoreOutput => Ok(error.output),
        _ => Err(damaged(error)),
    })
}

fn damaged(why: impl ToString) -> MeasurementError {
    MeasurementError::DamagedArchive(why.to_string())
}
