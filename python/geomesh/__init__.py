# SPDX-License-Identifier: MIT
"""Tetrahedral meshes of earth models, from surfaces that disagree with each other.

    import geomesh
    model = geomesh.Model(box=[[0, 0, -3000], [4000, 4000, 0]])
    model.add_surface("top", points, triangles)          # numpy arrays, a file, a PyVista or meshio object
    mesh = model.mesh(size=200)
    mesh.points, mesh.tetrahedra, mesh.region            # numpy views
    mesh.plot()
    mesh.write("model.vtu")

``geomesh.run("project.yaml")`` meshes a project file, ``geomesh.read("model.vtu")`` reads a mesh. ``geomesh.core`` is the
engine alone, for plain arrays (MIT). Lengths are in the unit of the project (metres), z counts upwards, rows count from
0, region ids from 1.
"""
import sys as _sys

from .core.errors import CannotMesh, Error, InternalError, Interrupted, InvalidInput, UsageError

__all__ = ["Model", "Mesh", "run", "read", "check", "read_surfaces", "register_pyvista", "Region", "Surface", "Curve",
           "Point", "Table", "View", "Error", "UsageError", "InvalidInput", "CannotMesh", "Interrupted", "InternalError",
           "__version__"]

_HOME = {"Model": "model", "run": "model", "check": "model", "read_surfaces": "inputs", "Mesh": "mesh", "read": "mesh",
         "Region": "mesh", "Surface": "mesh", "Curve": "mesh", "Point": "mesh", "Table": "tables", "View": "views",
         "__version__": "core"}


def __getattr__(name):
    # Other modules are loaded when they are first used, so that geomesh.core alone loads none of them: they have another licence and need
    # more libraries.
    import importlib
    if name in _HOME:
        return getattr(importlib.import_module("." + _HOME[name], __name__), name)
    if name in ("core", "bridges", "ensemble"):
        return importlib.import_module("." + name, __name__)
    raise AttributeError("module 'geomesh' has no attribute %r" % name)


def __dir__():
    return sorted(__all__ + ["core", "bridges"])


def register_pyvista():
    """Gives ``.geomesh`` to PyVista's surfaces: ``surface.geomesh.mesh(size=100)``. Needs PyVista."""
    import pyvista
    from . import pyvista_accessor
    pyvista_accessor.register(pyvista)


if "pyvista" in _sys.modules:
    register_pyvista()
