"""The pendulum in a notebook: what is drawn is the exact motion, and a start that cannot be is
refused.
"""

import numpy as np
import pytest

import libration as lb

pytest.importorskip("anywidget")
interpolate = pytest.importorskip("scipy.interpolate")

PENDULUM = lb.Pendulum(length=0.994, gravity=9.81)
MOTIONS = {
    "small": PENDULUM.release(1e-6),
    "wide": PENDULUM.release("150deg"),
    "next to the separatrix": PENDULUM.release("pi-1e-300"),
    "barely around": PENDULUM.launch("-30deg", 6.2),
    "fast": PENDULUM.launch(0.0, -300.0),
    "separatrix": lb.Pendulum(1.0, 9.0).launch(0.0, 6.0),
    "rest": PENDULUM.release(0.0),
    "upright": PENDULUM.release("180deg"),
    "a needle": lb.Pendulum(1e-6).release("90deg"),
}


@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS)
def test_what_is_drawn_is_the_motion(motion):
    course = motion.swing()._course
    t = np.linspace(0, course["span"], len(course["angles"]))
    between = interpolate.CubicHermiteSpline(t, course["angles"], course["velocities"])
    times = np.random.default_rng(1).uniform(0, course["span"], 2000)
    assert np.abs(between(times) - motion(times).angle).max() < 1e-4
    if course["repeats"]:
        later = motion(times + 3 * course["span"]).angle
        assert np.abs(between(times) + 3 * course["advance"] - later).max() < 1e-4


def test_captions_say_the_regime_and_the_period():
    said = {name: motion.swing().caption for name, motion in MOTIONS.items()}
    assert said["wide"] == "libration of 150°: T = 3.52448 s, 76.22 % longer than small swings"
    assert said["small"].endswith("6.25e-12 % longer than small swings")
    assert said["fast"] == "rotation: a turn takes 0.0209462 s"
    upwards = "separatrix: it approaches the upright position, and never reaches it"
    assert said["separatrix"] == upwards
    assert (said["rest"], said["upright"]) == ("rest (stable)", "rest (upright)")


def test_another_start_is_another_motion():
    swing = PENDULUM.release("60deg").swing()
    assert (swing.angle, swing.velocity) == (60.0, 0.0)
    before = swing._course
    swing.angle = 90
    assert swing.motion == lb.Motion(PENDULUM, "90.0deg") and swing._course != before
    swing.velocity = 9
    assert swing.motion.regime == "rotation" and swing.caption.startswith("rotation")
    swing.velocity, swing.angle = 0, 180
    assert swing.motion.regime == "rest (upright)"


@pytest.mark.parametrize(
    "name, value", [("angle", np.nan), ("angle", np.inf), ("velocity", np.nan), ("velocity", 1e200)]
)
def test_a_start_that_cannot_be_is_refused(name, value):
    swing = PENDULUM.release("60deg").swing()
    before = swing.motion, swing.caption, swing.angle, swing.velocity
    with pytest.raises(lb.LibrationError):
        setattr(swing, name, value)
    assert (swing.motion, swing.caption, swing.angle, swing.velocity) == before


def test_it_shows_itself():
    swing = PENDULUM.release("60deg").swing()
    bundle, _ = swing._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert repr(swing) == f"Swing({swing.motion!r})"
    assert "export default { render }" in swing._esm and ".libration-swing" in swing._css


def test_numbers_of_any_kind_are_starts():
    swing = PENDULUM.release("60deg").swing()
    for value in (np.float64(20), np.int64(20), np.float32(20), 20):
        swing.angle = value
        assert swing.motion == lb.Motion(PENDULUM, "20.0deg")
    with pytest.raises(AttributeError):
        swing.motion = PENDULUM.release("90deg")
