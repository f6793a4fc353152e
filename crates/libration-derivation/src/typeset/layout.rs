//! Layout of formulas: brackets, signs and spaces are decided once, for LaTeX and MathML alike.

use super::super::formula::{Decimal, DecimalUnit, Formula, Name, Subscript};
use super::precedence::{Precedence, precedence};
use libration::algebra::{Function, Rational};

/// The parts of a formula, set side by side, above and below.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Layout {
    Row(Vec<Self>),
    /// The letter of a variable.
    Letter(String),
    /// An upright word: a function, a unit, a subscript.
    Word(String),
    Digits(String),
    /// A sign with space around it: + = ≈.
    Sign(char),
    /// A sign that belongs to the following part: the minus of −x.
    Prefix(char),
    /// A mark directly after the previous part: °, !!.
    Suffix(&'static str),
    Comma,
    ThinSpace,
    /// Space at the beginning of a continued line.
    Indent,
    /// Space between a function and its argument.
    Application,
    Fraction(Box<Self>, Box<Self>),
    Root(Box<Self>),
    /// A letter with this number of primes.
    Primed(Box<Self>, u8),
    Scripts {
        base: Box<Self>,
        below: Option<Box<Self>>,
        above: Option<Box<Self>>,
    },
    /// ∑ or ∫ with its limits.
    Large {
        sign: char,
        from: Box<Self>,
        to: Box<Self>,
    },
    Brackets(Box<Self>),
    Bars(Box<Self>),
}

/// The style in which a formula is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    /// A formula on its own line: fractions are stacked.
    Display,
    /// A formula within a sentence: fractions have a slash.
    Inline,
}

impl Style {
    pub(crate) fn formula(self, formula: &Formula) -> Layout {
        match formula {
            Formula::Number(value) => self.number(value),
            Formula::Decimal(value) => decimal(value),
            Formula::Pi => Layout::Letter("π".to_owned()),
            Formula::Name(name) => self.name(name),
            Formula::Negate(operand) => {
                Layout::Row(vec![Layout::Prefix('−'), self.at_least(Precedence::Product, operand)])
            }
            Formula::Sum(terms) => self.sum(terms),
            Formula::Product(factors) => self.product(factors),
            Formula::Fraction(over, under) => self.fraction(over, under),
            Formula::Power(base, exponent) => self.power(base, exponent),
            Formula::Call(function, argument) => self.call(*function, None, argument),
            Formula::Apply(name, arguments) => self.apply(self.name(name), arguments),
            Formula::Agm(a, b) => self.apply(Layout::Word("agm".to_owned()), [&**a, &**b]),
            Formula::Series { index, from, to, term } => self.series(index, from, to.as_deref(), term),
            Formula::Integral { variable, from, to, integrand } => {
                self.integral(variable, from, to, integrand)
            }
            Formula::Derivative { of, by } => self.derivative(of, by),
            Formula::DoubleFactorial(argument) => {
                Layout::Row(vec![self.at_least(Precedence::Atom, argument), Layout::Suffix("!!")])
            }
            Formula::Order(argument) => self.apply(Layout::Letter("O".to_owned()), [&**argument]),
        }
    }

    /// The layout, in brackets if the formula binds weaker than its place requires.
    fn at_least(self, wanted: Precedence, formula: &Formula) -> Layout {
        let layout = self.formula(formula);
        if precedence(formula) < wanted { Layout::Brackets(Box::new(layout)) } else { layout }
    }

    fn number(self, value: &Rational) -> Layout {
        let numerator = value.numerator();
        let (negative, digits) =
            numerator.strip_prefix('-').map_or((false, numerator.as_str()), |digits| (true, digits));
        let whole = Layout::Digits(digits.to_owned());
        let size = match value.denominator().as_str() {
            "1" => whole,
            under => self.quotient(whole, Layout::Digits(under.to_owned())),
        };
        if negative { Layout::Row(vec![Layout::Prefix('−'), size]) } else { size }
    }

    fn quotient(self, over: Layout, under: Layout) -> Layout {
        match self {
            Self::Display => Layout::Fraction(Box::new(over), Box::new(under)),
            Self::Inline => Layout::Row(vec![over, Layout::Suffix("/"), under]),
        }
    }

    fn fraction(self, over: &Formula, under: &Formula) -> Layout {
        match self {
            Self::Display => self.quotient(self.formula(over), self.formula(under)),
            Self::Inline => self
                .quotient(self.at_least(Precedence::Product, over), self.at_least(Precedence::Power, under)),
        }
    }

    pub(super) fn name(self, name: &Name) -> Layout {
        let letter = match name.letter.chars().count() {
            1 => Layout::Letter(name.letter.clone()),
            _ => Layout::Word(name.letter.clone()),
        };
        let below = name.subscript.as_ref().map(|subscript| match subscript {
            Subscript::Word(word) => Layout::Word(word.clone()),
            Subscript::Index(index) => Self::Inline.formula(index),
        });
        let letter = if name.primes > 0 { Layout::Primed(Box::new(letter), name.primes) } else { letter };
        scripts(letter, below, None)
    }

