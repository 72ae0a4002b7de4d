# SPDX-License-Identifier: GPL-3.0-or-later
"""heatladder from Python: cases, exact solutions and the battery for a function `solve(case) -> points, T`."""
from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time as clock
import traceback
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, NoReturn, Optional, Sequence, Tuple, Union

from .library import HeatladderError, exact, solve
from .points import columns_of, numbers_of, numpy, rows_of, shaped

__all__ = ["Case", "HeatladderError", "NotApplicable", "Verdict", "case", "exact", "gates", "program", "reference", "run",
           "scenes", "solve", "solve_case", "verify"]
__version__ = "4.0.0"

NOT_APPLICABLE = 77  # exit status of a program for a case that it does not support
LONG = 10000  # points of an answer that is written as .npy
_asked = [0.0]  # seconds in `reference`, which are not those of a solve

Solve = Callable[["Case"], Tuple[Any, Any]]


class NotApplicable(Exception):
    """Raised by `solve` for a case that it does not support: its rows are skipped."""


def _value(text: str) -> Any:
    """A number, a list of numbers, or the text."""
    try:
        found = [int(word) if re.fullmatch(r"\s*[-+]?\d+\s*", word) else float(word) for word in text.split(",")]
    except ValueError:
        return text
    return found if len(found) > 1 else found[0]


class Case(Dict[str, Any]):
    """A case file.  case["k_x"] and case.k_x are numbers, lists of numbers, or words; the properties below are lists with
    one number for each axis, on a rod too."""

    def __getattr__(self, key: str) -> Any:
        try:
            return self[key]
        except KeyError:
            raise AttributeError(f"the case has no {key}") from None

    def numbers(self, key: str) -> List[float]:
        found = self[key]
        return list(found) if isinstance(found, list) else [found]

    @property
    def lo(self) -> List[float]:
        """The lower ends of the domain, m."""
        return self.numbers("lo")

    @property
    def hi(self) -> List[float]:
        """The upper ends of the domain, m."""
        return self.numbers("hi")

    @property
    def cells(self) -> List[int]:
        """The number of cells along each axis."""
        return [int(n) for n in self.numbers("cells")]

    @property
    def width(self) -> List[float]:
        """The width of a cell along each axis, m."""
        return [(hi - lo) / n for lo, hi, n in zip(self.lo, self.hi, self.cells)]

    @property
    def is_plain(self) -> bool:
        """A box with walls, without data that change in time, k(T), a tensor k or a resistance between materials."""
        more = {"shape", "k_law", "k_xy", "conductivity", "contact_resistance"}
        return not (more & self.keys() or {"periodic", "changing"} & {str(word) for word in self.values()})

    @property
    def sides(self) -> Iterator[Tuple[int, str, float, str]]:
        """The sides of a box: axis (0, 1, 2), "lo" or "hi", coordinate, "dirichlet", "neumann", "robin" or "periodic"."""
        for d in range(self["dim"]):
            for end, places in (("lo", self.lo), ("hi", self.hi)):
                yield d, end, places[d], str(self[f"side_{'xyz'[d]}_{end}"]).split(",")[0]

    def steps(self, dt: float) -> int:
        """The number of equal time steps: those of the case's dt where it has one, else of dt at most."""
        return round(self["t_end"] / self["dt"]) if "dt" in self else math.ceil(self["t_end"] / dt)


def program() -> str:
    """The path of the program: $HEATLADDER, else the one in this package, else the one on the PATH."""
    packaged = Path(__file__).with_name("bin") / "heatladder"
    found = os.environ.get("HEATLADDER") or (str(packaged) if packaged.is_file() else shutil.which("heatladder"))
    if not found:
        raise HeatladderError("no heatladder in this package, on the PATH or in $HEATLADDER")
    return found


def scenes() -> Dict[str, str]:
    """The scenes: name and what it is."""
    lines = _listing("scenes")
    return dict(line.split(": ", 1) for line in lines if line and line[0] != " ")


def gates(order: int = 2) -> Dict[str, str]:
    """The rows of the battery for a code of that order: name and what each detects."""
    listed = _listing("battery")
    rows = [row.split(None, 2) for row in (listed[1:listed.index("")] if "" in listed else listed[1:])]
    return {name: detects for name, of, detects in rows if (of == "4") == (order == 4)}


