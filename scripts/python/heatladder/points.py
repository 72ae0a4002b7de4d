# SPDX-License-Identifier: GPL-3.0-or-later
"""One rule for points: an array (..., dim) with the coordinates along its last axis; on a rod also a number or (n,).
Temperatures have the shape of the points without that axis.  Without NumPy: lists (n,) or (n, dim)."""
from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


def _array(values: Any, name: str) -> Any:
    """An array of real numbers in C order; masked, complex and other values are refused."""
    if numpy.ma.is_masked(values):
        raise ValueError(f"{name}: {numpy.ma.count_masked(values)} values are masked; leave those points out")
    found = numpy.asarray(values)
    if found.dtype.kind not in "fiub":
        raise TypeError(f"{name}: {found.dtype} where real numbers are wanted")
    return numpy.ascontiguousarray(found, float).reshape(found.shape)


def rows_of(points: Any, dim: Optional[int]) -> Tuple[Any, Tuple[int, ...]]:
    """The points as rows (n, dim), and their shape; dim None: that of the points."""
    if numpy is None:
        rows = [[float(x) for x in row] if hasattr(row, "__len__") else [float(row)] for row in points]
        wrong = [len(row) for row in rows if len(row) != (dim or len(rows[0]))]
        if wrong:
            raise ValueError(f"a point has {wrong[0]} coordinates, {dim or len(rows[0])} are wanted")
        return rows, (len(rows),)
    at = _array(points, "points")
    if dim == 1 or dim is None:
        at = at.reshape(at.shape + (1,)) if at.ndim < 2 else at
    dim = dim or at.shape[-1]
    if at.ndim < 1 or at.shape[-1] != dim or dim > 3:
        where = ("", "on a rod", "in the plane", "in space")[dim] if dim < 4 else "in no scene"
        raise ValueError(f"points of shape {numpy.shape(points)}: {where} they are {'(n,) or ' if dim == 1 else ''}(..., {dim})")
    return at.reshape(-1, dim), at.shape[:-1]


def numbers_of(values: Any) -> Any:
    """Temperatures in one row."""
    return [float(value) for value in values] if numpy is None else _array(values, "T").reshape(-1)


def columns_of(width: Optional[Sequence[Any]], n: int) -> List[Any]:
    """One column of n extents for each axis."""
    if width is None:
        return []
    if numpy is None:
        return [list(w) if hasattr(w, "__len__") else [float(w)] * n for w in width]
    columns = [_array(w, "width") for w in width]
    if any(column.size not in (1, n) for column in columns):
        raise ValueError(f"width: a number for each axis, or an array of {n} for each, is wanted")
    return [numpy.broadcast_to(column.reshape(-1), n) for column in columns]


def shaped(column: Sequence[float], shape: Tuple[int, ...]) -> Any:
    """A column as an array of that shape; a list without NumPy."""
    return list(column) if numpy is None else numpy.array(column).reshape(shape)
