# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact solutions and solvers in this process, by libheatladder (heatladder.h)."""
from __future__ import annotations

import ctypes
import difflib
import os
from ctypes import POINTER, Structure, byref, c_char, c_char_p, c_double, c_int, c_longlong, c_size_t, c_ulong, c_void_p
from functools import lru_cache
from numbers import Integral, Real
from pathlib import Path
from typing import Any, List, Mapping, Optional, Tuple, Union

from .points import numpy, rows_of


class HeatladderError(RuntimeError):
    """heatladder refused a request; the message is its own."""


class _Error(Structure):
    _fields_ = [("status", c_int), ("text", c_char * 480)]


class _Parameter(Structure):
    _fields_ = [("name", c_char_p), ("value", c_double), ("unit", c_char_p), ("about", c_char_p),
                ("choice", POINTER(c_char_p))]


class _Setting(Structure):
    _fields_ = [("name", c_char_p), ("value", c_double)]


class _Box(Structure):
    _fields_ = [("dim", c_int), ("lo", c_double * 3), ("hi", c_double * 3), ("hole", c_double), ("radius", c_double),
                ("t_end", c_double)]


class _Options(Structure):
    _fields_ = [("dx", c_double), ("dt", c_double), ("fourier", c_double), ("h", c_double), ("jitter", c_double),
                ("order", c_int), ("seed", c_ulong), ("kernel", c_char_p), ("stepper", c_char_p),
                ("layout", c_char_p), ("sampling", c_char_p), ("walls", c_char_p), ("mean", c_char_p)]


class _Field(Structure):
    _fields_ = [("dim", c_int), ("n", c_size_t), ("x", POINTER(c_double)), ("y", POINTER(c_double)),
                ("T", POINTER(c_double)), ("z", POINTER(c_double)), ("t", c_double), ("dt", c_double), ("steps", c_longlong)]


@lru_cache(maxsize=None)
def _library() -> ctypes.CDLL:
    """$HEATLADDER_LIBRARY, else the one in this package, else the installed one."""
    packaged = Path(__file__).with_name("lib") / "libheatladder.so"
    name = os.environ.get("HEATLADDER_LIBRARY") or (str(packaged) if packaged.is_file() else "libheatladder.so.4")
    try:
        h = ctypes.CDLL(name)
    except OSError as error:
        raise HeatladderError(f"no libheatladder in this package, installed or in $HEATLADDER_LIBRARY: {error}") from None
    h.hl_version.restype = c_char_p
    h.hl_scene.restype = h.hl_method.restype = c_char_p
    h.hl_problem_create.restype = c_void_p
    h.hl_problem_create.argtypes = [c_char_p, POINTER(_Setting), POINTER(_Error)]
    h.hl_problem_free.restype = h.hl_problem_box.restype = h.hl_field_free.restype = None
    h.hl_problem_free.argtypes = [c_void_p]
    h.hl_problem_box.argtypes = [c_void_p, POINTER(_Box)]
    h.hl_parameter.argtypes = [c_char_p, c_int, POINTER(_Parameter)]
    h.hl_exact_at.argtypes = [c_void_p, c_double, c_size_t, *[c_void_p] * 5, POINTER(_Error)]
    h.hl_solve.argtypes = [c_void_p, c_char_p, POINTER(_Options), POINTER(_Field), POINTER(_Error)]
    return h


def _number(name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, Real):
        raise HeatladderError(f"{name} = {value!r}: must be a number")
    return float(value)


def _word(name: str, value: Any) -> bytes:
    if not isinstance(value, str):
        raise HeatladderError(f"{name} = {value!r}: must be a word")
    return value.encode()


def _whole(name: str, value: Any, least: int, most: int) -> int:
    if isinstance(value, bool) or not isinstance(value, Integral) or not least <= value <= most:
        raise HeatladderError(f"{name} = {value!r}: must be a whole number from {least} to {most}")
    return int(value)


