# SPDX-License-Identifier: GPL-3.0-or-later
"""pytest --heatladder MODULE:FUNCTION: the battery on that function, a test for each row."""
from __future__ import annotations

import importlib
import shlex
import sys
from typing import Any, Dict, Iterable, List, Optional

import pytest

import heatladder


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("heatladder")
    group.addoption("--heatladder", metavar="MODULE:SOLVE", help="run heatladder's battery on this function")
    group.addoption("--heatladder-options", metavar="WORDS", default="",
                    help="options of `heatladder verify`, such as '--order 4 --skip plane/*'")


class GateFailed(Exception):
    """The row did not hold."""


class GateInconclusive(GateFailed):
    """The row did not decide."""


class Row(pytest.Item):
    """One row of the battery, already judged."""

    def __init__(self, *, gate: Dict[str, Any], **rest: Any) -> None:
        super().__init__(**rest)
        self.gate = gate

    def runtest(self) -> None:
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
        lines = [f"{self.gate['verdict']}: {self.gate['reason']}"]
        if self.gate.get("diagnosis"):
            lines.append(f"diagnosis: {self.gate['diagnosis']}")
        return "\n".join(lines + [self.gate["why"], f"heatladder {self.gate['command']}"])

    def reportinfo(self) -> Any:
        return self.path, None, f"heatladder: {self.name}"


class Battery(pytest.Collector):
    """Runs the battery when the tests are collected."""

    def __init__(self, *, target: str, options: str, **rest: Any) -> None:
        super().__init__(**rest)
        self.target, self.options = target, options

    def collect(self) -> Iterable[Row]:
        name, _, function = self.target.partition(":")
        if not function:
            raise pytest.UsageError(f"--heatladder {self.target}: MODULE:FUNCTION is wanted")
        sys.path.insert(0, str(self.config.invocation_params.dir))
        solve = getattr(importlib.import_module(name), function)
        verdict = heatladder.verify(solve, *shlex.split(self.options), quiet=True)
        if not verdict.gates:
            raise pytest.UsageError(f"heatladder verify ended with status {verdict.status}\n{verdict.text}")
        self.config.stash[diagnosis] = verdict.diagnosis
        for gate in verdict.gates:
            yield Row.from_parent(self, name=gate["id"], gate=gate)


diagnosis = pytest.StashKey[Optional[str]]()


def pytest_collection(session: pytest.Session) -> None:
    """With --heatladder alone no files are searched for tests."""
    if session.config.option.heatladder and session.config.args_source != pytest.Config.ArgsSource.ARGS:
        session.config.args = []


def pytest_collection_modifyitems(session: pytest.Session, config: pytest.Config, items: List[pytest.Item]) -> None:
    if not config.option.heatladder:
        return
    battery = Battery.from_parent(session, name="battery", target=config.option.heatladder,
                                  options=config.option.heatladder_options)
    rows = list(battery.collect())
    report = pytest.CollectReport(nodeid=battery.nodeid, outcome="passed", longrepr=None, result=rows)
    config.hook.pytest_collectreport(report=report)
    items.extend(rows)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Any:
    outcome = yield
    if call.excinfo is not None and isinstance(call.excinfo.value, GateInconclusive):
        outcome.get_result().inconclusive = True


def pytest_report_teststatus(report: pytest.TestReport) -> Any:
    return ("inconclusive", "i", "INCONCLUSIVE") if getattr(report, "inconclusive", False) else None


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    found = config.stash.get(diagnosis, None)
    if found:
        terminalreporter.write_line(f"heatladder: diagnosis: {found}")
    for report in terminalreporter.getreports("inconclusive"):
        terminalreporter.write_line(f"INCONCLUSIVE {report.nodeid} - {report.longreprtext.splitlines()[0]}")
