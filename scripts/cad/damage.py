"""Reads files that were damaged at random, from a seed."""

import random
import re
from concurrent.futures import ThreadPoolExecutor

from compare import relative, run
from expected import Case

SECONDS = 5  # that a file may take to be read
SOURCES = (
    ["step/" + n for n in ("cube_AP214", "bore_AP214", "hollow_box_AP214", "one_fillet_AP203", "cone_AP203", "torus_AP242", "spline_quadratic_AP203",
                           "glued_blocks_AP214", "frustum_AP214", "half_sphere_AP214", "ellipse_20_2_AP242")]
    + ["written/" + n for n in ("assembly_three_places_AP214", "void", "colour_both", "unit_inch", "shells_two", "faceted")]
    + ["brep/" + n for n in ("cube", "bore", "hollow_box", "cone", "torus", "spline_quadratic", "glued_blocks", "half_sphere")]
    + ["iges/" + n for n in ("cube_solids", "bore_faces", "cone_solids", "torus_faces", "spline_quadratic_solids")]
)


def byte_changed(text, r):
    i = r.randrange(len(text))
    return text[:i] + bytes([r.randrange(256)]) + text[i + 1 :]


def digit_changed(text, r):
    places = [m.start() for m in re.finditer(rb"[0-9]", text)]
    i = r.choice(places)
    return text[:i] + str(r.randrange(10)).encode() + text[i + 1 :]


def sign_changed(text, r):
    places = [m.start() for m in re.finditer(rb"[-+.,() ]", text)]
    i = r.choice(places)
    return text[:i] + r.choice([b"-", b"+", b".", b",", b"(", b")", b" ", b""]) + text[i + 1 :]


def line_removed(text, r):
    lines = text.split(b"\n")
    del lines[r.randrange(len(lines))]
    return b"\n".join(lines)


def line_doubled(text, r):
    lines = text.split(b"\n")
    i = r.randrange(len(lines))
    lines.insert(r.randrange(len(lines)) if r.random() < 0.5 else i, lines[i])
    return b"\n".join(lines)


def tokens_swapped(text, r, pattern=rb"#?[-+]?[0-9][0-9.Ee+-]*"):
    found = list(re.finditer(pattern, text))
    if len(found) < 2:
        return byte_changed(text, r)
    a, b = sorted(r.sample(found, 2), key=lambda m: m.start())
    return text[: a.start()] + b.group() + text[a.end() : b.start()] + a.group() + text[b.end() :]


def references_swapped(text, r):
    return tokens_swapped(text, r, rb"#[0-9]+")


def number_replaced(text, r):
    found = list(re.finditer(rb"[-+]?[0-9]+\.?[0-9]*([Ee][-+]?[0-9]+)?", text))
    m = r.choice(found)
    new = r.choice([b"0", b"0.", b"-1.", b"1.E300", b"1.E-300", b"2147483648", b"99999999999999999999", b"nan", b"1.E9", b"-0."])
    return text[: m.start()] + new + text[m.end() :]


def cut_off(text, r):
    return text[: r.randrange(len(text))]


def piece_removed(text, r):
    i = r.randrange(len(text))
    return text[:i] + text[i + r.randrange(1, 200) :]


def word_changed(text, r):
    words = [m for m in re.finditer(rb"[A-Z_]{4,}", text)]
    if len(words) < 2:
        return byte_changed(text, r)
    a, b = r.sample(words, 2)
    return text[: a.start()] + b.group() + text[a.end() :]


WAYS = [byte_changed, digit_changed, sign_changed, line_removed, line_doubled, tokens_swapped, references_swapped,
        number_replaced, cut_off, piece_removed, word_changed]


def damaged(text, seed, number):
    """The damage of this number: the same for the same text."""
    r = random.Random(f"{seed} {number}")
    way = r.choice(WAYS)
    result = way(text, r)
    if r.random() < 0.2:
        result = r.choice(WAYS)(result or b" ", r)
    return way.__name__, result


def verdict(whole, code, answer, said):
    """What became of a damaged file: a word and, where something is wrong, why."""
    if code is None:
        return "HUNG", ""
    if code < 0:
        return "CRASHED", f"signal {-code}"
    if code not in (0, 2, 3):
        return "ODD CODE", f"exit code {code}: {said.strip()[:200]}"
    if "could not read the file" in said:
        return "stopped", ""
    if code:
        return ("refused", "") if said.strip() else ("SILENT", "refused without a word")
    if answer is None:
        return "NO ANSWER", said[:200]
    given = [w for w in answer["warnings"] if not w.startswith("OpenCASCADE files do not state")]
    findings = any(s["stage"] == "repair" for s in answer["solids"])
    found, right = sorted(s["volume"] for s in answer["solids"]), whole
    if len(found) == len(right) and all(relative(f, v) <= 1e-6 for f, v in zip(found, right)):
        return "same", ""
    if given or findings:
        return "warned", ""
    return "WRONG", f"volumes {[f'{v:.7g}' for v in found]}, undamaged {[f'{v:.7g}' for v in right]}"


def read_damaged(options, converter):
    """Makes and reads the damages; prints those that went wrong and counts. Returns the exit code."""
    from made import make_files
    from main import write_by_hand

    folder = options.folder
    wanted = [s for s in SOURCES if not options.only or any(p in s for p in options.only.split(","))]
    cases = make_files(folder, converter, lambda n: n.rsplit(".", 1)[0] in wanted)
    cases += write_by_hand(folder, lambda n: n.rsplit(".", 1)[0] in wanted)
    sound = {}
    for case in cases:
        _, answer, _ = run(options.program, folder / case.name, case.options)
        sound[case.name] = sorted(s["volume"] for s in answer["solids"])
    (folder / "damaged").mkdir(exist_ok=True)

    def read(number):
        case: Case = cases[number % len(cases)]
        way, text = damaged((folder / case.name).read_bytes(), options.seed, number)
        path = folder / "damaged" / f"{number}.{case.name.rsplit('.', 1)[1]}"
        path.write_bytes(text)
        code, answer, said = run(options.program, path, [*case.options, "--cad-time-limit", str(SECONDS)], 20 * SECONDS)
        word, why = verdict(sound[case.name], code, answer, said)
        if not (options.keep and word.isupper()):
            path.unlink()
        return number, case.name, way, word, why

    counts, bad = {}, 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, name, way, word, why in pool.map(read, range(options.first, options.first + options.damages)):
            counts[word] = counts.get(word, 0) + 1
            if word.isupper():
                bad += 1
                print(f"{number:>6} {name:<36} {way:<20} {word}: {why}", flush=True)
    print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())))
    print(f"{options.damages - bad} passed, {bad} failed")
    return 1 if bad else 0
