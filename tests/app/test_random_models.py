# SPDX-License-Identifier: GPL-3.0-or-later
"""Random whole models (tests/fuzz/random_models.py) are meshed and checked: six from seed 1 in every run of the tests, 100 by night. Models
that failed once are in tests/corpus/models.

    GEOMESH_RANDOM_MODELS=1000 GEOMESH_RANDOM_SEED=5000 ctest ... -R app.random_models     another number, other seeds
"""
import os
import sys

from geomesh_program import NIGHTLY, PROGRAM, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from run_random_models import outcome_of  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_MODELS", "100" if NIGHTLY else "6"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "1"))


class RandomModels(ProgramTest):
    def test_random_whole_models_pass_the_check_or_are_refused_with_a_reason(self):
        outcomes = {}
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                outcome, why = outcome_of(seed, self.path(str(seed)), PROGRAM, 120)
                outcomes.setdefault(outcome, []).append(seed)
                self.assertIn(outcome, ("passes", "refused"), why)
        self.assertLess(len(outcomes.get("refused", [])), max(1, COUNT // 4), outcomes)


if __name__ == "__main__":
    main()
