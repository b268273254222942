# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole models of tests/corpus/models: each failed once, and is meshed and passes the check now. Its README says what failed."""
import os

from geomesh_program import SOURCE, ProgramTest, main

MODELS = os.path.join(SOURCE, "tests", "corpus", "models")


class CorpusModels(ProgramTest):
    def test_each_model_is_meshed_and_passes_the_check(self):
        names = sorted(name for name in os.listdir(MODELS) if os.path.isdir(os.path.join(MODELS, name)))
        self.assertGreater(len(names), 1)
        for name in names:
            with self.subTest(model=name):
                project = os.path.join(MODELS, name, "project.yaml")
                self.run_program(project, "-o", self.path(name), "--quiet")
                self.check(self.path(name, "model.vtu"), "--project", project)


if __name__ == "__main__":
    main()
