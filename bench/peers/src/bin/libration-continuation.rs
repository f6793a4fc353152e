//! The part of libration in `bench/peers/continuation`. For each line of input the program follows the response curve of the driven pendulum
//! once and prints the seconds, the number of points and the frequencies of the folds.

use libration::continuation::{BranchError, Response, ResponseOptions, SpecialKind};
use libration::progress::Quiet;
use std::error::Error;
use std::io::{self, BufRead, Write};
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let equation = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
    let options = ResponseOptions { generations: 0, ..ResponseOptions::default() };
    let followed =
        || -> Result<Response, BranchError> { Response::over(&equation, "w", [0.3, 1.4], &options, &Quiet) };
    for line in io::stdin().lock().lines() {
        line?;
        let start = Instant::now();
        let response = followed()?;
        let seconds = start.elapsed().as_secs_f64();
        let branch = &response.branches[0];
        let folds = branch.special.iter().filter(|it| it.kind == SpecialKind::Fold);
        let folds: Vec<String> = folds.map(|it| format!("{:?}", it.point.parameter)).collect();
        let mut out = io::stdout();
        writeln!(out, "{seconds:?} {} {}", branch.points.len(), folds.join(" "))?;
        out.flush()?;
    }
    Ok(())
}
