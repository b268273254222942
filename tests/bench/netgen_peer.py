#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills a surface mesh with tetrahedra by Netgen, for `quality_bench --section peers`.

    netgen_peer.py STEM     reads STEM.surface (points; triangles with the volume below and above, 0: none), writes STEM.1.node and STEM.1.ele

Triangles are counter-clockwise seen from above. They stay as they are.
"""
import sys

from netgen.meshing import Element2D, FaceDescriptor, Mesh, MeshingParameters, MeshPoint, Pnt, SetMessageImportance


def read(stem):
    with open(stem + ".surface") as file:
        n_points, n_triangles = map(int, file.readline().split())
        points = [tuple(map(float, file.readline().split())) for _ in range(n_points)]
        triangles = [tuple(map(int, file.readline().split())) for _ in range(n_triangles)]
    return points, triangles


def main():
    stem = sys.argv[1]
    points, triangles = read(stem)
    SetMessageImportance(0)
    mesh = Mesh(3)
    ids = [mesh.Add(MeshPoint(Pnt(*p))) for p in points]
    face = {}
    for a, b, c, below, above in triangles:
        if (below, above) not in face:
            face[below, above] = mesh.Add(FaceDescriptor(surfnr=len(face) + 1, domin=below, domout=above, bc=len(face) + 1))
        mesh.Add(Element2D(face[below, above], [ids[a], ids[b], ids[c]]))
    mesh.GenerateVolumeMesh(mp=MeshingParameters(optsteps3d=3))
    with open(stem + ".1.node", "w") as file:
        file.write("%d 3 0 0\n" % len(mesh.Points()))
        for i, p in enumerate(mesh.Points()):
            file.write("%d %r %r %r\n" % (i, p[0], p[1], p[2]))
    cells = list(mesh.Elements3D())
    with open(stem + ".1.ele", "w") as file:
        file.write("%d 4 0\n" % len(cells))
        for i, cell in enumerate(cells):
            file.write("%d %s\n" % (i, " ".join(str(v.nr - 1) for v in cell.vertices)))


if __name__ == "__main__":
    main()
