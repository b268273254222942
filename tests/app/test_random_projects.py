# SPDX-License-Identifier: GPL-3.0-or-later
"""Random well-formed projects end to end: meshed, checked, and the regions fill the box; or refused with a reason. Never a bug, never a
hang.

    GEOMESH_RANDOM_PROJECTS=300 GEOMESH_RANDOM_SEED=1000 ctest ... -R app.random_projects     another number, other seeds
"""
import os
import sys

from geomesh_program import BAD_INPUT, CANNOT_MESH, DONE, NIGHTLY, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from random_projects import RandomProject  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_PROJECTS", "300" if NIGHTLY else "20"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "1"))


class RandomProjects(ProgramTest):
    timeout = 60

    def run_seed(self, seed):
        model = RandomProject(seed)
        project = model.write(self.path(str(seed)))
        report_file = self.path(str(seed), "report.json")
        printed = self.run_program(project, "--report", report_file, "--quiet", status=None)
        status = self.last_status
        self.assertIn(status, (DONE, BAD_INPUT, CANNOT_MESH), printed)
        if status != DONE:
            self.assertIn("error: ", printed)
            return False
        check = self.check(self.path(str(seed), "out", "model.vtu"), "--project", project)
        self.assertAlmostEqual(check["volume"] / model.volume(), 1, delta=1e-12)
        by_region = sum(region["volume"] for region in self.report(report_file)["regions"])
        self.assertAlmostEqual(by_region / model.volume(), 1, delta=1e-9)
        return True

    def test_border_bent_by_rounding(self):
        """Found by seed 38, which was refused as input that crosses itself."""
        project = os.path.join(SOURCE, "tests", "corpus", "bent_border", "project.yaml")
        self.run_program(project, "-o", self.folder)
        self.check(self.path("model.vtu"), "--project", project)

    def test_seeds(self):
        refused = []
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                if not self.run_seed(seed):
                    refused.append(seed)
        print("%d of %d projects meshed; refused: %s" % (COUNT - len(refused), COUNT, refused))
        self.assertLess(len(refused), max(1, COUNT // 4))


if __name__ == "__main__":
    main()
