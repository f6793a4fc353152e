//! Equations of motion together with the variational equations.

use libration_numbers::expression::{Equation, Expression, Order, Symbol};

/// The equations of motion, followed by `deviations` copies of the equations of an
/// infinitesimal deviation: δx″ = Σ ∂F/∂xⱼ·δxⱼ + ∂F/∂xⱼ′·δxⱼ′, evaluated along the motion.
///
/// The deviations of x are called `delta1 x`, `delta2 x`, …, names that cannot occur in a text. As in every system,
/// the state contains all coordinates and then all velocities: for one variable and two deviations x, δ₁x, δ₂x, x′,
/// δ₁x′, δ₂x′. The deviations of a variable whose equation is of first order have equations of first order.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::with_tangents;
/// let duffing = with_tangents(&"x'' = -x - x^3".parse()?, 1);
/// assert_eq!(duffing.variables(), ["x", "delta1 x"]);
/// assert_eq!(duffing.accelerations()[1].to_string(), "(-1 - 3*x^2)*delta1 x");
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[must_use]
pub fn with_tangents(equation: &Equation, deviations: usize) -> Equation {
    with_sensitivities(equation, &[], deviations)
}

/// The same equations, in which the first deviations are those by some parameters: δx″ = ∂F/∂p + Σ
/// ∂F/∂xⱼ·δxⱼ + ∂F/∂xⱼ′·δxⱼ′. Starting from δx = δx′ = 0, these deviations are the derivatives of
/// the motion with respect to p. After these come `deviations` copies for deviations of the start.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::with_sensitivities;
/// let damped = with_sensitivities(&"x'' = -k*x - b*x'".parse()?, &["k", "b"], 0);
/// assert_eq!(damped.variables(), ["x", "delta1 x", "delta2 x"]);
/// assert_eq!(damped.accelerations()[1].to_string(), "-k*delta1 x - b*delta1 x' - x");
/// assert_eq!(damped.accelerations()[2].to_string(), "-k*delta2 x - b*delta2 x' - x'");
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
///
/// # References
/// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., Springer 1993, section I.14.
#[must_use]
pub fn with_sensitivities(equation: &Equation, parameters: &[&str], deviations: usize) -> Equation {
    let mut variables = equation.variables().to_vec();
    let mut orders = equation.orders().to_vec();
    let mut derivatives = equation.derivatives().to_vec();
    let starts = std::iter::repeat_n(None, deviations);
    for (number, parameter) in (1..).zip(parameters.iter().map(Some).chain(starts)) {
        let deviation = |name: &str| format!("delta{number} {name}");
        variables.extend(equation.variables().iter().map(|name| deviation(name)));
        orders.extend(equation.orders());
        let change = |formula: &Expression| {
            let by_motion = total_differential(formula, equation, &deviation);
            match parameter {
                Some(name) => sum(by_motion, formula.derivative(&Symbol::plain(name))).simplified(),
                None => by_motion.simplified(),
            }
        };
        derivatives.extend(equation.derivatives().iter().map(change));
    }
    Equation::of_derivatives(variables, orders, derivatives)
}

fn sum(a: Expression, b: Expression) -> Expression {
    Expression::Add(Box::new(a), Box::new(b))
}

/// The total differential of a formula with respect to all coordinates and velocities.
fn total_differential(
    formula: &Expression,
    equation: &Equation,
    deviation: &impl Fn(&str) -> String,
) -> Expression {
    let names = equation.variables().iter().zip(equation.orders());
    let pairs = names.flat_map(|(name, order)| {
        let primes: &[u8] = if *order == Order::First { &[0] } else { &[0, 1] };
        primes.iter().map(|primes| (Symbol::plain(name), Symbol::plain(&deviation(name)), *primes))
    });
    let terms = pairs.map(|(variable, deviation, primes)| {
        let slope = formula.derivative(&variable.with_primes(primes));
        let deviation = Expression::Symbol(deviation.with_primes(primes));
        Expression::Multiply(Box::new(slope), Box::new(deviation))
    });
    terms.reduce(sum).unwrap_or_else(|| Expression::from(0))
}
