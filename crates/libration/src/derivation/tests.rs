//! Derivations are made, and what is wrong cannot be.

use super::*;

#[test]
fn dump() {
    let start = std::time::Instant::now();
    match elliptic(None) {
        Ok(d) => {
            std::fs::write("/tmp/e.html", to_html(&d)).unwrap();
            std::fs::write("/tmp/e.tex", to_latex(&d)).unwrap();
            std::fs::write("/tmp/e.md", to_markdown(&d)).unwrap();
        }
        Err(e) => panic!("{e}"),
    }
    eprintln!("{:?}", start.elapsed());
    match formulas(None) {
        Ok(d) => {
            std::fs::write("/tmp/f.html", to_html(&d)).unwrap();
            std::fs::write("/tmp/f.tex", to_latex(&d)).unwrap();
            std::fs::write("/tmp/f.md", to_markdown(&d)).unwrap();
        }
        Err(e) => panic!("{e}"),
    }
    eprintln!("{:?}", start.elapsed());
}
