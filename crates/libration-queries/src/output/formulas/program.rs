//! Layout of functions in each language.

use crate::output::language::Language;
use std::fmt;

/// A function of real numbers.
pub(crate) struct Function {
    name: String,
    meaning: String,
    arguments: Vec<String>,
    /// Variables with their values, in the order in which they get them.
    steps: Vec<(String, String)>,
    pub(crate) result: String,
}

impl Function {
    pub(crate) fn new(name: &str, meaning: &str, arguments: Vec<String>) -> Self {
        Self {
            name: name.to_owned(),
            meaning: meaning.to_owned(),
            arguments,
            steps: vec![],
            result: String::new(),
        }
    }

    /// Assigns a value to a variable, which may have one already.
    pub(crate) fn define(&mut self, variable: &str, value: String) {
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

/// Functions below a comment.
pub(crate) struct Program {
    pub(crate) language: Language,
    /// The name of the module in Fortran.
    pub(crate) module: &'static str,
    pub(crate) comment: Vec<String>,
    pub(crate) functions: Vec<Function>,
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
            Language::C => "#include <math.h>\n".to_owned(),
            Language::Python => "from math import cos, sin, sqrt\n\n".to_owned(),
            Language::Rust => String::new(),
            Language::Fortran => format!(
                "module {}\n  use, intrinsic :: iso_fortran_env, only: real64\n  implicit none\ncontains\n",
                self.module
            ),
        };
        formatter.write_str(&opening)?;
        for (index, function) in self.functions.iter().enumerate() {
            let gap = if index > 0 && self.language == Language::Python { "\n\n" } else { "\n" };
            write!(formatter, "{gap}{}", self.written(function))?;
        }
        match self.language {
            Language::Fortran => write!(formatter, "\nend module {}\n", self.module),
            _ => Ok(()),
        }
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
                let list = if arguments.is_empty() { "void".to_owned() } else { typed("double ", "") };
                (format!("// {meaning}\ndouble {name}({list})\n{{\n"), "}\n".to_owned())
            }
            Language::Rust => {
                let has_capitals =
                    arguments.iter().chain([name]).any(|name| name.contains(char::is_uppercase));
                let allowed = if has_capitals { "#[allow(non_snake_case)]\n" } else { "" };
                let head =
                    format!("/// {meaning}\n{allowed}pub fn {name}({}) -> f64 {{\n", typed("", ": f64"));
                (head, "}\n".to_owned())
            }
            Language::Python => {
                (format!("def {name}({}):\n    \"\"\"{meaning}\"\"\"\n", typed("", "")), String::new())
            }
            Language::Fortran => (self.fortran_head(function), format!("  end function {name}\n")),
        };
        let steps = steps.iter().enumerate().map(|(index, step)| self.step(function, index, step));
        head + &steps.collect::<String>() + &self.returned(name, result) + &foot
    }

    fn fortran_head(&self, function: &Function) -> String {
        let Function { name, meaning, arguments, .. } = function;
        let list = arguments.join(", ");
        let mut head = format!("  ! {meaning}\n");
        head += &broken(&format!("  pure real(real64) function {name}({list})"), self.language);
        if !arguments.is_empty() {
            head += &broken(&format!("    real(real64), intent(in) :: {list}"), self.language);
        }
        let variables = function.variables();
        if !variables.is_empty() {
            head += &format!("    real(real64) :: {}\n", variables.join(", "));
        }
        head
    }

    fn step(&self, function: &Function, index: usize, (variable, value): &(String, String)) -> String {
        let is_first = function.steps[..index].iter().all(|(earlier, _)| earlier != variable);
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
            Language::Python if result.len() > COLUMNS / 2 => format!("    return ({result})"),
            Language::Python => format!("    return {result}"),
            Language::Rust => format!("    {result}"),
            Language::Fortran => format!("    {name} = {result}"),
        };
        broken(&text, self.language)
    }
}

/// Columns that lines of a program keep to; Fortran allows 132.
const COLUMNS: usize = 100;

/// A statement broken into lines, before the signs of sums, and within products and lists that are longer than a line.
fn broken(text: &str, language: Language) -> String {
    let end = if language == Language::Fortran { " &\n" } else { "\n" };
    let mut lines = vec![String::new()];
    let terms = text.replace(" + ", "\n+ ").replace(" - ", "\n- ");
    for part in terms.split('\n').flat_map(parts) {
        let line = lines.last_mut().expect("there is always a line");
        if !line.is_empty() && line.len() + 1 + part.len() > COLUMNS {
            lines.push(format!("        {part}"));
        } else {
            let joined = line.is_empty() || line.ends_with(' ') || part.starts_with('*');
            line.push_str(if joined { "" } else { " " });
            line.push_str(part);
        }
    }
    lines.join(end) + "\n"
}

/// The term itself, or if it is longer than a line, its parts before single asterisks and after commas.
fn parts(term: &str) -> Vec<&str> {
    let bytes = term.as_bytes();
    let is_factor =
        |at: usize| bytes[at] == b'*' && bytes[at - 1] != b'*' && bytes.get(at + 1) != Some(&b'*');
    let is_place = |at: &usize| is_factor(*at) || bytes[..*at].ends_with(b", ");
    let breaks = (1..bytes.len()).filter(|at| term.len() > COLUMNS - 8 && is_place(at));
    let ends: Vec<usize> = breaks.chain([term.len()]).collect();
    let starts = [0].into_iter().chain(ends.iter().copied());
    starts.zip(&ends).map(|(start, end)| &term[start..*end]).collect()
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
