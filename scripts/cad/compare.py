"""Runs `isopatch info --json` on a file and says in which ways the answer is not the expected one."""

import json
import math
import subprocess


def run(program, path, options, seconds=300):
    """Exit code (negative: a signal; None: it did not end), answer and messages."""
    try:
        done = subprocess.run([program, "info", "--json", "--quiet", *options, str(path)], capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, None, ""
    said = done.stderr.decode("utf-8", "replace")
    try:
        return done.returncode, json.loads(done.stdout), said
    except ValueError:
        return done.returncode, None, said + ("\nthe answer is no JSON" if done.returncode == 0 else "")


def hexadecimal(colour):
    return None if colour is None else "#" + "".join(f"{round(255 * c):02x}" for c in colour)


def box_difference(expected, found, metres):
    """The largest difference of two boxes, of the size."""
    if expected is None:
        return 0.0
    low, high = expected
    size = max(b - a for a, b in zip(low, high)) * metres
    return max(abs(e * metres - f) for es, fs in zip(expected, found) for e, f in zip(es, fs)) / size


def relative(found, expected):
    return abs(found - expected) / abs(expected) if expected else abs(found)


def body_problems(expected, found, metres):
    """Differences of one body, the worst first."""
    problems = []
    for what, power in (("volume", 3), ("area", 2)):
        right = getattr(expected, what) * metres**power
        off = relative(found[what], right)
        if not off <= expected.tolerance:
            problems.append((off, f"{what} is {found[what]:.9g}, should be {right:.9g} ({off:.1e} off)"))
    off = box_difference(expected.box, found["box"], metres)
    if not off <= 1e-6:
        problems.append((off, f"box is {found['box']}, should be {expected.box} units"))
    checks = found["checks"]
    if expected.stage != "repair":
        for what in ("closed", "manifold", "oriented"):
            if not checks[what]:
                problems.append((1, f"not {what}"))
        if checks["shells"] != expected.shells:
            problems.append((1, f"{checks['shells']} shells, should be {expected.shells}"))
        if expected.genus is not None and checks["genus"] != expected.genus:
            problems.append((1, f"genus {checks['genus']}, should be {expected.genus}"))
    if expected.stage and found["stage"] != expected.stage:
        problems.append((1, f"stage {found['stage']}, should be {expected.stage}"))
    if expected.name is not None and found["name"] != expected.name:
        problems.append((1, f"name {found['name']!r}, should be {expected.name!r}"))
    colours = {hexadecimal(f["colour"]) for f in found["faces"]}
    if expected.colours is not None and colours != expected.colours:
        problems.append((1, f"colours {colours}, should be {expected.colours}"))
    names = {f["name"] for f in found["faces"]}
    if expected.faces is not None and names != expected.faces:
        problems.append((1, f"faces are called {names}, should be {expected.faces}"))
    if not math.isfinite(found["volume"]):
        problems.append((1, "the volume is no number"))
    return problems


def bodies_problems(expected, found, metres):
    """Each expected body is compared with the one left that is most like it."""
    left, result = list(found), []
    for body in expected:
        rated = [(sum(p[0] for p in problems), k, problems) for k, f in enumerate(left) for problems in [body_problems(body, f, metres)]]
        if not rated:
            break
        _, k, problems = min(rated)
        left.pop(k)
        result += [text for _, text in problems]
    return result


def problems_of(case, code, answer, said):
    """All ways in which an answer is not the expected one."""
    if code is None:
        return ["it did not end"]
    if code < 0:
        return [f"ended by signal {-code}"]
    codes = case.code if isinstance(case.code, tuple) else (case.code,)
    if code not in codes:
        return [f"exit code {code}: {said.strip()[:300]}"]
    if answer is None:
        return [f"'{case.says}' is not in: {said.strip()[:300]}"] if case.says and case.says not in said else []
    if code != 0 and 0 in codes and case.says in said:
        return []  # what may be refused
    problems = []
    if code == 0 and case.bodies and answer["bodies"] != len(case.bodies):
        problems.append(f"{answer['bodies']} bodies, should be {len(case.bodies)}")
    if case.unit and answer["unit"] != case.unit:
        problems.append(f"unit {answer['unit']}, should be {case.unit}")
    warnings = " ".join(answer["warnings"])
    if case.warns is not None and case.warns != bool(warnings):
        problems.append(f"warning: {warnings[:300]}" if warnings else "no warning")
    if case.says and case.says not in warnings + said:
        problems.append(f"'{case.says}' is not in: {(warnings + said)[:300]}")
    return problems + bodies_problems(case.bodies, answer["solids"], case.metres)
