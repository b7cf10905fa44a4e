"""What a measurement was made with: the machine and the state of the tree."""

import datetime
import os
import pathlib
import re
import subprocess


def _first_match(path, pattern):
    try:
        found = re.search(pattern, pathlib.Path(path).read_text(), re.MULTILINE)
    except OSError:
        return None
    return found[1].strip() if found else None


def _caches():
    """{"L1d": "32K", "L2": ..., "L3": ...} of the first core, as the kernel says."""
    caches = {}
    for index in sorted(pathlib.Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        level, kind, size = ((index / name).read_text().strip() for name in ("level", "type", "size"))
        caches["L" + level + {"Data": "d", "Instruction": "i"}.get(kind, "")] = size
    return caches


def cores():
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0))


def describe():
    """CPU, cores, caches, memory in bytes. No name of the host: records are published."""
    kilobytes = _first_match("/proc/meminfo", r"^MemTotal:\s*(\d+) kB")
    return {
        "cpu": _first_match("/proc/cpuinfo", r"^model name\s*:(.*)$") or os.uname().machine,
        "cores": cores(),
        "caches": _caches(),
        "memory_bytes": int(kilobytes) * 1024 if kilobytes else None,
        "system": _first_match("/etc/os-release", r'^PRETTY_NAME="?([^"\n]*)') or os.uname().sysname,
    }


def memory_for_a_run():
    """Bytes that one run may take, or None: one that wants more is to fail and not to stop the machine."""
    kilobytes = _first_match("/proc/meminfo", r"^MemAvailable:\s*(\d+) kB")
    return int(0.9 * 1024 * int(kilobytes)) if kilobytes else None


def slug(machine):
    """A file name for a machine: "intel-xeon-2-50ghz-2-cores"."""
    text = re.sub(r"\((r|tm|c)\)|\b(cpu|processor)\b", " ", machine["cpu"].lower())
    return "-".join(re.findall(r"[a-z0-9]+", text) + [str(machine["cores"]), "cores"])


def commit(root):
    """Short hash of the tree's commit, with "+" if files differ from it; None without git."""
    def git(*arguments):
        return subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, text=True, check=True).stdout
    try:
        return git("rev-parse", "--short", "HEAD").strip() + ("+" if git("status", "--porcelain", "-uno") else "")
    except (OSError, subprocess.CalledProcessError):
        return None


def version(program):
    """"0.1.0" of an isopatch program."""
    said = subprocess.run([str(program), "--version"], capture_output=True, text=True, check=True).stdout
    return said.split()[1]  # "isopatch 0.1.0", then other lines


def provenance(root, program):
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "version": version(program),
        "commit": commit(root),
        "machine": describe(),
        "load_average": round(os.getloadavg()[0], 1),  # before the measurement: what others did
    }


def title(record):
    """Lines that name what a record was made with."""
    made_with, commit_name = record["machine"], record["commit"] or "unknown"
    lines = [f"isopatch {record['version']}, commit {commit_name}, {record['date']}",
             f"{made_with['cpu']}, {made_with['cores']} cores, caches "
             + ", ".join(f"{name} {size}" for name, size in made_with["caches"].items())
             + f", {(made_with['memory_bytes'] or 0) / 2**30:.0f} GiB, {made_with['system']}"]
    lines += [f"{made_with['compiler']}; {made_with['blas']}"] if "blas" in made_with else []
    if record["load_average"] > 0.3:
        lines += [f"Load average {record['load_average']:g} before the measurement: others used the machine, so figures "
                  "of more than", "one thread and of whole runs are worse than they would be."]
    return lines + [""]
