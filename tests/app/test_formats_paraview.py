#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What ParaView has in our files: regions, faces, curves and node sets under their names, with counts and volumes by its own filter.

Debian's python3-paraview cannot be installed beside python3-vtk9: GEOMESH_PVPYTHON names a pvpython that is elsewhere (docs/outputs.md).
"""
import json
import os
import shutil
import subprocess

import format_readers as readers
from geomesh_program import main
from test_formats import FormatTest, plain

PVPYTHON = os.environ.get("GEOMESH_PVPYTHON") or shutil.which("pvpython")
READS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pvpython_reads.py")


class ParaView(FormatTest):
    def setUp(self):
        super().setUp()
        if not PVPYTHON:
            self.skipTest("skipped: pvpython (python3-paraview) is not installed")

    def blocks(self, path):
        run = subprocess.run([PVPYTHON, READS, path], capture_output=True, text=True, timeout=200)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return json.loads(run.stdout.splitlines()[-1])["files"][0]

    def found_by_number(self, path, names):
        """`names`: number of the first array -> name."""
        block, = self.blocks(path)
        found = readers.Found(block["points"])
        for dimension, number, n, size in block["cells"]:
            into = {1: found.curves, 2: found.faces, 3: found.regions}[dimension]
            self.assertNotIn(plain(names[number]), into)
            into[plain(names[number])] = n, size
        found.nodes = {plain(name): n for name, n in block["nodes"].items()}
        return found

    def found_by_field_arrays(self, path):
        """Names as field arrays of the file itself have them."""
        block, = self.blocks(path)
        names = {}
        for name, number in block["ids"].items():
            names.setdefault(name.split(":")[0], {})[number] = name.split(":", 1)[1]
        kind = next(k for k in ("surface", "curve", "region") if k in names)
        return self.found_by_number(path, names[kind])

    def test_vtu_with_faces_and_curves_beside_it(self):
        path = self.convert("m.vtu")
        self.assert_regions(self.found_by_field_arrays(path))
        self.assert_faces(self.found_by_field_arrays(self.path("m.faces.vtp")))
        self.assert_curves(self.found_by_field_arrays(self.path("m.curves.vtp")))

    def test_vtu_of_second_order(self):
        found = self.found_by_field_arrays(self.convert("m.vtu", "--order", "2"))
        self.assert_regions(found)
        self.assertGreater(found.points, 7 * self.model["points"])

    def test_single_grid_with_node_sets(self):
        path = self.convert("m.vtu", "--single-grid", "--node-arrays")
        found = self.found_by_number(path, {g["id"]: g["name"] for g in self.sidecar(path)["groups"]})
        self.assert_regions(found)
        self.assert_faces(found)
        self.assert_curves(found)
        self.assert_node_sets(found)

    def test_parts(self):
        output = self.run_program("convert", self.stem + ".vtu", "-o", self.path("m.pvtu"), "--partitions", "3", status=None)
        if "without METIS" in output:
            self.skipTest("skipped: built without METIS")
        self.assert_regions(self.found_by_field_arrays(self.path("m.pvtu")))

    def found_in_exodus(self, path):
        """ParaView has a block for each element block, side set and node set, all under their names."""
        found = readers.Found(0)
        for block in self.blocks(path):
            name = block["name"][-1]
            if not block["cells"]:
                self.assertNotIn(name, found.nodes)
                found.nodes[name] = block["points"]
            for dimension, _, n, size in block["cells"]:
                into = {2: found.faces, 3: found.regions}[dimension]
                self.assertNotIn(name, into)
                into[name] = n, size
        return found

    def test_exodus(self):
        found = self.found_in_exodus(self.convert("m.e"))
        self.assert_regions(found)
        self.assert_faces(found)
        self.assert_node_sets(found)
        path = self.convert("m.vtu", "--single-grid", "--node-arrays")
        wanted = self.found_by_number(path, {g["id"]: g["name"] for g in self.sidecar(path)["groups"]})
        self.assertEqual(found.nodes, wanted.nodes)


if __name__ == "__main__":
    main()
