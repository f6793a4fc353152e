//! Functions as they are laid out in each language.

use super::Language;
use std::fmt;

/// The names of letters and variables, changed where the language has them for itself.
pub(super) struct Names {
    /// Each letter with its name in the program.
    pub(super) letters: Vec<(String, String)>,
    /// The name that stands for ω0 in coefficients, with its name in the program.
    pub(super) root: Option<(String, String)>,
    arguments: Vec<(&'static str, String)>,
    pub(super) sum: String,
    pub(super) phase: String,
    pub(super) displacement: String,
}

impl Names {
    pub(super) fn new(language: Language, letters: &[String], root: Option<&str>) -> Self {
        let mut taken: Vec<String> = vec![];
        let mut free = |name: &str| {
            let mut name = name.to_owned();
            while language.is_reserved(&name) || taken.contains(&language.folded(&name)) {
                name.push('_');
            }
            taken.push(language.folded(&name));
            name
        };
        let letters = letters.iter().map(|letter| (letter.clone(), free(letter))).collect();
        let root = root.map(|name| (name.to_owned(), free(name)));
        let arguments = ["amplitude", "strength", "time"].map(|name| (name, free(name))).to_vec();
        let (sum, phase, displacement) = (free("series"), free("phase"), free("x"));
        Self { letters, root, arguments, sum, phase, displacement }
    }

    /// The name of a letter in the program.
    pub(super) fn letter(&self, name: &str) -> String {
        let mut letters = self.letters.iter().chain(&self.root);
        letters.find(|(own, _)| own == name).map_or_else(|| name.to_owned(), |(_, changed)| changed.clone())
    }

    /// The name of an argument that is not a letter.
    pub(super) fn argument(&self, name: &str) -> String {
        let argument = self.arguments.iter().find(|(own, _)| *own == name);
        argument.map_or_else(|| name.to_owned(), |(_, changed)| changed.clone())
    }
}

/// A function of real numbers.
pub(super) struct Function {
    name: &'static str,
    meaning: &'static str,
    arguments: Vec<String>,
    /// Variables with their values, in the order in which they get them.
    steps: Vec<(String, String)>,
    pub(super) result: String,
}

impl Function {
    pub(super) fn new(name: &'static str, meaning: &'static str, arguments: Vec<String>) -> Self {
        Self { name, meaning, arguments, steps: vec![], result: String::new() }
    }

    /// Gives a variable a value, or another one.
    pub(super) fn define(&mut self, variable: &str, value: String) {
        self.steps.push((variable.to_owned(), value));
    }

    /// The variables, each once.
    fn variables(&self) -> Vec<&str> {
        let mut variables: Vec<&str> = vec![];
        for (variable, _) in &self.steps {
            if !variables.contains(&variable.as_str()) {
                variables.push(variable);
            }
        }
        variables
    }
}

/// Functions beneath a comment.
pub(super) struct Program {
    pub(super) language: Language,
    pub(super) comment: Vec<String>,
    pub(super) functions: Vec<Function>,
}

impl fmt::Display for Program {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mark = match self.language {
            Language::C | Language::Rust => "//",
            Language::Python => "#",
            Language::Fortran => "!",
        };
        for line in self.comment.iter().flat_map(|line| folded(line, 90)) {
            writeln!(formatter, "{mark} {line}")?;
        }
        let opening = match self.language {
            Language::C => "#include <math.h>\n",
            Language::Python => "from math import cos, sin, sqrt\n\n",
            Language::Rust => "",
            Language::Fortran => {
                "module oscillator\n  use, intrinsic :: iso_fortran_env, only: real64\n  implicit none\ncontains\n"
            }
        };
        formatter.write_str(opening)?;
        for (place, function) in self.functions.iter().enumerate() {
            let gap = if place > 0 && self.language == Language::Python { "\n\n" } else { "\n" };
            write!(formatter, "{gap}{}", self.written(function))?;
        }
        formatter.write_str(if self.language == Language::Fortran { "\nend module oscillator\n" } else { "" })
    }
}

impl Program {
    fn written(&self, function: &Function) -> String {
        let Function { name, meaning, arguments, steps, result } = function;
        let typed = |before: &str, after: &str| {
            arguments.iter().map(|name| format!("{before}{name}{after}")).collect::<Vec<_>>().join(", ")
        };
        let (head, foot) = match self.language {
            Language::C => {
                (format!("// {meaning}\ndouble {name}({})\n{{\n", typed("double ", "")), "}\n".to_owned())
            }
            Language::Rust => (
                format!("/// {meaning}\npub fn {name}({}) -> f64 {{\n", typed("", ": f64")),
                "}\n".to_owned(),
            ),
            Language::Python => {
                (format!("def {name}({}):\n    \"\"\"{meaning}\"\"\"\n", typed("", "")), String::new())
            }
            Language::Fortran => (self.fortran_head(function), format!("  end function {name}\n")),
        };
        let steps = steps.iter().enumerate().map(|(place, step)| self.step(function, place, step));
        head + &steps.collect::<String>() + &self.returned(name, result) + &foot
    }

    fn fortran_head(&self, function: &Function) -> String {
        let Function { name, meaning, arguments, .. } = function;
        let list = arguments.join(", ");
        let mut head = format!("  ! {meaning}\n  pure real(real64) function {name}({list})\n");
        head += &broken(&format!("    real(real64), intent(in) :: {list}"), self.language);
        let variables = function.variables();
        if !variables.is_empty() {
            head += &format!("    real(real64) :: {}\n", variables.join(", "));
        }
        head
    }

    fn step(&self, function: &Function, place: usize, (variable, value): &(String, String)) -> String {
        let is_first = function.steps[..place].iter().all(|(earlier, _)| earlier != variable);
        let text = match self.language {
            Language::C if is_first => format!("    double {variable} = {value};"),
            Language::C => format!("    {variable} = {value};"),
            Language::Rust => format!("    let {variable} = {value};"),
            Language::Python if value.len() > COLUMNS / 2 => format!("    {variable} = ({value})"),
            Language::Python => format!("    {variable} = {value}"),
            Language::Fortran => format!("    {variable} = {value}"),
        };
        broken(&text, self.language)
    }

    fn returned(&self, name: &str, result: &str) -> String {
        let text = match self.language {
            Language::C => format!("    return {result};"),
            Language::Python => format!("    return {result}"),
            Language::Rust => format!("    {result}"),
            Language::Fortran => format!("    {name} = {result}"),
        };
        broken(&text, self.language)
    }
}

/// Columns that lines of a program keep to; Fortran allows 132.
const COLUMNS: usize = 100;

/// A statement on as many lines as it takes, broken before the signs of sums.
fn broken(text: &str, language: Language) -> String {
    let end = if language == Language::Fortran { " &\n" } else { "\n" };
    let mut lines = vec![String::new()];
    for part in text.replace(" + ", "\n+ ").replace(" - ", "\n- ").split('\n') {
        let line = lines.last_mut().expect("there is always a line");
        if !line.is_empty() && line.len() + 1 + part.len() > COLUMNS {
            lines.push(format!("        {part}"));
        } else {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(part);
        }
    }
    lines.join(end) + "\n"
}

/// Words in lines of at most `columns` characters.
fn folded(text: &str, columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is always a line");
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > columns {
            lines.push(word.to_owned());
        } else {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    lines
}
