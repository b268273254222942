# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the random models: surfaces as GOCAD TSurf, and the project."""
import os


def write_surface(folder, name, points, triangles):
    """Points as they are (repr), triangles by rows from 0."""
    with open(os.path.join(folder, name + ".ts"), "w") as file:
        file.write("GOCAD TSurf 1\nHEADER {\nname:%s\n}\nTFACE\n" % name)
        file.writelines("VRTX %d %r %r %r\n" % (i + 1, *p) for i, p in enumerate(points))
        file.writelines("TRGL %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)
        file.write("END\n")


def read_surface(path):
    """The points and triangles of a file of write_surface."""
    points, triangles = [], []
    with open(path) as file:
        for fields in map(str.split, file):
            if fields and fields[0] == "VRTX":
                points.append(tuple(map(float, fields[2:5])))
            elif fields and fields[0] == "TRGL":
                triangles.append(tuple(int(v) - 1 for v in fields[1:4]))
    return points, triangles


def write_project(folder, text):
    """Returns the file."""
    project = os.path.join(folder, "project.yaml")
    with open(project, "w") as file:
        file.write(text)
    return project