    fn sum(self, terms: &[Formula]) -> Layout {
        let mut row = Vec::new();
        for (n, term) in terms.iter().enumerate() {
            let (negative, size) = unsigned(term);
            match (n, negative) {
                (0, false) => {}
                (0, true) => row.push(Layout::Prefix('−')),
                (_, false) => row.push(Layout::Sign('+')),
                (_, true) => row.push(Layout::Sign('−')),
            }
            let last = n + 1 == terms.len();
            row.push(self.at_least(if last { Precedence::Large } else { Precedence::Product }, &size));
        }
        Layout::Row(row)
    }

    fn product(self, factors: &[Formula]) -> Layout {
        let mut row: Vec<Layout> = Vec::new();
        for (n, factor) in factors.iter().enumerate() {
            let next = factors.get(n + 1);
            let open = next.is_some_and(|next| !matches!(next, Formula::Call(..)));
            if n > 0 {
                row.extend(between(&factors[n - 1], factor));
            }
            row.push(match factor {
                Formula::Call(function, argument) if open && *function != Function::Sqrt => {
                    self.bracketed_call(*function, None, argument)
                }
                // 1/8·a with a slash could be read as 1/(8a).
                Formula::Number(value) if next.is_some() => Self::Display.number(value),
                Formula::Number(value) if n == 0 => self.number(value),
                _ if next.is_none() => self.at_least(Precedence::Large, factor),
                _ => self.at_least(Precedence::Product, factor),
            });
        }
        Layout::Row(row)
    }

    fn power(self, base: &Formula, exponent: &Formula) -> Layout {
        let exponent = Self::Inline.formula(exponent);
        match base {
            Formula::Call(function, argument) if is_named(*function) => {
                self.call(*function, Some(exponent), argument)
            }
            Formula::Name(name) => match self.name(name) {
                Layout::Scripts { base, below, above: None } => {
                    Layout::Scripts { base, below, above: Some(Box::new(exponent)) }
                }
                letter => scripts(letter, None, Some(exponent)),
            },
            _ => scripts(self.at_least(Precedence::Atom, base), None, Some(exponent)),
        }
    }

    fn call(self, function: Function, exponent: Option<Layout>, argument: &Formula) -> Layout {
        match function {
            Function::Sqrt => Layout::Root(Box::new(self.formula(argument))),
            Function::Abs => Layout::Bars(Box::new(self.formula(argument))),
            Function::Exp => {
                scripts(Layout::Letter("e".to_owned()), None, Some(Self::Inline.formula(argument)))
            }
            _ if needs_brackets(self, argument) => self.bracketed_call(function, exponent, argument),
            _ => Layout::Row(vec![head(function, exponent), Layout::Application, self.formula(argument)]),
        }
    }

    fn bracketed_call(self, function: Function, exponent: Option<Layout>, argument: &Formula) -> Layout {
        match function {
            Function::Sqrt | Function::Abs | Function::Exp => self.call(function, exponent, argument),
            _ => Layout::Row(vec![
                head(function, exponent),
                Layout::Brackets(Box::new(self.formula(argument))),
            ]),
        }
    }

    fn apply<'a>(self, name: Layout, arguments: impl IntoIterator<Item = &'a Formula>) -> Layout {
        let mut row = Vec::new();
        for argument in arguments {
            if !row.is_empty() {
                row.push(Layout::Comma);
            }
            row.push(self.formula(argument));
        }
        Layout::Row(vec![name, Layout::Brackets(Box::new(Layout::Row(row)))])
    }

    fn series(self, index: &Name, from: &Formula, to: Option<&Formula>, term: &Formula) -> Layout {
        let first = vec![Self::Inline.name(index), Layout::Sign('='), Self::Inline.formula(from)];
        let last = to.map_or_else(|| Layout::Letter("∞".to_owned()), |to| Self::Inline.formula(to));
        let sign = Layout::Large { sign: '∑', from: Box::new(Layout::Row(first)), to: Box::new(last) };
        Layout::Row(vec![sign, self.at_least(Precedence::Product, term)])
    }

    /// The differential stands in the numerator if the integrand is the inverse of a formula.
    fn integral(self, variable: &Name, from: &Formula, to: &Formula, integrand: &Formula) -> Layout {
        let limit = |formula| Box::new(Self::Inline.formula(formula));
        let sign = Layout::Large { sign: '∫', from: limit(from), to: limit(to) };
        let differential = Layout::Row(vec![Layout::Letter("d".to_owned()), self.name(variable)]);
        match integrand {
            Formula::Fraction(over, under) if **over == Formula::from(1) && self == Self::Display => {
                Layout::Row(vec![sign, self.quotient(differential, self.formula(under))])
            }
            _ => {
                let integrand = self.at_least(Precedence::Product, integrand);
                Layout::Row(vec![sign, integrand, Layout::ThinSpace, differential])
            }
        }
    }

    fn derivative(self, of: &Formula, by: &Name) -> Layout {
        let d = || Layout::Letter("d".to_owned());
        let under = Layout::Row(vec![d(), self.name(by)]);
        match of {
            Formula::Name(name) => self.quotient(Layout::Row(vec![d(), self.name(name)]), under),
            _ => {
                let operator = self.quotient(d(), under);
                Layout::Row(vec![operator, Layout::ThinSpace, self.at_least(Precedence::Power, of)])
            }
        }
    }
}

