# SPDX-License-Identifier: GPL-3.0-or-later
"""Random horizons with throw across plane faults (tests/fuzz/random_throw.py): 60 in every run of the tests, more by night. Each mesh passes
the judge, and the volume below the horizon is that of its blocks.

    GEOMESH_RANDOM_THROW=1000 GEOMESH_RANDOM_SEED=5000 ctest ... -R app.random_throw     another number, other seeds
"""
import os
import sys

from geomesh_program import NIGHTLY, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from random_throw import RandomThrow  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_THROW", "600" if NIGHTLY else "60"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "0"))


class RandomThrowTest(ProgramTest):
    def volume_off(self, seed):
        """Of what is below the horizon from what its blocks hold."""
        model = RandomThrow(seed)
        project = model.write(self.path(str(seed)))
        self.run_program(project, "--quiet", "--threads", "1")
        self.check(self.path(str(seed), "out", "model.vtu"), "--project", project)
        report = self.report(self.path(str(seed), "out", "model.report.json"))
        below = sum(region["volume"] for region in report["regions"] if region["name"].split("__")[0] == "lower")
        return model, abs(below - model.volume_below())

    def test_each_block_is_there_to_its_faults(self):
        n_parted = 0
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                model, off = self.volume_off(seed)
                self.assertLess(off, 10 if model.within_tolerance else 1e-6)  # a tolerance of 0.1 over an area of 100
                n_parted += len(model.parted) > 0
        self.assertGreater(n_parted, COUNT // 2)


if __name__ == "__main__":
    main()
