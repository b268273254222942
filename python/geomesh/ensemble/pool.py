# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs realisations on the cores of this machine: persistent processes, each with one realisation at a time. If a
process dies (out of memory, a crash), its realisation has failed, and another process continues with the rest.
"""
import os
import selectors
import signal
import subprocess
import sys

from ..core.errors import Error
from .realise import Realiser, write_input


class Pool:
    """Runs realisations; `told(index, status)` is called for each one that ended."""

    def __init__(self, study, store, jobs, told):
        self._study, self._store, self._jobs, self._told = study, store, jobs, told
        self._left, self._busy = [], {}
        self._selector = selectors.DefaultSelector()

    def run(self, indices):
        self._left = list(reversed(indices))
        try:
            for _ in range(min(self._jobs, len(indices))):
                self._start()
            while self._busy:
                for key, _ in self._selector.select():
                    self._answered(key.data)
        finally:
            self._end_all()

    def _start(self):
        words = [sys.executable, "-m", __package__ + ".worker", self._study.file, self._store.directory, self._study.digest]
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", PYTHONPATH=os.pathsep.join(filter(None, sys.path)))
        process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1, env=environment,
                                   start_new_session=False)
        self._selector.register(process.stdout, selectors.EVENT_READ, process)
        self._busy[process] = None
        self._give(process)

    def _give(self, process):
        """Sends the next realisation to a worker process, or ends the process if none is left."""
        if not self._left:
            self._retire(process)
            return
        self._busy[process] = index = self._left.pop()
        try:
            process.stdin.write("%d\n" % index)
        except BrokenPipeError:
            pass  # the process died; _answered() handles the end of its output

    def _answered(self, process):
        line = process.stdout.readline()
        if line.endswith("\n"):
            index, status = line.split()
            self._told(int(index), status)
            self._give(process)
            return
        index = self._busy[process]
        self._retire(process)
        self._record_death(index, process.returncode)
        if self._left:
            self._start()

    def _retire(self, process):
        self._selector.unregister(process.stdout)
        del self._busy[process]
        try:
            process.stdin.close()
        except BrokenPipeError:
            pass
        process.stdout.close()
        process.wait()

    def _record_death(self, index, code):
        reason = "signal %s" % signal.Signals(-code).name if code < 0 else "exit status %d" % code
        record = {"index": index, "seed": self._study.seed, "study": self._study.digest, "drawn": {}, "status": "failed",
                  "failure": {"kind": "crash", "message": "the process ended with " + reason}, "wall_s": 0.0, "cpu_s": 0.0}
        try:
            drawn = Realiser(self._study).draw(index)
            record["drawn"] = drawn.values
            write_input(self._study, drawn, self._store.failure_folder(index))
        except Error:
            pass  # there is no input to keep if its random values could not be drawn
        self._store.put(record)
        self._told(index, "failed")

    def _end_all(self):
        for process in list(self._busy):
            process.terminate()
            self._retire(process)
