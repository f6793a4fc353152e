//! What the fields of an inspected file mean.

use crate::output::description::{Answers, Row, descriptions};

const JSON: &[Row] = &[
    ("file", "", "name of the file"),
    ("bytes", "1", "size of the file"),
    ("format", "", "kind of file, with the encoding of text"),
    ("sheets[].name", "", "name of the sheet, empty in text"),
    ("sheets[].delimiter", "", "what stands between columns"),
    ("sheets[].decimal", "", "decimal mark"),
    ("sheets[].header_line", "1", "number of the line with the names of the columns, or null"),
    ("sheets[].rows", "1", "rows of the table"),
    ("sheets[].columns[].number", "1", "number of the column, from 1"),
    ("sheets[].columns[].name", "", "header of the column"),
    ("sheets[].columns[].quantity", "", "quantity that the header names, or –"),
    ("sheets[].columns[].unit", "", "unit that the header names, or null"),
    ("sheets[].columns[].run", "", "run that the header names, or null"),
    ("sheets[].columns[].numbers", "1", "cells that are numbers"),
    ("sheets[].columns[].blanks", "1", "cells that are blank"),
    ("sheets[].columns[].words", "1", "cells that are neither"),
    ("sheets[].columns[].smallest", "", "smallest number, in the unit of the file, or null"),
    ("sheets[].columns[].largest", "", "largest number, in the unit of the file, or null"),
    ("traces[].name", "", "name of the run"),
    ("traces[].seen", "", "what was measured: angle or angular velocity"),
    ("traces[].unit", "", "unit of what was measured, after conversion"),
    ("traces[].rows", "1", "rows that would be fitted"),
    ("traces[].first_time_s", "s", "time of the first row"),
    ("traces[].last_time_s", "s", "time of the last row"),
    ("traces[].interval_s", "s", "time from row to row, or null where it varies"),
    ("traces[].jitter_s", "s", "scatter of that time, or null"),
    ("traces[].smallest", "", "smallest value, in the unit above"),
    ("traces[].largest", "", "largest value, in the unit above"),
    ("traces[].has_uncertainties", "", "whether the rows have uncertainties"),
    ("gate_times", "1", "number of times of a photogate, or null"),
    ("findings[].text", "", "what was concluded from the file"),
    ("findings[].option", "", "option that overrides it, or null"),
    ("undecided.why", "", "why there is no trace"),
    ("undecided.options[]", "", "options that would decide it"),
];

const CSV: &[Row] = &[
    ("sheet", "", "name of the sheet, empty in text"),
    ("column", "1", "number of the column, from 1"),
    ("name", "", "header of the column"),
    ("quantity", "", "quantity that the header names, or –"),
    ("unit", "", "unit that the header names"),
    ("run", "", "run that the header names"),
    ("numbers", "1", "cells that are numbers"),
    ("blanks", "1", "cells that are blank"),
    ("words", "1", "cells that are neither"),
    ("smallest", "", "smallest number, in the unit of the file"),
    ("largest", "", "largest number, in the unit of the file"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (descriptions("", JSON), descriptions("", CSV));
    vec![Answers { command: "inspect", option: "", json, csv }]
}
