# Compares your answers with SymPy. Those of this notebook are written in hexadecimal digits, so that you do not read them by accident.
try:
    import sympy
    from sympy import Rational, cos, exp, log, pi, sin, sqrt, tan
    from sympy.simplify.fu import TR8
except ImportError:
    sympy = None
    print("SymPy, which compares your answers, is not installed: run %pip install sympy")


def formula(digits):
    """A formula of this notebook; what is left out, O(...), counts as zero."""
    functions = {"Q": sympy.Rational, "exact": sympy.sympify, "power": sympy.Pow, "ln": sympy.log, "O": lambda it: 0}
    return sympy.sympify(eval(bytes.fromhex(digits).decode(), {**vars(sympy), **functions, **SYMBOLS}))


def in_terms(it):
    """The numbers before the products of a sum, with cosines of sums in place of products of cosines."""
    terms = sympy.Add.make_args(sympy.expand(TR8(sympy.expand(it))))
    return {product: number for number, product in (term.as_coeff_Mul() for term in terms if term != 0)}


def are_equal(a, b):
    difference = sympy.expand((a - b).rewrite(sympy.exp))
    return difference == 0 or sympy.simplify(difference) == 0


def scaled(answer, known):
    """A condition times the number that makes most of its terms those of the known one."""
    common = [known[it] / number for it, number in answer.items() if it in known]
    factor = max(common, key=common.count) if common else 1
    return {it: number * factor for it, number in answer.items()}


def compare(number, answer):
    """Says whether an answer is right, right but not simplified, or in which terms it is wrong."""
    if sympy is None or answer is None:
        return print(f"({number}) no answer yet")
    is_zero, question, solution = QUESTIONS[number]
    question, solution = question and formula(question), formula(solution)
    answer = sympy.sympify(answer, locals=dict(SYMBOLS))
    ratio = sympy.simplify(answer / solution) if is_zero else 1
    # A condition is the same with a factor in it that is a product.
    if is_zero and ratio != 0 and not ratio.has(sympy.Add) or not is_zero and are_equal(answer, solution):
        products = lambda it: any(power.args[0].func in (sympy.sin, sympy.cos) for power in it.atoms(sympy.Pow))
        is_long = sympy.count_ops(answer) > 1.2 * sympy.count_ops(solution) + 1 or products(answer) and not products(solution)
        is_question = answer == question and answer != solution
        return print(f"({number}) right, but not simplified" if is_long or is_question else f"({number}) right")
    found, known = in_terms(answer), in_terms(solution)
    found = scaled(found, known) if is_zero else found
    wrong = [it for it in {**known, **found} if found.get(it, 0) != known.get(it, 0)]
    reason = lambda it: "too much" if it not in known else "missing" if it not in found else "its number"
    print(f"({number}) wrong: " + ", ".join(f"the term in {it} ({reason(it)})" for it in wrong))
