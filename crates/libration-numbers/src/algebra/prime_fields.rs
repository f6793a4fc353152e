//! Arithmetic modulo several primes at once, one for each lane of a vector unit.

use super::{Function, PrimeField, Rational, Ring};
use libration_kernels::dispatch::{Kernel, dispatch_slices};

/// Number of primes: the number of 32-bit products that the widest registers hold.
pub const LANES: usize = 8;

/// One residue for each prime.
pub type Residues = [u32; LANES];

/// Sums of products of residues before reduction.
pub(super) type Sums = [u64; LANES];

/// Number of products that may be added to a folded sum.
pub(super) const PRODUCTS: usize = 8;

/// The integers modulo each of eight primes below 2³⁰, as Montgomery residues: a ring in which a number has an inverse only if it has one modulo
/// every prime.
#[derive(Clone, Debug)]
pub struct PrimeFields {
    lanes: PrimeLanes,
    /// 1/n for small n.
    inverses: Vec<Residues>,
}

/// The fields, each constant as an array over the primes.
#[derive(Clone, Copy, Debug)]
pub(super) struct PrimeLanes {
    primes: Residues,
    negative_inverses: Residues,
    units: Residues,
    radices_squared: Residues,
}

/// Number of small integers whose inverses are kept.
const KEPT_INVERSES: usize = 512;

/// One number for each lane. The function is always inlined, and thus compiled for the instruction set of its caller.
#[inline(always)]
fn each<T: Copy + Default>(mut number: impl FnMut(usize) -> T) -> [T; LANES] {
    let mut all = [T::default(); LANES];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
}

impl PrimeLanes {
    fn new(primes: Residues) -> Self {
        let fields = primes.map(PrimeField::new);
        Self {
            primes,
            negative_inverses: fields.map(|field| field.negative_inverse()),
            units: fields.map(|field| field.unit()),
            radices_squared: fields.map(|field| field.radix_squared()),
        }
    }

    #[inline(always)]
    fn field(&self, lane: usize) -> PrimeField {
        PrimeField::from_constants(
            self.primes[lane],
            self.negative_inverses[lane],
            self.units[lane],
            self.radices_squared[lane],
        )
    }

    #[inline(always)]
    pub(super) fn product(&self, a: &Residues, b: &Residues) -> Residues {
        each(|lane| self.field(lane).product(a[lane], b[lane]))
    }

    #[inline(always)]
    fn sum(&self, a: &Residues, b: &Residues) -> Residues {
        each(|lane| self.field(lane).sum(a[lane], b[lane]))
    }

    #[inline(always)]
    fn difference(&self, a: &Residues, b: &Residues) -> Residues {
        each(|lane| self.field(lane).difference(a[lane], b[lane]))
    }

    /// The sums, reduced far enough that [`PRODUCTS`] more products can be added.
    #[inline(always)]
    pub(super) fn folded(&self, sums: &Sums) -> Sums {
        each(|lane| self.field(lane).folded(sums[lane]))
    }

    /// The residues of sums to which at most [`PRODUCTS`] products were added.
    #[inline(always)]
    pub(super) fn settled(&self, sums: &Sums) -> Residues {
        each(|lane| {
            let field = self.field(lane);
            field.reduced(field.folded(sums[lane]))
        })
    }
}

/// `sums + a·b`.
#[inline(always)]
pub(super) fn accumulated(sums: &Sums, a: &Residues, b: &Residues) -> Sums {
    each(|lane| sums[lane] + u64::from(a[lane]) * u64::from(b[lane]))
}

impl PrimeFields {
    pub fn new(primes: Residues) -> Self {
        let lanes = PrimeLanes::new(primes);
        Self { lanes, inverses: small_inverses(&lanes) }
    }

    pub(super) fn lanes(&self) -> &PrimeLanes {
        &self.lanes
    }

    pub fn primes(&self) -> Residues {
        self.lanes.primes
    }

    pub fn unit(&self) -> Residues {
        self.lanes.units
    }

    /// A number modulo each prime, computed by `number`.
    pub fn in_each(&self, number: impl Fn(&PrimeField) -> Option<u32>) -> Option<Residues> {
        let mut all = [0; LANES];
        for (lane, one) in all.iter_mut().enumerate() {
            *one = number(&self.lanes.field(lane))?;
        }
        Some(all)
    }

    pub fn integer(&self, value: u64) -> Residues {
        each(|lane| self.lanes.field(lane).residue(value))
    }

    /// The inverse; `None` if the number is zero modulo one of the primes.
    pub fn inverse(&self, a: &Residues) -> Option<Residues> {
        inverse(&self.lanes, a)
    }
}

