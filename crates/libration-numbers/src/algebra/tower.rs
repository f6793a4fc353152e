//! A tower of square roots over the rational numbers, extended when necessary.

use super::{Function, Rational, Rationals, Ring};

/// All sums of products of square roots; each root is that of an element of the field below it.
///
/// An element consists of 2ʰ fractions, where h is the number of roots: first the part without the last root, then its coefficient.
#[derive(Clone, Debug, Default)]
pub struct Tower {
    /// s₁, s₂, …, each as an element of the field of the previous roots.
    squares: Vec<Vec<Rational>>,
}

impl Tower {
    /// The square root of an element; the tower is extended by one root if it does not contain it yet. `None` for a negative number.
    pub fn adjoin_root(&mut self, square: &[Rational]) -> Option<Vec<Rational>> {
        let square = self.lifted(square);
        if let Some(root) = self.root_of(&square) {
            return Some(root);
        }
        if self.number(&square) < 0.0 {
            return None;
        }
        let mut root = vec![Rational::from(0); 2 * square.len()];
        root[square.len()] = Rational::from(1);
        self.squares.push(square);
        Some(root)
    }

    /// An element of a lower field as an element of the whole tower.
    pub fn lifted(&self, element: &[Rational]) -> Vec<Rational> {
        let mut lifted = element.to_vec();
        lifted.resize(1 << self.squares.len(), Rational::from(0));
        lifted
    }

    /// The value of the element. Terms of opposite signs cancel as they do in `f64`.
    pub fn number(&self, element: &[Rational]) -> f64 {
        let height = element.len().trailing_zeros() as usize;
        match height.checked_sub(1) {
            None => element[0].to_f64(),
            Some(below) => {
                let (plain, root) = element.split_at(element.len() / 2);
                if root.iter().all(Rational::is_zero) {
                    return self.number(plain);
                }
                self.number(plain) + self.number(root) * self.number(&self.squares[below]).sqrt()
            }
        }
    }

