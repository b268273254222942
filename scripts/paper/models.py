# SPDX-License-Identifier: GPL-3.0-or-later
"""The models of the paper's figures with bodies of our own making. Standard library only; the same files every time."""
import math


def write_off(path, points, faces):
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        file.writelines("%r %r %r\n" % tuple(p) for p in points)
        file.writelines("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)


def circle(x, y, radius, n):
    return [(x + radius * math.cos(2 * math.pi * i / n), y + radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


def mechanical_part(path):
    """Figure 5: a bearing bracket. A plate with rounded ends and four bolt holes, and on it a hub with a bore; walls in bands of
    triangles, plane faces as polygons with holes, written as a TetGen .poly."""
    end, bolts, hub, bore = 64, 24, 96, 64
    outline = [(60 + 30 * math.cos(a), 30 * math.sin(a)) for a in (math.pi * (i / end - 0.5) for i in range(end + 1))]
    outline += [(-x, -y) for x, y in outline]
    holes = [circle(sx * 62, sy * 14, 5, bolts) for sx in (-1, 1) for sy in (-1, 1)]
    hub_ring, bore_ring = circle(0, 0, 24, hub), circle(0, 0, 14, bore)
    points, facets = [], []

    def ring(flat, z):
        points.extend((x, y, z) for x, y in flat)
        return list(range(len(points) - len(flat), len(points)))

    def wall(flat, heights):
        rings = [ring(flat, z) for z in heights]
        for low, high in zip(rings, rings[1:]):
            for i in range(len(flat)):
                k = (i + 1) % len(flat)
                facets.append([[low[i], low[k], high[k]]])
                facets.append([[low[i], high[k], high[i]]])
        return rings[0], rings[-1]

    outer = wall(outline, (0, 6, 12))
    bolt_walls = [wall(h, (0, 12)) for h in holes]
    hub_wall = wall(hub_ring, (12, 28, 44))
    bore_wall = wall(bore_ring, (0, 15, 30, 44))
    inside = [(62.0 * sx, 14.0 * sy) for sx in (-1, 1) for sy in (-1, 1)]
    facets.append([outer[0]] + [b[0] for b in bolt_walls] + [bore_wall[0]])
    holes_below = inside + [(0.0, 0.0)]
    plate_top = [outer[1]] + [b[1] for b in bolt_walls] + [hub_wall[0]]
    facets.append(plate_top)
    facets.append([hub_wall[1], bore_wall[1]])
    centre_of = {len(facets) - 3: holes_below, len(facets) - 2: inside + [(0.0, 0.0)], len(facets) - 1: [(0.0, 0.0)]}
    with open(path, "w", encoding="ascii") as file:
        file.write("%d 3 0 0\n" % len(points))
        file.writelines("%d %r %r %r\n" % (i, *map(float, p)) for i, p in enumerate(points))
        file.write("%d 0\n" % len(facets))
        for f, loops in enumerate(facets):
            marks = centre_of.get(f, [])
            file.write("%d %d\n" % (len(loops), len(marks)))
            file.writelines("%d %s\n" % (len(loop), " ".join(map(str, loop))) for loop in loops)
            z = points[loops[0][0]][2]
            file.writelines("%d %r %r %r\n" % (i + 1, x, y, float(z)) for i, (x, y) in enumerate(marks))
        file.write("0\n0\n")


def sphere(level):
    """An icosahedron divided `level` times, on the unit sphere."""
    t = (1 + 5 ** 0.5) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1),
              (-t, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2),
             (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middle, divided = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(tuple((points[a][k] + points[b][k]) / 2 for k in range(3)))
            return middle[key]
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = divided
    return [tuple(x / math.hypot(*p) for x in p) for p in points], faces


def blob(level, lobes, stretch, shift):
    """A closed surface about the origin: a sphere with lobes (direction, height, width), stretched and moved."""
    points, faces = sphere(level)
    units = [(tuple(x / math.hypot(*d) for x in d), h, w) for d, h, w in lobes]

    def radius(p):
        return 1 + sum(h * math.exp((sum(a * b for a, b in zip(p, d)) - 1) / w) for d, h, w in units)
    made = [tuple(s * x * radius(p) + o for x, s, o in zip(p, stretch, shift)) for p in points]
    return made, faces


def two_animals(first, second):
    """Figure 6: a quadruped (four legs, neck, tail) and a fish (snout, fins, tail), one through the other."""
    legs = [((sx * 0.55, sy * 0.5, -0.8), 1.3, 0.02) for sx in (-1, 1) for sy in (-1, 1)]
    write_off(first, *blob(4, legs + [((1, 0, 0.55), 1.4, 0.03), ((-1, 0, 0.2), 0.7, 0.01)], (1.5, 0.8, 0.9), (0, 0, 0)))
    fins = [((0, 1, -0.1), 0.9, 0.012), ((0, -1, -0.1), 0.9, 0.012), ((-0.1, 0, 1), 0.7, 0.02), ((-1, 0, 0.25), 0.8, 0.02), ((-1, 0, -0.25), 0.8, 0.02)]
    write_off(second, *blob(4, fins + [((1, 0, 0), 0.4, 0.02)], (2.2, 0.7, 0.8), (0.31, 0.47, -0.23)))


def fan(path, n=30):
    """Figures 1 and 2: nearly all segments meet in two points, at small angles."""
    points = [(0.0, 0.0, 0.3), (0.1, -0.2, 3.0)]
    for i in range(n):
        angle, r = 2 * math.pi * i / n, (1.0, 2.3, 0.4)[i % 3]
        points.append((r * math.cos(angle), r * math.sin(angle), 0.11 * ((i * 7) % 5)))
    faces = [f for i in range(n) for k in [(i + 1) % n] for f in ((0, 2 + k, 2 + i), (1, 2 + i, 2 + k))]
    write_off(path, points, faces)


def pyramids_and_block(path, half=0.5, far=4.0):
    """Figure 4: four pyramids whose apices touch, and a block across them; they are given as they are and intersected."""
    points = [(0.0, 0.0, 0.0)]
    faces = []
    for q in range(4):
        base = len(points)
        for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            x, y, z = far, y * half * far, z * half * far
            for _ in range(q):
                x, y = -y, x
            points.append((x, y, z))
        faces += [(0, base + (c + 1) % 4, base + c) for c in range(4)] + [tuple(range(base, base + 4))]
    at = len(points)
    points += [(x, y, z) for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
    faces += [tuple(at + i for i in f) for f in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))]
    write_off(path, points, faces)
