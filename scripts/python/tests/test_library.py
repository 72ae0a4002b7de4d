# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the library's binding: $HEATLADDER_LIBRARY is the library under test, $HEATLADDER the program."""
import math
import os
import threading

import pytest

import heatladder

numpy = pytest.importorskip("numpy")
if not os.environ.get("HEATLADDER_LIBRARY"):
    pytest.skip("no library is given", allow_module_level=True)


def gauss(x, t, kappa):
    spread = 2.0 ** 2 + 2 * kappa * t
    return math.sqrt(2.0 ** 2 / spread) * math.exp(-x * x / (2 * spread))


def test_exact_gives_temperatures_within_their_bound():
    x = numpy.linspace(-1.5, 2, 7)
    T, bound = heatladder.exact("rod-gauss", x, 3, bound=True, kappa=0.02)
    assert T.shape == bound.shape == (7,) and (0 <= bound).all() and bound.max() < 1e-12
    assert T == pytest.approx([gauss(at, 3, 0.02) for at in x], abs=1e-12)
    assert heatladder.exact("rod-gauss", 0.5, 3, kappa=0.02) == pytest.approx(gauss(0.5, 3, 0.02), abs=1e-12)


def test_exact_takes_points_of_the_plane_in_any_shape():
    points = numpy.moveaxis(numpy.mgrid[0.1:1:3j, 0.2:0.8:2j], 0, -1)
    T = heatladder.exact("square-step", points, 0.3)
    assert T.shape == (3, 2)
    one = heatladder.reference("square-step", [list(points[1, 1])], "temperature", time=0.3)["temperature"]
    assert T[1, 1] == pytest.approx(one[0], abs=1e-12)


def test_exact_takes_points_in_space():
    points = numpy.moveaxis(numpy.mgrid[-0.6:0.6:3j, 0.2:0.8:2j, -1:1:4j], 0, -1)
    T, bound = heatladder.exact("cube-step", points, 3, bound=True)
    assert T.shape == (3, 2, 4) and bound.max() < 1e-12
    one = heatladder.reference("cube-step", [list(points[1, 1, 2])], "temperature", time=3)["temperature"]
    assert T[1, 1, 2] == pytest.approx(one[0], abs=1e-12)
    with pytest.raises(ValueError, match="in space"):
        heatladder.exact("cube-step", [(0.1, 0.2)], 3)


def test_a_choice_is_a_word():
    steel = heatladder.exact("plate", [(0.03, 0.04)], 20, material="steel")
    assert (heatladder.exact("plate", [(0.03, 0.04)], 20, material="vanadium") != steel).all()
    with pytest.raises(heatladder.HeatladderError, match="steel or titanium or vanadium"):
        heatladder.exact("plate", [(0.03, 0.04)], 20, material="stell")


def test_solve_converges_to_exact():
    errors = []
    for dx in (0.05, 0.025):
        x, T = heatladder.solve("rod-step", "so_ssph", dx, {"kappa": 0.02, "t_end": 5}, h=1.2)
        errors.append(abs(T - heatladder.exact("rod-step", x, 5, kappa=0.02)).max())
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    points, T = heatladder.solve("plate", "ftcs", 0.01, {"t_end": 3}, stepper="euler")
    assert points.shape == (100, 2) and T.shape == (100,)
    with pytest.raises(heatladder.HeatladderError, match="unknown option 'kernle'; did you mean 'kernel'"):
        heatladder.solve("plate", "so_ssph", 0.01, kernle="cubic")


@pytest.mark.parametrize("words, match", [(("rod-gaus", 0.0, 1), "rod-gaus"), (("rod-gauss", 1e9, 1), "outside"),
                                          (("rod-gauss", 0.0, -1), "t = -1")])
def test_a_refusal_is_an_error_with_the_librarys_words(words, match):
    with pytest.raises(heatladder.HeatladderError, match=match):
        heatladder.exact(*words)


GAUSS, STEP = ("rod-gauss", 0.0, 1), ("rod-step", "so_ssph", 0.1)

# Each argument of exact and solve: of a wrong type, NaN, negative, unknown.
BAD = [
    ("exact", (None, 0.0, 1), {}, "scene = None: must be a word"),
    ("exact", ("rod-gaus", 0.0, 1), {}, "unknown scene 'rod-gaus'; did you mean 'rod-gauss'"),
    ("exact", ("rod-gauss", 0.0, math.nan), {}, "t = nan"),
    ("exact", ("rod-gauss", 0.0, "1"), {}, "t = '1': must be a number"),
    ("exact", ("rod-gauss", math.nan, 1), {}, "x = nan m is outside"),
    ("exact", GAUSS, {"kapa": 1}, "unknown parameter of rod-gauss 'kapa'; did you mean 'kappa'"),
    ("exact", GAUSS, {"kappa": -1}, "kappa=-1"),
    ("exact", GAUSS, {"kappa": None}, "kappa = None: must be a number"),
    ("exact", GAUSS, {"kappa": "0.1"}, "must be a number"),
    ("solve", (3, "so_ssph", 0.1), {}, "scene = 3: must be a word"),
    ("solve", ("rod-step", 3, 0.1), {}, "method = 3: must be a word"),
    ("solve", ("rod-step", "so_sph", 0.1), {}, "did you mean 'so_ssph'"),
    ("solve", ("rod-step", "so_ssph", "0.1"), {}, "dx = '0.1': must be a number"),
    ("solve", ("rod-step", "so_ssph", math.nan), {}, "--dx nan"),
    ("solve", STEP, {"kernel": 3}, "kernel = 3: must be a word"),
    ("solve", STEP, {"kernel": "cubicc"}, "did you mean 'cubic'"),
    ("solve", STEP, {"dt": "0.1"}, "dt = '0.1': must be a number"),
    ("solve", STEP, {"dt": -1}, "--dt -1"),
    ("solve", STEP, {"dt": math.nan}, "--dt nan"),
    ("solve", STEP, {"fourier": -0.3}, "--fourier -0.3"),
    ("solve", STEP, {"dt": 0.1, "fourier": 0.1}, "exclude each other"),
    ("solve", STEP, {"jitter": 0.2}, "do not move"),
    ("solve", STEP, {"order": 2.5}, "order = 2.5: must be a whole number"),
    ("solve", STEP, {"order": 7}, "--order 7"),
    ("solve", STEP, {"seed": -1}, "seed = -1: must be a whole number"),
    ("solve", STEP, {"seed": True}, "seed = True"),
    ("solve", STEP, {"parameters": {"kappa": math.inf}}, "kappa=inf"),
]


@pytest.mark.parametrize("call, words, options, says", BAD)
def test_bad_arguments_are_named(call, words, options, says):
    with pytest.raises(heatladder.HeatladderError) as error:
        getattr(heatladder, call)(*words, **options)
    assert says in str(error.value)


def test_threads_get_the_same_numbers():
    x, found = numpy.linspace(0, 1, 2000), {}
    threads = [threading.Thread(target=lambda k=k: found.update({k: heatladder.exact("rod-step", x, 1 + k)}))
               for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k in range(4):
        assert (found[k] == heatladder.exact("rod-step", x, 1 + k)).all()
