"""Pages of small made-up parts with known fields, filled into the template as the program does it.

  fixture.py FOLDER      writes report.html, compare.html, model.html, verification.html, faults.html and grid.html (300 patches, 250,000 points)
"""

import array
import base64
import html
import json
import math
import pathlib
import sys

WEB = pathlib.Path(__file__).resolve().parent.parent / "web"
THREE = pathlib.Path("/usr/share/javascript/three/three.min.js")
DISPLACEMENT = {"key": "displacement", "label": "Displacement", "unit": "um", "factor": 1e6, "components": 3}
STRESS = {"key": "stress", "label": "Stress", "unit": "MPa", "factor": 1e-6, "components": 6}
VON_MISES = {"key": "von_mises", "label": "Von Mises stress", "unit": "MPa", "factor": 1e-6, "components": 1}
JACOBIAN = {"key": "scaled_jacobian", "label": "Scaled Jacobian", "unit": "", "factor": 1, "components": 1}
TRACTION = {"key": "traction", "label": "Traction", "unit": "MPa", "factor": 1e-6, "components": 3, "on": "interfaces"}
SIDES = ["west", "east", "south", "north", "front", "back"]
NAN = float("nan")

STUDY = """# A quarter ring, held at its foot.
title = "quarter ring <of two patches>"

[model]
file = "ring.xml"
length_unit = "mm"

[[material]]
name = "steel"
young = "210 GPa"
poisson = 0.3

[[support]]
name = "foot"
faces = ["0:west"]
displacement = [0, 0, 0]

[[load]]
name = "head"
faces = ["1:east"]
force = [0, "-200 N", "50 N"]
"""

PLOT = """<svg viewBox="0 0 420 190" role="img" aria-label="residual over iterations">
<line x1="50" y1="160" x2="410" y2="160" stroke="var(--line)"/>
<polyline points="50,20 140,60 230,90 320,130 410,150" fill="none" stroke="var(--plot-1)" stroke-width="2"/>
<text x="230" y="185" text-anchor="middle" fill="var(--soft)" font-size="12">iteration</text></svg>"""


def block(numbers):
    values = array.array("f", numbers)
    if sys.byteorder == "big":
        values.byteswap()
    return base64.b64encode(values.tobytes()).decode()


def short_block(numbers, step):
    values = array.array("h", (-32768 if math.isnan(x) else round(x / step) for x in numbers))
    if sys.byteorder == "big":
        values.byteswap()
    return base64.b64encode(values.tobytes()).decode()


def levels(start, end, elements, per_element):
    n = elements * per_element
    return [start + (end - start) * i / n for i in range(n + 1)]


def stress_components(stress):
    """xx, yy, zz, xy, yz, zx, all different."""
    return [stress, 0.5 * stress, -0.25 * stress, 0.125 * stress, -2 * stress, 3 * stress]


class Scene:
    """Collects the grids of patches; `fields(point)` gives displacement and von Mises stress there."""

    def __init__(self, fields):
        self.fields, self.patches, self.jacobian = fields, [], []
        self.points, self.displacement, self.von_mises, self.stress = [], [], [], []

    def add(self, name, place, parameters, per_element, faces, jacobian=lambda *parameter: 0.9):
        """`place(u, v, w)`: the point; `faces`: six of (kind, supports, loads)."""
        first = len(self.points) // 3
        for w in parameters[2]:
            for v in parameters[1]:
                for u in parameters[0]:
                    point = place(u, v, w)
                    moved, stress = self.fields(point)
                    self.points.extend(point)
                    self.displacement.extend(moved)
                    self.von_mises.append(stress)
                    self.stress.extend(stress_components(stress))
                    self.jacobian.append(jacobian(u, v, w))
        self.patches.append({
            "name": name, "first": first, "sizes": [len(p) for p in parameters], "parameters": parameters,
            "element_ends": [list(range(0, len(p), per_element)) for p in parameters],
            "faces": [{"kind": kind, "label": f"{name}:{side}", "supports": supports, "loads": loads}
                      for side, (kind, supports, loads) in zip(SIDES, faces)]})

    def data(self, **more):
        columns = [self.points[c::3] for c in range(3)]
        step = max(map(abs, self.stress)) / 32767
        return {
            "length": {"unit": "mm", "factor": 1000},
            "box": {"min": [min(c) for c in columns], "max": [max(c) for c in columns]},
            "fields": [DISPLACEMENT, VON_MISES, {**STRESS, "step": step}, JACOBIAN],
            "points": block(self.points), "displacement": block(self.displacement),
            "von_mises": block(self.von_mises), "stress": short_block(self.stress, step), "scaled_jacobian": block(self.jacobian), "patches": self.patches,
            "supports": [], "loads": [], "markers": [], "warnings": [],
            "tolerance": {"chord": 5e-4, "field": 5e-3, "is_coarse": False}, **more}


