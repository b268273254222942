# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts models of other packages to geomesh models. The packages are not imported: their objects are recognised by
their attributes.

Each function returns a :class:`geomesh.Model` whose surfaces may be added to, and whose rules may be changed, before it
is meshed. Surfaces of implicit modelling end at the grid they were taken from; ``extend`` lets them reach the box. With
``as_fields=True`` the scalar fields themselves become surfaces (:meth:`Model.add_field`), which need no extension.
"""
import numpy

from .core.errors import UsageError
from .implicit_fields import FaultField, FieldPart, GridField, Lattice, continued, parts_at_faults, takes
from .inputs import without_nan
from .model import Model


def _box_of_extent(extent):
    """Converts a box given as [x0, x1, y0, y1, z0, z1] to its two corners."""
    x0, x1, y0, y1, z0, z1 = (float(v) for v in extent)
    return [[x0, y0, z0], [x1, y1, z1]]


def _is_empty(surface, rows):
    return surface is None or rows is None or len(surface) == 0 or len(rows) == 0


def from_gempy(geo_model, *, as_fields=False, extend="flat", column=True):
    """A model from a computed GeoModel of GemPy 3.

    It uses ``structural_frame.structural_groups`` (youngest first) with ``is_fault`` and ``elements``; ``name``,
    ``vertices`` (n, 3) in the model's coordinates and ``edges`` (m, 3), the triangles, of each element; and
    ``grid.extent`` or ``grid.regular_grid.extent``. A surface of GemPy is the base of the unit of its name, so the
    column consists of these names; the surface itself is called ``base_NAME``. The lowest surface of a group that
    erodes has ``base: erode``, that of a group that onlaps has ``base: onlap``.

    Parameters
    ----------
    as_fields : bool
        Take the scalar fields instead of ``vertices`` and ``edges``. They are in ``grid.regular_grid`` with
        ``resolution`` and ``extent``; ``solutions.raw_arrays.scalar_field_matrix``, a row for each group with a value at
        the centre of each cell, z fastest; and ``scalar_field_at_interface`` of each element. Without
        ``structural_frame.fault_relations`` all faults affect all other groups. The surfaces of a group are values of
        one field and never cross. A group that faults affect has one field for each side of them, continued from the
        nodes of that side. Groups below one that erodes are valid below its lowest surface, and a group that onlaps is
        valid above the highest surface of the next group. A fault that other faults affect is smooth across them.
    extend : str or None
        How surfaces go on to the box (key `extend`); None: not at all. Without use with ``as_fields``.
    column : bool
        Name units by the column.
    """
    grid = geo_model.grid
    extent = getattr(grid, "extent", None)
    if extent is None:
        extent = grid.regular_grid.extent
    if as_fields:
        return _fields_of_gempy(geo_model, extent, column)
    model = Model(box=_box_of_extent(extent), name=_file_name(getattr(getattr(geo_model, "meta", None), "name", None)))
    rules = {} if extend is None else {"extend": extend}
    names = []
    for group in geo_model.structural_frame.structural_groups:
        elements = [e for e in group.elements if not _is_empty(e.vertices, e.edges)]
        if getattr(group, "is_fault", False):
            for element in elements:
                model.add_surface(element.name, *without_nan(element.vertices, element.edges), kind="fault", **rules)
            continue
        relation = str(getattr(group.structural_relation, "name", group.structural_relation)).lower()
        for element in elements:
            own = dict(rules)
            if element is elements[-1] and relation in ("erode", "onlap") and names:
                own["base"] = relation
            model.add_surface("base_" + element.name, *without_nan(element.vertices, element.edges), kind="horizon",
                              **own)
            names.append(element.name)
    if column and names:
        below = [e.name for g in geo_model.structural_frame.structural_groups for e in g.elements
                 if _is_empty(e.vertices, e.edges) and not getattr(g, "is_fault", False)]
        model.column = [word for name in names for word in (name, "base_" + name)] + [(below or ["basement"])[-1]]
    return model


def _file_name(name):
    text = "".join(c if c.isalnum() or c in "_-" else "_" for c in str(name or "model"))
    return text or "model"


def from_loopstructural(model, *, as_fields=False, extend="flat", nodes=80):
    """A model from a GeologicalModel of LoopStructural.

    It uses ``get_stratigraphic_surfaces()`` and ``get_fault_surfaces()`` with ``name``, ``vertices`` (n, 3) and
    ``triangles`` (m, 3) of each surface; and ``bounding_box.global_origin`` and ``global_maximum``, or ``origin`` and
    ``maximum``. Several surfaces of one name are pieces of one surface, and are joined.

    Parameters
    ----------
    as_fields : bool
        Take the scalar fields instead of surfaces. They are the ``features`` (youngest first) with ``name``, ``type``,
        ``evaluate_value(points, ignore_regions=True)`` of points in the model's own frame, ``faults`` and ``regions``;
        ``scale(points, inplace=False)``; and ``stratigraphic_column``: its ``get_isovalues()``, or the dict of dicts with
        ``min`` of earlier versions. A unit's base is called ``base_NAME``. Features without faults are evaluated where a value
        is needed. A feature that faults displace has one field for each side of them, continued from nodes of that
        side. Unconformities, which are regions with ``parent``, ``value`` and ``sign``, bound the domains.
    extend : str or None
        How surfaces go on to the box (key `extend`). Without use with ``as_fields``.
    nodes : int
        With ``as_fields``: nodes along the longest side of the box, at which features that are faulted are evaluated.
    """
    bounds = model.bounding_box
    low = getattr(bounds, "global_origin", None)
    high = getattr(bounds, "global_maximum", None)
    if low is None or high is None:
        low, high = bounds.origin, bounds.maximum
    if as_fields:
        return _fields_of_loopstructural(model, low, high, nodes)
    made = Model(box=[low, high], name="model")
    rules = {} if extend is None else {"extend": extend}
    for kind, surfaces in (("horizon", model.get_stratigraphic_surfaces()), ("fault", model.get_fault_surfaces())):
        for name, points, triangles in _joined(surfaces):
            made.add_surface(name, points, triangles, kind=kind, **rules)
    return made


class _Sequence:
    """Horizons of implicit fields, youngest first, and the units between them."""

    def __init__(self, model):
        self.model = model
        self._column = []  # Names of the units and horizons added so far, alternately, from the youngest unit on.
        self._reaching = None  # Unit that extends below its domain, so that the next base is its base; or None.
        self._is_complete = False  # Whether the units added so far fill the box down to its bottom.

    def add(self, unit, name, parts, values, value, above=(), below=()):
        """Adds the base of a unit unless the field has no such value where it is valid; returns whether it was added.

        `above`, `below`: (name, values, value) of the horizons that bound the domain of the field.
        """
        if self._is_complete:
            return False
        inside = numpy.ones(values.shape, dtype=bool)
        for sign, bounds in ((1, above), (-1, below)):
            for _, bound, at in bounds:
                inside &= ~(sign * (bound - at) < 0)
        unit = self._reaching or unit
        held = [part for part in parts if takes(values, value, part.nodes & inside)]
        self._reaching = unit if not held and (values[inside] > value).any() else None
        self._is_complete = self._reaching is not None and not above
        for part in held:
            domain = {key: place if key == "block" else list(place) for key, place in part.domain.items()}
            for key, bounds in (("above", above), ("below", below)):
                if bounds:
                    domain[key] = domain.get(key, []) + [bound for bound, _, _ in bounds]
            self.model.add_field(name, part.field, value, domain=domain or None)
        if held:
            self._column += [unit, name]
        return bool(held)

    def column(self, lowest):
        """Returns units and horizons, with the name of the unit below them all; empty without horizons."""
        return self._column and self._column + [self._reaching or lowest]


def _fields_of_gempy(geo_model, extent, column):
    frame, grid = geo_model.structural_frame, geo_model.grid.regular_grid
    shape = tuple(int(n) for n in grid.resolution)
    low, high = (numpy.array(grid.extent, dtype=float)[k::2] for k in (0, 1))
    spacing = (high - low) / shape
    lattice = Lattice(low + spacing / 2, spacing, shape)
    matrix = numpy.asarray(geo_model.solutions.raw_arrays.scalar_field_matrix, dtype=float)
    groups = frame.structural_groups
    if matrix.shape != (len(groups), int(numpy.prod(shape))) or min(shape) < 2:
        raise UsageError("the scalar fields of the GemPy model have the shape %s; %d groups and a grid of %s cells, "
                         "computed, were expected" % (matrix.shape, len(groups), "x".join(map(str, shape))))
    fields = [continued(row.reshape(shape)) for row in matrix]
    model = Model(box=_box_of_extent(extent), name=_file_name(getattr(getattr(geo_model, "meta", None), "name", None)))
    elements = [[(e.name, float(numpy.ravel(e.scalar_field_at_interface)[0])) for e in group.elements
                 if getattr(e, "scalar_field_at_interface", None) is not None] for group in groups]
    faults = {}
    for g, group in enumerate(groups):
        for name, value in elements[g] if getattr(group, "is_fault", False) else ():
            if takes(fields[g], value, numpy.ones(shape, dtype=bool)):
                model.add_field(name, GridField(lattice, fields[g]), value, kind="fault")
                faults.setdefault(g, []).append(FaultField(name, fields[g] - value))
    relations = getattr(frame, "fault_relations", None)
    sequence, eroding = _Sequence(model), []
    strata = [g for g in range(len(groups)) if not getattr(groups[g], "is_fault", False) and elements[g]]
    for g in strata:
        own = [f for k, found in faults.items() if relations is None or relations[k][g] for f in found]
        parts = parts_at_faults(lattice, fields[g], own, [f for found in faults.values() for f in found])
        surfaces = sorted(elements[g], key=lambda element: -element[1])
        relation = str(getattr(groups[g].structural_relation, "name", groups[g].structural_relation)).lower()
        older = [k for k in strata if k > g]
        onto = []
        if relation == "onlap" and older:
            name, value = max(elements[older[0]], key=lambda element: element[1])
            if takes(fields[older[0]], value, numpy.ones(shape, dtype=bool)):
                onto = [("base_" + name, fields[older[0]], value)]
        for name, value in surfaces:
            is_there = sequence.add(name, "base_" + name, parts, fields[g], value, above=onto, below=eroding)
        if relation == "erode" and is_there and older:
            eroding = eroding + [("base_" + surfaces[-1][0], fields[g], surfaces[-1][1])]
    if column:
        below = [e.name for e in list(getattr(frame, "structural_elements", []))[-1:]
                 if getattr(e, "scalar_field_at_interface", None) is None]
        below = below or [e.name for group in groups for e in group.elements
                          if getattr(e, "scalar_field_at_interface", None) is None]
        model.column = sequence.column((below or ["basement"])[-1])
    return model


class _FeatureField:
    """The scalar field of a feature of LoopStructural as a function, also beyond unconformities that bound it."""

    def __init__(self, model, feature):
        self.model, self.feature = model, feature

    def __call__(self, x, y, z):
        points = numpy.stack([x, y, z], axis=-1).reshape(-1, 3)
        points = self.model.scale(points, inplace=False) if hasattr(self.model, "scale") else points
        try:
            values = self.feature.evaluate_value(points, ignore_regions=True)
        except TypeError:  # an earlier version
            values = self.feature.evaluate_value(points)
        return numpy.asarray(values, dtype=float).reshape(numpy.shape(x))


def _isovalues(column):
    """Returns (feature, unit, value of its base) for a stratigraphic column."""
    if hasattr(column, "get_isovalues"):
        return [(facts["group"], unit, float(facts["value"])) for unit, facts in column.get_isovalues().items()]
    return [(group, unit, float(facts["min"])) for group, units in column.items() if group != "faults"
            for unit, facts in units.items()]


def _kind_of(feature):
    return str(getattr(feature.type, "name", feature.type)).upper().replace("_", "")


def _fields_of_loopstructural(loop, low, high, nodes):
    low, high = numpy.array(low, dtype=float), numpy.array(high, dtype=float)
    shape = numpy.maximum(numpy.ceil((high - low) / (high - low).max() * (nodes - 1)).astype(int), 3) + 1
    lattice = Lattice(low, (high - low) / (shape - 1), tuple(int(n) for n in shape))
    model = Model(box=[low, high], name="model")
    places = lattice.places().T

    def sampled(feature):
        return _FeatureField(loop, feature)(*places).reshape(lattice.shape)

    def smooth(feature, values):
        if numpy.isfinite(values).all():
            return _FeatureField(loop, feature)
        return GridField(lattice, continued(values))

    faults = {}
    for feature in loop.features:
        if _kind_of(feature) in ("FAULT", "INACTIVEFAULT", "FAULTINACTIVE"):
            values = sampled(feature)
            if takes(values, 0, numpy.ones(lattice.shape, dtype=bool)):
                model.add_field(feature.name, smooth(feature, values), 0, kind="fault")
                faults[feature.name] = FaultField(feature.name, continued(values))
    isovalues = _isovalues(loop.stratigraphic_column)
    strata = [f for f in loop.features if f.name in {group for group, _, _ in isovalues}]
    values, parts = {}, {}
    for feature in strata:
        found = values[feature.name] = sampled(feature)
        own = [faults[f.name] for f in feature.faults if f.name in faults]
        parts[feature.name] = (parts_at_faults(lattice, found, own, list(faults.values())) if own else
                               [FieldPart(smooth(feature, found), {}, numpy.ones(lattice.shape, dtype=bool))])
    _add_loop_horizons(model, strata, isovalues, values, parts)
    return model


def _bounds_of(feature, names):
    """Returns the horizons above and below which a feature is valid, as (feature, value), from its unconformities."""
    bounds = {"above": [], "below": []}
    for region in feature.regions:
        parent = getattr(region, "parent", None)
        if parent is not None and parent.name in names:
            bounds["below" if region.sign else "above"].append((parent.name, float(region.value)))
    return bounds


def _add_loop_horizons(model, strata, isovalues, values, parts):
    names = [feature.name for feature in strata]
    bounds = {feature.name: _bounds_of(feature, names) for feature in strata}
    # (unit, feature, value) of each surface, the base of the unit; a unit without a base yet; names of the surfaces
    surfaces, open_unit, name_of = [], None, {}
    for group in names:
        units = {value: unit for of, unit, value in isovalues if of == group}
        cut = {value for found in bounds.values() for key in ("above", "below") for of, value in found[key] if of == group}
        lowest = [value for value in units if not numpy.isfinite(value)]
        if lowest and cut and min(cut) < min((v for v in units if numpy.isfinite(v)), default=numpy.inf):
            units[min(cut)] = units.pop(lowest[0])  # the unconformity is the base of the lowest unit of the group
        for value in sorted(set(units) | cut, reverse=True):
            if not numpy.isfinite(value):
                if open_unit is not None:
                    raise UsageError("the unit %s has no base, and others lie below it; add an unconformity" % open_unit)
                open_unit = units[value]
                continue
            unit = units.get(value) or open_unit or "over_%s_unconformity" % group
            open_unit = None if unit == open_unit else open_unit
            surfaces.append((unit, group, value))
            name_of[group, value] = "base_" + unit
    sequence = _Sequence(model)
    for unit, group, value in surfaces:
        kept = {key: [(name_of[bound], values[bound[0]], bound[1]) for bound in bounds[group][key] if bound[0] != group]
                for key in ("above", "below")}
        own = {key: [at for of, at in bounds[group][key] if of == group] for key in ("above", "below")}
        if any(value < at for at in own["above"]) or any(value > at for at in own["below"]):
            continue  # the surface lies on the removed side of the unconformity that bounds its feature
        sequence.add(unit, name_of[group, value], parts[group], values[group], value, **kept)
    model.column = sequence.column(open_unit or "basement")


def _joined(surfaces):
    """Returns (name, points, triangles) with pieces of one name joined, in the given order. NaN vertices are dropped."""
    pieces = {}
    for surface in surfaces:
        if not _is_empty(surface.vertices, surface.triangles):
            pieces.setdefault(str(surface.name), []).append(without_nan(numpy.asarray(surface.vertices, dtype=float),
                                                                        surface.triangles))
    for name, parts in pieces.items():
        offsets = numpy.cumsum([0] + [len(points) for points, _ in parts[:-1]])
        yield (name, numpy.concatenate([points for points, _ in parts]),
               numpy.concatenate([rows + offset for (_, rows), offset in zip(parts, offsets)]))


def surfaces_of_gmsh(gmsh, entities=None):
    """(name, points, triangles) of discrete or meshed surfaces in the current model of the gmsh module.

    Parameters
    ----------
    gmsh : module
        The module ``gmsh``, initialised, with a meshed model.
    entities : list of (2, tag), optional
        Default: all of dimension 2. Names are those of the physical group that the entity is in, else of the entity,
        else ``surface_TAG``.
    """
    found = []
    for dimension, tag in (gmsh.model.getEntities(2) if entities is None else entities):
        _, nodes = gmsh.model.mesh.getElementsByType(2, tag)  # gmsh's element type 2: triangles of three nodes
        if len(nodes) == 0:
            continue
        tags, coordinates, _ = gmsh.model.mesh.getNodes(dimension, tag, True)
        tags, first = numpy.unique(numpy.asarray(tags, dtype=numpy.int64), return_index=True)
        points = numpy.asarray(coordinates, dtype=float).reshape(-1, 3)[first]
        triangles = numpy.searchsorted(tags, numpy.asarray(nodes, dtype=numpy.int64)).reshape(-1, 3)
        found.append((_gmsh_name(gmsh, dimension, tag), points, triangles))
    if not found:
        raise UsageError("the gmsh model has no triangles: mesh its surfaces first (gmsh.model.mesh.generate(2))")
    return found


def _gmsh_name(gmsh, dimension, tag):
    for group in gmsh.model.getPhysicalGroupsForEntity(dimension, tag):
        name = gmsh.model.getPhysicalName(dimension, group)
        if name:
            return name
    return gmsh.model.getEntityName(dimension, tag) or "surface_%d" % tag
