"""Questions of the command by `libration._native.ask`, and the command of the wheel."""

import json
import signal
import subprocess
import sys
import threading
import time

import pytest

import libration as lb
from interruption import alarmed
from libration import _native


def program(*arguments, **options):
    return subprocess.run(
        [sys.executable, "-m", "libration", *arguments], capture_output=True, text=True, **options
    )


QUESTIONS = [
    ["period", "60deg", "--json"],
    ["period", "0deg:170deg:1deg", "--csv"],
    ["motion", "60deg", "--times", "0:1:0.1", "--figure", "-"],
    ["expand", "duffing", "--order", "5", "--json"],
    ["decay", "60deg", "--linear", "0.1", "--cycles", "3"],
]


@pytest.mark.parametrize("arguments", QUESTIONS, ids=" ".join)
def test_answers_are_those_of_the_command(arguments):
    answer, notes, error, _ = _native.ask(arguments)
    told = program(*arguments)
    assert (answer, notes, error) == (told.stdout, [], None)
    assert told.returncode == 0 and answer


def test_many_amplitudes_have_what_each_has_alone():
    """A compiler optimised code of the batches wrongly that people get, and not that of the tests
    in Rust, which has other options.
    """
    amplitudes = [f"{degrees}deg" for degrees in range(0, 180, 5)] + [
        "pi-1e-6", "pi-1e-300", "1e-9"
    ]
    many = json.loads(_native.ask(["period", *amplitudes, "--json"])[0])["results"]
    each = [
        json.loads(_native.ask(["period", amplitude, "--json"])[0])["results"]
        for amplitude in amplitudes
    ]
    assert [[found] for found in many] == each


@pytest.mark.parametrize(
    "arguments, kind, status",
    [
        (["period", "60degg"], lb.errors.UsageError, 2),
        (["period", "200deg"], lb.errors.NoAnswer, 1),
    ],
)
def test_errors_have_the_message_of_the_command(arguments, kind, status):
    answer, _, error, _ = _native.ask(arguments)
    told = program(*arguments)
    assert type(error) is kind and answer == "" and told.returncode == status
    assert str(error).removeprefix("amplitudes: ") in told.stderr
    assert error.parameter == "amplitudes" and error.hint is None


def test_notes_come_beside_the_answer():
    _, notes, _, _ = _native.ask(
        ["simulate", "pendulum", "--initial", "theta=30", "--times", "0:1:1", "--json"]
    )
    told = program(
        "simulate", "pendulum", "--initial", "theta=30", "--times", "0:1:1", "--json"
    ).stderr
    assert [f"note: {note}\n" for note in notes] == [told] and "degrees" in told


def test_the_input_stands_for_a_file():
    table = b"amplitude (deg),period (s)\n10,2.01\n30,2.04\n50,2.1\n70,2.21\n"
    arguments = ["fit", "periods", "-", "--json"]
    answer, _, error, _ = _native.ask(arguments, table)
    written = program(*arguments, input=table.decode()).stdout
    assert error is None and "give length to obtain gravity" in answer
    assert answer == written.replace("--length", "length")


def test_ctrl_c_ends_an_answer_and_keeps_what_is_done():
    answer, _, error, _ = alarmed(
        0.3, lambda: _native.ask(["expand", "pendulum", "--order", "999", "--json"])
    )
    assert isinstance(error, KeyboardInterrupt)
    if answer:
        assert json.loads(answer)["interrupted"] is True
    assert _native.ask(["period", "1", "--json"])[2] is None


def test_what_the_function_of_the_progress_raises_ends_the_answer():
    def fails(how_far):
        raise RuntimeError(how_far)

    _, _, error, _ = _native.ask(["expand", "pendulum", "--order", "999", "--json"], None, fails)
    assert type(error) is RuntimeError and "order" in str(error)


def test_threads_ask_at_the_same_time_and_others_go_on():
    options = ["--set=A=1.5,c=1/2", "--points=20", "--skip=1", "--json"]
    starts = [f"--initial=theta=0.{n}" for n in range(1, 7)]
    questions = [["section", "driven_pendulum", start, *options] for start in starts]
    alone = [_native.ask(question)[0] for question in questions]
    together = [""] * len(questions)

    def ask(n):
        together[n] = _native.ask(questions[n])[0]

    asking = [threading.Thread(target=ask, args=(n,)) for n in range(len(questions))]
    for thread in asking:
        thread.start()
    turns = 0
    while any(thread.is_alive() for thread in asking):
        turns += 1
        time.sleep(0)
    for thread in asking:
        thread.join()
    assert together == alone and turns > 0


def test_the_command_ends_at_ctrl_c():
    running = subprocess.Popen(
        [sys.executable, "-m", "libration", "expand", "pendulum", "--order", "999", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    time.sleep(1)
    running.send_signal(signal.SIGINT)
    _, told = running.communicate()
    assert running.returncode in (130, -signal.SIGINT), told


def test_a_missing_file_is_a_file_not_found_error(tmp_path):
    with pytest.raises(FileNotFoundError, match="cannot read"):
        lb.lab.fit_periods(tmp_path / "none.csv")
    with pytest.raises(lb.errors.NoAnswer):
        lb.lab.read(tmp_path / "none.csv")