def ring_fields(point):
    """Linear in the place: what a click must show is known wherever it falls."""
    x, y, z = point
    return [1e-4 * z + 2e-3 * (0.06 - x), -4e-3 * (0.06 - x), 1e-3 * y], 1e8 + 2e9 * y


def ring_place(u, v, w):
    """u: angle in parts of a quarter turn, v: from the inner to the outer radius, w: thickness."""
    radius, angle = 0.04 + 0.02 * v, 0.5 * math.pi * u
    return [radius * math.cos(angle), radius * math.sin(angle), 0.01 * w]


def ring():
    outside = ("boundary", [], [])
    scene = Scene(ring_fields)
    # The second direction goes from the outer to the inner radius: its parameter decreases, the patch is right-handed.
    sampled = [[levels(0, 0.5, 3, 4), levels(0, 0.5, 3, 4)], levels(1, 0, 2, 4), levels(0, 1, 1, 4)]
    joint = ("interface", [], [])
    scene.add("0", lambda u, v, w: ring_place(u, v, w), [sampled[0][0], sampled[1], sampled[2]], 4,
              [("boundary", [0], []), joint, outside, outside, outside, outside], lambda u, v, w: 0.95 - 0.3 * u)
    scene.add("1", lambda u, v, w: ring_place(0.5 + u, v, w), [sampled[0][1], sampled[1], sampled[2]], 4,
              [joint, ("boundary", [], [0]), outside, outside, outside, ("boundary", [1], [1])])
    return scene


TIP = ring_place(1, 1, 0.5)


def ring_markers():
    peak = ring_place(1, 1, 1)
    tip, top = ring_fields(TIP), ring_fields(peak)
    # Not what the linear field has there: a page that shows these figures has them from the marker.
    exact = [1.2345678e-5, -2.4691357e-4, 5.9994e-5]
    return [
        {"name": "tip", "kind": "probe", "patch": 1, "parameter": [0.5, 1, 0.5], "point": TIP, "displacement": exact,
         "von_mises": 2.19876e8},
        {"name": "largest displacement", "kind": "max_displacement", "patch": 1, "parameter": [0.5, 1, 1], "point": peak,
         "displacement": top[0], "von_mises": top[1]},
        {"name": "largest von Mises stress", "kind": "max_von_mises", "patch": 1, "parameter": [0.5, 1, 0.5],
         "point": ring_place(0.9, 1, 0.5), "displacement": ring_fields(ring_place(0.9, 1, 0.5))[0], "von_mises": tip[1]}]


