#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes random whole models and has each checked by `geomesh check`; what is not in order is listed and kept.

    tests/fuzz/run_random_models.py --count 1000 --seed 1 --folder build/random     all that fails stays in the folder
    tests/fuzz/run_random_models.py --count 1000 --as-default                       with `mesh: {size: L}`, what most projects ask for
    tests/fuzz/run_random_models.py --count 10000 --light           with fewer triangles and larger sizes: a second each
    tests/fuzz/run_random_models.py --seed 4711 --count 1 --folder here --keep      one of them
    tests/fuzz/run_random_models.py --count 10000 --light --jobs 4  four at a time, each on one thread

    tests/fuzz/run_random_models.py --count 1000 --light --options  with random keys of the project file

Outcomes: `passes`, `refused` (status 3 or 4 with a message), `wrong` (the check finds faults), `bug` (status 1, a signal, or a refusal
without a message), `slow` (beyond --limit seconds of CPU), `asked` (the same, but the sizes ask for so many elements that it takes as long,
and the estimate told), `declined` (with --options: a combination that the program tells as a mistake). The exit status is 1 where anything is wrong, a bug or slow.
What is not in order is told at once, in the order of the seeds; every hundred models a line tells the counts so far and the CPU time.
"""
import argparse
import concurrent.futures
import json
import os
import re
import resource
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from random_models import RandomModel  # noqa: E402
from random_options import RandomOptions  # noqa: E402

FINE = ("passes", "refused", "declined", "asked")
LEAST_PACE = 2000  # elements a CPU second: who asks for more than the limit allows at that was told so by the estimate


def estimated(printed):
    """The most elements that a run said were to come."""
    return max([int(n) for n in re.findall(r"(\d+) elements (?:or more )?to come", printed)], default=0)


def run(program, arguments, limit):
    """Exit status (negative: a signal) and what was printed. A run that waits for what never comes uses no CPU: ten times the limit ends it."""
    with subprocess.Popen([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace") as process:
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (limit, limit + 5))
        try:
            printed = process.communicate(timeout=10 * limit)[0]
        except subprocess.TimeoutExpired:
            process.kill()
            return 1, "no end after %d s: %s" % (10 * limit, process.communicate()[0])
    return process.returncode, printed


def outcome_of(seed, folder, program, limit, as_default=False, light=False, options=False):
    return checked_outcome((RandomOptions if options else RandomModel)(seed, as_default, light).write(folder), folder, program, limit, options)


def checked_outcome(project, folder, program, limit, options=False):
    """The outcome of a project in its folder, and why."""
    status, printed = run(program, [project, "--verbose", "--threads", "1"], limit)
    if status in (-24, -9):  # SIGXCPU, or the harder bound behind it
        outcome = "asked" if estimated(printed) > LEAST_PACE * limit else "slow"
        return outcome, "meshing took more than %d s; the estimate was %d elements" % (limit, estimated(printed))
    if status in (3, 4) and "error: " in printed:
        return "refused", printed[printed.index("error: "):][:300]
    if status == 2 and options and "error: " in printed:
        return "declined", printed[printed.index("error: "):][:300]
    if status != 0:
        return "bug", "status %d: %s" % (status, printed[-300:])
    report = os.path.join(folder, "check.json")
    mesh = os.path.join(folder, "out", "model.vtu")
    if not os.path.exists(mesh):
        mesh = os.path.join(folder, "out", "model.pvtu")
    status, printed = run(program, ["check", mesh, "--project", project, "--report", report], limit)
    if status == 0:
        return "passes", ""
    if status == 3 and os.path.exists(report):
        with open(report) as file:
            return "wrong", "; ".join("%s: %s" % (fault["id"], fault["what"]) for fault in json.load(file)["faults"])[:600]
    return "bug", "check, status %d: %s" % (status, printed[-300:])


def in_order(pool, work, items, ahead):
    """Each item with its result, in the items' order, no more than `ahead` of them begun beyond the one given."""
    waiting = []
    for item in items:
        waiting.append((item, pool.submit(work, item)))
        if len(waiting) >= ahead:
            item, result = waiting.pop(0)
            yield item, result.result()
    for item, result in waiting:
        yield item, result.result()


def tally(first, last, counts):
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return "seeds %d to %d: %s; %.0f s of CPU" % (first, last, ", ".join("%d %s" % (n, outcome) for outcome, n in sorted(counts.items())), used.ru_utime + used.ru_stime)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--seed", type=int, default=1, help="of the first model")
    options.add_argument("--folder", default="random-models")
    options.add_argument("--program", default=os.path.join(HERE, "..", "..", "build", "release", "bin", "geomesh"))
    options.add_argument("--limit", type=int, default=120, help="CPU seconds of one run")
    options.add_argument("--keep", action="store_true", help="keep models that pass, too")
    options.add_argument("--as-default", action="store_true", help="with `mesh: {size: L}` in place of the modes")
    options.add_argument("--light", action="store_true", help="with fewer triangles and larger sizes: many more in the same time")
    options.add_argument("--options", action="store_true", help="with random keys of the project file (random_options.py)")
    options.add_argument("--jobs", type=int, default=1, help="models at a time")
    options = options.parse_args()
    counts = {}
    last = options.seed + options.count - 1

    def one(seed):
        return outcome_of(seed, os.path.join(options.folder, str(seed)), options.program, options.limit, options.as_default, options.light, options.options)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for seed, (outcome, why) in in_order(pool, one, range(options.seed, last + 1), 2 * options.jobs):
            counts[outcome] = counts.get(outcome, 0) + 1
            if outcome != "passes":
                print("%d %s: %s" % (seed, outcome, why.replace("\n", " ")), flush=True)
            if outcome in FINE and not options.keep:
                shutil.rmtree(os.path.join(options.folder, str(seed)))
            if seed == last or (seed + 1 - options.seed) % 100 == 0:
                print(tally(options.seed, seed, counts), flush=True)
    return 1 if any(outcome not in FINE for outcome in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
