# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects in the form of other packages, met by attributes: the packages themselves are not needed."""
from types import SimpleNamespace as Of

import numpy
import pytest

from geomesh import bridges
from shapes import sheet


def gempy_model():
    """A computed GeoModel of GemPy 3: two conformable surfaces, and a fault whose group stands first."""
    fault_points = numpy.array([[480.0, 0, 0], [480, 1000, 0], [520, 0, -1000], [520, 1000, -1000]])
    fault = Of(name="F1", vertices=fault_points, edges=numpy.array([[0, 1, 2], [1, 3, 2]]))
    inside = dict(low=0.0, high=1000.0, n=11)
    rock1 = Of(name="rock1", vertices=sheet(lambda x, y: -300 + 0 * x, **inside)[0], edges=sheet(lambda x, y: x, **inside)[1])
    rock2 = Of(name="rock2", vertices=sheet(lambda x, y: -600 + 0 * x, **inside)[0], edges=sheet(lambda x, y: x, **inside)[1])
    basement = Of(name="basement", vertices=None, edges=None)
    groups = [Of(name="Fault_Series", is_fault=True, structural_relation=Of(name="FAULT"), elements=[fault]),
              Of(name="Strat_Series", is_fault=False, structural_relation=Of(name="ERODE"),
                 elements=[rock1, rock2, basement])]
    return Of(meta=Of(name="Simple model"), structural_frame=Of(structural_groups=groups),
              grid=Of(extent=numpy.array([0.0, 1000, 0, 1000, -1000, 0])))


def test_a_gempy_model_becomes_units_between_the_bases_of_its_surfaces():
    model = bridges.from_gempy(gempy_model())
    assert model.column == ["rock1", "base_rock1", "rock2", "base_rock2", "basement"]
    mesh = model.mesh()
    volume = {}
    for region in mesh.regions:
        volume[region.unit] = volume.get(region.unit, 0) + region.volume
    assert volume == pytest.approx({"rock1": 300e6, "rock2": 300e6, "basement": 400e6})
    assert "F1" in [s.name for s in mesh.surfaces if s.kind == "fault" and s.area > 0]


def test_a_loopstructural_model_gives_its_surfaces_with_pieces_of_one_name_joined():
    half = dict(n=6)
    points, triangles = sheet(lambda x, y: -500 + 0 * x, **half)
    left = points[:, 0] < 400
    keep = left[triangles].all(axis=1)
    pieces = [Of(name="unit_a", vertices=points, triangles=triangles[keep]),
              Of(name="unit_a", vertices=points, triangles=triangles[~keep])]
    loop = Of(get_stratigraphic_surfaces=lambda: pieces, get_fault_surfaces=lambda: [],
              bounding_box=Of(global_origin=numpy.array([0.0, 0, -1000]), global_maximum=numpy.array([1000.0, 1000, 0])))
    mesh = bridges.from_loopstructural(loop, extend=None).mesh()
    assert sorted(r.volume for r in mesh.regions) == pytest.approx([500e6, 500e6])


def test_surfaces_of_a_gmsh_model_come_with_the_names_of_their_physical_groups():
    points, triangles = sheet(lambda x, y: -500 + 0 * x)
    tags = numpy.arange(len(points)) * 3 + 5  # gmsh numbers nodes as it likes
    order = numpy.random.default_rng(1).permutation(len(points))
    of_mesh = Of(getElementsByType=lambda kind, tag: (numpy.arange(len(triangles)), tags[triangles].ravel()),
                 getNodes=lambda dim, tag, boundary: (tags[order], points[order].ravel(), []))
    gmsh = Of(model=Of(getEntities=lambda dim: [(2, 7)], mesh=of_mesh,
                       getPhysicalGroupsForEntity=lambda dim, tag: [4],
                       getPhysicalName=lambda dim, group: "top", getEntityName=lambda dim, tag: ""))
    (name, got, rows), = bridges.surfaces_of_gmsh(gmsh)
    assert name == "top" and (got == points).all() and (rows == triangles).all()
