# SPDX-License-Identifier: GPL-3.0-or-later
"""Random whole models with random keys of the project file (tests/fuzz/random_options.py) are meshed and checked: 12 from
seed 2050 in every run of the tests, 300 by night.

    GEOMESH_RANDOM_OPTIONS=1000 GEOMESH_RANDOM_SEED=5000 ctest ... -R app.random_options     another number, other seeds
"""
import os
import sys

from geomesh_program import NIGHTLY, PROGRAM, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from random_options import RandomOptions  # noqa: E402
from run_random_models import outcome_of  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_OPTIONS", "300" if NIGHTLY else "12"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "2050"))


def may_take_long(seed):
    """Whether the project asks for more than its sizes say: all input triangles, Delaunay by added points, the best shapes."""
    mesh = RandomOptions(seed, light=True).project["mesh"]
    return mesh.get("mode") == "conforming" or mesh.get("honour") == "exact" or mesh.get("quality") == "best" or "quality_measure" in mesh


class RandomOptionsTest(ProgramTest):
    def test_every_project_is_meshed_and_passes_or_is_refused_with_a_reason(self):
        outcomes = {}
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                outcome, why = outcome_of(seed, self.path(str(seed)), PROGRAM, 120, light=True, options=True)
                outcomes.setdefault(outcome, []).append(seed)
                if outcome == "slow" and may_take_long(seed):
                    continue
                self.assertIn(outcome, ("passes", "refused", "declined", "asked"), why)
        self.assertGreater(len(outcomes.get("passes", [])), COUNT // 2, outcomes)


if __name__ == "__main__":
    main()
