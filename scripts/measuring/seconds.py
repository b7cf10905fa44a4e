"""What a program took: by the clock, and of the processor, which other work on the machine lengthens less."""

import os
import resource
import subprocess
import time
from typing import NamedTuple


class Seconds(NamedTuple):
    clock: float
    processor: float  # of all threads

    def plus(self, other):
        return Seconds(self.clock + other.clock, self.processor + other.processor)

    def minus(self, other):
        return Seconds(self.clock - other.clock, self.processor - other.processor)

    def share(self, part):
        return Seconds(part * self.clock, part * self.processor)


def of_all(several):
    total = Seconds(0.0, 0.0)
    for one in several:
        total = total.plus(one)
    return total


def _of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measured(call):
    """(what call() returns, Seconds): programs that it starts and waits for. One at a time: all children count."""
    clock, processor = time.monotonic(), _of_children()
    result = call()
    return result, Seconds(time.monotonic() - clock, _of_children() - processor)


def of_program(line, folder, *, threads, timeout=None, memory=None):
    """Seconds of a program that says nothing. memory: bytes that it may have.

    Raises subprocess.TimeoutExpired, and CalledProcessError where it fails.
    """
    settings = dict(os.environ, OMP_NUM_THREADS=str(threads))
    limit = (lambda: resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))) if memory else None
    return measured(lambda: subprocess.run(
        line, cwd=folder, env=settings, check=True, timeout=timeout, stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit))[1]