def ring_summary(markers):
    tip, top, stress = markers
    return {
        "schema_version": 1, "program": {"name": "isopatch", "version": "0.1.0"}, "title": "quarter ring",
        "study": "ring.toml",
        "model": {"patches": 2, "interfaces": 1, "boundary_faces": 10, "bodies": 1, "control_points": 40, "elements": 12,
                  "volume": math.pi / 4 * (0.06**2 - 0.04**2) * 0.01, "boundary_area": 0.00497,
                  "box": {"min": [0, 0, 0], "max": [0.06, 0.06, 0.01]}, "largest_gap": 0, "min_scaled_jacobian": 0.8,
                  "left_handed_patches": [], "patches_not_certified": [1]},
        "materials": [{"name": "steel", "patches": [0, 1], "young": 2.1e11, "poisson": 0.3, "density": 7850}],
        "supports": [{"name": "foot", "kind": "displacement", "faces": ["0:west"], "area": 2e-4},
                     {"name": "support 2 (back)", "kind": "symmetry", "faces": ["1:back"], "area": 7.854e-4}],
        "loads": [{"name": "head", "kind": "force", "faces": ["1:east"], "area": 2e-4, "patches": [], "volume": 0},
                  {"name": "load 2 (cover)", "kind": "pressure", "faces": ["1:back"], "area": 7.854e-4, "patches": [],
                   "volume": 0}],
        "discretization": {"degree": [3, 3, 3], "elements": 96, "control_points": 700, "dofs_uncoupled": 2100,
                           "dofs_eliminated": 1980, "multipliers": 120, "multipliers_free": 120, "dofs": 1980,
                           "dofs_free": 1890},
        "coupling": "elimination",
        "solver": {"method": "cg", "reason": "positive definite and too large for factors in memory", "iterations": 23,
                   "relative_residual": 3.2e-10, "energy_error": 1.3e-9, "residual_history": [1, 1e-3, 1e-9],
                   "operator": "matrix_free", "levels": 3, "matrix_nonzeros": 1147401, "factor_nonzeros": 0,
                   "factor_flops": 0, "memory_bytes": 15721000, "predicted_bytes": 42769385, "analysis_seconds": 0.06,
                   "factorization_seconds": 0.2, "solve_seconds": 0.04},
        "results": {"max_displacement": math.hypot(*top["displacement"]), "max_displacement_point": top["point"],
                    "max_displacement_at": {"patch": 1, "parameter": [1, 0, 1]}, "internal_energy": 0.0123456,
                    "external_work": 0.0123456, "max_von_mises": stress["von_mises"],
                    "max_von_mises_point": stress["point"], "max_von_mises_at": {"patch": 1, "parameter": [0.9, 0, 0.5]},
                    "max_von_mises_sampled": "at Gauss points and on faces", "total_load": [0, -200, 50],
                    "reactions": [{"support": "foot", "force": [1e-12, 200, -50], "moment": [0, 0, 0]}]},
        "probes": [{"name": "tip", "patch": 1, "parameter": tip["parameter"], "point": tip["point"],
                    "displacement": tip["displacement"], "stress": [0] * 6, "von_mises": tip["von_mises"]}],
        "levels": [{"refine": i, "dofs": 1980 * 3**i, "internal_energy": 0.0123456, "max_displacement": 2.75e-4,
                    "max_von_mises": 1.234567e8, "energy_norm_error": None if i == 0 else 0.0345 / 2**i, "seconds": 1.5}
                   for i in range(4)],
        "accuracy": {"energy": 0.01, "stress": None, "probe": "", "reached": True, "missing": "",
                     "text": "1 % in the energy norm asked: reached, as estimated"},
        "warnings": ["patch 1: the sign of its Jacobian could not be certified", "a warning without a place"],
        "timings": {"model": 0.0157, "coupling and loads": 0.0132, "assembly": 0.8018, "solve": 0.3494,
                    "results": 0.0011, "output": 0.0329, "total": 1.2141},
        "parallel": {"processes": 1, "threads": 2}, "memory": {"peak_bytes": 66584576}}


def ring_report():
    markers = ring_markers()
    warnings = [{"text": "patch 1: the sign of its Jacobian could not be certified", "patch": 1, "point": None}]
    scene = ring().data(
        supports=[{"name": "foot", "kind": "displacement", "reaction": [0, 200, -50]},
                  {"name": "support 2 (back)", "kind": "symmetry", "reaction": [0, 0, 0]}],
        loads=[{"name": "head", "kind": "force", "total": [0, -200, 50]},
               {"name": "load 2 (cover)", "kind": "pressure", "total": [0, 0, -10]}],
        markers=markers, warnings=warnings)
    return {"kind": "report", "program": "isopatch 0.1.0", "title": "quarter ring <of two patches>", "study": STUDY,
            "summary": ring_summary(markers), "plots": [{"title": "Residual", "svg": PLOT}], "scene": scene}


