# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the package: $HEATLADDER is the program under test."""
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import heatladder

PACKAGE = Path(heatladder.__file__).parents[1]

# An explicit scheme for one material on a rod, and the same with a conductivity 5 % too large.
SOLVER = '''
import math
import heatladder

def solve(case, factor=1.0):
    if case.dim != 1 or case.materials != 1 or case.source != "no":
        raise heatladder.NotApplicable
    (lo,), (hi,), (n,), (dx,) = case.lo, case.hi, case.cells, case.width
    x = [lo + (i + 0.5) * dx for i in range(n)]
    scene = heatladder.reference(case, [lo, *x, hi], "initial_mean,rho_c,k_x,wall_x", width=[dx])
    T, rho_c, k, kind, value, b = (list(column) for column in scene.values())
    kappa = factor * k[0] / rho_c[0]
    coupling, flux = [], []  # of both walls, s^-1 and K s^-1
    for wall in (0, -1):
        beyond = 1 / b[wall] if kind[wall] == 3 else 0
        coupling.append(0 if kind[wall] == 2 else 1 / (dx / (2 * factor * k[0]) + beyond) / dx / rho_c[0])
        flux.append(value[wall] / dx / rho_c[0] if kind[wall] == 2 else 0)
    T[0], T[-1] = value[0], value[-1]
    g = [coupling[0], *[kappa / dx ** 2] * (n - 1), coupling[1]]
    steps = math.ceil(4 * case.t_end * kappa / dx ** 2)
    for _ in range(steps):
        q = [g[i] * (T[i + 1] - T[i]) for i in range(n + 1)]
        rate = [q[i + 1] - q[i] for i in range(n)]
        rate[0] += flux[0]
        rate[-1] += flux[1]
        T[1:-1] = [t + case.t_end / steps * r for t, r in zip(T[1:-1], rate)]
    return x, T[1:-1]

def wrong(case):
    return solve(case, 1.05)

def crashes(case):
    raise ValueError("nothing here")

if __name__ == "__main__":
    heatladder.run(solve)
'''


@pytest.fixture
def mine(tmp_path, monkeypatch):
    (tmp_path / "mine.py").write_text(SOLVER)
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("PYTHONPATH", f"{PACKAGE}{os.pathsep}{tmp_path}")
    sys.modules.pop("mine", None)
    import mine as module
    return module


