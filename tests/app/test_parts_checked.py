#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""geomesh check --project of meshes in parts and of meshes whose faces bear no names: sides of the volume are no surfaces, and a horizon
that lies elsewhere is found."""
import os
import re
import shutil

from geomesh_program import ProgramTest, main


class PartsChecked(ProgramTest):
    bare = False

    def setUp(self):
        super().setUp()
        self.project = self.copy_of_sample("normal-fault", "{size: 400}")
        with open(self.project) as file:
            text = file.read()
        with open(self.project, "w") as file:
            file.write(re.sub(r"(?m)^output:.*$", "output: {directory: out, formats: [vtu], partitions: 3}", text))
        self.run_program(self.project, "-o", self.path("parts"))
        self.moved = self.project_with_a_horizon_elsewhere()

    def project_with_a_horizon_elsewhere(self):
        folder = self.path("moved")
        shutil.copytree(os.path.dirname(self.project), folder)
        horizon = os.path.join(folder, "surfaces", "top_sand.ts")
        with open(horizon) as file:
            text = file.read()
        with open(horizon, "w") as file:
            file.write(re.sub(r"(?m)^(VRTX .* )(\S+)$", lambda m: m.group(1) + "%.3f" % (float(m.group(2)) - 60), text))
        return os.path.join(folder, "project.yaml")

    def kinds(self, mesh, project):
        return {fault["id"] for fault in self.check(mesh, "--project", project, status=None)["faults"]}

    def test_parts_are_checked_as_one_mesh_with_their_names(self):
        mesh = self.path("parts", "normal_fault.pvtu")
        done = " ".join(self.check(mesh, "--project", self.project)["checks_done"])
        self.assertIn("regions were held against", done)
        self.assertIn("curves", done)
        self.assertIn("faces_off_their_surface", self.kinds(mesh, self.moved))
        self.assertNotEqual(self.last_status, 0)

    def test_a_mesh_alone_is_checked_without_the_sides_of_its_box(self):
        self.run_program("convert", self.path("parts", "normal_fault.pvtu"), "-o", self.path("alone.vtu"))
        for name in ("alone.faces.vtp", "alone.curves.vtp"):
            if os.path.exists(self.path(name)):
                os.remove(self.path(name))
        mesh = self.path("alone.vtu")
        self.check(mesh, "--project", self.project)
        self.assertIn("faces_off_their_surface", self.kinds(mesh, self.moved))


if __name__ == "__main__":
    main()
