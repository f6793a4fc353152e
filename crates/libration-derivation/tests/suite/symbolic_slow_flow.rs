//! Slow flows with symbols, step by step.

use libration::perturbation::{SymbolicSlowFlowError, SymbolicSlowFlowOptions, slow_flow_symbolically};
use libration::progress::Quiet;
use libration_derivation::internals::Trials;
use libration_derivation::internals::build::{letter, number, sin, tenths};
use libration_derivation::{
    Block, Check, ComparedAt, Derivation, DerivationError, Formula, Name, Statement, formula_latex,
    slow_flow, to_markdown,
};

type Case = (&'static str, Option<(u32, u32)>, &'static [(&'static str, usize)]);

const DUFFING: &str = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)";

/// Free and driven oscillators whose amplitude or phase changes in the lowest order of their small terms.
const CASES: &[Case] = &[
    (DUFFING, Some((1, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", Some((1, 3)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", Some((3, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 = F*cos(W*t)", Some((1, 2)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 = F*cos(W*t)", Some((2, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*h*x*cos(W*t) + eps*a*x^3 = 0", Some((2, 1)), &[]),
    ("x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(W*t))*x = 0", Some((2, 1)), &[]),
    ("x'' + eps*(c*x' + a*x^3) + w^2*x + eps*h*W^2*cos(W*t)*x = 0", Some((2, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^5 = eps*F*cos(W*t)", Some((1, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*(F*cos(W*t) + K*sin(W*t))", Some((1, 1)), &[]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(1.05*t)", Some((1, 1)), &[]),
    ("x'' + eps*(m*x' + a*x^3) + x = eps*cos(W*t)", Some((1, 1)), &[]),
    ("x'' - eps*m*(1 - x^2)*x' + w0^2*x = eps*F*cos(W*t)", Some((1, 1)), &[]),
    ("x'' + eps*R*sign(x') + w0^2*x = eps*F*cos(W*t)", Some((1, 1)), &[]),
    ("x'' + eps*c*x'*abs(x') + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)", Some((1, 1)), &[]),
    ("x'' + c*x' + sin(x) = F*cos(W*t)", Some((1, 1)), &[("c", 2), ("F", 2)]),
    ("m*x'' + c*x' + k*x + b*x^3 = F*cos(W*t)", Some((1, 1)), &[("c", 1), ("b", 1), ("F", 1)]),
    ("x'' + c*x' + w^2*x + b*x*abs(x) = F*cos(W*t)", Some((1, 1)), &[("c", 1), ("F", 1)]),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = 0", None, &[]),
    ("x'' + mu*x' + w^2*x + a*x^3 = 0", None, &[("mu", 1), ("a", 1)]),
    ("x'' + c*x' + w^2*x + b*x^3 = 0", None, &[("c", 2)]),
    ("x'' + eps*c*x'*abs(x') + w^2*x = 0", None, &[]),
    ("x'' + eps*R*sign(x') + w^2*x = 0", None, &[]),
    ("x'' + x = eps*(m*(1 - x^2)*x' - b*x^3)", None, &[]),
    ("x'' + w^2*x = eps*(a*x' - b*x'^3)", None, &[]),
    ("x'' + w^2*x + eps*(c*x' + d*x'^3 + a*x^3 + b*x^5) = 0", None, &[]),
    ("x'' + w^2*x + eps*(c*x' + R*sign(x')) = 0", None, &[]),
    ("x'' + w^2*x + eps*a*x^3 = 0", None, &[]),
    ("x'' + w^2*x + eps*((c + k)*x' + d*x'*abs(x')) = 0", None, &[]),
];

fn options(resonance: Option<(u32, u32)>, small: &[(&str, usize)]) -> SymbolicSlowFlowOptions {
    let small = small.iter().map(|(name, order)| ((*name).to_owned(), *order)).collect();
    SymbolicSlowFlowOptions { resonance, small, ..SymbolicSlowFlowOptions::default() }
}

pub(crate) fn derived((text, resonance, small): &Case) -> Result<Derivation, DerivationError> {
    slow_flow(&text.parse().unwrap(), &options(*resonance, small), &Quiet)
}

pub(crate) fn duffing() -> Derivation {
    derived(&CASES[0]).unwrap()
}

type CaseOfOrder = (Case, usize);

/// Oscillators whose slow flow has products of two small terms, or terms of two orders without products.
const HIGHER: &[CaseOfOrder] = &[
    ((QUADRATIC, Some((1, 1)), &[("a2", 1), ("a3", 2), ("mu", 2), ("F", 2)]), 2),
    (("x'' + w^2*x + m*x' + a*x*x' = 0", None, &[("m", 2), ("a", 1)]), 2),
    (
        (
            "x'' + w^2*x + m*x' + a*x*x' + b*x'^2 + c*x^2 = F*cos(W*t)",
            Some((1, 1)),
            &[("m", 2), ("a", 1), ("b", 1), ("c", 1), ("F", 2)],
        ),
        2,
    ),
    (("x'' + w^2*x + m*x' + a*x^2 + b*x^3 = 0", None, &[("m", 2)]), 2),
    ((DUFFING, Some((1, 1)), &[]), 2),
    (("x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(W*t))*x + eps*a*x^3 = 0", Some((2, 1)), &[]), 2),
    (("x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(W*t))*x + eps*a*x^3 = 0", Some((1, 1)), &[]), 2),
    (("x'' - eps*m*(1 - x^2)*x' + w0^2*x = eps*F*cos(W*t)", Some((1, 1)), &[]), 2),
    (("x'' - eps*m*(1 - x^2)*x' + w0^2*x = 0", None, &[]), 2),
    (("x'' + x = eps*(m*(1 - x^2)*x' - b*x^3)", None, &[]), 2),
    (("x'' + eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)", Some((3, 1)), &[]), 2),
    (("x'' + eps*mu*x' + w0^2*x + eps*a*x^2 = eps*F*cos(W*t)", Some((2, 1)), &[]), 2),
    (("x'' + w^2*x + m*x' + n*x'^3 + a*x^3 = 0", None, &[("m", 2), ("n", 1), ("a", 1)]), 2),
    (("x'' + x + m*x' + n*x'*abs(x') = 0", None, &[("m", 1), ("n", 2)]), 2),
    (("x'' + c*x' + sin(x) = F*cos(W*t)", Some((1, 1)), &[("c", 2), ("F", 3)]), 3),
    (("x'' + c*x' + sin(x) = F*cos(W*t)", Some((1, 1)), &[("c", 2), ("F", 2)]), 4),
    (("x'' + w^2*x + m*x' + n*x'^3 = 0", None, &[("m", 2), ("n", 3)]), 3),
    (("x'' + eps*(c*x' + a*x^3) + w^2*x + eps*h*W^2*cos(W*t)*x = 0", Some((2, 1)), &[]), 2),
    (("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*(F*cos(W*t) + K*sin(W*t))", Some((1, 1)), &[]), 2),
    (("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 = eps*F*cos(1.05*t)", Some((1, 1)), &[]), 2),
    (("x'' + eps*(1 + eps)*c*x' + x + eps*a*x^2 = eps*cos(W*t)", Some((1, 1)), &[]), 2),
    (("k*v'' + eps*c*v'^3 + q*v + eps*a*v^2 = 0", None, &[]), 2),
    (("x'' + eps*c*x' + w^2*(1 + eps*d)*x + eps*a*x^5 = 0", None, &[]), 2),
];

/// Quadratic and cubic terms together.
const QUADRATIC: &str = "x'' + mu*x' + w0^2*x + a2*x^2 + a3*x^3 = F*cos(W*t)";

fn derived_to((case, order): &CaseOfOrder) -> Result<Derivation, DerivationError> {
    let (text, resonance, small) = case;
    let options = SymbolicSlowFlowOptions { order: Some(*order), ..options(*resonance, small) };
    slow_flow(&text.parse().unwrap(), &options, &Quiet)
}

/// A slow flow of both orders, with products of its rates.
pub(crate) fn second_order() -> Derivation {
    derived_to(&HIGHER[4]).unwrap()
}

/// The formula of a result as the derivation writes it.
fn latex(text: &str) -> String {
    let greek = libration::expression::Expression::Symbol(libration::expression::Symbol::plain("epsilon"));
    let formula = text.parse::<libration::expression::Expression>().unwrap();
    formula_latex(&Formula::from(&formula.substitute(&libration::expression::Symbol::plain("eps"), &greek)))
}

fn sides(derivation: &Derivation) -> Vec<String> {
    let of_block = |block: &Block| match block {
        Block::Equation { equation, .. } => {
            let statement = equation.statement();
            let rest = statement.rest.iter().map(|(_, side)| formula_latex(side));
            rest.chain([formula_latex(&statement.first)]).collect()
        }
        _ => vec![],
    };
    derivation.steps.iter().flat_map(|step| step.blocks.iter().flat_map(of_block)).collect()
}

/// Asserts that the derivation of each case contains these formulas or words.
fn assert_contained(expected: &[(usize, &[&str])]) {
    for (case, parts) in expected {
        let page = to_markdown(&derived(&CASES[*case]).unwrap());
        for part in *parts {
            assert!(page.contains(part), "{}: {part}: {page}", CASES[*case].0);
        }
    }
}

#[test]
fn derivations_end_in_the_formulas_of_the_expansion() {
    for case in CASES {
        let (text, resonance, small) = case;
        let derivation = derived(case).unwrap_or_else(|error| panic!("{text}: {error}"));
        let flow =
            slow_flow_symbolically(&text.parse().unwrap(), &options(*resonance, small), &Quiet).unwrap();
        let sides = sides(&derivation);
        let state = &flow.steady_state;
        let expected = [Some(&flow.amplitude_rate), Some(&flow.phase_rate), state.relation.as_ref()];
        let further = [&state.backbone, &state.peak_amplitude, &state.critical_drive, &state.cycle_amplitude];
        for formula in expected.into_iter().chain(further.map(Option::as_ref)).flatten() {
            let is_free_relation = resonance.is_none() && Some(formula) == state.relation.as_ref();
            let formula = latex(formula);
            assert!(is_free_relation || sides.contains(&formula), "{text}: {formula}: {sides:?}");
        }
    }
}

#[test]
fn products_of_two_small_terms_are_derived() {
    for case in HIGHER {
        let ((text, resonance, small), order) = case;
        let derivation = derived_to(case).unwrap_or_else(|error| panic!("{text}: {error}"));
        let options = SymbolicSlowFlowOptions { order: Some(*order), ..options(*resonance, small) };
        let flow = slow_flow_symbolically(&text.parse().unwrap(), &options, &Quiet).unwrap();
        let sides = sides(&derivation);
        for formula in [&flow.amplitude_rate, &flow.phase_rate] {
            assert!(sides.contains(&latex(formula)), "{text}: {formula}: {sides:?}");
        }
    }
    // The orders of the symbols decide without a requested one.
    let asked = to_markdown(&derived_to(&HIGHER[0]).unwrap());
    assert_eq!(to_markdown(&derived(&HIGHER[0].0).unwrap()), asked);
}

/// Nayfeh and Mook, section 4.1.1 with 2.3.1: a3 − 10·a2²/(9·w0²) in place of a3; section 3.3.4 for the frequency of van der Pol's oscillator,
/// ω0 − μ²/(16·ω0) at A = 2.
#[test]
fn textbook_results_of_the_second_order_are_derived() {
    let page = |case: usize| to_markdown(&derived_to(&HIGHER[case]).unwrap());
    let quadratic = page(0);
    for part in [
        r"x_{1}:=-\frac{a_{2}A^{2}}{2w_{0}^{2}}+\frac{a_{2}A^{2}}{6w_{0}^{2}}\,\cos 2\psi",
        r"&=\frac{5a_{2}^{2}A^{3}}{6w_{0}^{2}}\,\cos \psi -\frac{a_{2}^{2}A^{3}}{6w_{0}^{2}}\,\cos 3\psi",
        r"\beta :=\frac{3a_{3}}{8w_{0}}-\frac{5a_{2}^{2}}{12w_{0}^{3}}",
        r"A_{\mathrm{max}}:=\frac{F}{\mu w_{0}}",
        "in this order amplitude and phase do not change",
    ] {
        assert!(quadratic.contains(part), "{part}: {quadratic}");
    }
    let van_der_pol = page(8);
    let turning = r"\varphi'=-\frac{\varepsilon ^{2}m^{2}}{8w_{0}}+\frac{\varepsilon ^{2}m^{2}A^{2}}{8w_{0}}-\frac{7\varepsilon ^{2}m^{2}A^{4}}{256w_{0}}";
    assert!(van_der_pol.contains(turning), "{van_der_pol}");
}

/// Nayfeh and Mook, sections 4.1.1, 4.1.2, 3.3.4 and 5.7.3, in the definitions of amplitude, phase and detuning here.
#[test]
fn textbook_results_are_derived() {
    let expected: [(usize, &[&str]); 4] = [
        (
            0,
            &[
                r"A'=-\varepsilon \mu A-\frac{\varepsilon F}{2w_{0}}\,\sin \varphi",
                r"-\varepsilon ax^{3}&=-\varepsilon a\left(A\,\cos \psi \right)^{3}\\",
                r"A_{\mathrm{max}}:=\frac{F}{2\mu w_{0}}",
                r"F=\sqrt{\frac{256\mu ^{3}w_{0}^{3}}{9\sqrt{3}\left|a\right|}}",
            ],
        ),
        (1, &[r"x=A\,\cos \psi +\frac{9F}{8w_{0}^{2}}\,\cos Wt", r"\int_{0}^{6\pi }"]),
        (5, &[r"\sin 2\varphi =\frac{4\mu w_{0}}{h}", r"\cos\left(\psi -Wt\right)"]),
        (23, &[r"A_{0}:=2", r"=-\varepsilon m"]),
    ];
    assert_contained(&expected);
}

#[test]
fn every_formula_but_definitions_is_evaluated_for_several_choices() {
    let mut compared = 0;
    for step in &duffing().steps {
        for block in &step.blocks {
            let Block::Equation { equation, .. } = block else { continue };
            match equation.check() {
                Check::Digits { compared_at: ComparedAt::Choices { choices }, .. }
                | Check::Choices { choices, .. } => {
                    assert_eq!(*choices, 3);
                    compared += 1;
                }
                check => assert!(matches!(check, Check::Definition | Check::Premise), "{check:?}"),
            }
        }
    }
    assert!(compared > 25, "{compared}");
}

#[test]
fn false_statements_fail_for_choices_of_symbols() {
    let mut trials = Trials::choices().unwrap();
    trials.choose(&Name::new("a"), &|choice| tenths(7 + i64::try_from(choice).unwrap())).unwrap();
    let square =
        |factor: i64| Statement::equal(sin(2 * letter("a")).squared(), number(factor) - sin(letter("a")));
    assert!(matches!(trials.compare_choices(square(1)), Err(DerivationError::Failed { .. })));
    // One choice of three is enough to refuse.
    let at_first = Statement::equal(letter("a"), tenths(7));
    assert!(matches!(trials.compare_choices(at_first), Err(DerivationError::Failed { .. })));
    let doubled = Statement::equal(2 * letter("a"), letter("a") + letter("a"));
    assert!(trials.compare_choices(doubled).is_ok());
}

#[test]
fn flows_of_several_orders_are_refused() {
    let refused: [Case; 5] = [
        // A detuning of another order than the rates, and terms between an order and its double.
        (
            "x'' + m*x' + w^2*x + a*x^3 = F*cos(W*t)",
            Some((1, 1)),
            &[("m", 1), ("a", 2), ("F", 1), ("sigma", 2)],
        ),
        ("x'' + m*x' + w^2*x + a*x^3 + b*x^5 = 0", None, &[("m", 2), ("a", 3), ("b", 4)]),
        // Products of three, of terms of two orders, and with a drive that is not small.
        ("x'' + w^2*x + m*x' + a*x^3 = 0", None, &[("m", 1), ("a", 3)]),
        ("x'' + w^2*x + m*x' + a*x^3 + b*x^5 = 0", None, &[("m", 1), ("a", 2), ("b", 3)]),
        ("x'' + m*x' + w^2*x + a*x^3 = F*cos(W*t)", Some((3, 1)), &[("a", 1), ("m", 2)]),
    ];
    for case in &refused {
        assert!(matches!(derived(case), Err(DerivationError::SeveralOrders)), "{}", case.0);
    }
    // Harmonics of abs act in the next order, and do not end.
    let kinked = ("x'' + c*x' + w^2*x + b*x*abs(x) = F*cos(W*t)", Some((1, 1)), &[("c", 2), ("F", 2)][..]);
    let kinked = derived(&kinked);
    assert!(
        matches!(kinked, Err(DerivationError::Symbolic(SymbolicSlowFlowError::KinkOrder(1)))),
        "{kinked:?}"
    );
    let taken = derived(&("x'' + eps*psi*x' + A*x = 0", None, &[]));
    assert!(matches!(taken, Err(DerivationError::TakenLetter { .. })), "{taken:?}");
    let taken = derived(&("x'' + eps*A_start*x' + x = 0", None, &[]));
    assert!(matches!(taken, Err(DerivationError::TakenLetter { .. })), "{taken:?}");
}

/// Nayfeh and Mook, sections 3.3 (damping by powers of the velocity, dry friction) and 3.3.4 (van der Pol); the phase by dφ/dA = φ′/A′.
#[test]
fn amplitude_and_phase_are_given_in_time() {
    let expected: [(usize, &[&str]); 9] = [
        (
            18,
            &[
                r"A=A_{\mathrm{start}}e^{-\varepsilon \mu t}",
                r"\varphi =\varphi _{\mathrm{start}}-\frac{3a}{16\mu w_{0}}\left(A^{2}-A_{\mathrm{start}}^{2}\right)",
            ],
        ),
        (19, &[r"A=A_{\mathrm{start}}e^{-\mu t/2}"]),
        (21, &[r"A=\frac{1}{A_{\mathrm{start}}^{-1}+\frac{4\varepsilon cwt}{3\pi }}"]),
        (22, &[r"A=A_{\mathrm{start}}-\frac{2\varepsilon Rt}{w\pi }"]),
        (
            23,
            &[
                r"A^{-2}=\left(A_{\mathrm{start}}^{-2}-\frac{1}{4}\right)e^{-\varepsilon mt}+\frac{1}{4}",
                r"\varphi =\varphi _{\mathrm{start}}-\frac{3b}{m}\,\ln \frac{A}{A_{\mathrm{start}}}+\frac{3\varepsilon bt}{2}",
            ],
        ),
        (
            26,
            &[
                r"A=\left(A_{\mathrm{start}}+\frac{4R}{cw\pi }\right)e^{-\varepsilon ct/2}-\frac{4R}{cw\pi }",
                "as long as this is positive.",
            ],
        ),
        (25, &["The phase follows by integrating its rate along this amplitude."]),
        // The factor of A in A′ is a sum.
        (
            28,
            &[
                r"A^{-1}=\left(A_{\mathrm{start}}^{-1}+\frac{\frac{4\varepsilon dw}{3\pi }}{\frac{\varepsilon c}{2}+\frac{\varepsilon k}{2}}\right)e^{\left(\varepsilon c/2+\varepsilon k/2\right)t}",
            ],
        ),
        (27, &[r"\psi'=w+\frac{3\varepsilon aA^{2}}{8w}"]),
    ];
    assert_contained(&expected);
}

#[test]
fn what_has_no_elementary_solution_is_left_out() {
    let has = |case: &Case| derived(case).unwrap().steps.iter().any(|step| step.id == "in-time");
    assert!(!has(&CASES[0]));
    assert!(!has(&("x'' + w^2*x + eps*(c*x' + d*x'^3 + k*x'^5) = 0", None, &[])));
}
