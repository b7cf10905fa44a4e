"""Runs of isopatch, and what their summary.json says about time."""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
from typing import NamedTuple, Optional


class Run(NamedTuple):
    summary: Optional[dict]  # summary.json; None if the run failed
    wall_seconds: float      # from start to end, reading and writing included
    failure: str             # why, in a line; empty if it went well
    said: str = ""           # all that was said on standard error

    @property
    def dofs(self):
        return self.summary["discretization"]["dofs_free"]


def environment(root, threads):
    """As scripts/environment sets it, with a number of OpenMP threads."""
    settings = dict(os.environ)
    settings.setdefault("OPENBLAS_NUM_THREADS", "1")
    settings["OMP_NUM_THREADS"] = str(threads)
    if os.geteuid() == 0:
        settings.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    data = root.parent / "shared" / "data"
    if data.is_dir():
        settings.setdefault("ISOPATCH_DATA", str(data))
    return settings


def _limit_memory(limit):
    return (lambda: resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))) if limit else None


def run_study(root, command, study, overrides, *, threads, folder, timeout=None, memory=None):
    """One run in a new folder below `folder`, which is removed afterwards.

    command: the program with what starts it, a list. overrides: {key: value} for --set. memory: bytes that each
    process may have. A failure is in the result, not an exception.
    """
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    output = pathlib.Path(tempfile.mkdtemp(prefix="run-", dir=folder))
    line = [*map(str, command), "run", str(study), "--quiet", "--output", str(output)]
    for key, value in overrides.items():
        line += ["--set", f"{key}={value}"]
    start = time.monotonic()
    summary, failure, said = None, "", ""
    try:
        code, said = _finish(line, environment(root, threads), timeout, _limit_memory(memory))
        if code is None:
            failure = f"not done after {timeout:g} s"
        elif code:
            failure = cause(said) or f"exit code {code}"
        wall = time.monotonic() - start
        summary = json.loads((output / "summary.json").read_text()) if not failure else None
    except OSError as error:
        wall, failure = time.monotonic() - start, str(error)
    finally:
        shutil.rmtree(output, ignore_errors=True)
    return Run(summary, wall, failure, said)


def _finish(line, settings, timeout, before):
    """(exit code, standard error) of a command that has ended with all that it started; the code is None where time
    was up."""
    process = subprocess.Popen(line, env=settings, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True, start_new_session=True, preexec_fn=before)
    try:
        said = process.communicate(timeout=timeout)[1]
        return process.returncode, said
    except subprocess.TimeoutExpired:
        return None, _end(process)
    except BaseException:
        _end(process)
        raise


def _end(process, patience=20):
    """Ends a command and its ranks, and returns what it said. A launcher passes SIGTERM on to the ranks, also to those
    on other nodes, and ends after them; SIGKILL would leave them running, so it comes last."""
    for number, seconds in ((signal.SIGTERM, patience), (signal.SIGKILL, patience)):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            pass
        try:
            return process.communicate(timeout=seconds)[1]
        except subprocess.TimeoutExpired:
            pass
    return ""


# What launchers add to the failure of a rank.
LAUNCHERS_PART = re.compile(r"^[-=*]+$|^(srun|slurmstepd): |exited? with (exit|non-zero)|Primary job +terminated|"
                            r"a non-zero exit code|mpi(exec|run) (detected|noticed)|^Process name: |^Exit code: ")


def cause(text):
    """The line that says why: isopatch's own error, else the first line that is not a launcher's about a rank's end."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    own = [line for line in lines if line.startswith("isopatch: error")]
    others = [line for line in lines if not LAUNCHERS_PART.search(line)]
    return (own or others or lines or [""])[0]


def phases(run):
    """{phase: seconds} of a run: those of summary.json, the solver's parts in place of "solve", and in "start and
    files" what the program took beyond them."""
    timings, solver = dict(run.summary["timings"]), run.summary["solver"]
    total = timings.pop("total")
    parts = {"solve: " + part: solver.get(part + "_seconds") or 0.0 for part in ("analysis", "factorization", "solve")}
    result = {}
    for name, seconds in timings.items():
        if name == "solve" and sum(parts.values()) > 0:
            result.update(parts)
            result["solve: rest"] = max(0.0, seconds - sum(parts.values()))
        else:
            result[name] = seconds
    result["start and files"] = max(0.0, run.wall_seconds - total)
    return result


def fastest(runs):
    """The least time of each phase over runs of the same study, and of the whole."""
    tables = [phases(run) for run in runs]
    return {name: min(table.get(name, 0.0) for table in tables) for name in tables[0]}, min(
        run.wall_seconds for run in runs)


def is_direct(run):
    return (run.summary["solver"].get("factor_nonzeros") or 0) > 0 and run.summary["solver"]["method"] in (
        "cholmod", "mumps", "umfpack")