fn inverse(lanes: &PrimeLanes, a: &Residues) -> Option<Residues> {
    a.iter().all(|&a| a != 0).then(|| {
        let (mut result, mut square) = (lanes.units, *a);
        let exponents = lanes.primes.map(|prime| prime - 2);
        for bit in 0..30 {
            let longer = lanes.product(&result, &square);
            result = each(|lane| if exponents[lane] >> bit & 1 == 1 { longer[lane] } else { result[lane] });
            square = lanes.product(&square, &square);
        }
        result
    })
}

/// 1/0 = 0, 1/1, 1/2, …, all computed from the inverse of one factorial.
fn small_inverses(lanes: &PrimeLanes) -> Vec<Residues> {
    let mut integers = vec![[0; LANES]];
    let mut factorials = vec![lanes.units];
    for n in 1..KEPT_INVERSES {
        integers.push(lanes.sum(&integers[n - 1], &lanes.units));
        factorials.push(lanes.product(&factorials[n - 1], &integers[n]));
    }
    let last = &factorials[KEPT_INVERSES - 1];
    let mut over_factorial = inverse(lanes, last).expect("the primes are above all small integers");
    let mut inverses = vec![[0; LANES]; KEPT_INVERSES];
    for n in (1..KEPT_INVERSES).rev() {
        inverses[n] = lanes.product(&over_factorial, &factorials[n - 1]);
        over_factorial = lanes.product(&over_factorial, &integers[n]);
    }
    inverses
}

impl Ring for PrimeFields {
    type Element = Residues;

    fn zero(&self) -> Residues {
        [0; LANES]
    }

    fn is_zero(&self, a: &Residues) -> bool {
        *a == [0; LANES]
    }

    /// A fraction modulo each prime; `None` if one of the primes divides the denominator.
    fn rational(&self, value: &Rational) -> Option<Residues> {
        self.in_each(|field| field.fraction(value))
    }

    fn add(&self, a: &Residues, b: &Residues) -> Residues {
        self.lanes.sum(a, b)
    }

    fn subtract(&self, a: &Residues, b: &Residues) -> Residues {
        self.lanes.difference(a, b)
    }

    fn negate(&self, a: &Residues) -> Residues {
        self.lanes.difference(&[0; LANES], a)
    }

    fn multiply(&self, a: &Residues, b: &Residues) -> Residues {
        self.lanes.product(a, b)
    }

    fn times_integer(&self, a: &Residues, factor: i64) -> Residues {
        let magnitude = match u32::try_from(factor.unsigned_abs()) {
            Ok(word) => self.lanes.product(&[word; LANES], &self.lanes.radices_squared),
            Err(_) => self.integer(factor.unsigned_abs()),
        };
        let product = self.lanes.product(a, &magnitude);
        if factor < 0 { self.negate(&product) } else { product }
    }

    fn divide(&self, a: &Residues, divisor: &Residues) -> Option<Residues> {
        Some(self.lanes.product(a, &self.inverse(divisor)?))
    }

    fn over_integer(&self, a: &Residues, divisor: u64) -> Option<Residues> {
        let kept = usize::try_from(divisor).ok().filter(|&n| n > 0).and_then(|n| self.inverses.get(n));
        match kept {
            Some(inverse) => Some(self.lanes.product(a, inverse)),
            None => self.divide(a, &self.integer(divisor)),
        }
    }

    fn value(&self, _: Function, _: &Residues) -> Option<Residues> {
        None
    }

    fn power(&self, _: &Residues, _: &Rational) -> Option<Residues> {
        None
    }

    fn pi(&self) -> Option<Residues> {
        None
    }

    fn convolution(&self, a: &[Residues], b: &[Residues]) -> Residues {
        dispatch_slices(ResidueConvolution { lanes: &self.lanes, a, b })
    }
}

struct ResidueConvolution<'a> {
    lanes: &'a PrimeLanes,
    a: &'a [Residues],
    b: &'a [Residues],
}

impl Kernel for ResidueConvolution<'_> {
    type Output = Residues;

    #[inline(always)]
    fn run(self) -> Residues {
        let mut sums = [0; LANES];
        for (a, b) in self.a.chunks(PRODUCTS).zip(self.b.rchunks(PRODUCTS)) {
            sums = self.lanes.folded(&sums);
            for (a, b) in a.iter().zip(b.iter().rev()) {
                sums = accumulated(&sums, a, b);
            }
        }
        self.lanes.settled(&sums)
    }
}
