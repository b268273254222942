# SPDX-License-Identifier: GPL-3.0-or-later
"""Stand-ins with the attributes of objects of other packages, so that the packages themselves are not needed."""
from types import SimpleNamespace as Of

import numpy
import pytest

import geomesh
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
    tags = numpy.arange(len(points)) * 3 + 5  # numbers of nodes in gmsh need not be consecutive
    order = numpy.random.default_rng(1).permutation(len(points))
    of_mesh = Of(getElementsByType=lambda kind, tag: (numpy.arange(len(triangles)), tags[triangles].ravel()),
                 getNodes=lambda dim, tag, boundary: (tags[order], points[order].ravel(), []))
    gmsh = Of(model=Of(getEntities=lambda dim: [(2, 7)], mesh=of_mesh,
                       getPhysicalGroupsForEntity=lambda dim, tag: [4],
                       getPhysicalName=lambda dim, group: "top", getEntityName=lambda dim, tag: ""))
    (name, got, rows), = bridges.surfaces_of_gmsh(gmsh)
    assert name == "top" and (got == points).all() and (rows == triangles).all()


EXTENT = numpy.array([0.0, 1000, 0, 1000, -1000, 0])


def fold(x, y, z, throw=0.0):
    """Folded strata, lowered by the throw on the side above the fault."""
    return z + 620 - 50 * numpy.sin(x / 150) - 20 * numpy.cos(y / 200) + throw


def cover(x, y, z):
    return z + 220 - 30 * numpy.cos(x / 250)


def dipping(x, y, z):
    """Returns negative values to the west and above: the fault dips to the west."""
    return x - 500 - 0.6 * (z + 500)


def faulted(x, y, z):
    return fold(x, y, z, numpy.where(dipping(x, y, z) < 0, 80.0, 0.0))


def gempy_fields(groups, resolution=(50, 50, 50), relations=None):
    """Returns a computed GeoModel of GemPy 3 from (name, relation, function, {element: value}) for each group."""
    n = numpy.array(resolution)
    step = (EXTENT[1::2] - EXTENT[::2]) / n
    centres = numpy.meshgrid(*(EXTENT[2 * k] + step[k] * (numpy.arange(n[k]) + 0.5) for k in range(3)), indexing="ij")
    matrix = numpy.vstack([numpy.ravel(function(*centres)) for _, _, function, _ in groups])
    made = [Of(name=name, is_fault=relation == "FAULT", structural_relation=Of(name=relation),
               elements=[Of(name=e, vertices=None, edges=None, scalar_field_at_interface=v) for e, v in values.items()])
            for name, relation, _, values in groups]
    elements = [e for group in made for e in group.elements] + [Of(name="basement", vertices=None, edges=None)]
    grid = Of(resolution=n, extent=EXTENT)
    return Of(meta=Of(name="Implicit"), grid=Of(regular_grid=grid, extent=EXTENT),
              structural_frame=Of(structural_groups=made, structural_elements=elements,
                                  fault_relations=numpy.array(relations) if relations is not None else None),
              solutions=Of(raw_arrays=Of(scalar_field_matrix=matrix)))


def wrong_units(mesh, unit_at, clear_of):
    """Returns centres of tetrahedra whose unit differs from `unit_at`, away from where fields take their values."""
    units = {region.id: region.unit for region in mesh.regions}
    centres = numpy.asarray(mesh.points)[numpy.asarray(mesh.tetrahedra)].mean(axis=1).T
    found = numpy.array([units[r] for r in numpy.asarray(mesh.region)])
    clear = numpy.all([numpy.abs(field(*centres) - value) > slack for field, value, slack in clear_of], axis=0)
    assert clear.mean() > 0.75
    return int((found != unit_at(*centres))[clear].sum())


def strata(x, y, z, field=faulted):
    value = field(x, y, z)
    return numpy.where(value > 80, "rock1", numpy.where(value > -60, "rock2", "basement"))


