#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are level sets of fields, given as functions."""
import math
import unittest

import numpy

import geomesh

BOX = [[-500, -500, -500], [500, 500, 500]]


def fold(x, y, z):
    return z - 80 * numpy.sin(x / 100) - 20 * numpy.cos(y / 150)


class Fields(unittest.TestCase):
    def model(self, column=None):
        return geomesh.Model(box=BOX, column=column)

    def test_units_of_a_fold_are_right_at_20000_points(self):
        model = self.model(["a", "top", "b", "base", "c"])
        model.add_field("top", fold, 30)
        model.add_field("base", fold, -60)
        mesh = model.mesh(size=80)
        points, cells = numpy.asarray(mesh.points), numpy.asarray(mesh.tetrahedra)
        centres = points[cells].mean(axis=1)
        rows = numpy.random.default_rng(1).choice(len(centres), size=min(20000, len(centres)), replace=False)
        value = fold(*centres[rows].T)
        tolerance = 80 / 40 * 1.3  # the gradient of the folded field has at most length 1.3
        names = numpy.array([mesh.names[r] if isinstance(mesh.names, dict) else None for r in numpy.asarray(mesh.region)[rows]])
        wanted = numpy.where(value > 30, "a", numpy.where(value > -60, "b", "c"))
        clear = (abs(value - 30) > tolerance) & (abs(value + 60) > tolerance)
        self.assertTrue((names[clear] == wanted[clear]).all())

    def test_a_ball_has_its_volume(self):
        model = self.model()
        model.add_field("ball", lambda x, y, z: numpy.sqrt(x * x + y * y + z * z) - 300, 0, kind="body")
        mesh = model.mesh(refine="none")
        volumes = {region.name: region.volume for region in mesh.regions}
        self.assertAlmostEqual(volumes["ball"] / (4 / 3 * math.pi * 300 ** 3), 1, delta=0.001)

    def region_volumes(self, model):
        """Returns volumes of regions at the default size and tolerance."""
        return {region.name: region.volume for region in model.mesh().regions}

    def test_curved_surfaces_keep_their_volumes_at_the_default(self):
        """Triangles with their corners on the surface itself would all lie inside a ball, which would lose 0.7 % of its
        volume, a torus 1 %."""
        model = self.model()
        model.add_field("ball", lambda x, y, z: numpy.sqrt(x * x + y * y + z * z) - 300, 0, kind="body")
        self.assertAlmostEqual(self.region_volumes(model)["ball"] / (4 / 3 * math.pi * 300 ** 3), 1, delta=0.001)
        model = self.model()
        model.add_field("torus", lambda x, y, z: numpy.hypot(numpy.hypot(x, y) - 280, z) - 90, 0, kind="body")
        self.assertAlmostEqual(self.region_volumes(model)["torus"] / (2 * math.pi ** 2 * 280 * 90 ** 2), 1, delta=0.001)

    def test_a_recumbent_fold_keeps_its_volumes_at_the_default(self):
        def recumbent(x, y, z):
            return x + 150 - 0.0025 * (z - 40 * numpy.sin(y / 300)) ** 2
        model = self.model(["front", "top", "core"])
        model.add_field("top", recumbent, 0)
        at = numpy.arange(1000) - 499.5
        y, z = numpy.meshgrid(at, at, indexing="ij")
        wanted = numpy.clip(-recumbent(0, y, z) + 500, 0, 1000).sum()  # volume by an integral that is exact along x, with midpoints across
        volumes = self.region_volumes(model)
        found = volumes["core"] if abs(volumes["core"] - wanted) < abs(volumes["front"] - wanted) else volumes["front"]
        self.assertAlmostEqual(found / wanted, 1, delta=0.001)

    def test_balls_one_metre_apart_keep_their_volumes_at_the_default(self):
        model = self.model()
        for name, radius in (("inner", 300), ("shell", 301)):
            model.add_field(name, lambda x, y, z, radius=radius: numpy.sqrt(x * x + y * y + z * z) - radius, 0, kind="body")
        volumes = self.region_volumes(model)
        self.assertAlmostEqual(volumes["inner"] / (4 / 3 * math.pi * 300 ** 3), 1, delta=0.001)
        self.assertAlmostEqual((volumes["inner"] + volumes["shell"]) / (4 / 3 * math.pi * 301 ** 3), 1, delta=0.001)
        self.assertAlmostEqual(volumes["shell"] / (4 / 3 * math.pi * (301 ** 3 - 300 ** 3)), 1, delta=0.03)

    def test_a_fold_that_jumps_at_a_fault_is_a_function_for_each_side(self):
        model = self.model(["a", "top", "b", "base", "c"])
        model.add_field("fault", lambda x, y, z: x - 0.5 * z, 0, kind="fault")
        for side, throw in (("above", 0), ("below", 80)):
            def strata(x, y, z, throw=throw):
                return fold(x, y, z) + throw
            model.add_field("top", strata, 30, domain={side: "fault"})
            model.add_field("base", strata, -60, domain={side: "fault"})
        mesh = model.mesh(size=80)
        at = (numpy.arange(1000) + 0.5) - 500
        x, y = numpy.meshgrid(at, at, indexing="ij")
        height = -fold(x, y, 0)  # volumes by integrals that are exact along z, with midpoints in the map; the fault is at z = 2 x
        west = numpy.maximum(height + 30, 2 * x) - numpy.maximum(height - 60, 2 * x)
        east = numpy.minimum(height - 50, 2 * x) - numpy.minimum(height - 140, 2 * x)
        volumes = {unit: sum(r.volume for r in mesh.regions if r.name.split("__")[0] == unit) for unit in "abc"}
        self.assertAlmostEqual(volumes["b"] / (west.sum() + east.sum()), 1, delta=0.001)
        self.assertAlmostEqual(sum(volumes.values()) / 1e9, 1, delta=1e-9)

    def test_a_domain_at_a_surface_that_is_not_there_is_refused(self):
        model = self.model()
        model.add_field("base", fold, 0, domain={"below": "unconformity"})
        with self.assertRaisesRegex(geomesh.UsageError, "'unconformity', which is no other horizon or fault"):
            model.mesh()

    def test_a_function_that_fails_is_reported_with_surface_and_place(self):
        def bad(x, y, z):
            raise ValueError("no such rock")
        model = self.model()
        model.add_field("top", bad, 0)
        with self.assertRaisesRegex(geomesh.InvalidInput, r"surface top: .*\(-500, -500, -500\): ValueError: no such rock"):
            model.mesh()

    def test_a_value_that_is_not_finite_is_reported_with_its_place(self):
        model = self.model()
        model.add_field("top", lambda x, y, z: numpy.where(x > 499, numpy.nan, z), 0)
        with self.assertRaisesRegex(geomesh.InvalidInput, r"surface top: .*not finite at \(500"):
            model.mesh()

    def test_a_field_without_the_value_is_reported(self):
        model = self.model()
        model.add_field("top", fold, 5000)
        with self.assertRaisesRegex(geomesh.InvalidInput, "surface top: .*5000 is not among them"):
            model.mesh()

    def test_what_is_no_field_is_refused(self):
        with self.assertRaises(geomesh.UsageError):
            self.model().add_field("top", 3, 0)


if __name__ == "__main__":
    unittest.main()