/// The sign of a summand and the summand without it.
fn unsigned(term: &Formula) -> (bool, Formula) {
    match term {
        Formula::Negate(size) => (true, (**size).clone()),
        Formula::Number(value) if value.is_negative() => (true, Formula::Number(-value.clone())),
        Formula::Decimal(value) => match value.mantissa.strip_prefix('-') {
            Some(size) => (true, Formula::Decimal(Decimal { mantissa: size.to_owned(), ..value.clone() })),
            None => (false, term.clone()),
        },
        Formula::Product(factors) => match factors.split_first() {
            Some((Formula::Number(value), rest)) if value.is_negative() => {
                let size = [vec![Formula::Number(-value.clone())], rest.to_vec()].concat();
                (true, Formula::Product(size))
            }
            _ => (false, term.clone()),
        },
        _ => (false, term.clone()),
    }
}

/// The sign between two factors.
fn between(left: &Formula, right: &Formula) -> Option<Layout> {
    let begins_with_digit = match right {
        Formula::Number(_) | Formula::Decimal(_) => true,
        Formula::Power(base, _) => matches!(**base, Formula::Number(_)),
        _ => false,
    };
    let is_function = |formula: &Formula| match formula {
        Formula::Call(function, _) => is_named(*function),
        Formula::Power(base, _) => matches!(**base, Formula::Call(function, _) if is_named(function)),
        _ => false,
    };
    match (left, right) {
        (Formula::Decimal(_), _) => Some(Layout::Sign('·')),
        _ if begins_with_digit => Some(Layout::Sign('·')),
        (Formula::Number(_), Formula::Fraction(..)) => Some(Layout::Sign('·')),
        _ if is_function(left) || is_function(right) => Some(Layout::ThinSpace),
        (_, Formula::Series { .. } | Formula::Integral { .. }) => Some(Layout::ThinSpace),
        _ => None,
    }
}

/// Returns `true` if the function is written as a word before its argument.
fn is_named(function: Function) -> bool {
    !matches!(function, Function::Sqrt | Function::Abs | Function::Exp)
}

/// Returns `false` for arguments such as 2θ, and θ0/2 in a display, which need no brackets after a function.
fn needs_brackets(style: Style, argument: &Formula) -> bool {
    match argument {
        Formula::Name(_) | Formula::Pi => false,
        Formula::Fraction(..) => style == Style::Inline,
        Formula::Product(factors) => !factors
            .iter()
            .all(|factor| matches!(factor, Formula::Name(_) | Formula::Pi | Formula::Number(_))),
        _ => true,
    }
}

fn head(function: Function, exponent: Option<Layout>) -> Layout {
    scripts(Layout::Word(function.word().to_owned()), None, exponent)
}

fn scripts(base: Layout, below: Option<Layout>, above: Option<Layout>) -> Layout {
    if below.is_none() && above.is_none() {
        return base;
    }
    Layout::Scripts { base: Box::new(base), below: below.map(Box::new), above: above.map(Box::new) }
}

fn decimal(value: &Decimal) -> Layout {
    let (negative, digits) =
        value.mantissa.strip_prefix('-').map_or((false, value.mantissa.as_str()), |digits| (true, digits));
    let mut row = Vec::new();
    row.extend(negative.then_some(Layout::Prefix('−')));
    row.push(Layout::Digits(digits.to_owned()));
    if value.exponent != 0 {
        let ten = Layout::Digits("10".to_owned());
        let exponent = Style::Inline.number(&Rational::from(i64::from(value.exponent)));
        row.extend([Layout::Sign('·'), scripts(ten, None, Some(exponent))]);
    }
    row.extend(unit(value.unit));
    Layout::Row(row)
}

fn unit(unit: DecimalUnit) -> Vec<Layout> {
    let word = |text: &str| Layout::Word(text.to_owned());
    let spaced = |layout| vec![Layout::ThinSpace, layout];
    match unit {
        DecimalUnit::One => vec![],
        DecimalUnit::Degree => vec![Layout::Suffix("°")],
        DecimalUnit::Radian => spaced(word("rad")),
        DecimalUnit::Second => spaced(word("s")),
        DecimalUnit::Metre => spaced(word("m")),
        DecimalUnit::RadianPerSecond => {
            spaced(Layout::Row(vec![word("rad"), Layout::Suffix("/"), word("s")]))
        }
        DecimalUnit::MetrePerSecondSquared => {
            let squared = scripts(word("s"), None, Some(Layout::Digits("2".to_owned())));
            spaced(Layout::Row(vec![word("m"), Layout::Suffix("/"), squared]))
        }
    }
}