def ring_compare():
    scene = ring()
    traction = []
    for patch in scene.patches:
        n0, n1, n2 = patch["sizes"]
        for k in range(n2):
            for j in range(n1):
                for i in range(n0):
                    # The second side of the interface alone has values.
                    on = patch["name"] == "1" and i == 0
                    traction.extend([3e7 * (j + 1) / n1, -2e7, 5e6 * k] if on else [NAN] * 3)
    point = ring_place(0.5, 1, 1)
    data = scene.data(traction=block(traction), markers=[
        {"name": "largest difference of the displacement", "kind": "probe", "patch": 0, "parameter": [0.5, 1, 1],
         "point": point, "displacement": ring_fields(point)[0], "von_mises": ring_fields(point)[1]}])
    data["fields"] = [*data["fields"], TRACTION]
    side = {"dofs": 3225, "dofs_free": 2985, "multipliers": 0, "method": "cholmod", "iterations": 1,
            "relative_residual": 1.9e-13, "matrix_nonzeros": 1147401, "factor_nonzeros": 691089, "memory_bytes": 15721000,
            "max_displacement": 5.771715819e-4, "max_von_mises": 338686942.97, "internal_energy": 0.57852999,
            "timings": {"coupling and loads": 0.005, "assembly": 0.7, "solve": 0.215, "results": 0.001}}
    summary = {"schema_version": 1, "title": "quarter ring", "elimination": side,
               "lagrange": {**side, "method": "mumps", "dofs": 5025, "multipliers": 900, "factor_nonzeros": 1395255},
               "difference": {"displacement": 1.7e-14, "internal_energy": 2.5e-14, "multipliers": 4e-14,
                              "allowed": 1e-9, "allowed_multipliers": 1e-8}, "agree": True, "warnings": []}
    return {"kind": "compare", "program": "isopatch 0.1.0", "title": "quarter ring", "study": STUDY, "summary": summary,
            "plots": [{"title": "Residuals", "svg": PLOT}], "scene": data}


def claim(suite, case, what, verdict, **more):
    return {"suite": suite, "case": case, "test": case.title().replace(" ", ""), "what": what, "verdict": verdict, **more}


def verification():
    """A verification with every kind of claim: held, failed, not run, reported, an order of convergence."""
    numbers = {"unit": "m", "kind": "closed form", "source": "Hooke", "reference": 2.0, "value": 2.0001, "difference": 5e-5,
               "comparison": "relative", "least": None, "allowed": 1e-3, "reason": "", "study": {"file": "bar.toml", "set": ["a.b=1"]}}
    order = {"unit": "", "kind": "manufactured", "source": "p + 1", "reference": 3.0, "value": 3.02, "difference": 0.02,
             "comparison": "absolute", "least": None, "allowed": 0.15, "reason": "meshes that are affordable", "study": None,
             "convergence": {"sizes": [0.5, 0.25], "errors": [8e-3, 1e-3], "orders": [3.0]}}
    claims = [claim("closed_forms", "bar", "u at the end", "holds", **numbers),
              claim("closed_forms", "bar", "u at the joint", "FAILS", **{**numbers, "value": 3.0, "difference": 0.5}),
              claim("manufactured", "one patch", "order of displacement in L2, p = 2", "holds", **order),
              claim("solvers", "cg", "iterations", "holds", **{**numbers, "unit": "", "reference": 14.0, "value": 7.0, "difference": 0.0,
                                                            "comparison": "at most", "least": 1.0, "allowed": 0.0}),
              claim("seed_studies", "terrific", "largest displacement", "reported",
                    **{**numbers, "allowed": None, "why": "the paper prints <another> load"}),
              claim("seed_studies", "chair stand", "needs chair_stand.xml; set ISOPATCH_DATA", "not run")]
    keys = {"holds": "hold", "FAILS": "fail", "not run": "not_run", "reported": "reported"}
    count = lambda some: {key: sum(c["verdict"] == verdict for c in some) for verdict, key in keys.items()}
    suites = [{"name": name, **count([c for c in claims if c["suite"] == name])}
              for name in dict.fromkeys(c["suite"] for c in claims)]
    summary = {"schema_version": 1, "program": {"name": "isopatch", "version": "0.1.0"}, "level": "quick", "seconds": 12.3,
               **count(claims), "suites": suites, "claims": claims}
    return {"kind": "verification", "program": "isopatch 0.1.0", "title": "Verification", "study": "", "summary": summary,
            "plots": [{"title": "", "section": "manufactured", "svg": PLOT}], "scene": None}


def ring_parameterization():
    patch = lambda name, **more: {"name": name, "certified": True, "determinant_bound": 5e-5, "min_scaled_jacobian": 0.81,
                                  "mean_scaled_jacobian": 0.93, "histogram": [0] * 8 + [8, 24], "volume": 1e-4,
                                  "control_points": 343, "optimized": False, **more}
    return {"certified": False, "size": 0.1, "tolerance": 1e-5, "largest_deviation": 8.6e-6, "largest_deviation_at": "a:face 3",
            "largest_gap": 0, "patches": [patch("a"), patch("b", certified=False, determinant_bound=2.5e-5)],
            "faces": [{"name": "a:face 1 = b:face 5", "sides": ["0:east", "1:west"], "deviation": 1e-6, "gap": 2e-8},
                      {"name": "a:face 3", "sides": ["0:west"], "deviation": 8.6e-6, "gap": 0}],
            "rounds": 2, "evaluations": 0, "seconds": 0.1}


