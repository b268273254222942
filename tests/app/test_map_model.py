# SPDX-License-Identifier: GPL-3.0-or-later
"""From the data of a geological map to a block model (samples/from-map), checked against the map's own observations."""
import csv
import os
import re
import subprocess
import sys

from geomesh_program import SOURCE, ProgramTest, main


def read_tetrahedra(path):
    """Nodes and elements by set of an Abaqus file: {id: point}, {set: [four ids]}."""
    points, elements, target = {}, {}, None
    with open(path) as file:
        for line in file:
            if line.startswith("*"):
                name = re.search(r"ELSET=([^,\s]+)", line, re.IGNORECASE)
                is_element = line.upper().startswith("*ELEMENT")
                target = points if line.upper().startswith("*NODE") else elements.setdefault(name.group(1), []) if is_element and name else None
            elif target is points:
                words = line.split(",")
                points[int(words[0])] = tuple(float(x) for x in words[1:4])
            elif target is not None:
                target.append([int(x) for x in line.split(",")[1:5]])
    return points, elements


def holds(a, b, c, d, p):
    def side(a, b, c, d):
        u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
        return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])
    return side(a, b, c, p) >= 0 and side(a, c, d, p) >= 0 and side(a, d, b, p) >= 0 and side(b, d, c, p) >= 0


class MapModel(ProgramTest):
    timeout = 600

    def top_tetrahedra(self, points, elements):
        """In cells of 500 m of the map: (box, unit, corners) of what lies in them."""
        cells = {}
        for unit, rows in elements.items():
            for row in rows:
                corners = [points[i] for i in row]
                low, high = [[f(p[k] for p in corners) for k in range(3)] for f in (min, max)]
                if high[2] < 200:  # the ground is nowhere lower than 297 m
                    continue
                for i in range(int(low[0] // 500), int(high[0] // 500) + 1):
                    for j in range(int(low[1] // 500), int(high[1] // 500) + 1):
                        cells.setdefault((i, j), []).append((low, high, unit, corners))
        return cells

    def unit_at_the_ground(self, cells, x, y):
        """The unit of the highest tetrahedron on the vertical through a place, found by steps of 5 m from above."""
        near = [entry for entry in cells.get((int(x // 500), int(y // 500)), []) if entry[0][0] <= x <= entry[1][0] and entry[0][1] <= y <= entry[1][1]]
        for z in range(1200, 200, -5):
            for low, high, unit, corners in near:
                if low[2] <= z <= high[2] and holds(*corners, (x, y, z)):
                    return re.sub(r"__B?\d+$", "", unit)
        return None

    def test_blocks_of_a_mapped_area(self):
        data = self.shared("map")
        script = os.path.join(SOURCE, "samples", "from-map", "make_project.py")
        subprocess.run([sys.executable, script, data, self.folder], check=True, timeout=60)
        self.run_program(self.path("project.yaml"))
        check = self.check(self.path("out", "map_model.vtu"), "--project", self.path("project.yaml"))
        report = self.report(self.path("out", "map_model.report.json"))
        units = {re.sub(r"__B?\d+$", "", name) for name in self.region_names(check)}
        with open(os.path.join(data, "geological_map_data", "contacts.csv")) as file:
            mapped = {row["name"] for row in csv.DictReader(file)}
        self.assertEqual(units, mapped | {"older"})
        faults = {s["name"]: s["area"] for s in report["surfaces"] if s["name"].startswith("Fault_")}
        self.assertEqual(len(faults), 6)
        self.assertTrue(all(area > 1e6 for area in faults.values()), faults)
        # Each dip was measured in a unit that the mapper names: how often does the model have that unit there? The dips' places are no
        # input of the horizons. A column of eleven units taken at random agrees in one of eleven.
        points, elements = read_tetrahedra(self.path("out", "map_model.inp"))
        full = {group["name"]: group["full_name"] for group in self.report(self.path("out", "map_model.inp.json"))["groups"]}
        cells = self.top_tetrahedra(points, {full[name]: rows for name, rows in elements.items()})
        with open(os.path.join(data, "geological_map_data", "stratigraphic_orientations.csv")) as file:
            seen = [(row["formation"], self.unit_at_the_ground(cells, float(row["X"]), float(row["Y"]))) for row in csv.DictReader(file)]
        inside = [(formation, unit) for formation, unit in seen if unit]
        agree = sum(formation == unit for formation, unit in inside)
        print("the unit at the ground agrees at %d of %d places where dips were measured" % (agree, len(inside)))
        self.assertGreater(len(inside), 190)
        self.assertGreater(agree, 0.5 * len(inside))


if __name__ == "__main__":
    main()