def _value(scene: bytes, name: str, value: Union[float, str]) -> float:
    """A number, or the index of a word among the choices of the parameter."""
    if not isinstance(value, str):
        return _number(name, value)
    parameter, i, words = _Parameter(), 0, []  # type: _Parameter, int, List[str]
    while _library().hl_parameter(scene, i, byref(parameter)):
        i += 1
        if parameter.name.decode() == name and parameter.choice:
            while parameter.choice[len(words)]:
                words.append(parameter.choice[len(words)].decode())
    if value not in words:
        raise HeatladderError(f"{name} = '{value}': must be {' or '.join(words) if words else 'a number'}")
    return float(words.index(value))


class _Problem:
    """A scene at given parameters, released at the end of a `with`."""

    def __init__(self, scene: str, parameters: Mapping[str, Union[float, str]]) -> None:
        name, why = _word("scene", scene), _Error()
        settings = [_Setting(key.encode(), _value(name, key, value)) for key, value in parameters.items()]
        array = (_Setting * (len(settings) + 1))(*settings)
        self.address = _library().hl_problem_create(name, array, byref(why))
        if not self.address:
            raise HeatladderError(why.text.decode())

    def __enter__(self) -> "_Problem":
        return self

    def __exit__(self, *_: Any) -> None:
        _library().hl_problem_free(self.address)

    def box(self) -> _Box:
        box = _Box()
        _library().hl_problem_box(self.address, byref(box))
        return box


def _check(status: int, why: _Error) -> None:
    if status:
        raise HeatladderError(why.text.decode())


def exact(scene: str, points: Any, t: float, bound: bool = False, **parameters: Union[float, str]) -> Any:
    """Exact temperatures of a scene at points and a time: an array, K.

    points      (..., dim), m; on a rod also a number or (n,).  T has that shape without the last axis
    t           s
    bound       True: a pair of arrays, temperatures and bounds of their error
    parameters  of the scene, as in `heatladder list scenes`: kappa=0.02
    """
    _need_numpy()
    with _Problem(scene, parameters) as problem:
        rows, shape = rows_of(points, problem.box().dim)
        columns = [numpy.ascontiguousarray(column) for column in rows.T]
        T, error, why = numpy.empty(shape), numpy.empty(shape), _Error()
        places = [column.ctypes.data for column in columns] + [None] * (3 - len(columns))
        _check(_library().hl_exact_at(problem.address, _number("t", t), T.size, *places, T.ctypes.data,
                                      error.ctypes.data, byref(why)), why)
    return (T, error) if bound else T


def _need_numpy() -> None:
    if numpy is None:
        raise HeatladderError("exact and solve need NumPy")


def _options(dx: Any, options: Mapping[str, Any]) -> _Options:
    """The options of a run, each of its type."""
    types = dict(_Options._fields_)
    found = _Options(dx=_number("dx", dx))
    for name, value in options.items():
        if name not in types or name == "dx":
            near = difflib.get_close_matches(name, types, 1)
            raise HeatladderError(f"unknown option '{name}'" + (f"; did you mean '{near[0]}'?" if near else "")
                                  + f" (valid: {', '.join(types)})")
        kind = types[name]
        setattr(found, name, _word(name, value) if kind is c_char_p else
                _number(name, value) if kind is c_double else _whole(name, value, 0, 2 ** (31 if kind is c_int else 63) - 1))
    return found


def solve(scene: str, method: str, dx: float, parameters: Optional[Mapping[str, Union[float, str]]] = None,
          **options: Union[float, str]) -> Tuple[Any, Any]:
    """Solves a scene to its end time: points, (n,), (n, 2) or (n, 3), and temperatures, (n,).

    options  of the method: stepper="rk2", dt=0.01, kernel="wendland", h=1.3, layout="jitter", jitter=0.2, seed=3, ...
    """
    _need_numpy()
    found, why, given = _Field(), _Error(), _options(dx, options)
    with _Problem(scene, parameters or {}) as problem:
        _check(_library().hl_solve(problem.address, _word("method", method), byref(given), byref(found), byref(why)), why)
    *places, T = [numpy.ctypeslib.as_array(column, (found.n,)).copy() for column in
                  (found.x, found.y, found.z, found.T) if column]
    _library().hl_field_free(byref(found))
    return (places[0] if len(places) == 1 else numpy.column_stack(places)), T
