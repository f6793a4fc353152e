//! Tables for LaTeX.

use libration_queries::internals::document::DocumentTable;
use libration_queries::internals::latex::tabular;
use libration_queries::internals::table::Column;

#[test]
fn what_latex_would_take_for_its_own_is_spelled_out() {
    let table = DocumentTable {
        caption: "Two".to_owned(),
        columns: vec![Column::words("name"), Column::numbers("T₀ / s")],
        rows: vec![vec![r"a_b & 50 % \input{x}".to_owned(), "1.5 ± 0.1".to_owned()]],
    };
    let expected = "% Two\n\\begin{tabular}{lr}\n\\hline\nname & T$_0$ / s \\\\\n\\hline\n\
                    a\\_b \\& 50 \\% \\textbackslash{}input\\{x\\} & 1.5 $\\pm$ 0.1 \\\\\n\\hline\n\\end{tabular}\n";
    assert_eq!(tabular(&table), expected);
}
