# SPDX-License-Identifier: GPL-3.0-or-later
"""What cibuildwheel runs on each wheel: a box in two by a horizon, meshed, checked and written."""
import os
import tempfile

import numpy

import geomesh
import geomesh.core

x, y = numpy.meshgrid(numpy.linspace(-10, 1010, 18), numpy.linspace(-10, 1010, 18))
points = numpy.column_stack([x.ravel(), y.ravel(), (-500 + 40 * numpy.sin(x / 150)).ravel()])
corner = (numpy.arange(17)[:, None] * 18 + numpy.arange(17)).ravel()
triangles = numpy.vstack([numpy.column_stack([corner, corner + 1, corner + 19]), numpy.column_stack([corner, corner + 19, corner + 18])])
model = geomesh.Model(box=[[0, 0, -1000], [1000, 1000, 0]])
model.add_surface("top", points, triangles)
mesh = model.mesh(size=150)
assert len(mesh.regions) == 2 and len(mesh.tetrahedra) > 500
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "model.vtu")
    mesh.write(file)
    assert os.path.getsize(file) > 10000
print(len(mesh.tetrahedra), "tetrahedra in", [region.name for region in mesh.regions])
