"""Arrays in ufuncs: shapes, types, memory, flags, threads."""

import copy
import pickle
import re
import subprocess
import sys
import threading
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import libration as lb
from libration import _ufuncs
from ufuncs import ALL, inputs, outputs, same

every = pytest.mark.parametrize("ufunc", ALL)


@every
def test_is_a_ufunc_with_loops_for_two_types(ufunc):
    assert isinstance(ufunc, np.ufunc)
    assert ufunc.types == [f"{c * ufunc.nin}->{c * ufunc.nout}" for c in "fd"]


@every
@pytest.mark.parametrize(
    "count", [0, 1, 7, 8, 9, 63, 64, 65, 255, 256, 257, 2047, 2048, 2049, 4097]
)
def test_arrays_are_their_scalars_bit_for_bit(ufunc, count):
    arguments = inputs(ufunc, count)
    found = outputs(ufunc(*arguments))
    for i in range(count):
        one = outputs(ufunc(*(float(x[i]) for x in arguments)))
        assert [x[i].tobytes() for x in found] == [x.tobytes() for x in one]


@every
def test_strides_order_and_bytes_do_not_matter(ufunc):
    arguments = inputs(ufunc, (20, 30))
    expected = ufunc(*arguments)
    same(ufunc(*(x[::-1] for x in arguments)), tuple(x[::-1] for x in outputs(expected)))
    same(ufunc(*(x[::3, ::-2] for x in arguments)), tuple(x[::3, ::-2] for x in outputs(expected)))
    same(ufunc(*map(np.asfortranarray, arguments)), expected)
    same(ufunc(*(x.astype(">f8") for x in arguments)), expected)
    unaligned = [
        np.frombuffer(b"\0" + x.tobytes(), dtype=np.uint8)[1:].view(float).reshape(x.shape)
        for x in arguments
    ]
    same(ufunc(*unaligned), expected)


@every
def test_arguments_are_broadcast(ufunc):
    arguments = inputs(ufunc, 6)
    shapes = [tuple(5 if i == j else 1 for j in range(ufunc.nin)) for i in range(ufunc.nin)]
    spread = [x[:5].reshape(shape) for x, shape in zip(arguments, shapes)]
    found = outputs(ufunc(*spread))
    assert found[0].shape == (5,) * ufunc.nin
    same(tuple(found), ufunc(*(np.array(x) for x in np.broadcast_arrays(*spread))))
    # One number beside arrays, on either side: a step of zero bytes.
    for fixed in range(ufunc.nin if ufunc.nin > 1 else 0):
        mixed = [float(x[0]) if i == fixed else x for i, x in enumerate(arguments)]
        full = [np.full(6, x) if np.ndim(x) == 0 else x for x in mixed]
        same(ufunc(*mixed), ufunc(*full))


@every
def test_shapes_that_do_not_fit_are_refused(ufunc):
    if ufunc.nin > 1:
        with pytest.raises(ValueError, match="broadcast"):
            ufunc(*(np.full(3 + i, 0.5) for i in range(ufunc.nin)))


@every
def test_single_precision_is_double_precision_rounded(ufunc):
    arguments = [x.astype(np.float32) for x in inputs(ufunc)]
    found = outputs(ufunc(*arguments))
    assert all(x.dtype == np.float32 for x in found)
    same(
        tuple(found),
        tuple(x.astype(np.float32) for x in outputs(ufunc(*(x.astype(float) for x in arguments)))),
    )


@every
@pytest.mark.parametrize("kind", ["?", "b", "B", "h", "H", "i", "q", "Q", "e", "d"])
def test_all_types_but_single_precision_are_computed_in_double_precision(ufunc, kind):
    ones = [np.ones(3, kind)] * ufunc.nin
    expected = ufunc(*[np.ones(3)] * ufunc.nin)
    assert outputs(expected)[0].dtype == np.float64
    same(ufunc(*ones), expected)
    same(ufunc(*(x[0] for x in ones)), tuple(x[0] for x in outputs(expected)))
    # Python numbers, and arrays of another of these types, next to them keep their digits.
    for other in (0.3, np.float16(0.3), np.float64(0.3)):
        mixed = [*ones[1:], other]
        same(ufunc(*mixed), ufunc(*([np.ones(3)] * (ufunc.nin - 1)), float(other)))


@every
def test_single_precision_is_kept_next_to_what_numpy_casts_to_it(ufunc):
    single = np.full(3, 0.5, np.float32)
    for other in (0.5, np.float16(0.5), np.bool_(1), np.int16(1), single):
        assert outputs(ufunc(*[other] * (ufunc.nin - 1), single))[0].dtype == np.float32
    if ufunc.nin > 1:
        assert outputs(ufunc(*[np.ones(3)] * (ufunc.nin - 1), single))[0].dtype == np.float64
        ints = [np.ones(3, np.int32)] * (ufunc.nin - 1)
        assert outputs(ufunc(*ints, single))[0].dtype == np.float64
    assert outputs(ufunc(*[np.int8(1)] * ufunc.nin, dtype=np.float32))[0].dtype == np.float32


