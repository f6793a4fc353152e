//! All questions of the command, for a page: words and files in, parts of the answer and written files out.
//!
//! # Method
//! The page runs the commands of the command line, with the same words, in a worker, and gets the same bytes. A worker that panics is ended and
//! created anew; its output until then is kept. A page from a disk has no memory that workers share, but browsers let a module wait for a promise
//! (`web/src/engine/suspension.ts`): every 50 ms the run checks its `Host`, and meanwhile the worker receives a cancellation. The result is then
//! that of the command after Ctrl-C: the finished part. Where a browser lacks this the worker is ended. On its only thread the work reports its
//! progress itself, at each check (`parallel::update` of the command).

pub mod ensemble;
mod host;
mod page;

use host::PageHost;
use libration_web::exchange::exchange;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, Once, PoisonError};

/// Input that the page has given for the next command.
#[derive(Debug, Default)]
struct Given {
    words: Vec<OsString>,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

static GIVEN: Mutex<Given> = Mutex::new(Given { words: Vec::new(), files: BTreeMap::new() });

/// The bytes of the exchange are the next word of the question.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn argument() {
    let word = String::from_utf8_lossy(&std::mem::take(&mut exchange().given)).into_owned();
    GIVEN.lock().unwrap_or_else(PoisonError::into_inner).words.push(word.into());
}

/// The bytes of the exchange are the name of a file, of the given length, followed by its contents.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn file(name_length: usize) {
    let mut bytes = std::mem::take(&mut exchange().given);
    let holds = bytes.split_off(name_length.min(bytes.len()));
    let name = String::from_utf8_lossy(&bytes).into_owned();
    GIVEN.lock().unwrap_or_else(PoisonError::into_inner).files.insert(name.into(), holds);
}

/// Runs the query; returns its exit status.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> u8 {
    tell_of_panics();
    let Given { words, files } = take_given();
    match libration_queries::ask(words, Arc::new(PageHost::new(files))) {
        Ok(()) => 0,
        Err(error) => {
            page::error(&error.to_json());
            error.status()
        }
    }
}

fn take_given() -> Given {
    std::mem::take(&mut *GIVEN.lock().unwrap_or_else(PoisonError::into_inner))
}

fn tell_of_panics() {
    static TELL_OF_PANICS: Once = Once::new();
    TELL_OF_PANICS.call_once(|| std::panic::set_hook(Box::new(|panic| page::fault(&panic.to_string()))));
}
