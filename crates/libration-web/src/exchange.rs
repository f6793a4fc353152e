//! The memory in which the page and the module exchange texts and numbers.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Contents of the exchange.
#[derive(Debug)]
pub struct Exchange {
    /// Input from the page: a text in UTF-8, or the bytes of a file.
    pub given: Vec<u8>,
    /// Numbers for the page.
    pub numbers: Vec<f64>,
    /// Text for the page, or the reason why there is no result.
    pub text: String,
}

static EXCHANGE: Mutex<Exchange> =
    Mutex::new(Exchange { given: Vec::new(), numbers: Vec::new(), text: String::new() });

/// The exchange, for as long as the result lives.
pub fn exchange() -> MutexGuard<'static, Exchange> {
    EXCHANGE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Exchange {
    /// Takes the input of the page as text.
    ///
    /// # Errors
    /// In words, where it is none.
    pub fn take_text(&mut self) -> Result<String, String> {
        String::from_utf8(std::mem::take(&mut self.given)).map_err(|error| error.to_string())
    }

    /// Leaves numbers, or the reason why there are none; `true` if there are numbers.
    pub fn answer(&mut self, answer: Result<Vec<f64>, String>) -> bool {
        let answered = answer.is_ok();
        (self.numbers, self.text) = match answer {
            Ok(numbers) => (numbers, String::new()),
            Err(reason) => (vec![], reason),
        };
        answered
    }
}

/// Makes room for a number of bytes of the page, and returns their address.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    let mut exchange = exchange();
    exchange.given.clear();
    exchange.given.resize(length, 0);
    exchange.given.as_mut_ptr()
}

/// Address of the numbers.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    exchange().numbers.as_ptr()
}

/// Number of the numbers.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn numbers_count() -> usize {
    exchange().numbers.len()
}

/// Address of the text.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    exchange().text.as_ptr()
}

/// Number of bytes of the text.
#[expect(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    exchange().text.len()
}