def ring_model():
    scene = ring().data()
    scene["fields"] = [JACOBIAN]
    del scene["displacement"], scene["von_mises"], scene["stress"]
    return {"kind": "model", "program": "isopatch 0.1.0", "title": "quarter ring", "study": None,
            "summary": {"model": ring_summary(ring_markers())["model"], "parameterization": ring_parameterization()},
            "plots": [], "scene": scene}


def faults():
    """Two faces of a cube of which one crosses itself, an edge, a vertex."""
    square = lambda z, order: block(c for i in order for c in [(0, 0, z), (0.1, 0, z), (0.1, 0.1, z), (0, 0.1, z)][i])
    faces = [{"name": "part: face 0", "remark": "", "is_faulty": False, "points": square(0, [0, 1, 2, 3]),
              "triangles": [0, 1, 2, 0, 2, 3]},
             {"name": "part: face 1", "remark": "outline <crosses> itself", "is_faulty": True,
              "points": square(0.1, [0, 1, 3, 2]), "triangles": [0, 1, 2, 0, 2, 3]},
             {"name": "part: face 2", "remark": "", "is_faulty": True, "points": "", "triangles": []}]
    lines = [{"name": "", "is_faulty": False, "points": square(0, [0, 1, 2, 3])},
             {"name": "part: edge 3", "is_faulty": True, "points": square(0.1, [0, 1])},
             {"name": "part: edge 4", "is_faulty": True, "points": square(0.1, [2, 2])}]
    scene = {"length": {"unit": "mm", "factor": 1e3}, "box": {"min": [0, 0, 0], "max": [0.1, 0.1, 0.1]}, "faces": faces,
             "lines": lines, "places": [{"name": "crossing", "point": [0.05, 0.05, 0.1]}]}
    summary = {"message": "solid 'part', face 1: its outline <crosses> itself", "solids": [
        {"name": "part", "file": "part.off", "faces": 3, "edges": 12, "vertices": 8, "state": "closed"}]}
    return {"kind": "faults", "program": "isopatch 0.1.0", "title": "part", "study": STUDY, "summary": summary, "plots": [],
            "scene": None, "faults": scene}


