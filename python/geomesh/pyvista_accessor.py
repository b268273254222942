# SPDX-License-Identifier: GPL-3.0-or-later
"""``.geomesh`` on objects of PyVista, where PyVista is installed.

    import pyvista, geomesh
    geomesh.register_pyvista()
    mesh = pyvista.read("top.vtp").geomesh.mesh(size=100, box=[[0, 0, -3000], [4000, 4000, 0]])

The accessor is there after :func:`geomesh.register_pyvista`, after ``import geomesh`` where PyVista had been imported
before, and after :meth:`geomesh.Mesh.to_pyvista`.
"""
from __future__ import annotations

from typing import Any, Optional

import numpy

from .core.errors import UsageError
from .inputs import arrays_of


class Accessor:
    """Methods of geomesh for a surface of PyVista (a PolyData, or the surface of another data set)."""

    def __init__(self, data: Any) -> None:
        self._data = data

    def _surface(self) -> Any:
        """Returns the data set itself if it consists of faces, else its surface, in triangles."""
        data = self._data
        if not hasattr(data, "faces") and hasattr(data, "extract_surface"):
            data = data.extract_surface()
        return data.triangulate() if hasattr(data, "triangulate") else data

    def add_to(self, model: Any, name: str, kind: str = "horizon", **rules: Any) -> Any:
        """Adds the surface to a :class:`geomesh.Model`, which is returned; arguments as of
        :meth:`geomesh.Model.add_surface`."""
        points, triangles = arrays_of(self._surface())
        return model.add_surface(name, points, triangles, kind=kind, **rules)

    def mesh(self, size: Any = None, box: Any = None, name: str = "surface", kind: Optional[str] = None,
             **keys: Any) -> Any:
        """Meshes the inside of a closed surface, or a box that the surface divides.

        Parameters
        ----------
        size, **keys
            As of :meth:`geomesh.Model.mesh`.
        box : array_like, shape (2, 3), optional
            Of the model; default: the bounds of the surface.
        kind : {"horizon", "fault", "body"}, optional
            Default: a body where the surface is closed (``is_manifold``), else a horizon.
        """
        from .model import Model
        surface = self._surface()
        if box is None:
            b = numpy.asarray(surface.bounds, dtype=float)
            if b.shape != (6,):
                raise UsageError("the bounds of the surface are not known: give a box")
            box = [b[0::2], b[1::2]]
        if kind is None:
            kind = "body" if getattr(surface, "is_manifold", False) else "horizon"
        return self.add_to(Model(box=box), name, kind=kind).mesh(size=size, **keys)


def register(pyvista: Any) -> None:
    """Adds ``.geomesh`` to PyVista's data sets. A second call has no effect."""
    known = getattr(pyvista, "DataSet", None)
    if known is None or hasattr(known, "geomesh"):
        return
    own = getattr(pyvista, "register_dataset_accessor", None)
    if own is not None:  # newer versions of PyVista can register accessors
        own("geomesh", known)(Accessor)
    else:
        known.geomesh = property(Accessor)
