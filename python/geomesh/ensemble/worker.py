# SPDX-License-Identifier: GPL-3.0-or-later
"""A process of the pool: reads indices from its standard input, one per line, and prints one line when a result is
stored.

It ends when its input does, so that it does not outlive a driver that was killed.
"""
import os
import signal
import sys

from .realise import Realiser, write_input
from .store import Store
from .study import read_study


def run_one(study, realiser, store, index):
    """Stores the result of one realisation, and the input if it failed."""
    record, drawn = realiser.result(index)
    if record["status"] == "failed" and drawn is not None:
        write_input(study, drawn, store.failure_folder(index))
    store.put(record)
    return record["status"]


def main(study_file, directory, digest):
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that started this one handles Ctrl-C
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what libraries print must not be mixed with this process' own lines
    study = read_study(study_file)
    realiser, store = Realiser(study), Store(directory, digest)
    for line in sys.stdin:
        index = int(line)
        answers.write("%d %s\n" % (index, run_one(study, realiser, store, index)))
        answers.flush()


if __name__ == "__main__":
    main(*sys.argv[1:4])