@every
def test_other_types_are_refused(ufunc):
    for wrong in (1j, np.longdouble(1), np.datetime64("2026-01-01")):
        with pytest.raises(TypeError):
            ufunc(*[wrong] * ufunc.nin)
    with pytest.raises(TypeError, match="cast"):
        ufunc(*[np.int8(1)] * ufunc.nin, out=(np.empty((), int),) * ufunc.nout)


@every
def test_texts_and_objects_are_refused_by_the_name_of_their_argument(ufunc):
    numbers = "give a number or an array of numbers"
    radians = f"{numbers}, in SI units and radians: numpy.radians(60) for 60deg"
    floats = "give a float or an array of floats, such as numpy.asarray(values, dtype=float)"
    for i, name in enumerate(_ufuncs.arguments(ufunc)):
        for wrong, got in {
            "60deg": f"got '60deg': {radians}",
            ("1", "2"): f"got '1': {radians}",
            Decimal("0.5"): f"got Decimal: {floats}",
            (Fraction(1, 2), 1): f"got Fraction: {floats}",
            None: f"got NoneType: {floats}",
        }.items():
            given = list(wrong) if isinstance(wrong, tuple) else wrong
            for options in ({}, {"dtype": float}):
                with pytest.raises(TypeError, match=f"^{re.escape(f'{name}: {got}')}$"):
                    ufunc(*[0.5] * i, given, *[0.5] * (ufunc.nin - i - 1), **options)


@every
def test_results_go_where_they_are_wanted(ufunc):
    arguments = inputs(ufunc)
    expected = outputs(ufunc(*arguments))
    out = tuple(np.full(1000, -7.0) for _ in expected)
    found = outputs(ufunc(*arguments, out=out))
    assert all(x is y for x, y in zip(found, out))
    same(found, tuple(expected))
    where = np.arange(1000) % 3 == 0
    out = tuple(np.full(1000, -7.0) for _ in expected)
    ufunc(*arguments, out=out, where=where)
    same(out, tuple(np.where(where, x, -7.0) for x in expected))
    single = tuple(np.empty(1000, np.float32) for _ in expected)
    same(ufunc(*arguments, out=single), tuple(x.astype(np.float32) for x in expected))
    with pytest.raises(ValueError, match="shape|broadcast"):
        ufunc(*arguments, out=tuple(np.empty(999) for _ in expected))


@every
def test_results_may_lie_over_the_inputs(ufunc):
    expected = outputs(ufunc(*inputs(ufunc)))
    arguments = inputs(ufunc)
    # Outputs in place of the inputs, and of the input beside them.
    spare = [np.empty(1000) for _ in range(ufunc.nout)]
    same(ufunc(*arguments, out=tuple((arguments[::-1] + spare)[: ufunc.nout])), tuple(expected))
    # Shifted by one element in either direction.
    for read, write in ((slice(0, 1000), slice(1, 1001)), (slice(1, 1001), slice(0, 1000))):
        memory = [np.empty(1001) for _ in range(ufunc.nin)]
        for x, y in zip(memory, inputs(ufunc)):
            x[read] = y
        out = tuple([x[write] for x in memory] + spare)[: ufunc.nout]
        same(ufunc(*(x[read] for x in memory), out=out), tuple(expected))
    # Turned round.
    arguments = inputs(ufunc)
    out = tuple([x[::-1] for x in arguments] + spare)[: ufunc.nout]
    same(ufunc(*arguments, out=out), tuple(expected))


@every
def test_arrays_that_may_not_be_written(ufunc, tmp_path):
    arguments = inputs(ufunc)
    expected = ufunc(*arguments)
    for x in arguments:
        x.flags.writeable = False
    same(ufunc(*arguments), expected)
    with pytest.raises(ValueError, match="read-only"):
        ufunc(*arguments, out=(arguments[0],) + (None,) * (ufunc.nout - 1))
    mapped = []
    for i, x in enumerate(arguments):
        np.save(tmp_path / f"{i}.npy", x)
        mapped.append(np.load(tmp_path / f"{i}.npy", mmap_mode="r"))
    same(tuple(map(np.asarray, outputs(ufunc(*mapped)))), tuple(outputs(expected)))


