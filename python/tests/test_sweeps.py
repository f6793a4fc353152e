"""Sweeps: what they answer, and that nothing that happens on the way shows in the store."""

import json
import pickle
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import libration as lb

xarray = pytest.importorskip("xarray")
pytest.importorskip("zarr", minversion="3")
pytest.importorskip("distributed")

import killing  # noqa: E402
from interruption import interrupted_after  # noqa: E402


@pytest.fixture(scope="session")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The files of a store that was made at once."""
    place = tmp_path_factory.mktemp("undisturbed") / "sweep.zarr"
    killing.asked(place)
    return killing.tree(place)


def test_a_sweep_gives_what_each_question_gives(tmp_path: Path) -> None:
    amplitudes = np.radians([10.0, 60.0, 179.0])
    periods = lb.sweep(
        "period", {"amplitude": amplitudes, "length": [0.5, 2.0]}, tmp_path / "periods.zarr"
    )
    assert periods.sizes == {"amplitude": 3, "length": 2}
    np.testing.assert_array_equal(periods.amplitude, amplitudes)
    np.testing.assert_array_equal(periods.ratio, np.transpose([lb.period_ratio(amplitudes)] * 2))
    np.testing.assert_array_equal(
        periods.period_s[:, 1], lb.period(amplitudes, 2.0, lb.STANDARD_GRAVITY)
    )
    assert (periods.status == 0).all() and (periods.message == "").all()
    assert periods.period_s.attrs["units"] == "s"
    assert periods.period_s.attrs["long_name"].startswith("exact period")
    assert periods.attrs["question"] == "libration period '{amplitude}' --length '{length}'"
    assert periods.attrs["version"] == lb.__version__


def test_lists_are_a_further_dimension(tmp_path: Path) -> None:
    question = "section driven_pendulum --set c=1/2 --points 4 --skip 1"
    keep = {"omega": "points[0:6].state[1]", "first": "points[0].state[0]"}
    found = lb.sweep(
        question, {"A": "1:1.2:0.1", "theta": [0.1, 0.2]}, tmp_path / "a.zarr", keep=keep, chunk=2
    )
    assert found.omega.dims == ("A", "theta", "omega_number") and found.omega.shape == (3, 2, 6)
    assert np.isfinite(found.omega[..., :4]).all() and np.isnan(found.omega[..., 4:]).all()
    answer = lb._native.ask(
        [*question.split(), "--json", "--set", "A=1.1", "--initial", "theta=0.2"]
    )[0]
    points = json.loads(answer)["points"]
    np.testing.assert_array_equal(found.omega[1, 1, :4], [point["state"][1] for point in points])
    assert found["first"].dims == ("A", "theta")


def test_points_without_an_answer_say_why(tmp_path: Path) -> None:
    found = lb.sweep(
        "period",
        {"amplitude": ["60deg", "190deg", "0x"]},
        tmp_path / "a.zarr",
        keep=["results[0].ratio"],
    )
    assert found.status.values.tolist() == [0, 1, 2]
    assert np.isnan(found["ratio"].values).tolist() == [False, True, True]
    assert "below pi" in str(found.message.values[1]) and str(found.message.values[0]) == ""
    assert [str(it) for it in found.amplitude.values] == ["60deg", "190deg", "0x"]
    degrees = lb.sweep("period", {"amplitude": "10deg:30deg:10deg"}, tmp_path / "b.zarr")
    assert degrees.amplitude.values.tolist() == [10.0, 20.0, 30.0]
    assert degrees.amplitude.attrs["units"] == "deg"


def test_any_chunks_and_any_number_of_threads_give_the_same_numbers(
    tmp_path: Path, undisturbed: dict[str, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    for threads in (1, 3):
        monkeypatch.setattr(lb._workers, "cores", lambda: threads)
        again = killing.asked(tmp_path / f"{threads}.zarr")
        assert killing.tree(tmp_path / f"{threads}.zarr") == undisturbed
    other = lb.sweep(
        killing.QUESTION, killing.OVER, tmp_path / "c.zarr", keep=killing.KEEP, chunk=50
    )
    np.testing.assert_array_equal(other.omega, again.omega)


def test_questions_take_keywords(tmp_path: Path) -> None:
    given = {"system": "driven_pendulum", "set": {"c": "1/2"}, "skip": 1, "points": 2}
    over = {"A": [1.0, 1.1], "theta": [0.1]}
    keep = {"omega": "points[0:2].state[1]"}
    found = lb.sweep("section", over, tmp_path / "a.zarr", keep=keep, **given)
    text = lb.sweep(
        "section driven_pendulum --set c=1/2 --skip 1 --points 2",
        over,
        tmp_path / "b.zarr",
        keep=keep,
    )
    np.testing.assert_array_equal(found.omega, text.omega)
    initial = lb.sweep(
        "section",
        {"theta'": [1.0]},
        tmp_path / "c.zarr",
        keep=keep,
        **given,
        initial={"theta": 0.1},
        period=6.0,
    )
    assert initial.sizes["theta'"] == 1 and np.isfinite(initial.omega).all()
    with pytest.raises(TypeError, match="takes no `speed`"):
        lb.sweep("section", over, tmp_path / "d.zarr", speed=1, **given)
    with pytest.raises(lb.errors.UsageError, match="not a query that takes keywords"):
        lb.sweep("section --points 2", over, tmp_path / "d.zarr", **given)


def test_a_finished_store_is_read_and_another_sweep_refused(tmp_path: Path) -> None:
    place = tmp_path / "a.zarr"
    lb.sweep("period", {"amplitude": [0.5, 1.0]}, place)
    before = killing.tree(place)
    lb.sweep("period", {"amplitude": [0.5, 1.0]}, place)
    others = [
        ("period --length 2m", {"amplitude": [0.5, 1.0]}, {}),
        ("period", {"amplitude": [0.5, 1.1]}, {}),
        ("period", {"amplitude": [0.5, 1.0]}, {"keep": ["results[0].ratio"]}),
        ("period", {"amplitude": [0.5, 1.0]}, {"chunk": 2}),
    ]
    for question, over, how in others:
        with pytest.raises(lb.errors.NoAnswer, match="another sweep"):
            lb.sweep(question, over, place, **how)
    assert killing.tree(place) == before
    root = place / "zarr.json"
    text = root.read_text()
    for old, new, reason in [
        ('"format": 1', '"format": 2', "its format is 2"),
        ('"version": "', '"version": "9.', "its version"),
    ]:
        root.write_text(text.replace(old, new))
        with pytest.raises(lb.errors.NoAnswer, match=reason):
            lb.sweep("period", {"amplitude": [0.5, 1.0]}, place)
    own = tmp_path / "own"
    own.mkdir()
    (own / "letter.txt").write_text("dear")
    with pytest.raises(lb.errors.NoAnswer, match="something other than a sweep"):
        lb.sweep("period", {"amplitude": [0.5, 1.0]}, own)


def test_questions_that_cannot_be_are_refused_before_anything_is_written(tmp_path: Path) -> None:
    place = tmp_path / "a.zarr"
    for question, over in [
        ("nonsense", {"a": [1]}), ("period", {"amplitude": ["190deg"]}), ("period 1", {"b": [1]})
    ]:
        with pytest.raises(lb.LibrationError):
            lb.sweep(question, over, place)
    with pytest.raises(ValueError, match="2 dimensions"):
        lb.sweep("period", {"amplitude": [[1.0]]}, place)
    with pytest.raises(lb.errors.UsageError, match="speed"):
        lb.sweep("period", {"amplitude": [1.0]}, place, keep=["speed"])
    assert not place.exists()


def test_progress_is_told_to_the_last_point(tmp_path: Path) -> None:
    seen: list[tuple[int, int | None]] = []
    lb.sweep(
        "period",
        {"amplitude": [0.5, 1.0, 1.5]},
        tmp_path / "a.zarr",
        progress=lambda done, of: seen.append((done, of)),
    )
    assert seen == [(1, 3), (2, 3), (3, 3)]


def started(place: Path, before: int) -> "subprocess.Popen[bytes]":
    """A process with a sweep of which more than this number of chunks are done."""
    running = killing.client(place, None)
    killing.until(lambda: killing.chunks_done(place) > before or running.poll() is not None)
    return running


def test_a_killed_process_is_gone_on_from(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    place = tmp_path / "sweep.zarr"
    for before in (0, 5, 20):
        running = started(place, before)
        running.kill()
        running.communicate()
        done = killing.tree(place)
        assert all(undisturbed[path] == content for path, content in done.items())
    killing.asked(place)
    assert killing.tree(place) == undisturbed
    left = [file.name for file in tmp_path.iterdir()]
    assert left == ["sweep.zarr"], "something unfinished is left next to the store"


def test_ctrl_c_keeps_what_is_done(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    for attempt in range(5):
        place = tmp_path / f"{attempt}.zarr"
        running = started(place, 2)
        running.send_signal(signal.SIGINT)
        _, message = running.communicate(timeout=killing.LONGEST)
        # The sweep takes half a second, and may have ended before the signal came.
        if running.returncode != 0:
            break
    assert running.returncode != 0 and b"Interrupted" in message, message.decode()
    assert 2 < killing.chunks_done(place)
    killing.asked(place)
    assert killing.tree(place) == undisturbed


def test_a_file_is_on_the_disk_before_it_is_in_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[bool] = []
    monkeypatch.setattr(
        lb._zarr.os, "fsync", lambda file: seen.append((tmp_path / "store/a/b").exists())
    )
    lb._zarr.write(tmp_path / "store", "a/b", b"content")
    assert seen == [False] and (tmp_path / "store/a/b").read_bytes() == b"content"


def test_a_sweep_that_ends_before_any_of_its_files_is_gone_on_with(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def small(name: str) -> "dict[str, bytes]":
        lb.sweep("period", {"amplitude": [0.5, 1.0]}, tmp_path / name, keep=["results[0].ratio"])
        return killing.tree(tmp_path / name)

    undisturbed, write = small("undisturbed"), lb._zarr.write
    for number in range(len(undisturbed)):
        left = iter(range(number))

        def failing(store: Path, path: str, content: bytes) -> None:
            if next(left, None) is None:
                raise OSError("the power is off")
            write(store, path, content)

        with monkeypatch.context() as patch:
            patch.setattr(lb._zarr, "write", failing)
            with pytest.raises(lb.errors.NoAnswer, match="the power is off"):
                small(f"{number}")
        assert small(f"{number}") == undisturbed


def test_ctrl_c_before_the_first_answer(tmp_path: Path) -> None:
    question = "lyapunov double_pendulum --intervals 100000000"
    caught = interrupted_after(
        0.5, lambda: lb.sweep(question, {"theta1": [2.0]}, tmp_path / "a.zarr")
    )
    assert caught.partial is None and not (tmp_path / "a.zarr").exists()


FULL = """
import resource, sys
import libration as lb
resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
question = "section driven_pendulum --initial theta=0.2 --set c=1/2 --points 3 --skip 1"
keep = {"omega": "points[0:600].state[1]", "first": "points[0].state[1]"}
lb.sweep(question, {"A": [1.0, 1.1, 1.2]}, sys.argv[1], keep=keep, chunk=1)
"""


def test_a_full_disk_is_told(tmp_path: Path) -> None:
    place = tmp_path / "sweep.zarr"
    output = subprocess.run(
        [sys.executable, "-c", FULL, str(place)], capture_output=True, text=True
    )
    assert "NoAnswer: cannot write" in output.stderr
    assert "continues from there" in output.stderr, output.stderr
    assert killing.chunks_done(place) == 0
    drafts = [file for file in tmp_path.rglob("*.part")]
    assert drafts == []
    question = "section driven_pendulum --initial theta=0.2 --set c=1/2 --points 3 --skip 1"
    keep = {"omega": "points[0:600].state[1]", "first": "points[0].state[1]"}
    found = lb.sweep(question, {"A": [1.0, 1.1, 1.2]}, place, keep=keep, chunk=1)
    assert (found.status == 0).all()


@pytest.mark.parametrize("victim", ["worker", "scheduler", "client"])
def test_a_cluster_that_is_killed_leaves_the_same_store(
    victim: str, tmp_path: Path, undisturbed: dict[str, bytes]
) -> None:
    assert killing.round_of(victim, tmp_path, seed=len(victim)) == undisturbed


def test_plans_go_to_workers() -> None:
    plan = lb._plan.Plan(
        lb._native.sweep_plan(["period"], [("amplitude", ["0.5", "1.0"])], [], None)
    )
    assert pickle.loads(pickle.dumps(plan)) == plan


def test_what_is_kept_and_where_is_checked(tmp_path: Path) -> None:
    question, over = "modes double_pendulum", {"m2": [1, 2]}
    for keywords, told in [
        ({"over": {}}, "there is no axis"),
        ({"over": over, "chunk": 0}, "1 or more"),
        ({"over": over, "keep": {"a/b": "modes[0].angular_frequency_rad_per_s"}}, "has no `/`"),
        ({"over": over}, "all numbers of these results stand in lists"),
        ({"over": over, "keep": ["modes[0].freq"]}, "they have lists that"),
    ]:
        with pytest.raises(lb.errors.UsageError, match=told):
            lb.sweep(question, store=tmp_path / "s.zarr", **keywords)
    keep = "omega=modes[0].angular_frequency_rad_per_s"
    assert lb.sweep(question, over, tmp_path / "s.zarr", keep=keep).omega.shape == (2,)
