# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of ensembles."""
import argparse
import os
import sys
import time

from ..core.errors import Error, UsageError
from . import collect, slurm
from .pool import Pool
from .store import Store
from .study import read_study

_DONE, _BUG, _USAGE, _CANNOT = 0, 1, 2, 4
_INTERRUPTED = 130


def _arguments(words):
    parser = argparse.ArgumentParser(prog="geomesh ensemble", description="Realisations of a project with uncertain surfaces.")
    parser.add_argument("study", metavar="STUDY.yaml")
    parser.add_argument("-o", dest="directory", metavar="DIR")
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("--only", default="")
    parser.add_argument("--missing", type=int, default=0, metavar="N")
    parser.add_argument("--collect", action="store_true")
    parser.add_argument("--slurm", action="store_true")
    parser.add_argument("--per-task", type=int, default=0)
    parser.add_argument("--retry-failed", action="store_true")
    parser.add_argument("--quiet", action="store_true")
    return parser.parse_args(words)


def indices_of(text, realisations):
    """Returns the numbers of realisations in a text such as "17", "1-100" or "3,5,9-12"."""
    found = []
    for part in text.split(","):
        first, dash, last = part.strip().partition("-")
        try:
            low, high = int(first), int(last if dash else first)
        except ValueError:
            raise UsageError("--only %s: an index, or a range such as 1-100, was expected" % text) from None
        if not 1 <= low <= high <= realisations:
            raise UsageError("--only %s: realisations are counted from 1 to %d" % (text, realisations))
        found += range(low, high + 1)
    return sorted(set(found))


class _Progress:
    def __init__(self, total, quiet):
        self._total, self._quiet, self._started, self._ended, self.failed = total, quiet, time.monotonic(), 0, 0
        self._told = 0.0

    def __call__(self, index, status):
        self._ended += 1
        self.failed += status == "failed"
        now = time.monotonic()
        if self._quiet or (now - self._told < 1 and self._ended < self._total):
            return
        self._told = now
        print("%d of %d realisations, %d failed, %.0f s" % (self._ended, self._total, self.failed, now - self._started),
              file=sys.stderr, flush=True)


def _run(study, store, given):
    asked = indices_of(given.only, study.realisations) if given.only else list(range(1, study.realisations + 1))
    if given.retry_failed:
        for index in asked:
            store.drop_failed(index)
    left = store.missing(asked)
    if left != asked and not given.quiet:
        print("%d of %d realisations are there already" % (len(asked) - len(left), len(asked)), file=sys.stderr)
    if left:
        jobs = given.jobs or len(os.sched_getaffinity(0))
        Pool(study, store, jobs, _Progress(len(left), given.quiet)).run(left)


def _collect(study, store, quiet):
    results = collect.Results(study, store)
    files, with_hdf5 = collect.write_all(results, store.directory)
    for r in results.failed[:5]:
        print("warning: realisation %d failed (%s): %s" % (r["index"], r["failure"]["kind"], r["failure"]["message"]), file=sys.stderr)
    if len(results.failed) > 5:
        print("warning: and %d more; table.csv lists them" % (len(results.failed) - 5), file=sys.stderr)
    if not with_hdf5:
        print("warning: results.h5 is left out: the Python package h5py is not installed", file=sys.stderr)
    if not quiet:
        _tell(results, store.directory, files)
    return _CANNOT if results.failed and not results.done else _DONE


def _tell(results, directory, files):
    cpu = sum(r["cpu_s"] for r in results.records)
    print("%d realisations done, %d failed, %d missing; %.2f CPU seconds each" %
          (len(results.done), len(results.failed), len(results.missing), cpu / max(len(results.records), 1)))
    for row in collect.statistics(results):
        print("    %-30s P10 %.5g  P50 %.5g  P90 %.5g" % (row[0], *row[3:6]))
    for name in files:
        print("wrote " + os.path.join(directory, name))


def _list_missing(study, store, per_line):
    """Prints ranges of realisations for the option --only, one per line, for GNU parallel."""
    left = store.missing(range(1, study.realisations + 1))
    for start in range(0, len(left), per_line):
        print(",".join(map(str, left[start:start + per_line])))


def run(words):
    given = _arguments(words)
    study = read_study(os.path.abspath(given.study))
    store = Store(os.path.abspath(given.directory or study.directory), study.digest)
    if given.missing:
        _list_missing(study, store, given.missing)
    elif given.slurm:
        script, tasks = slurm.write_scripts(study, store.directory, given.per_task)
        print("wrote the scripts of %d tasks; submit them with: sh %s" % (tasks, script))
    else:
        if not given.collect:
            _run(study, store, given)
        if not given.only:
            return _collect(study, store, given.quiet)
    return _DONE


def main(words=None):
    """The exit status."""
    try:
        return run(sys.argv[1:] if words is None else words)
    except KeyboardInterrupt:
        print("interrupted: what was complete is kept, and the same command continues from there", file=sys.stderr)
        return _INTERRUPTED
    except UsageError as error:
        print("error: %s" % error, file=sys.stderr)
        return _USAGE
    except Error as error:
        print("error: %s" % error, file=sys.stderr)
        return _BUG
    except OSError as error:
        print("error: %s" % error, file=sys.stderr)
        return _USAGE


if __name__ == "__main__":
    sys.exit(main())