def _listing(topic: str) -> List[str]:
    return subprocess.run([program(), "list", topic], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()


def case(path: Union[str, "os.PathLike[str]"]) -> Case:
    """Reads a case file."""
    pairs = (line.rstrip("\n").split(" = ", 1) for line in open(path, encoding="utf-8"))
    return Case((pair[0], _value(pair[1])) for pair in pairs if len(pair) == 2)


def reference(scene: Union[Case, str], points: Any, what: str, time: float = 0,
              width: Optional[Sequence[Any]] = None) -> Dict[str, Any]:
    """Evaluates a scene at points: a dictionary of arrays by column name, each of the shape of the points.

    scene   a case, or the words of `heatladder reference`: "rod-gauss --set kappa=0.02"
    points  (..., dim), m; on a rod also a number or (n,), so that with words one point of the plane is [(x, y)]
    what    columns separated by commas: temperature, initial_mean, source, k_x, rho_c, wall_x, ...
    time    s
    width   of the cell around each point, m, by axis: numbers, or arrays of the shape of the points; for initial_mean
    """
    rows, shape = rows_of(points, scene["dim"] if isinstance(scene, Case) else None)
    if not len(rows):
        raise ValueError("reference: no points")
    dim, cells = len(rows[0]), columns_of(width, len(rows))
    if cells and len(cells) != dim:
        raise ValueError(f"width has {len(cells)} numbers, one for each of {dim} axes is wanted")
    header = ["x", "y", "z"][:dim] + ["dx", "dy", "dz"][:len(cells)]
    table = "\n".join(",".join(repr(float(x)) for x in [*row, *(column[i] for column in cells)])
                      for i, row in enumerate(rows))
    words = scene["oracle"] if isinstance(scene, Case) else scene
    began = clock.perf_counter()
    answer = subprocess.run(
        [program(), "reference", *words.split(), "--points", "-", "--time", repr(float(time)), "--what", what],
        input=",".join(header) + "\n" + table + "\n", stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    _asked[0] += clock.perf_counter() - began
    if answer.returncode:
        raise HeatladderError(answer.stderr.strip())
    lines = answer.stdout.splitlines()
    names = lines[0].split(",")
    if names[:dim] != header[:dim]:
        raise ValueError(f"points are (n, {dim}), the scene has {' '.join(n for n in names if n in ('x', 'y', 'z'))} alone")
    columns = zip(*([float(word) for word in line.split(",")] for line in lines[1:]))
    return {name: shaped(column, shape) for name, column in list(zip(names, columns))[dim:]}


def _write(case: Case, points: Any, T: Any, out: str, seconds: Optional[float] = None) -> None:
    """Writes an answer as text, or as NumPy's .npy if it is long; text has the seconds of the solve."""
    (rows, _), values = rows_of(points, case["dim"]), numbers_of(T)
    if len(rows) != len(values):
        raise ValueError(f"solve returned {len(rows)} points and {len(values)} temperatures")
    if numpy and len(values) >= LONG:
        with open(out, "wb") as f:
            numpy.save(f, numpy.ascontiguousarray(numpy.column_stack([rows, values])))
        return
    with open(out, "w", encoding="utf-8") as f:
        if seconds is not None:
            print(f"# seconds = {seconds:.6g}", file=f)
        print(",".join(["x", "y", "z"][:case["dim"]] + ["T"]), file=f)
        for row, value in zip(rows, values):
            print(*(float(x) for x in row), float(value), sep=",", file=f)


def solve_case(solve: Solve, case_path: str, out: str) -> int:
    """Runs `solve` on a case file and writes its answer; returns the exit status of a program."""
    try:
        given = case(case_path)
        began, _asked[0] = clock.perf_counter(), 0
        points, T = solve(given)
        _write(given, points, T, out, clock.perf_counter() - began - _asked[0])
    except NotApplicable:
        return NOT_APPLICABLE
    except Exception:
        traceback.print_exc()
        return 1
    return 0


@dataclass
class Verdict:
    """Result of the battery: exit status, rows as in `verify --json`, and the fault that most failing rows name."""
    status: int
    gates: List[Dict[str, Any]] = field(default_factory=list)
    diagnosis: Optional[str] = None
    text: str = ""


def _serve(solve: Solve, directory: str, done: threading.Thread) -> None:
    """Serves requests (three lines: reply name, case, answer) until the battery ends."""
    requests = os.fdopen(os.open(f"{directory}/requests", os.O_RDWR), "r", encoding="utf-8", buffering=1)
    reply = -1
    while True:
        name, case_path, out = (requests.readline().rstrip("\n") for _ in range(3))
        if reply >= 0:
            os.close(reply)  # already read: the next request has arrived
        if not name:
            break
        reply = os.open(f"{directory}/{name}", os.O_RDWR)  # does not block, even if the shell was killed
        os.write(reply, f"{solve_case(solve, case_path, out)}\n".encode())
    requests.close()
    done.join()


def verify(solve: Solve, *arguments: str, quiet: bool = False) -> Verdict:
    """Runs the battery on `solve` in this process: `heatladder verify --solver` with these arguments."""
    with tempfile.TemporaryDirectory(prefix="heatladder-") as directory:
        os.mkfifo(f"{directory}/requests")
        ask = (f"cd '{directory}' && mkfifo $$ && printf '%s\\n' $$ \"{{case}}\" \"{{out}}\" >requests && "
               "read -r status <$$; rm -f $$; exit $status")
        command = [program(), "verify", "--solver", ask, "--json", f"{directory}/verdict.json", *arguments]
        battery = subprocess.Popen(command, stdout=subprocess.PIPE if quiet else None, text=True)
        text: List[str] = []

        def wait() -> None:
            text.append(battery.communicate()[0] or "")
            with open(f"{directory}/requests", "w", encoding="utf-8") as requests:
                requests.write("\n\n\n")

        waiting = threading.Thread(target=wait)
        waiting.start()
        try:
            _serve(solve, directory, waiting)
        except BaseException:
            battery.terminate()
            waiting.join()
            raise
        try:
            with open(f"{directory}/verdict.json", encoding="utf-8") as f:
                found = json.load(f)
        except FileNotFoundError:
            found = {}
        return Verdict(battery.returncode, found.get("gates", []), found.get("diagnosis"), text[0])


def run(solve: Solve) -> NoReturn:
    """Runs `solve` as a program: `PROGRAM CASE OUT` runs one case, `PROGRAM verify [options]` the battery."""
    words = sys.argv[1:]
    if words[:1] == ["verify"]:
        sys.exit(verify(solve, *words[1:]).status)
    if len(words) != 2:
        sys.exit(f"usage: {sys.argv[0]} CASE OUT | verify [options of heatladder verify]")
    sys.exit(solve_case(solve, *words))
