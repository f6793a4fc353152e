//! Small parameters with their orders, and resonances.

use crate::query_error::{QueryError, option};

/// Small parameters with their orders: `eps`, or `a2:1,a3:2`.
pub(crate) fn small_orders(text: &str) -> Result<Vec<(String, usize)>, QueryError> {
    let one = |part: &str| {
        let (name, order) = part.split_once(':').unwrap_or((part, "1"));
        let order = order.trim().parse().map_err(|_| {
            QueryError::usage(
                option("small"),
                format!("cannot read the order in `{}`: give a2:1,a3:2", part.trim()),
            )
        })?;
        Ok((name.trim().to_owned(), order))
    };
    text.split(',').map(one).collect()
}

/// The resonance of a drive: p and q of `p/q`.
pub(crate) fn drive_resonance(text: &str) -> Result<(u32, u32), QueryError> {
    let pair = text.split_once('/').and_then(|(p, q)| Some((p.trim().parse().ok()?, q.trim().parse().ok()?)));
    pair.ok_or_else(|| {
        let reason =
            format!("cannot read `{}`: give drive over natural frequency, such as 1/1 or 1/3", text.trim());
        QueryError::usage(option("resonance"), reason)
    })
}

/// Natural frequencies as whole numbers, `1:2`.
pub(crate) fn frequency_ratios(text: &str) -> Result<Vec<u32>, QueryError> {
    let ratios: Option<Vec<u32>> = text.split(':').map(|part| part.trim().parse().ok()).collect();
    ratios.ok_or_else(|| {
        let reason =
            format!("cannot read `{}`: give a whole number for each coordinate, such as 1:2", text.trim());
        QueryError::usage(option("ratios"), reason)
    })
}
