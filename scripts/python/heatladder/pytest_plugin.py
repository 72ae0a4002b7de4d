# SPDX-License-Identifier: GPL-3.0-or-later
"""pytest --heatladder MODULE:FUNCTION: the battery on that function, a test for each row."""
from __future__ import annotations

import fnmatch
import importlib
import re
import shlex
import sys
from pathlib import Path
from typing import Any, Dict, List, Optional

import pytest

import heatladder


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("heatladder")
    group.addoption("--heatladder", metavar="MODULE:SOLVE", help="run heatladder's battery on this function")
    group.addoption("--heatladder-options", metavar="WORDS", default="",
                    help="options of `heatladder verify`, such as '--order 4 --skip plane/*'")
    group.addoption("--heatladder-allow-skips", action="store_true",
                    help="pass where the function skips all rows (NotApplicable)")


class GateFailed(Exception):
    """The row did not hold."""


class GateInconclusive(GateFailed):
    """The row did not decide."""


class Battery(pytest.Collector):
    """The battery on one function: run once, on the rows that are selected, when the first of them is due."""

    verdict: Optional[heatladder.Verdict] = None

    def __init__(self, *, target: str, options: str, **rest: Any) -> None:
        super().__init__(**rest)
        self.target, self.words = target, shlex.split(options)

    def _take(self, option: str) -> List[str]:
        """Removes an option from the words; its values."""
        values = []
        while option in self.words:
            at = self.words.index(option)
            values += self.words[at + 1:at + 2]
            del self.words[at:at + 2]
        return values

    def collect(self) -> List[Row]:
        name, _, function = self.target.partition(":")
        if not function:
            raise pytest.UsageError(f"--heatladder {self.target}: MODULE:FUNCTION is wanted")
        sys.path.insert(0, str(self.config.invocation_params.dir))
        self.solve = getattr(importlib.import_module(name), function)
        only, skip = (",".join(self._take(option)).split(",") for option in ("--only", "--skip"))
        rows = list(heatladder.gates(4 if "--order 4" in " ".join(self.words) else 2))
        if "--gates" in self.words:
            text = Path(self.words[self.words.index("--gates") + 1]).read_text(encoding="utf-8")
            rows = re.findall(r'\bGATE\("([^"]+)"', text)
        found = [row for row in rows if (only == [""] or any(fnmatch.fnmatchcase(row, glob) for glob in only))
                 and not any(fnmatch.fnmatchcase(row, glob) for glob in skip)]
        if not found:
            raise pytest.UsageError("heatladder: no row of the battery matches --only and --skip")
        return [Row.from_parent(self, name=row) for row in found]

    def gate(self, name: str) -> Dict[str, Any]:
        """The verdict of a row."""
        if self.verdict is None:
            rows = ",".join(item.name for item in self.session.items if isinstance(item, Row))
            self.verdict = heatladder.verify(self.solve, "--only", rows, *self.words, quiet=True)
        for gate in self.verdict.gates:
            if gate["id"] == name:
                return gate
        if self.verdict.gates:
            pytest.skip("not among the rows of --heatladder-options")
        raise GateFailed(f"heatladder verify ended with status {self.verdict.status}\n{self.verdict.text}")


class Row(pytest.Item):
    """One row of the battery."""

    gate: Optional[Dict[str, Any]] = None

    def runtest(self) -> None:
        assert isinstance(self.parent, Battery)
        self.gate = self.parent.gate(self.name)
        verdict = self.gate["verdict"]
        if verdict == "skipped":
            pytest.skip(self.gate["reason"])
        if verdict == "inconclusive":
            raise GateInconclusive(self.gate["reason"])
        if verdict != "pass":
            raise GateFailed(self.gate["reason"])

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if not isinstance(excinfo.value, GateFailed):
            return super().repr_failure(excinfo)
        if self.gate is None:
            return str(excinfo.value)
        lines = [f"{self.gate['verdict']}: {self.gate['reason']}"]
        if self.gate.get("diagnosis"):
            lines.append(f"diagnosis: {self.gate['diagnosis']}")
        words = self.gate["command"].partition(" --solver ")[0]  # the program is a pipe to this process
        return "\n".join(lines + [self.gate["why"], f"heatladder {words}",
                                  f"pytest --heatladder {self.parent.target} -k {self.name}"])

    def reportinfo(self) -> Any:
        return self.path, None, f"heatladder: {self.name}"


battery_key = pytest.StashKey[Battery]()


def pytest_collection(session: pytest.Session) -> None:
    """With --heatladder alone no files are searched for tests."""
    if session.config.option.heatladder and session.config.args_source != pytest.Config.ArgsSource.ARGS:
        session.config.args = []


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(session: pytest.Session, config: pytest.Config, items: List[pytest.Item]) -> None:
    """Adds the rows, before -k and -m select."""
    if not config.option.heatladder:
        return
    battery = Battery.from_parent(session, name="battery", target=config.option.heatladder,
                                  options=config.option.heatladder_options)
    rows = battery.collect()
    report = pytest.CollectReport(nodeid=battery.nodeid, outcome="passed", longrepr=None, result=rows)
    config.hook.pytest_collectreport(report=report)
    config.stash[battery_key] = battery
    items.extend(rows)


def _all_skipped(config: pytest.Config) -> bool:
    battery = config.stash.get(battery_key, None)
    gates = battery.verdict.gates if battery and battery.verdict else []
    return bool(gates) and all(gate["verdict"] == "skipped" for gate in gates) \
        and not config.option.heatladder_allow_skips


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    if _all_skipped(session.config) and session.exitstatus in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Any:
    outcome = yield
    if call.excinfo is not None and isinstance(call.excinfo.value, GateInconclusive):
        outcome.get_result().inconclusive = True


def pytest_report_teststatus(report: pytest.TestReport) -> Any:
    return ("inconclusive", "i", "INCONCLUSIVE") if getattr(report, "inconclusive", False) else None


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    battery = config.stash.get(battery_key, None)
    if battery and battery.verdict and battery.verdict.diagnosis:
        terminalreporter.write_line(f"heatladder: diagnosis: {battery.verdict.diagnosis}")
    if _all_skipped(config):
        terminalreporter.write_line("heatladder: every row was skipped, so nothing was verified: a failure without "
                                    "--heatladder-allow-skips")
    for report in terminalreporter.getreports("inconclusive"):
        terminalreporter.write_line(f"INCONCLUSIVE {report.nodeid} - {report.longreprtext.splitlines()[0]}")