@every
def test_subclasses_stay_what_they_are(ufunc):
    class Labelled(np.ndarray):
        pass

    arguments = inputs(ufunc, 5)
    assert type(outputs(ufunc(*(x.view(Labelled) for x in arguments)))[0]) is Labelled
    masked = [np.ma.masked_array(x, mask=[0, 1, 0, 0, 0]) for x in arguments]
    found = outputs(ufunc(*masked))[0]
    expected = outputs(ufunc(*arguments))[0]
    if ufunc.nout == 1:  # NumPy keeps masks for one output only
        assert found.mask.tolist() == [False, True, False, False, False]
        assert found[2] == expected[2]
    zero = ufunc(*(np.array(x[0]) for x in arguments))
    assert all(np.isscalar(x) for x in outputs(zero))


@every
def test_valid_inputs_raise_no_flags(ufunc):
    with np.errstate(all="raise"):
        for shape in (1, 1000):
            ufunc(*inputs(ufunc, shape))
            ufunc(*(x.astype(np.float32) for x in inputs(ufunc, shape)))


EDGES = [
    (lb.period_ratio, (0.0, 5e-324, np.pi, -np.pi)),
    (lb.period_excess, (0.0, 5e-324, 1e-200, np.pi)),
    (lb.period_ratio_near_top, (2.3e-308, np.pi)),
    (lb.nome, (0.0, 5e-324, np.pi)),
    (lb.special.ellipk, (0.0, 1.0, 5e-324)),
    (lb.special.ellipe, (0.0, 1.0, 5e-324)),
    (lb.special.ellipkm1, (0.0, 1.0, 5e-324)),
    (lb.special.ellipk_kp, (0.0, 1.0, 1e-300)),
    (lb.special.ellipnome, (0.0, 1.0, 5e-324)),
    (lb.special.inverse_nome, (0.0, 1.0, 5e-324, 0.9929)),
    (lb.special.inverse_nome_kp, (0.0, 1.0, 5e-324, 0.9929)),
]


@pytest.mark.parametrize("ufunc, values", EDGES)
def test_ends_of_the_domain_raise_no_flags(ufunc, values):
    with np.errstate(all="raise"):
        for value in values:
            assert not np.isnan(ufunc(value))
        assert not np.isnan(ufunc(np.array(values))).any()


def test_separatrix_and_rest_raise_no_flags():
    with np.errstate(all="raise"):
        assert lb.motion(0.0, 0.0, 6.0, 3.0) == (0.0, 6.0)
        assert lb.motion(1e300, 0.0, 0.0, 3.0) == (0.0, 0.0)
        assert lb.special.ellipj(0.0, 1.0) == (0.0, 1.0, 1.0, 0.0)
        assert lb.special.ellipj(1.0, 0.0)[3] == 1.0


special = lb.special
OF_A_MODULUS = [getattr(special, f"ellip{name}") for name in ("k", "e", "k_kp", "km1", "nome")]
OF_TWO = [special.ellipj, special.ellipj_kp, special.ellipkinc, special.ellipeinc]
OUTSIDE = [
    (lb.period_ratio, (3.2,)),
    (lb.period_excess, (np.inf,)),
    (lb.period_ratio_near_top, (0.0,)),
    (lb.nome, (-4.0,)),
    *((lb.period, values) for values in ((1.0, 0.0, 9.81), (1.0, 1.0, -9.81), (3.2, 1.0, 9.81))),
    (lb.state, (np.inf, 1.0, 1.0)),
    *((lb.state, (1.0, *values)) for values in ((3.2, 1.0), (1.0, 0.0), (1.0, -2.0))),
    (lb.motion, (1.0, 1.0, 1.0, 0.0)),
    (lb.motion, (1.0, 1.0, np.inf, 1.0)),
    (lb.motion, (1.0, 1e300, 0.0, 1.0)),
    (lb.motion, (-np.inf, 1.0, 1.0, 1.0)),
    *((ufunc, (x,)) for ufunc in OF_A_MODULUS for x in (-1e-9, 1.1)),
    *((ufunc, (0.5, x)) for ufunc in OF_TWO for x in (-1e-9, 1.1)),
    *((ufunc, (np.inf, 0.5)) for ufunc in (special.ellipj, special.ellipkinc, special.ellipeinc)),
    (special.inverse_nome, (0.995,)),
    (special.inverse_nome_kp, (-0.1,)),
]


@pytest.mark.parametrize("ufunc, values", OUTSIDE)
def test_outside_the_domain_is_nan_with_a_warning(ufunc, values):
    with pytest.warns(RuntimeWarning, match="invalid value"):
        assert all(np.isnan(x) for x in outputs(ufunc(*values)))
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        # One such element among many.
        ufunc(*(np.append(x, v) for x, v in zip(inputs(ufunc), values)))


