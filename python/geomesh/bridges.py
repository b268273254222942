# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of other packages as geomesh models. The packages are not imported: their objects are met by attributes.

Each function returns a :class:`geomesh.Model` whose surfaces may be added to, and whose rules may be changed, before it
is meshed. Surfaces of implicit modelling end at the grid they were taken from; ``extend`` lets them reach the box.
"""
import numpy

from .core.errors import UsageError
from .inputs import without_nan
from .model import Model


def _box_of_extent(extent):
    """[x0, x1, y0, y1, z0, z1] as corners."""
    x0, x1, y0, y1, z0, z1 = (float(v) for v in extent)
    return [[x0, y0, z0], [x1, y1, z1]]


def _is_empty(surface, rows):
    return surface is None or rows is None or len(surface) == 0 or len(rows) == 0


def from_gempy(geo_model, *, extend="flat", column=True):
    """A model from a computed GeoModel of GemPy 3.

    Read are ``structural_frame.structural_groups`` (youngest first), of each ``is_fault`` and ``elements``, of these
    ``name``, ``vertices`` (n, 3) in the model's coordinates and ``edges`` (m, 3), the triangles; and
    ``grid.extent`` or ``grid.regular_grid.extent``. A surface of GemPy is the base of the unit of its name, so the
    column is made of these names; the surface itself is called ``base_NAME``. Groups that erode become ``base:
    erode``, those that onlap ``base: onlap``, at their lowest surface.

    Parameters
    ----------
    extend : str or None
        How surfaces go on to the box (key `extend`); None: not at all.
    column : bool
        Name units by the column.
    """
    grid = geo_model.grid
    extent = getattr(grid, "extent", None)
    if extent is None:
        extent = grid.regular_grid.extent
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


def from_loopstructural(model, *, extend="flat"):
    """A model from a GeologicalModel of LoopStructural.

    Read are ``get_stratigraphic_surfaces()`` and ``get_fault_surfaces()``, of each surface ``name``, ``vertices``
    (n, 3) and ``triangles`` (m, 3); and ``bounding_box.global_origin`` and ``global_maximum``, or ``origin`` and
    ``maximum``. Surfaces of several pieces come as several of one name and are joined.
    """
    bounds = model.bounding_box
    low = getattr(bounds, "global_origin", None)
    high = getattr(bounds, "global_maximum", None)
    if low is None or high is None:
        low, high = bounds.origin, bounds.maximum
    made = Model(box=[low, high], name="model")
    rules = {} if extend is None else {"extend": extend}
    for kind, surfaces in (("horizon", model.get_stratigraphic_surfaces()), ("fault", model.get_fault_surfaces())):
        for name, points, triangles in _joined(surfaces):
            made.add_surface(name, points, triangles, kind=kind, **rules)
    return made


def _joined(surfaces):
    """(name, points, triangles) with pieces of one name put together, in the order given. NaN vertices are dropped."""
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
        _, nodes = gmsh.model.mesh.getElementsByType(2, tag)  # 2: triangles of three nodes
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
