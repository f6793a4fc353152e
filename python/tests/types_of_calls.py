"""Types that a checker must find: read by mypy and pyright, not run."""

from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import xarray
from numpy.typing import NDArray
from typing_extensions import assert_type

import libration as lb

Floats = NDArray[np.floating[Any]]

array = np.linspace(0.0, 1.0, 5)
assert_type(lb.period_ratio(1.0), np.float64)
assert_type(lb.period_ratio(array), Floats)
assert_type(lb.period([0.1, 0.2], 1.0, 9.81), Floats)
assert_type(lb.period_excess(array, out=array, where=array > 0.5), Floats)
assert_type(lb.motion(1.0, 1.0, 0.0, 3.0), tuple[np.float64, np.float64])
assert_type(lb.state(array, 1.0, 3.0), tuple[Floats, Floats])
assert_type(lb.special.ellipj(array, 0.5), tuple[Floats, Floats, Floats, Floats])
assert_type(lb.special.ellipkinc(0.5, 0.5), np.float64)
assert_type(lb.special.ellipk.nin, int)

motion = lb.Pendulum("99.4cm", 9.81).release("60deg")
assert_type(motion.period, float)
angle, velocity = motion(array)
assert_type(lb.Pendulum(Decimal("1.2"), Fraction(981, 100)).launch(np.float32(0), 1), lb.Motion)
assert_type(lb.Motion(motion.pendulum, Fraction(1, 2), "30deg/s")(Decimal("0.5")), lb.State)
assert_type(lb.formulas.best(amplitude=Decimal(1), tolerance=1e-3).error(Decimal(1)), float)
assert_type(lb.formulas["bernoulli"].ratio([0.1, 0.2]), NDArray[np.float64])
assert_type(motion.harmonics().angle, NDArray[np.float64])
assert_type(lb.formulas["bernoulli"].error("60deg"), float)
assert_type(
    lb.sweep("period", {"amplitude": array, "length": ["1m", "2m"]}, "periods.zarr"), xarray.Dataset
)

lb.period(1.0, 1.0)  # type: ignore[call-overload]  # pyright: ignore
lb.state(array, 1.0, 3.0, out=array)  # type: ignore[call-overload]  # pyright: ignore

decay = lb.decay("60deg", linear=0.1, power=["1.5:0.1"], cycles=3)
assert_type(decay, lb.Answer)
assert_type(decay.rows, lb.Rows)
assert_type(decay.to_dict(), dict[str, Any])
assert_type(decay.rows[0], lb.Fields)
assert_type(
    lb.section(
        "driven_pendulum",
        set={"A": 1.5, "c": "1/2"},
        initial=[{"theta": 0.2}],
        direction="rising",
        points=3,
    ),
    lb.Answer,
)
assert_type(lb.backbone("duffing", amplitudes=np.linspace(0.1, 1, 3)), lb.Answer)
assert_type(lb.figure.errors(formulas=["bernoulli"]), lb.Picture)
assert_type(lb.derive("elliptic"), lb.Derivation)
assert_type(lb.paper("black-vel").wrong, lb.Rows)
recording = lb.lab.read("swing.csv", angle=2, angle_unit="deg")
assert_type(recording, lb.lab.Recording)
assert_type(lb.lab.fit_trace(recording, length="0.57m±0.004m"), lb.lab.Fit)
assert_type(lb.expand("pendulum").code("rust"), str)
assert_type(lb.expand("duffing", letters="epsilon").frequency(0.1, epsilon=Fraction(1, 2)), float)
sol = lb.simulate("pendulum", {"theta": Fraction(1, 2)}, Decimal(1), events=["theta"])
assert_type(sol["theta"], NDArray[np.float64])
assert_type(sol.events["theta"], lb.Events)
assert_type(sol(array), lb.States)
lb.nothing  # type: ignore[attr-defined]  # pyright: ignore
lb.questions.nothing  # type: ignore[attr-defined]  # pyright: ignore
lb.decay("60deg", lineer=0.1)  # type: ignore[call-arg]
lb.Pendulum(lenght=1.0)  # type: ignore[call-arg]
lb.Pendulum([1.0])  # type: ignore[arg-type]
lb.section("lorenz", direction="up")  # type: ignore[arg-type]