# Largest error beside a surface: the mesh's tolerance of 80 / 20 m, times slopes of up to 1.2, plus 1 for interpolation
# between the nodes of the grid.
NEAR = 6
AT_FOLDS = [(faulted, 80, NEAR), (faulted, -60, NEAR), (dipping, 0, NEAR)]


def test_fields_of_gempy_give_units_on_both_sides_of_a_fault_and_below_an_unconformity():
    model = bridges.from_gempy(gempy_fields(
        [("Fault", "FAULT", dipping, {"F1": 0.0}), ("Cover", "ERODE", cover, {"sand": 0.0}),
         ("Strata", "ERODE", faulted, {"rock2": -60.0, "rock1": 80.0})],
        relations=[[0, 0, 1], [0, 0, 0], [0, 0, 0]]), as_fields=True)
    assert model.column == ["sand", "base_sand", "rock1", "base_rock1", "rock2", "base_rock2", "basement"]
    domains = [s.get("domain") for s in model.project()["surfaces"] if s["name"] == "base_rock1"]
    assert domains == [{"below": ["F1", "base_sand"]}, {"above": ["F1"], "below": ["base_sand"]}]
    mesh = model.mesh(size=80)
    assert wrong_units(mesh, lambda *p: numpy.where(cover(*p) > 0, "sand", strata(*p)), AT_FOLDS + [(cover, 0, NEAR)]) == 0
    areas = {s.name: s.area for s in mesh.surfaces}
    x, y = numpy.meshgrid(*2 * [numpy.arange(1000) + 0.5], indexing="ij")
    exact = numpy.sqrt(1 + (30 / 250 * numpy.sin(x / 250)) ** 2).mean() * 1e6
    assert areas["base_sand"] == pytest.approx(exact, rel=1e-3)
    assert areas["F1"] == pytest.approx(1e6 * numpy.sqrt(1 + 0.6 ** 2), rel=1e-3)


def test_fields_of_gempy_at_an_upright_fault_hold_in_blocks():
    def upright(x, y, z):
        return 505 - x

    def field(x, y, z):
        return fold(x, y, z, numpy.where(upright(x, y, z) > 0, 80.0, 0.0))
    model = bridges.from_gempy(gempy_fields([("Fault", "FAULT", upright, {"F1": 0.0}),
                                             ("Strata", "ERODE", field, {"rock1": 80.0, "rock2": -60.0})]), as_fields=True)
    assert {tuple(s["domain"]) for s in model.project()["surfaces"] if "domain" in s} == {("block",)}
    mesh = model.mesh(size=80)
    assert wrong_units(mesh, lambda *p: strata(*p, field=field),
                       [(field, 80, NEAR), (field, -60, NEAR), (upright, 0, NEAR)]) == 0


def test_a_group_of_gempy_that_onlaps_ends_on_the_highest_surface_of_the_next():
    def young(x, y, z):
        return z + 480 - 0.1 * x
    mesh = bridges.from_gempy(gempy_fields([("Young", "ONLAP", young, {"fill": 0.0}),
                                            ("Old", "ERODE", fold, {"rock1": 80.0, "rock2": -60.0})]),
                              as_fields=True).mesh(size=80)

    def unit_at(*p):
        return numpy.where(fold(*p) < 80, strata(*p, field=fold), numpy.where(young(*p) > 0, "fill", "rock1"))
    assert wrong_units(mesh, unit_at, [(fold, 80, NEAR), (fold, -60, NEAR), (young, 0, NEAR)]) == 0


def test_surfaces_of_gempy_that_the_box_does_not_hold_leave_their_units_out():
    values = {"high": 900.0, "rock1": 80.0, "rock2": -60.0, "deep": -900.0}
    model = bridges.from_gempy(gempy_fields([("Strata", "ERODE", fold, values)]), as_fields=True)
    assert model.column == ["rock1", "base_rock1", "rock2", "base_rock2", "deep"]


