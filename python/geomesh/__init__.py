# SPDX-License-Identifier: MIT
"""Tetrahedral meshes of earth models, from surfaces that disagree with each other.

    import geomesh
    model = geomesh.Model(box=[[0, 0, -3000], [4000, 4000, 0]])
    model.add_surface("top", points, triangles)          # numpy arrays, a file, a PyVista or meshio object
    mesh = model.mesh(size=200)
    mesh.points, mesh.tetrahedra, mesh.region            # numpy views
    mesh.write("model.vtu")

``geomesh.run("project.yaml")`` meshes a project file. ``geomesh.core`` is the engine alone, for plain arrays (MIT).
Lengths are in the unit of the project (metres), z counts upwards, rows count from 0, region ids from 1.
"""
from .core.errors import CannotMesh, Error, InternalError, Interrupted, InvalidInput, UsageError

__all__ = ["Model", "Mesh", "run", "check", "read_surfaces", "Error", "UsageError", "InvalidInput", "CannotMesh",
           "Interrupted", "InternalError"]

_HOME = {"Model": "model", "run": "model", "check": "model", "read_surfaces": "inputs", "Mesh": "mesh",
         "Region": "mesh", "Surface": "mesh", "Curve": "mesh", "Point": "mesh"}


def __getattr__(name):
    # geomesh.core alone loads nothing of the rest, which has another licence and more libraries.
    import importlib
    if name in _HOME:
        return getattr(importlib.import_module("." + _HOME[name], __name__), name)
    if name in ("core", "bridges"):
        return importlib.import_module("." + name, __name__)
    raise AttributeError("module 'geomesh' has no attribute %r" % name)


def __dir__():
    return sorted(__all__ + ["core", "bridges"])
