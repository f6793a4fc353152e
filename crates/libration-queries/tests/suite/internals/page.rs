//! The page that is written.

use libration_queries::internals::page::write;

#[test]
fn a_page_is_written_and_none_is_explained() {
    let path = std::env::temp_dir().join(format!("libration-page-{}.html", std::process::id()));
    write(Some(b"<!doctype html>"), &path).unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"<!doctype html>");
    std::fs::remove_file(&path).unwrap();
    assert!(write(None, &path).unwrap_err().to_string().contains("web/build"));
    assert!(!path.exists());
}
