//! The result at one point of a sweep.

use crate::call::{self, Call};
use crate::command;
use crate::host::Host;
use crate::query_error::QueryError;
use serde_json::Value;
use std::ffi::OsString;
use std::io;
use std::sync::Arc;

/// The result to a question as JSON, in this process.
pub(crate) fn answer(words: &[String]) -> Result<Value, QueryError> {
    let mut words: Vec<OsString> = words.iter().map(Into::into).collect();
    let end = words.iter().position(|word| word == "--").unwrap_or(words.len());
    words.insert(end, "--json".into());
    let call = Call::new(words.clone(), Arc::new(PointHost(call::current())));
    call::within(&call, || {
        let mut json = vec![];
        command::write(&command::matches_of_query(words)?, &mut json)?;
        let none = || QueryError::failed("the result is not on the standard output");
        serde_json::from_slice(&json).map_err(|_| none())
    })
}

/// The host of a point, whose progress is shown by the sweep alone.
struct PointHost(Arc<Call>);

impl Host for PointHost {
    fn write(&self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn goes_on(&self) -> bool {
        !self.0.is_cancelled()
    }
}

/// A reason in one line.
pub(crate) fn reason(failure: &QueryError) -> String {
    failure.to_string().split_whitespace().collect::<Vec<_>>().join(" ")
}