    /// The element as a formula.
    pub fn text(&self, element: &[Rational]) -> String {
        let height = element.len().trailing_zeros() as usize;
        let radicands: Vec<String> = self.squares[..height].iter().map(|square| self.text(square)).collect();
        let mut text = String::new();
        for (number, coefficient) in
            element.iter().enumerate().filter(|(_, coefficient)| !coefficient.is_zero())
        {
            let inside = radicands.iter().enumerate().filter(|(level, _)| number >> level & 1 == 1);
            let roots: Vec<String> = inside.map(|(_, radicand)| format!("sqrt({radicand})")).collect();
            let size = coefficient.magnitude();
            let factor = (size != Rational::from(1) || roots.is_empty()).then(|| size.to_string());
            let product = factor.into_iter().chain(roots).collect::<Vec<_>>().join("*");
            text = match (text.is_empty(), coefficient.is_negative()) {
                (true, false) => product,
                (true, true) => format!("-{product}"),
                (false, false) => format!("{text} + {product}"),
                (false, true) => format!("{text} - {product}"),
            };
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// The positive element of the field whose square is this element, if there is one.
    fn root_of(&self, element: &[Rational]) -> Option<Vec<Rational>> {
        let root = self.any_root_of(element)?;
        Some(if self.number(&root) < 0.0 { self.negate(&root) } else { root })
    }

    /// With x² + s·y² = a and 2xy = b for the root x + y√s of a + b√s: x² is one of (a ± √(a² − s·b²))/2.
    fn any_root_of(&self, element: &[Rational]) -> Option<Vec<Rational>> {
        if element.len() == 1 {
            return element[0].square_root().map(|root| vec![root]);
        }
        let (a, b) = element.split_at(element.len() / 2);
        let square = &self.squares[a.len().trailing_zeros() as usize];
        let nothing = vec![Rational::from(0); a.len()];
        if self.is_zero_slice(b) {
            if let Some(root) = self.any_root_of(a) {
                return Some([root, nothing].concat());
            }
            let root = self.any_root_of(&self.product(a, &self.inverse(square)?))?;
            return Some([nothing, root].concat());
        }
        let norm = self.difference(&self.product(a, a), &self.product(square, &self.product(b, b)));
        let of_norm = self.any_root_of(&norm)?;
        let half =
            |x: Vec<Rational>| self.scaled(&x, &Rational::new(1, 2).unwrap_or_else(|| Rational::from(0)));
        let candidates = [half(self.sum(a, &of_norm)), half(self.difference(a, &of_norm))];
        candidates.iter().find_map(|candidate| {
            let x = self.any_root_of(candidate)?;
            let y = self.product(b, &self.inverse(&self.scaled(&x, &Rational::from(2)))?);
            Some([x, y].concat())
        })
    }

    fn is_zero_slice(&self, a: &[Rational]) -> bool {
        a.iter().all(Rational::is_zero)
    }

    fn sum(&self, a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        a.iter().zip(b).map(|(a, b)| Rationals.add(a, b)).collect()
    }

    fn difference(&self, a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        a.iter().zip(b).map(|(a, b)| Rationals.subtract(a, b)).collect()
    }

    fn scaled(&self, a: &[Rational], factor: &Rational) -> Vec<Rational> {
        a.iter().map(|a| Rationals.multiply(a, factor)).collect()
    }

    fn product(&self, a: &[Rational], b: &[Rational]) -> Vec<Rational> {
        if self.is_zero_slice(a) || self.is_zero_slice(b) {
            return vec![Rational::from(0); a.len()];
        }
        if a.len() == 1 {
            return vec![Rationals.multiply(&a[0], &b[0])];
        }
        let half = a.len() / 2;
        let ((a, c), (b, d)) = (a.split_at(half), b.split_at(half));
        let square = &self.squares[half.trailing_zeros() as usize];
        let plain = self.sum(&self.product(a, b), &self.product(&self.product(c, d), square));
        [plain, self.sum(&self.product(a, d), &self.product(c, b))].concat()
    }

    /// The inverse, by means of the conjugate, whose product with the element lies in the field below.
    fn inverse(&self, a: &[Rational]) -> Option<Vec<Rational>> {
        if a.len() == 1 {
            return Rational::from(1).checked_div(&a[0]).map(|reciprocal| vec![reciprocal]);
        }
        let (plain, root) = a.split_at(a.len() / 2);
        let square = &self.squares[plain.len().trailing_zeros() as usize];
        let norm =
            self.difference(&self.product(plain, plain), &self.product(square, &self.product(root, root)));
        let inverse = self.inverse(&norm)?;
        let minus: Vec<Rational> = root.iter().map(|x| Rationals.negate(x)).collect();
        Some([self.product(plain, &inverse), self.product(&minus, &inverse)].concat())
    }

    /// The value, if the element is a fraction.
    fn to_rational<'a>(&self, a: &'a [Rational]) -> Option<&'a Rational> {
        self.is_zero_slice(&a[1..]).then_some(&a[0])
    }
}

impl Ring for Tower {
    type Element = Vec<Rational>;

    fn zero(&self) -> Self::Element {
        self.lifted(&[Rational::from(0)])
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        self.is_zero_slice(a)
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        Some(self.lifted(std::slice::from_ref(value)))
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.sum(a, b)
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.difference(a, b)
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        a.iter().map(|a| Rationals.negate(a)).collect()
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.product(a, b)
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        self.scaled(a, &Rational::from(factor))
    }

    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        Some(self.product(a, &self.inverse(divisor)?))
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        a.iter().map(|a| Rationals.over_integer(a, divisor)).collect()
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        if function == Function::Sqrt {
            return self.root_of(at);
        }
        Rationals.value(function, self.to_rational(at)?).and_then(|value| self.rational(&value))
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        Rationals.power(self.to_rational(a)?, exponent).and_then(|value| self.rational(&value))
    }

    fn pi(&self) -> Option<Self::Element> {
        None
    }
}