def box_piece(name, low, high, **more):
    """A block between two corners: points of each face apart, edges as pairs of points."""
    corner = lambda i: [(low, high)[(i >> c) & 1][c] for c in range(3)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    points = [x for quad in quads for i in quad for x in corner(i)]
    triangles = [4 * q + k for q in range(6) for k in (0, 1, 2, 0, 2, 3)]
    edges = [block(corner(i) + corner(i | bit)) for i in range(8) for bit in (1, 2, 4) if not i & bit]
    return {"name": name, "body": "part", "file": "", "volume": math.prod(b - a for a, b in zip(low, high)), "is_faulty": False,
            "faces": ["face <0>"], "points": block(points), "triangles": triangles, "edges": edges, **more}


def blocks(failed=False):
    """An L of two parts, one of them twice as long, which meet in part of a side; three blocks of them."""
    long, short = box_piece("part 0 of part", (0, 0, 0), (0.2, 0.1, 0.1)), box_piece("part 1 of part", (0, 0.1, 0), (0.1, 0.2, 0.1))
    joint = {"piece": 0, "points": block([0.1, 0.1, 0, 0.1, 0.1, 0.1])}
    parts = {"name": "parts after the cuts", "pieces": [long, short], "lines": [joint]}
    corners = [((0, 0, 0), (0.1, 0.1, 0.1)), ((0.1, 0, 0), (0.2, 0.1, 0.1)), ((0, 0.1, 0), (0.1, 0.2, 0.1))]
    pieces = [box_piece(f"part#{i}", *ends, file=f"block_{i}.step") for i, ends in enumerate(corners)]
    body = {"name": "part", "volume": 3e-3, "block_volume": 3e-3 * (1 + 1e-9), "cuts": 1, "parts": 2, "t_joints": 1, "further_cuts": 1,
            "by_tetrahedra": False, "hexahedra": 3, "seconds": 0.25}
    stages = [parts, {"name": "blocks", "pieces": pieces, "lines": []}]
    if failed:
        body["error"] = "solid 'part': 1 of its parts could not be <cut>"
        long["is_faulty"] = True
        stages = [{**parts, "name": "blocks"}]
    scene = {"length": {"unit": "mm", "factor": 1e3}, "box": {"min": [0, 0, 0], "max": [0.2, 0.2, 0.1]}, "lines_name": "T-joints",
             "stages": stages, "faces": [], "places": []}
    return {"kind": "blocks", "program": "isopatch 0.1.0", "title": "part.step", "study": "", "summary": {"bodies": [body], "t_joints": ["face 4 of block 'part' meets <part#1>"] if failed else []},
            "plots": [], "scene": None, "faults": None, "blocks": scene}


def staged():
    """A report whose patches came of triangles: one stage where the pieces are, one where they are apart."""
    data, cut = ring_report(), blocks()["blocks"]
    cut["stages"][0] |= {"name": "triangles", "apart": 0, "shows_triangles": True}
    for piece in cut["stages"][0]["pieces"]:
        piece |= {"remark": "12 triangles", "volume": 0, "faces": []}
    data["summary"] = {**data["summary"], "stages": [
        {"name": "solid", "kept": True, "file": "stages/solids.h5", "made": "2026-11-30 10:28 UTC", "seconds": 3.3},
        {"name": "hexahedra", "kept": False, "file": "stages/blocks.h5", "made": "2026-11-30 10:29 UTC", "seconds": 5.4}]}
    return {**data, "blocks": cut}


def unmade():
    """Triangles of which no solid could be made."""
    data = staged()
    data["blocks"]["stages"] = data["blocks"]["stages"][:1]
    data["blocks"]["stages"][0]["pieces"][0]["is_faulty"] = True
    return {**data, "kind": "stages", "scene": None, "summary": {"error": "part.stl: 3 of <46> faces lie on nothing", "stages": []}}


def grid_fields(point):
    x, y, z = point
    return [0, 0, -1e-3 * x * x], 1e8 * abs(0.1 - z) * (1 + 10 * math.sin(20 * y) ** 2)


def grid_report(counts=(10, 6, 5), samples=9):
    """A box of many patches that all meet, `samples` points along each of their edges."""
    scene = Scene(grid_fields)
    step, n = 0.1, counts
    parameter = levels(0, 1, 2, (samples - 1) // 2)
    for c in range(n[2]):
        for b in range(n[1]):
            for a in range(n[0]):
                ends = [a == 0, a == n[0] - 1, b == 0, b == n[1] - 1, c == 0, c == n[2] - 1]
                faces = [("boundary" if end else "interface", [0] if s == 0 and end else [], [0] if s == 1 and end else [])
                         for s, end in enumerate(ends)]
                place = lambda u, v, w: [step * (a + u), step * (b + v), step * (c + w) + 0.02 * math.sin(4 * step * (a + u))]
                scene.add(str(len(scene.patches)), place, [parameter] * 3, (samples - 1) // 2, faces)
    data = scene.data(supports=[{"name": "wall", "kind": "displacement", "reaction": [0, 0, 1000]}],
                      loads=[{"name": "end", "kind": "force", "total": [0, 0, -1000]}])
    return {"kind": "report", "program": "isopatch 0.1.0", "title": f"{len(scene.patches)} patches", "study": "# many",
            "summary": {}, "plots": [], "scene": data}


def fill(data):
    """The page of the data: what the program makes of the template."""
    # JSON knows no NaN; those of the fields are in the blocks.
    text = json.dumps(data, allow_nan=False).replace("</", "<\\/")
    scripts = "\n".join(path.read_text() for path in [THREE, *sorted(WEB.glob("*.js"))])
    style = "\n".join(path.read_text() for path in sorted(WEB.glob("*.css")))
    page = (WEB / "page.html").read_text()
    for marker, value in [("<!--isopatch:title-->", html.escape(data["title"])),
                          ("/*isopatch:style*/", style), ("/*isopatch:scripts*/", scripts),
                          ("/*isopatch:data*/", text)]:
        before, after = page.split(marker)
        page = before + value + after
    return page


PAGES = {"report": ring_report, "compare": ring_compare, "model": ring_model, "verification": verification, "faults": faults,
         "blocks": blocks, "failure": lambda: blocks(failed=True), "staged": staged, "unmade": unmade,
         "grid": lambda: grid_report(samples=9)}


def write_page(name, folder):
    path = pathlib.Path(folder) / f"{name}.html"
    path.write_text(fill(PAGES[name]()))
    return path


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    for page_name in PAGES:
        print(write_page(page_name, sys.argv[1]))
