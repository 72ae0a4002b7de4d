# SPDX-License-Identifier: GPL-3.0-or-later
"""heatladder from Python: cases, exact solutions and the battery for a function `solve(case) -> points, T`."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import traceback
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Dict, List, NoReturn, Optional, Sequence, Tuple, Union

from .library import HeatladderError, exact, solve

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

__all__ = ["Case", "HeatladderError", "NotApplicable", "Verdict", "case", "exact", "program", "reference", "run", "solve",
           "solve_case", "verify"]
__version__ = "4.0.0"

NOT_APPLICABLE = 77  # exit status of a program for a case that it does not support
LONG = 10000  # points of an answer that is written as .npy

Solve = Callable[["Case"], Tuple[Any, Any]]


class NotApplicable(Exception):
    """Raised by `solve` for a case that it does not support: its rows are skipped."""


class Case(Dict[str, str]):
    """A case file: keys and values as text; properties give the usual ones as numbers."""

    def numbers(self, key: str) -> List[float]:
        return [float(word) for word in self[key].split(",")]

    @property
    def dim(self) -> int:
        """1 for a rod, 2 for a rectangle."""
        return int(self["dim"])

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
        return [int(word) for word in self["cells"].split(",")]

    @property
    def width(self) -> List[float]:
        """The width of a cell along each axis, m."""
        return [(hi - lo) / n for lo, hi, n in zip(self.lo, self.hi, self.cells)]

    @property
    def t_end(self) -> float:
        """The end time, s."""
        return float(self["t_end"])


def program() -> str:
    """The path of the program: $HEATLADDER, else the one in this package, else the one on the PATH."""
    packaged = Path(__file__).with_name("bin") / "heatladder"
    found = os.environ.get("HEATLADDER") or (str(packaged) if packaged.is_file() else shutil.which("heatladder"))
    if not found:
        raise HeatladderError("no heatladder in this package, on the PATH or in $HEATLADDER")
    return found


def case(path: Union[str, "os.PathLike[str]"]) -> Case:
    """Reads a case file."""
    pairs = (line.rstrip("\n").split(" = ", 1) for line in open(path, encoding="utf-8"))
    return Case(pair for pair in pairs if len(pair) == 2)


def _rows(points: Any) -> List[List[float]]:
    """Points as rows: a list of numbers is a list of points on a rod."""
    return [[float(x) for x in row] if hasattr(row, "__len__") else [float(row)] for row in points]


def _columns(lines: Sequence[str]) -> List[Any]:
    rows = [[float(word) for word in line.split(",")] for line in lines]
    return [numpy.array(column) if numpy else list(column) for column in zip(*rows)]


def reference(scene: Union[Case, str], points: Any, what: str, time: float = 0,
              width: Optional[Sequence[float]] = None) -> Dict[str, Any]:
    """Evaluates a scene at points: a dictionary of arrays by column name, one value per point.

    scene   a case, or the words of `heatladder reference`: "rod-gauss --set kappa=0.02"
    points  (n,) on a rod, (n, 2) in the plane, (n, 3) in space, m
    what    columns separated by commas: temperature, initial_mean, source, k_x, rho_c, wall_x, ...
    time    s
    width   of the cell about each point, m, by axis: for means over cells (initial_mean)
    """
    rows = _rows(points)
    if not rows:
        raise ValueError("reference: no points")
    dim, cell = len(rows[0]), [] if width is None else [float(w) for w in width]
    header = ["x", "y", "z"][:dim] + ["dx", "dy", "dz"][:len(cell)]
    table = "\n".join(",".join(repr(x) for x in row + cell) for row in rows)
    words = scene["oracle"] if isinstance(scene, Case) else scene
    answer = subprocess.run(
        [program(), "reference", *words.split(), "--points", "-", "--time", repr(float(time)), "--what", what],
        input=",".join(header) + "\n" + table + "\n", stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if answer.returncode:
        raise HeatladderError(answer.stderr.strip())
    lines = answer.stdout.splitlines()
    return dict(list(zip(lines[0].split(","), _columns(lines[1:])))[dim:])


def _write(points: Any, T: Any, out: str) -> None:
    """Writes an answer as text, or as NumPy's .npy if it is long."""
    if len(points) != len(T):
        raise ValueError(f"solve returned {len(points)} points and {len(T)} temperatures")
    if numpy and len(T) >= LONG:
        with open(out, "wb") as f:
            numpy.save(f, numpy.column_stack([numpy.asarray(points, float), numpy.asarray(T, float)]))
        return
    rows = _rows(points)
    with open(out, "w", encoding="utf-8") as f:
        print(",".join(["x", "y", "z"][:len(rows[0])] + ["T"]), file=f)
        for row, value in zip(rows, T):
            print(*row, float(value), sep=",", file=f)


def solve_case(solve: Solve, case_path: str, out: str) -> int:
    """Runs `solve` on a case file and writes its answer; returns the exit status of a program."""
    try:
        _write(*solve(case(case_path)), out)
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