@pytest.mark.parametrize(
    "known, unknown",
    [
        # 2**99 K at k = 0 is 9.956e29; K is 738 at k' = 1e-320.
        (lambda: lb.special.ellipj(9.9e29, 0.0), lambda: lb.special.ellipj(1e30, 0.0)),
        (lambda: lb.special.ellipj_kp(1120, 1e-320), lambda: lb.special.ellipj_kp(1e33, 1e-320)),
        (lambda: lb.state(3e15, 0.5, 1.0), lambda: lb.state(4e15, 0.5, 1.0)),
        (lambda: lb.motion(9e29, 0.5, 0.0, 1.0), lambda: lb.motion(1.1e30, 0.5, 0.0, 1.0)),
    ],
)
def test_lost_phases_are_nan_with_a_warning(known, unknown):
    with np.errstate(all="raise"):
        assert np.isfinite(outputs(known())).all()
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert np.isnan(unknown()[0])


def test_the_sine_amplitude_of_a_subnormal_modulus_is_one():
    # cn is below 1e-155 at K/2 from the quarter K = 738.2.
    sn, cn, _, _ = lb.special.ellipj_kp(1120, 1e-320)
    assert sn == 1 and abs(cn) < 1e-150


@every
def test_nan_goes_through_without_a_warning(ufunc):
    with np.errstate(all="raise"):
        for place in range(ufunc.nin):
            arguments = inputs(ufunc, 20)
            arguments[place][3] = np.nan
            found = outputs(ufunc(*arguments))
            assert all(np.isnan(x[3]) and not np.isnan(np.delete(x, 3)).any() for x in found)


def test_a_warning_of_an_earlier_row_is_kept():
    rows = np.full((3, 4), 1.0)
    rows[0, 0] = 9.0
    with pytest.warns(RuntimeWarning, match="invalid value"):
        lb.period_ratio(rows[:, ::2])


def test_flags_of_casts_are_kept():
    with np.errstate(over="raise"), pytest.raises(FloatingPointError, match="overflow"):
        lb.special.ellipkinc(np.array([1e39, 1.0]), 0.5, dtype=np.float32, casting="unsafe")


@every
def test_two_threads_find_the_same(ufunc):
    arguments = inputs(ufunc, 20_000)
    expected = ufunc(*arguments)
    found = [None] * 4

    def work(i):
        with (
            warnings.catch_warnings(action="error")
            if sys.version_info >= (3, 14)
            else np.errstate(all="raise")
        ):
            found[i] = ufunc(*arguments)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one in found:
        same(one, expected)


def test_the_interpreter_goes_on_meanwhile():
    counted, done = 0, threading.Event()

    def work():
        lb.motion(np.linspace(0, 1e3, 3_000_000), 1.0, 2.0, 3.0)
        done.set()

    threading.Thread(target=work).start()
    while not done.is_set():
        counted += 1
    assert counted > 1000


@every
def test_pickles_and_copies(ufunc):
    assert pickle.loads(pickle.dumps(ufunc)) is ufunc
    assert copy.deepcopy(ufunc) is ufunc


def test_unpickles_in_another_process():
    text = pickle.dumps(lb.period_ratio)
    code = f"import pickle; print(pickle.loads({text!r})(1.0))"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert float(found.stdout) == lb.period_ratio(1.0)


def test_reductions_that_mean_nothing_are_refused():
    with pytest.raises(TypeError):
        lb.special.ellipkinc.reduce([[0.1, 0.2]], axis=None, initial=None, dtype=complex)
    with pytest.raises(ValueError, match="reduce only supported"):
        lb.period_ratio.reduce([0.1, 0.2])


OF_TWO_ARGUMENTS = [ufunc for ufunc in ALL if ufunc.nin == 2]


@pytest.mark.parametrize("ufunc", OF_TWO_ARGUMENTS)
@pytest.mark.parametrize("method", ["reduce", "accumulate", "reduceat"])
def test_reductions_of_two_arguments_are_refused_with_the_reason(ufunc, method):
    if not hasattr(np.sin, "__dict__"):
        pytest.skip("ufuncs of this NumPy take no attributes")
    call = f"{ufunc.__name__}({', '.join(_ufuncs.arguments(ufunc))})"
    reason = rf"^{ufunc.__name__}\.{method} has no meaning.*: give arrays to {re.escape(call)}$"
    for arguments in ([[0.1, 0.2]], [[0.1, 0.2], [0]]):
        with pytest.raises(TypeError, match=reason):
            getattr(ufunc, method)(*arguments)
    with pytest.raises(TypeError, match=reason):
        getattr(ufunc, method)([[0.1, 0.2]], axis=1, dtype=float)


def test_outer_and_at_work_as_for_every_ufunc():
    u, m = np.linspace(0, 2, 5), np.linspace(0, 1, 4)
    same(lb.special.ellipkinc.outer(u, m), lb.special.ellipkinc(u[:, None], m))
    angles = np.array([1.0, 2.0])
    lb.period_excess.at(angles, [0, 0])
    assert angles.tolist() == [lb.period_excess(lb.period_excess(1.0)), 2.0]
