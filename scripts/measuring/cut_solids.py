"""Solids through isopatch: what they are, studies on them, and what comes of cutting and solving, or why nothing does."""

import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import time
from typing import NamedTuple

from measuring import runs

ELEMENTARY = {"plane", "cylinder", "cone", "sphere", "torus"}


class Outcome(NamedTuple):
    code: int       # exit code; negative: the signal that ended it; None: it took too long
    output: str     # standard output
    said: str       # standard error
    seconds: float  # of the processor

    @property
    def error(self):
        """The program's own line that says why; "" if it went well."""
        return "" if self.code == 0 else runs.cause(self.said)


def call(root, line, *, seconds, threads=1):
    """A command that may take so many seconds of the processor and, where others work too, twenty times as long."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 5))

    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as said:
        process = subprocess.Popen([str(word) for word in line], env=runs.environment(root, threads),
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=said, start_new_session=True,
                                   preexec_fn=limit)
        try:
            status, usage = _ended(process, time.monotonic() + 20 * seconds)
        except BaseException:
            os.killpg(process.pid, signal.SIGKILL)
            raise
        process.returncode = os.waitstatus_to_exitcode(status)
        code = None if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else process.returncode
        output.seek(0)
        said.seek(0)
        return Outcome(code, output.read(), said.read(), usage.ru_utime + usage.ru_stime)


def _ended(process, latest):
    """Status and usage of a process, ended if need be: its own usage, which a pool of threads cannot tell from that of
    all children."""
    while True:
        finished, status, usage = os.wait4(process.pid, os.WNOHANG)
        if finished:
            return status, usage
        if time.monotonic() > latest:
            os.killpg(process.pid, signal.SIGKILL)
        time.sleep(0.02)


# -------------------------------------------------------------- descriptions


def described(root, program, file, *, seconds=60):
    """(the first body as `isopatch info --json` has it, ""), or (None, why)."""
    found = call(root, [program, "info", "--json", file], seconds=seconds)
    if found.code != 0:
        return None, found.error or "no answer in time"
    content = json.loads(found.output)
    if len(content.get("solids", [])) != 1:
        return None, f"{len(content.get('solids', []))} bodies"
    return content["solids"][0], ""


def corners(solid, face):
    """The places of the corners of a face, loop by loop, in order."""
    result = []
    for loop in solid["faces"][face]["loops"]:
        for use in loop:
            vertices = solid["edges"][use["edge"]]["vertices"]
            if vertices:
                result.append(tuple(solid["vertices"][vertices[-1 if use["reversed"] else 0]]))
    return result


def _normal(places):
    total = [0.0, 0.0, 0.0]
    for a, b in zip(places, places[1:] + places[:1]):
        total = [t + a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i, t in enumerate(total)]
    length = sum(t * t for t in total) ** 0.5 or 1.0
    return [t / length for t in total]


def merged_faces(solid):
    """Lists of faces that are one side: neighbours in one plane with one name and colour, as isopatch merges them.
    The name of a side is that of its first."""
    faces = solid["faces"]
    side = list(range(len(faces)))

    def first(face):
        while side[face] != face:
            face = side[face]
        return face

    for edge in solid["edges"]:
        if len(edge["faces"]) == 2:
            a, b = edge["faces"]
            alike = all(faces[a][key] == faces[b][key] for key in ("name", "colour"))
            if alike and faces[a]["surface"] == faces[b]["surface"] == "plane":
                cosine = sum(x * y for x, y in zip(_normal(corners(solid, a)), _normal(corners(solid, b))))
                if cosine > 1 - 1e-12:
                    low, high = sorted((first(a), first(b)))
                    side[high] = low
    groups = {}
    for face in range(len(faces)):
        groups.setdefault(first(face), []).append(face)
    return [groups[face] for face in sorted(groups)]


def face_name(solid, face):
    return solid["faces"][face]["name"] or f"face {face}"


def held_and_loaded(solid):
    """The first faces of two sides: the largest one, and the largest of those that have fewest corners in common
    with it. Of sides that are one face, if there are two: others stay apart where the graph would not be 3-connected."""
    groups = merged_faces(solid)
    single = [group for group in groups if len(group) == 1]
    groups = single if len(single) > 1 else groups
    area = {group[0]: sum(solid["faces"][face]["area"] for face in group) for group in groups}
    places = {group[0]: {place for face in group for place in corners(solid, face)} for group in groups}
    held = max(area, key=area.get)
    others = [face for face in area if face != held]
    return held, min(others, key=lambda face: (len(places[face] & places[held]), -area[face]))


def kind_of(solid):
    """i: contractible, all edges convex; ii: with others; iii: holes, seams or a graph that is not 3-connected; iv:
    with surfaces that are not elementary."""
    checks = solid["checks"]
    whole = checks["contractible"] and checks["simple"] and checks["three_connected"]
    if any(face["surface"] not in ELEMENTARY for face in solid["faces"]):
        return "iv"
    if not whole or checks["faces_with_inner_loops"] or checks["periodic_faces"] or checks["closed_edges"]:
        return "iii"
    return "ii" if any(edge["convexity"] == "non-convex" for edge in solid["edges"]) else "i"


# --------------------------------------------------------------------- runs


def study_text(file, held, loaded, traction=(1, 2, 3), time_limit=60):
    """A study of steel: clamped on one face, with a traction in MPa on another."""
    stress = ", ".join(f'"{t} MPa"' for t in traction)
    return "\n".join(['[model]', f'file = {json.dumps(str(file))}', '[segmentation]', f'time_limit = {time_limit}',
                      '[[material]]', 'name = "steel"', '[[support]]', f'faces = [{json.dumps(held)}]',
                      'displacement = [0, 0, 0]', '[[load]]', f'faces = [{json.dumps(loaded)}]',
                      f'traction = [{stress}]', '[output]', 'fields = false', 'hdf5 = false', 'report = false', ''])


def cut(root, program, file, folder, *, seconds):
    """(what `isopatch segment --json` says of the first body, Outcome)."""
    outcome = call(root, [program, "segment", file, "--json", "--time-limit", seconds, "-o",
                          pathlib.Path(folder) / "blocks"], seconds=seconds + 10)
    return (json.loads(outcome.output)["bodies"][0] if outcome.code == 0 else None), outcome


def solve(root, program, study, folder, *, seconds):
    """(summary.json, Outcome) of a study given as text."""
    folder = pathlib.Path(folder)
    (folder / "study.toml").write_text(study)
    outcome = call(root, [program, "run", folder / "study.toml", "--quiet", "--output", folder / "results"],
                   seconds=seconds)
    summary = json.loads((folder / "results" / "summary.json").read_text()) if outcome.code == 0 else None
    return summary, outcome


def in_few_words(error, most=90):
    """An error without the program, the file, folders and the solid, up to where details begin."""
    text = re.sub(r"^isopatch: error: ", "", error)
    text = re.sub(r"^\S*/\S+: ", "", text)
    text = re.sub(r"(?<![\w.])/(\S*/)+", "", text)  # of other files, all but the name
    text = re.sub(r"^(solid|body \d+) '[^']*'[:,]? ", "", text)
    text = re.split(r"; | \(| at |: \d+ ", text)[0]
    return text if len(text) <= most else text[:most].rsplit(" ", 1)[0] + " ..."
