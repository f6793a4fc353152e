//! The page goes into the command where the variable `LIBRATION_PAGE` names its file.

use std::env;
use std::error::Error;
use std::fs;
use std::path::{Path, absolute};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=LIBRATION_PAGE");
    let page = match env::var_os("LIBRATION_PAGE") {
        Some(path) => {
            let path = absolute(path)?;
            println!("cargo::rerun-if-changed={}", path.display());
            format!("Some(include_bytes!({path:?}))")
        }
        None => "None".to_owned(),
    };
    let out = env::var_os("OUT_DIR").ok_or("cargo says where to write")?;
    Ok(fs::write(Path::new(&out).join("page.rs"), page)?)
}