def plugin(*words):
    loaded = [] if (PACKAGE / "bin").exists() else ["-p", "heatladder.pytest_plugin"]
    return subprocess.run([sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *loaded, *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def test_reference_gives_the_exact_solution():
    sigma2 = 2.0 ** 2
    found = heatladder.reference("rod-gauss", [0.0, 1.5], "temperature", time=3)
    spread = sigma2 + 2 * 0.01 * 3
    exact = [math.sqrt(sigma2 / spread) * math.exp(-x * x / (2 * spread)) for x in (0.0, 1.5)]
    assert list(found["temperature"]) == pytest.approx(exact, rel=1e-12)


EXACT = """
import heatladder, numpy

def solve(case):
    (lo,), (n,), (dx,) = case.lo, case.cells, case.width
    x = lo + (numpy.arange(n) + 0.5) * dx
    return x, heatladder.reference(case, x, "temperature", time=case.t_end)["temperature"]

heatladder.run(solve)
"""


@pytest.mark.parametrize("dx, start", [("0.001", b"\x93NUMPY"), ("0.1", b"# seconds = ")])
def test_long_answers_are_binary_and_judged_alike(dx, start, tmp_path, monkeypatch):
    pytest.importorskip("numpy")
    (tmp_path / "exact.py").write_text(EXACT)
    monkeypatch.setenv("PYTHONPATH", str(PACKAGE))
    code, where = [sys.executable, str(tmp_path / "exact.py")], tmp_path / "cases"
    subprocess.run([heatladder.program(), "case", "rod-gauss", "--dx", dx, "--into", str(where)], check=True)
    place = where / "rod-gauss" / dx
    subprocess.run([*code, str(place / "case"), str(place / "out.csv")], check=True)
    assert (place / "out.csv").read_bytes().startswith(start)
    judged = subprocess.run([heatladder.program(), "run", "rod-gauss", "mine", "--dx", dx, "--json", "-", "--solver",
                             " ".join([*code, "{case} {out}"])], check=True, stdout=subprocess.PIPE)
    assert json.loads(judged.stdout)["error_l1"] < 1e-12


def test_reference_takes_points_of_the_plane_and_means_over_cells():
    found = heatladder.reference("square-step", [(0.0, 0.0), (1.9, 1.9)], "initial_mean", width=[0.1, 0.1])
    assert list(found["initial_mean"]) == pytest.approx([10, 0], rel=1e-14)


def test_a_refusal_is_an_error_with_the_programs_words():
    with pytest.raises(heatladder.HeatladderError, match="rod-gaus"):
        heatladder.reference("rod-gaus", [0.0], "temperature")


def test_case_reads_numbers_and_text(tmp_path):
    path = tmp_path / "case"
    path.write_text("dim = 2\nlo = 0, 1\nhi = 2, 4\ncells = 4, 3\nt_end = 5\nk_x = 1e-2\nmap = y,-x\nsource = no\n")
    case = heatladder.case(path)
    assert (case.dim, case.width, case.t_end, case.source, case.map) == (2, [0.5, 1.0], 5, "no", "y,-x")
    assert (case["dim"], case["lo"], case["k_x"], case.k_x) == (2, [0, 1], 0.01, 0.01)
    path.write_text("dim = 1\nlo = -2\nhi = 2\ncells = 8\n")
    case = heatladder.case(path)
    assert (case["lo"], case.lo, case.cells, case.width) == (-2, [-2], [8], [0.5])
    with pytest.raises(AttributeError, match="no k_y"):
        case.k_y


def test_scenes_and_gates_are_listed():
    assert heatladder.scenes()["rod-gauss"].startswith("a Gaussian")
    assert len(heatladder.scenes()) >= 24 and "conductivity" in heatladder.gates()["smooth/gauss"]


CASES = {1: "rod-gauss", 2: "square-step", 3: "cube-step"}

# Points of each shape, by dimension: the shape of T, or an error.
SHAPES = [
    (1, (), ()), (1, (5,), (5,)), (1, (5, 1), (5,)), (1, (5, 2), None), (1, (2, 3, 1), (2, 3)),
    (2, (2,), ()), (2, (5, 2), (5,)), (2, (5,), None), (2, (5, 3), None), (2, (4, 3, 2), (4, 3)),
    (3, (5, 3), (5,)), (3, (5, 2), None), (3, (4, 3, 2, 3), (4, 3, 2)), (3, (5, 4), None), (3, (), None),
]


@pytest.mark.parametrize("dim, shape, due", SHAPES)
@pytest.mark.parametrize("call", ["exact", "reference", "words", "answer"])
def test_one_rule_for_points(call, dim, shape, due, tmp_path):
    numpy = pytest.importorskip("numpy")
    points = numpy.random.default_rng(3).uniform(-0.4, 0.4, shape)
    case = heatladder.Case(dim=dim, oracle=CASES[dim])
    if call == "words" and dim > 1 and len(shape) == 1:
        pytest.skip("read as points of a rod")
    if call == "exact" and not os.environ.get("HEATLADDER_LIBRARY"):
        pytest.skip("no library is given")

    def evaluate():
        if call == "exact":
            return heatladder.exact(CASES[dim], points, 1.0)
        if call == "answer":
            T = numpy.zeros(shape[:-1] if dim > 1 or len(shape) > 1 else shape)
            heatladder._write(case, points, T, str(tmp_path / "out"))
            return numpy.zeros(due)
        return heatladder.reference(case if call == "reference" else CASES[dim], points, "temperature", 1)["temperature"]
    if due is None:
        with pytest.raises((ValueError, heatladder.HeatladderError), match="points|column"):
            evaluate()
        return
    assert evaluate().shape == due


@pytest.mark.parametrize("n", [10, 20000])
def test_answers_are_in_c_order_and_complete(n, tmp_path):
    numpy = pytest.importorskip("numpy")
    case, out = heatladder.Case(dim=3), tmp_path / "out"
    x, y, z = (numpy.linspace(0, a, n) for a in (1, 2, 3))
    heatladder._write(case, numpy.array([x, y, z]).T, x, str(out))
    table = numpy.load(out) if n > heatladder.LONG else numpy.loadtxt(out, delimiter=",", skiprows=1)
    assert table.flags.c_contiguous and (table == numpy.column_stack([x, y, z, x])).all()
    masked = numpy.ma.masked_greater(x, 0.5)
    for points, T, wanted in ((numpy.array([x, y, z]).T, masked, "masked"),
                              (numpy.ma.masked_greater(numpy.array([x, y, z]).T, 0.5), x, "masked"),
                              (numpy.array([x, y, z, x]).T, x, "shape"), (numpy.array([x, y, z]).T, x[1:], "temperatures")):
        with pytest.raises(ValueError, match=wanted):
            heatladder._write(case, points, T, str(out))
    with pytest.raises(TypeError, match="real numbers"):
        heatladder._write(case, numpy.array([x, y, z]).T, x + 1j, str(out))


def test_a_case_has_sides_and_steps():
    case = heatladder.Case(dim=2, lo=[0, -1], hi=[2, 1], t_end=1.0, cells=[4, 4], side_x_lo="neumann, 0.5, 1",
                           side_x_hi="dirichlet, 2", side_y_lo="robin, 3, 4", side_y_hi="periodic")
    assert list(case.sides) == [(0, "lo", 0, "neumann"), (0, "hi", 2, "dirichlet"), (1, "lo", -1, "robin"),
                                (1, "hi", 1, "periodic")]
    assert (case.is_plain, case.steps(0.3), heatladder.Case(case, dt=0.1).steps(0.3)) == (False, 4, 10)
    assert heatladder.Case(case, side_y_hi="neumann, 0").is_plain
    assert not heatladder.Case(case, side_y_hi="neumann, 0", source="changing").is_plain
    assert not heatladder.Case(case, conductivity="field").is_plain


def test_reference_takes_a_width_for_each_point():
    numpy = pytest.importorskip("numpy")
    found = heatladder.reference("rod-step", [0.5, 0.5], "initial_mean", width=[numpy.array([0.2, 0.1])])
    assert list(found["initial_mean"]) == pytest.approx([5, 5])
    with pytest.raises(ValueError, match="width"):
        heatladder.reference("rod-step", [0.5, 0.5], "initial_mean", width=[0.1, 0.1])


def test_verify_holds_a_right_code_in_this_process(mine):
    verdict = heatladder.verify(mine.solve, "--only", "walls/insulated", quiet=True)
    assert (verdict.status, [gate["verdict"] for gate in verdict.gates]) == (0, ["pass"])


def test_verify_names_the_fault_of_a_wrong_code(mine):
    verdict = heatladder.verify(mine.wrong, "--only", "walls/insulated", quiet=True)
    assert verdict.status == 1
    assert "the diffusivity, k/rho c" in verdict.gates[0]["diagnosis"]


def test_a_code_that_raises_is_a_failure_and_does_not_hang(mine):
    assert heatladder.verify(mine.crashes, "--only", "walls/insulated", quiet=True).status not in (0, 77)


def test_a_program_answers_one_case(mine, tmp_path):
    heat = heatladder.program()
    subprocess.run([heat, "case", "rod-cosine", "--dx", "0.1", "--into", "cases"], check=True, stdout=subprocess.DEVNULL)
    (case,) = Path("cases").rglob("case")
    subprocess.run([sys.executable, "mine.py", case, "out.csv"], check=True)
    assert Path("out.csv").read_text().partition("\n")[2].startswith("x,T\n0.05,")


def test_pytest_has_a_test_for_each_row(mine):
    run = plugin("--heatladder", "mine:solve", "--heatladder-options", "--only 'walls/*'")
    assert run.returncode == 0, run.stdout
    assert "2 passed" in run.stdout


def test_pytest_shows_the_diagnosis_of_a_row_that_fails(mine):
    run = plugin("--heatladder", "mine:wrong", "--heatladder-options", "--only walls/insulated")
    assert run.returncode == 1, run.stdout
    assert "as if the diffusivity" in run.stdout


def test_pytest_skips_what_the_code_is_not_for(mine):
    words = ["-rs", "--heatladder", "mine:solve", "--heatladder-options", "--only 'contact/*'"]
    run = plugin(*words)
    assert " skipped in " in run.stdout and "passed" not in run.stdout and "failed" not in run.stdout, run.stdout
    assert run.returncode == 1 and "every row was skipped" in run.stdout
    assert plugin(*words, "--heatladder-allow-skips").returncode == 0


def test_pytest_selects_rows_before_any_runs(mine, tmp_path):
    (tmp_path / "mine.py").write_text(SOLVER.replace("def solve(case, factor=1.0):", """def solve(case, factor=1.0):
    print(case.oracle.split()[0], file=open("runs.txt", "a"))"""))
    run = plugin("-k", "insulated", "--heatladder", "mine:solve", "--heatladder-options", "--only 'walls/*'")
    assert run.returncode == 0 and "1 passed, 2 deselected" in run.stdout, run.stdout
    assert set(Path("runs.txt").read_text().split()) == {"rod-cosine"}
    run = plugin("-k", "nothing", "--heatladder", "mine:crashes")
    assert "deselected" in run.stdout and "failed" not in run.stdout, run.stdout


def test_readme_names_what_is_there():
    text = (PACKAGE / "README.md").read_text()
    assert f"{heatladder.LONG // 1000} {heatladder.LONG % 1000:03d} points" in text
    names = set(re.findall(r"heatladder\.([A-Za-z_]+)\(", text) + re.findall(r"raise heatladder\.([A-Za-z]+)", text))
    assert len(names) >= 5 and all(callable(getattr(heatladder, name)) for name in names)
