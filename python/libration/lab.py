"""The laboratory: files of instruments and fits of their data.

>>> import numpy as np
>>> import libration as lb
>>> t = np.arange(0, 20, 0.05)
>>> angle = lb.Pendulum(length=0.57).release("40deg")(t).angle
>>> rec = lb.lab.recording(t=t, angle=angle + 1e-3 * np.sin(1e4 * t**2))
>>> rec.traces.rows.tolist(), rec.traces.seen.tolist()
([400], ['angle'])
>>> fit = lb.lab.fit_trace(rec, length="0.570(1)m", model="undamped")
>>> print(fit.g)
9.807+/-0.017
"""

from __future__ import annotations

from inspect import signature
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._ask import Columns, Given, Path, Table
from ._numbers import floats
from .answer import Answer, answer
from .fit import Fit, Measured
from .questions import fit_amplitudes, fit_gates, fit_lengths, fit_periods, fit_response, fit_trace
from .questions import inspect as _inspect
from .questions import plan

__all__ = [
    "Fit",
    "Measured",
    "Recording",
    "fit_gates",
    "fit_amplitudes",
    "fit_lengths",
    "fit_periods",
    "fit_response",
    "fit_trace",
    "plan",
    "read",
    "recording",
    "spectrum",
]


class Recording(Answer):
    """The contents of a file: the results of `libration inspect`, and its numbers.

    Fits take it in place of the file, read in the same way.
    """

    __slots__ = ()

    @property
    def columns(self) -> dict[str, NDArray[Any]]:
        """The columns by their headers, in the units of the file; NaN without a number."""
        columns = [(it["name"] or str(it["number"]), it["values"]) for it in self["column_values"]]
        return {name: np.array(values, dtype=float) for name, values in columns}


def read(file: Path | Columns, **reading: Given | bool) -> Recording:
    """Reads the file of an instrument: text in any dialect, Excel, archives; or columns.

    Parameters
    ----------
    file : str or path or mapping or pandas.DataFrame
        The file, or columns by names with units, such as ``{"t (s)": t, "theta (deg)": angle}``.
    **reading
        Settings in place of detected ones, such as ``angle=2, angle_unit="deg"``: the parameters of
        `libration.questions.inspect`, with the same names.

    Returns
    -------
    Recording

    Raises
    ------
    NoAnswer
        The file cannot be read.
    UsageError
        It does not have the requested columns or runs.
    TypeError
        There is no such parameter.

    Examples
    --------
    >>> import libration as lb
    >>> rec = lb.lab.read({"t (s)": [0, 0.1, 0.2], "theta (deg)": [61, 55, 38]})
    >>> rec.columns["theta (deg)"].tolist()
    [61.0, 55.0, 38.0]
    >>> rec.trace_values[0]["values"]
    [1.064650843716541, 0.9599310885968813, 0.6632251157578453]
    """
    found = _inspect(file, **_known("read", {"values": True, **reading}))
    return Recording(found, found._asked)


HEADERS = {
    "t": "t (s)",
    "angle": "angle (rad)",
    "angular_velocity": "angular velocity (rad/s)",
    "x": "x (m)",
    "y": "y (m)",
    "uncertainty": "uncertainty",
}


def recording(
    *,
    t: ArrayLike,
    angle: ArrayLike | None = None,
    angular_velocity: ArrayLike | None = None,
    x: ArrayLike | None = None,
    y: ArrayLike | None = None,
    uncertainty: ArrayLike | None = None,
) -> Recording:
    """A recording from arrays, in seconds, radians and metres; it is read like a file.

    Parameters
    ----------
    t : array_like
        Times in seconds.
    angle, angular_velocity : array_like
        Angles from the downward vertical in radians, or angular velocities in rad/s.
    x, y : array_like
        Positions in metres, in place of an angle.
    uncertainty : array_like
        Standard uncertainties of the angles or angular velocities; a number for all of them.

    Returns
    -------
    Recording

    Examples
    --------
    >>> import libration as lb
    >>> rec = lb.lab.recording(t=[0, 0.1, 0.2], angle=[1.0, 0.9, 0.6], uncertainty=0.01)
    >>> rec.traces.has_uncertainties.tolist()
    [True]
    """
    own = {name: it for name, it in locals().items() if name in HEADERS and it is not None}
    given = {name: floats(name, it) for name, it in own.items()}
    shape = given["t"].shape
    columns = {
        HEADERS[name]: np.broadcast_to(it, shape) if it.ndim == 0 else it
        for name, it in given.items()
    }
    options: dict[str, Any] = {"uncertainty": "uncertainty"} if uncertainty is not None else {}
    return answer(Recording, "inspect", {"file": Table(columns), "values": True, **options})


def spectrum(
    file: Path | Columns,
    *,
    harmonics: int | None = None,
    swings: int | None = None,
    **reading: Given | bool,
) -> Answer:
    """The harmonics of measured swings, compared with a pendulum of the same first harmonic.

    Windows of a few swings are fitted by least squares, with the phase of the first harmonic, so
    that amplitudes may fall, and rows may be uneven, missing or wrong; uncertainties are from the
    noise about each harmonic. ``.plot()`` draws the spectrum with both. Even harmonics show an
    asymmetry, odd ones that differ show another torque or a wrong scale of the angle; ``remarks``
    states it.

    Parameters
    ----------
    file : str or path or mapping or Recording
        A file, columns by names with units, or what was read of them.
    harmonics : int, optional
        The highest harmonic; default 7.
    swings : int, optional
        The number of swings in a window; default 5, at least 3.
    **reading
        Settings in place of detected ones, as for `read`.

    Returns
    -------
    Answer
        With ``traces``, a row for each run, whose ``harmonics`` are the means of its ``windows``.

    Raises
    ------
    NoAnswer
        There are too few swings, none that can be seen above the noise, or the file cannot be read.
    UsageError
        It does not have the requested columns or runs.
    TypeError
        There is no such parameter.

    Examples
    --------
    >>> import numpy as np
    >>> import libration as lb
    >>> t = np.arange(0, 20, 0.02)
    >>> angle = lb.Pendulum(length=0.57).release("80deg")(t).angle
    >>> rng = np.random.default_rng(1)
    >>> found = lb.lab.spectrum(lb.lab.recording(t=t, angle=angle + 1e-3 * rng.normal(size=t.size)))
    >>> third = found.traces[0].harmonics[3]
    >>> bool(abs(third["in_phase"] - third["theory"]) < 4 * third["difference_uncertainty"])
    True
    >>> round(third["theory"], 4)
    -0.0162
    """
    given = {"spectrum": True, "harmonics": harmonics, "swings": swings, **reading}
    return _inspect(file, **_known("spectrum", given))


def _known(function: str, given: dict[str, Any]) -> dict[str, Any]:
    """The parameters of `libration.questions.inspect`; others are refused."""
    known = [it for it in signature(_inspect).parameters if it not in ("file", "progress")]
    for name in given:
        if name not in known:
            raise TypeError(f"{function} takes no `{name}`: it takes {', '.join(known)}")
    return given
