//! Correlations of inputs through their common causes: `length,bob-radius=0.9`.

use libration_lab::fit::{BudgetInput, Correlation};

/// Reads `NAME,NAME=R`.
pub(super) fn correlation(text: &str) -> Result<Correlation, String> {
    let form = || "give two inputs and a number from -1 to 1, such as length,bob-radius=0.9".to_owned();
    let (names, coefficient) = text.split_once('=').ok_or_else(form)?;
    let (one, other) = names.split_once(',').ok_or_else(form)?;
    let coefficient =
        coefficient.trim().parse().ok().filter(|r| (-1.0..=1.0).contains(r)).ok_or_else(form)?;
    Ok(Correlation { between: [input(one)?, input(other)?], coefficient })
}

fn input(name: &str) -> Result<BudgetInput, String> {
    let option = |input: BudgetInput| input.name().replace(' ', "-");
    // The slope stands for all inputs of a line, and is not one of those of a single pendulum.
    let mut inputs = BudgetInput::ALL.into_iter().filter(|input| *input != BudgetInput::Slope);
    inputs.clone().find(|input| option(*input) == name.trim()).ok_or_else(|| {
        let names: Vec<String> = inputs.by_ref().map(option).collect();
        format!("`{}` is not an input; the inputs are {}", name.trim(), names.join(", "))
    })
}
