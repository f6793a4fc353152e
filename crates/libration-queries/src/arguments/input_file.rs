//! The bytes of an input file, limited in number whatever the file is.

use crate::call;
use crate::host::InputFile;
use crate::query_error::QueryError;
use libration_lab::measurement::ReadOptions;
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a file or, for `-`, of the standard input, as many as a table may have.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, QueryError> {
    read_at_most(path, ReadOptions::DEFAULT_SIZE_LIMIT)
}

/// The bytes with another limit. A file whose size is known is refused before it is read; pipes and devices are read up to
/// the limit.
pub(crate) fn read_at_most(path: &Path, limit: usize) -> Result<Vec<u8>, QueryError> {
    let cannot = |error: io::Error| {
        let reason = format!("cannot read {}: {error}", path.display());
        match error.kind() {
            io::ErrorKind::NotFound => QueryError::missing_file(reason),
            _ => QueryError::failed(reason),
        }
    };
    let call = call::current();
    if path.as_os_str() == "-" {
        return within(&mut call.host().read(), path, limit).map_err(cannot)?;
    }
    let InputFile { size, mut bytes } = call.host().open(path).map_err(cannot)?;
    match usize::try_from(size) {
        Ok(size) if size <= limit => within(&mut bytes, path, limit).map_err(cannot)?,
        _ => Err(too_large(path, &format!("has {size} bytes"), limit)),
    }
}

fn within(from: &mut dyn Read, path: &Path, limit: usize) -> io::Result<Result<Vec<u8>, QueryError>> {
    let mut bytes = vec![];
    from.take(limit as u64 + 1).read_to_end(&mut bytes)?;
    Ok(match bytes.len() <= limit {
        true => Ok(bytes),
        false => Err(too_large(path, "is longer than that", limit)),
    })
}

fn too_large(path: &Path, how: &str, limit: usize) -> QueryError {
    let reason = format!("it {how}, and at most {limit} bytes are read: give a part of it");
    QueryError::no_result(&path.display().to_string(), reason)
}