def test_a_gempy_model_that_was_not_computed_on_a_regular_grid_is_refused():
    given = gempy_fields([("Strata", "ERODE", fold, {"rock1": 80.0})])
    given.solutions.raw_arrays.scalar_field_matrix = numpy.zeros((1, 64))
    with pytest.raises(geomesh.UsageError, match="1 groups and a grid of 50x50x50 cells"):
        bridges.from_gempy(given, as_fields=True)


class Feature:
    """A feature of LoopStructural, which has values in the model's own frame and none beyond its regions."""

    def __init__(self, name, kind, function, faults=(), regions=()):
        self.name, self.type, self.function = name, Of(name=kind), function
        self.faults, self.regions = list(faults), list(regions)

    def evaluate_value(self, points, ignore_regions=False):
        x, y, z = (points * 1000 + [0, 0, -1000]).T
        values = numpy.array(self.function(x, y, z), dtype=float)
        for region in [] if ignore_regions else self.regions:
            values[~region(points)] = numpy.nan
        return values


class Unconformity(Of):
    def __call__(self, points):
        values = self.parent.evaluate_value(points)
        return values <= self.value if self.sign else values >= self.value


def loop_model(column, features):
    return Of(features=features, stratigraphic_column=column,
              scale=lambda points, inplace=True: (numpy.array(points) - [0, 0, -1000]) / 1000,
              bounding_box=Of(global_origin=numpy.array([0.0, 0, -1000]), global_maximum=numpy.array([1000.0, 1000, 0])))


def loop_features():
    fault, sand = Feature("F1", "FAULT", dipping), Feature("cover", "INTERPOLATED", cover)
    below = Unconformity(parent=sand, value=0.0, sign=True)
    sand.regions.append(Unconformity(parent=sand, value=0.0, sign=False))
    return [sand, Of(name="__cover_unconformity", type=Of(name="UNCONFORMITY")), fault,
            Feature("strata", "INTERPOLATED", faulted, [fault], [below])]


@pytest.mark.parametrize("column", [
    Of(get_isovalues=lambda: {"rock2": {"value": -60, "group": "strata"}, "rock1": {"value": 80, "group": "strata"},
                              "sand": {"value": 0, "group": "cover"}}),
    {"cover": {"sand": {"min": -numpy.inf, "max": numpy.inf, "id": 0}}, "faults": {"F1": {}},
     "strata": {"rock1": {"min": 80, "max": numpy.inf}, "rock2": {"min": -60, "max": 80},
                "basement": {"min": -numpy.inf, "max": -60}}}])
def test_fields_of_loopstructural_give_units_at_faults_and_unconformities(column):
    model = bridges.from_loopstructural(loop_model(column, loop_features()), as_fields=True, nodes=50)
    assert model.column == ["sand", "base_sand", "rock1", "base_rock1", "rock2", "base_rock2", "basement"]
    mesh = model.mesh(size=80)
    assert wrong_units(mesh, lambda *p: numpy.where(cover(*p) > 0, "sand", strata(*p)), AT_FOLDS + [(cover, 0, NEAR)]) == 0


def test_values_of_one_side_of_a_fault_are_continued_as_the_polynomial_that_they_are():
    from geomesh.implicit_fields import GridField, Lattice, continued
    lattice = Lattice(numpy.array([1.0, 2, 3]), numpy.array([0.5, 0.25, 1]), (12, 14, 9))
    x, y, z = lattice.places().T.reshape((3,) + lattice.shape)
    linear = 2 * x - 3 * y + z
    near = x - 0.6 * z < 2.5
    found = continued(numpy.where(near, linear, numpy.nan))
    beside = near.copy()
    for axis in range(3):  # add all corners of the grid cells that have a node of known value
        beside |= numpy.roll(beside, 1, axis) | numpy.roll(beside, -1, axis)
    inside = (slice(1, -1),) * 3
    assert numpy.abs(found - linear)[inside][beside[inside]].max() < 1e-9
    at = numpy.random.default_rng(3).uniform([1, 2, 3], [6.5, 5.25, 11], (100, 3)).T
    assert GridField(lattice, linear)(*at) == pytest.approx(2 * at[0] - 3 * at[1] + at[2])
