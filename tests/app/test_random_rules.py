# SPDX-License-Identifier: GPL-3.0-or-later
"""Random columns with rules (tests/fuzz/random_rules.py): 24 from seed 0 in every run of the tests, 600 by night. Each mesh passes
the check, fills the volume, and has at each element's centroid the unit that the rules give there.

    GEOMESH_RANDOM_RULES=1000 GEOMESH_RANDOM_SEED=5000 ctest ... -R app.random_rules     another number, other seeds
"""
import os
import re
import sys

from geomesh_program import NIGHTLY, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from random_rules import RandomRules  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_RULES", "600" if NIGHTLY else "24"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "0"))


def tetrahedra(path):
    """Of a Gmsh file of version 2.2: the name of the region and the four corners of each."""
    with open(path) as file:
        lines = iter(file.read().splitlines())
    names, points = {}, {}
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dimension, number, name = next(lines).split(maxsplit=2)
                names[dimension, number] = name.strip('"')
        elif line == "$Nodes":
            for _ in range(int(next(lines))):
                number, *place = next(lines).split()
                points[number] = tuple(map(float, place))
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                fields = next(lines).split()
                if fields[1] == "4":
                    yield names["3", fields[3]], [points[v] for v in fields[-4:]]


class RandomRulesTest(ProgramTest):
    def wrong_places(self, seed):
        """Centroids of elements that are not in the unit that the rules give, and how many were asked."""
        model = RandomRules(seed)
        project = model.write(self.path(str(seed)))
        self.run_program(project, "--quiet", "--threads", "1")
        check = self.check(self.path(str(seed), "out", "model.vtu"), "--project", project)
        self.assertAlmostEqual(check["volume"] / model.volume(), 1, delta=0.01)
        wrong, n_asked = [], 0
        for name, corners in tetrahedra(self.path(str(seed), "out", "model.msh")):
            place = tuple(sum(p[k] for p in corners) / 4 for k in range(3))
            unit = model.unit_at(place)
            n_asked += unit is not None
            if unit is not None and re.sub(r"__B?\d+", "", name) != unit:
                wrong.append((name, unit, place))
        return wrong, n_asked

    def test_each_element_is_in_the_unit_that_the_rules_give(self):
        n_asked = 0
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                wrong, asked = self.wrong_places(seed)
                n_asked += asked
                self.assertEqual(wrong[:3], [], "%d of %d" % (len(wrong), asked))
        self.assertGreater(n_asked, 100 * COUNT)


if __name__ == "__main__":
    main()
