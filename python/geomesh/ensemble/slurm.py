# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes scripts for a Slurm array: each task runs some realisations, and after all have ended a last job collects the
results."""
import os
import shlex
import sys

from .store import write_whole

MOST_TASKS = 1000  # Slurm's MaxArraySize is 1001 by default


def write_scripts(study, directory, per_task):
    """Writes array.sbatch, collect.sbatch and submit.sh into directory/slurm; returns (submit.sh, number of tasks)."""
    per_task = per_task or -(-study.realisations // MOST_TASKS)
    tasks = -(-study.realisations // per_task)
    folder = os.path.join(os.path.abspath(directory), "slurm")
    call = "%s %s -o %s" % (_program(), shlex.quote(study.file), shlex.quote(os.path.abspath(directory)))
    array = [_head(study, folder, "%a"), "#SBATCH --array=1-%d" % tasks, "",
             "first=$(( (SLURM_ARRAY_TASK_ID - 1) * %d + 1 ))" % per_task, "last=$(( first + %d ))" % (per_task - 1),
             "[ $last -le %d ] || last=%d" % (study.realisations, study.realisations),
             'exec %s --jobs "${SLURM_CPUS_PER_TASK:-1}" --only "$first-$last"' % call, ""]
    collect = [_head(study, folder, "collect"), "", "exec %s --collect" % call, ""]
    submit = ["#!/bin/sh", "# Submits the array and, after it, the job that collects. Further arguments go to both (-p PARTITION).",
              "set -e", "cd %s" % shlex.quote(folder), 'job=$(sbatch --parsable "$@" array.sbatch)',
              'exec sbatch --dependency=afterany:"${job%%;*}" "$@" collect.sbatch', ""]
    for name, lines in (("array.sbatch", array), ("collect.sbatch", collect), ("submit.sh", submit)):
        write_whole(os.path.join(folder, name), "\n".join(lines))
    return os.path.join(folder, "submit.sh"), tasks


def _head(study, folder, log):
    name = "".join(c if c.isalnum() or c in "-_." else "_" for c in study.name)
    return "\n".join(["#!/bin/bash", "#SBATCH --job-name=%s" % name, "#SBATCH --cpus-per-task=1",
                      "#SBATCH --output=%s.log" % os.path.join(folder, log)])


def _program():
    """Returns the command that starts geomesh.ensemble: by the program geomesh if that was used here, else by this interpreter."""
    program = os.environ.get("GEOMESH_PROGRAM")
    if program:
        return shlex.quote(os.path.abspath(program)) + " ensemble"
    path = shlex.quote(os.pathsep.join(filter(None, sys.path)))
    return "env PYTHONPATH=%s %s -m geomesh.ensemble" % (path, shlex.quote(sys.executable))
