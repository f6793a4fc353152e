"""Notebooks of derivations: every cell runs, and answers to exercises are compared by SymPy."""

import contextlib
import io
import json

import pytest
import sympy

import libration as lb

DRIVEN = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)"
DERIVATIONS = [
    ("short", {}),
    ("perturbation", {"order": 3}),
    ("perturbation", {"oscillator": "helmholtz_duffing", "order": 2}),
    ("averaging", {"order": 1}),
    ("averaging", {"set": {"n": 2}, "order": 2}),
    ("limit-cycle", {"order": 4}),
    ("averaging", {"oscillator": DRIVEN, "resonance": "1/1"}),
]


def code_cells(method, given, exercises):
    derivation = lb.derive(method, **given, exercises=exercises)
    cells = json.loads(derivation.to_notebook())["cells"]
    return [cell for cell in cells if cell["cell_type"] == "code"]


def output_of(program, names):
    written = io.StringIO()
    with contextlib.redirect_stdout(written):
        exec(compile(program, "cell", "exec"), names)
    return written.getvalue()


@pytest.mark.parametrize("method, given", DERIVATIONS)
def test_every_cell_of_exercises_runs(method, given):
    cells = code_cells(method, given, exercises=True)
    names = {"__name__": "__main__"}
    said = "".join(output_of(cell["source"], names) for cell in cells)
    folded = [cell for cell in cells if cell["metadata"]]
    assert all(cell["metadata"]["jupyter"]["source_hidden"] for cell in folded)
    assert {cell["id"] for cell in folded} <= {"prelude", "comparison"}
    asked = sum(cell["id"].startswith("exercise-") for cell in cells)
    assert said.count("no answer yet") == asked > 0


def compared(names, place, answer):
    return output_of(f"compare({place!r}, answer)", names | {"answer": answer}).strip()


@pytest.mark.parametrize("method, given", DERIVATIONS)
def test_answers_are_right_or_not_simplified_or_wrong_in_a_term(method, given):
    names = {"__name__": "__main__"}
    cells = code_cells(method, given, exercises=True)
    (comparison,) = (cell["source"] for cell in cells if cell["id"] == "comparison")
    output_of(comparison, names)
    own = sympy.Symbol("own", positive=True)
    assert names["QUESTIONS"]
    for place, (is_zero, _, digits) in names["QUESTIONS"].items():
        solution = names["formula"](digits)
        head = f"({place}) "
        assert compared(names, place, solution) == head + "right"
        if solution.is_number:
            assert compared(names, place, solution + 1).startswith(head + "wrong")
            continue
        terms = sympy.Add.make_args(sympy.expand(solution))
        parts = [n * term / 10 for term in terms for n in (1, 2, 3, 4)]
        long = sympy.Add(*parts, evaluate=False)
        assert compared(names, place, long) == head + "right, but not simplified", solution
        more = compared(names, place, solution + own)
        assert more == head + "wrong: the term in own (too much)", (solution, more)
        if not is_zero:
            doubled = compared(names, place, solution + terms[0])
            assert doubled.startswith(head + "wrong: the term in "), (solution, doubled)
        if is_zero:
            assert compared(names, place, -solution) == head + "right"


def test_a_textbook_answer_is_judged_term_by_term():
    names = {"__name__": "__main__"}
    cells = code_cells("perturbation", {"order": 3}, exercises=True)
    output_of(next(cell["source"] for cell in cells if cell["id"] == "comparison"), names)
    # cos^3 x = (3 cos x + cos 3x)/4.
    answers = {
        "(3*cos(τ) + cos(3*τ))/4": "(4.2) right",
        "cos(τ)**3": "(4.2) right, but not simplified",
        "cos(τ)/4 + cos(3*τ)/4": "(4.2) wrong: the term in cos(τ) (its number)",
        "3*cos(τ)/4": "(4.2) wrong: the term in cos(3*τ) (missing)",
    }
    for answer, said in answers.items():
        assert compared(names, "4.2", answer) == said
        assert compared(names, "4.2", eval(answer, names)) == said


def test_notebooks_run_in_jupyter():
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    notebook = nbformat.reads(
        lb.derive("perturbation", order=3, exercises=True).to_notebook(), as_version=4
    )
    nbformat.validate(notebook)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
