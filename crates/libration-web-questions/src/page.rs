//! Functions that the page provides: output, progress, and cancellation.
#![expect(unsafe_code, reason = "functions of the page, which read the memory that they are given")]

#[cfg_attr(target_arch = "wasm32", link(wasm_import_module = "page"))]
unsafe extern "C" {
    #[link_name = "output"]
    fn page_output(at: *const u8, length: usize);
    #[link_name = "note"]
    fn page_note(at: *const u8, length: usize);
    #[link_name = "progress"]
    fn page_progress(at: *const u8, length: usize);
    #[link_name = "error"]
    fn page_error(at: *const u8, length: usize);
    #[link_name = "fault"]
    fn page_fault(at: *const u8, length: usize);
    #[link_name = "written"]
    fn page_written(name: *const u8, name_length: usize, at: *const u8, length: usize);
    #[link_name = "goes_on"]
    safe fn page_goes_on() -> i32;
    #[link_name = "milliseconds"]
    safe fn page_milliseconds() -> f64;
}

/// The next part of the result.
pub(crate) fn output(bytes: &[u8]) {
    // SAFETY: the page copies these bytes before it returns.
    unsafe { page_output(bytes.as_ptr(), bytes.len()) }
}

/// A sentence with the result.
pub(crate) fn note(sentence: &str) {
    // SAFETY: as above.
    unsafe { page_note(sentence.as_ptr(), sentence.len()) }
}

/// Progress of long work; empty when it has ended.
pub(crate) fn progress(how_far: &str) {
    // SAFETY: as above.
    unsafe { page_progress(how_far.as_ptr(), how_far.len()) }
}

/// The reason why there is no result, as JSON.
pub(crate) fn error(json: &str) {
    // SAFETY: as above.
    unsafe { page_error(json.as_ptr(), json.len()) }
}

/// Message of a panic, which ends the module.
pub(crate) fn fault(reason: &str) {
    // SAFETY: as above.
    unsafe { page_fault(reason.as_ptr(), reason.len()) }
}

/// A file that was written.
pub(crate) fn written(name: &str, bytes: &[u8]) {
    // SAFETY: as above.
    unsafe { page_written(name.as_ptr(), name.len(), bytes.as_ptr(), bytes.len()) }
}

/// Returns `true` if the command may continue: the page handles the messages received meanwhile, which takes a moment.
pub(crate) fn goes_on() -> bool {
    page_goes_on() != 0
}

/// Milliseconds since 1970.
pub(crate) fn milliseconds() -> f64 {
    page_milliseconds()
}
