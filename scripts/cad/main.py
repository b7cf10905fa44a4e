"""Makes CAD files, reads them with isopatch and compares; see README.md."""

import argparse
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = ["TKSTEP", "TKIGES", "TKXSBase", "TKTopAlgo", "TKBRep", "TKernel", "TKMath", "TKG3d"]


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/cad_files", description=__doc__)
    parser.add_argument("--list", action="store_true", help="name the files and stop")
    parser.add_argument("--only", default="", metavar="PART", help="only files whose name contains this; several by commas")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/app/isopatch", help="default: %(default)s")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/cad_files", help="where the files go")
    parser.add_argument("--jobs", type=int, default=2, help="files read at a time")
    parser.add_argument("--damages", type=int, default=0, metavar="N", help="instead: read N damaged files")
    parser.add_argument("--seed", type=int, default=1, help="of the damages")
    parser.add_argument("--keep", action="store_true", help="leave damaged files that went wrong in FOLDER/damaged")
    parser.add_argument("--first", type=int, default=0, help="number of the first damage")
    return parser.parse_args()


def converter(folder):
    """Compiles exchange.cpp where it is newer than its program."""
    program, source = folder / "exchange", HERE / "exchange.cpp"
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        command = ["g++", "-std=c++20", "-w", "-isystem", "/usr/include/opencascade", str(source), "-o", str(program)]
        subprocess.run(command + [f"-l{name}" for name in LIBRARIES], check=True)
    return program


def write_by_hand(folder, wanted):
    """The files of written.py; returns their cases."""
    from written import CASES

    cases = [case for case in CASES if wanted(case.name)]
    (folder / "written").mkdir(parents=True, exist_ok=True)
    for case in cases:
        content = case.make() if callable(case.make) else case.make
        (folder / case.name).write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
    return cases


def compare_all(cases, options):
    """Prints what is wrong; returns how many files are."""
    from compare import problems_of, run

    def check(case):
        return case, problems_of(case, *run(options.program, options.folder / case.name, case.options))

    failed = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for case, problems in pool.map(check, cases):
            failed += bool(problems)
            for i, problem in enumerate(problems[:4]):
                print(f"{case.name if i == 0 else '':<44} {problem}", flush=True)
            if len(problems) > 4:
                print(f"{'':<44} and {len(problems) - 4} more")
    print(f"{len(cases) - failed} passed, {failed} failed")
    return failed


def main():
    options = arguments()
    parts = [part for part in options.only.split(",") if part]

    def wanted(name):
        return not parts or any(part in name for part in parts)

    options.folder.mkdir(parents=True, exist_ok=True)
    if options.damages:
        from damage import read_damaged

        return read_damaged(options, converter(options.folder))
    from made import make_files

    cases = make_files(options.folder, converter(options.folder), wanted) + write_by_hand(options.folder, wanted)
    if options.list:
        print("\n".join(case.name for case in cases))
        return 0
    return 1 if compare_all(cases, options) else 0


if __name__ == "__main__":
    sys.exit(main())
