#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random whole models with random options: keys of the project file in combinations that nobody tried.

    python3 tests/fuzz/random_options.py SEED FOLDER     writes FOLDER/project.yaml and its surfaces

The surfaces are those of random_models.py. Each group of keys (box, surfaces, rules, sizes, output ...) is drawn by itself, so that options
meet each other by chance. Some combinations are mistakes, which the program has to tell (status 2).
"""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from random_models import RandomModel  # noqa: E402

FORMATS = ["msh", "msh-binary", "msh22", "msh22-binary", "inp", "exodus", "med", "xdmf", "ogs", "openfoam", "mfem", "pflotran", "tetgen",
           "pflotran-explicit", "tough", "geos", "html"]


def rounded(value):
    return float("%.3g" % value)


class RandomOptions(RandomModel):
    """A random model whose `project` (a map, as the project file has it) has random options."""

    def __init__(self, seed, as_default=False, light=False):
        super().__init__(seed, as_default, light)
        self.names = {kind: [s[0] for s in self.surfaces if s[1] == kind] for kind in ("horizon", "fault", "body")}
        self.least = min(self.size)
        self.length = rounded(self.least * self.chance.uniform(0.35, 0.9))
        self.project = {"name": "model", "box": self.box(), "surfaces": [self.surface(s) for s in self.surfaces]}
        self.add("wells", [{"name": name, "file": name + ".pl"} for name, _ in self.wells])
        self.add("points", [{"name": "p%d" % k, "at": self.inside()} for k in range(self.chance.choice([0, 0, 0, 1, 3]))])
        self.add("column", self.column)
        self.add("tolerance", self.likely(0.15, lambda: rounded(self.least * self.chance.choice([1e-6, 1e-4, 1e-3, 1e-2]))))
        self.add("rules", self.rules_asked())
        self.add("mesh", self.mesh())
        self.add_names()
        self.project["output"] = self.output()
        self.text = json.dumps(self.project, indent=1) + "\n"

    # ---- drawing

    def likely(self, share, make):
        return make() if self.chance.random() < share else None

    def add(self, key, value):
        if value:
            self.project[key] = value

    def some(self, names, most=3):
        return self.chance.sample(names, min(len(names), self.chance.randint(1, most)))

    def inside(self):
        return list(self.place(*(self.chance.uniform(0.02, 0.98) for _ in range(3))))

    def drawn(self, *choices):
        """A map of what was drawn: choices are (key, share of models that have it, values or a function that makes one)."""
        result = {}
        for key, share, values in choices:
            if self.chance.random() < share:
                value = values() if callable(values) else self.chance.choice(values)
                if value is not None:
                    result[key] = value
        return result

    # ---- what is asked

    def box(self):
        """One of all ways to give the volume; heights may be horizons."""
        chance = self.chance
        low, high = self.place(0, 0, 0), self.place(1, 1, 1)
        horizons = self.names["horizon"]
        bottom = low[2] if chance.random() < 0.8 or len(horizons) < 2 else horizons[-1]
        top = high[2] if chance.random() < 0.8 or len(horizons) < 2 else horizons[0]
        draw = chance.random()
        if draw < 0.5:
            return {"min": list(low), "max": list(high)}
        if draw < 0.6:
            return {"margin": chance.choice([0, rounded(0.1 * self.least), [rounded(0.05 * self.least), 0, rounded(0.1 * self.least)]])}
        if draw < 0.8:
            size = [rounded(self.size[k] * chance.uniform(0.4, 0.8)) for k in range(2)]
            return {"center": list(self.place(0.5, 0.5, 0)[:2]), "size": size, "azimuth": chance.choice([0, 30, 45, 90, -17.5]), "bottom": bottom, "top": top}
        corners = [(0.1, 0.05), (0.9, 0.1), (0.85, 0.9), (0.5, 0.55), (0.1, 0.95)]
        corners = corners if chance.random() < 0.5 else [corners[k] for k in (0, 1, 2, 4)]
        return {"polygon": [list(self.place(u, v, 0)[:2]) for u, v in corners], "bottom": bottom, "top": top}

    def surface(self, surface):
        name, kind, _, _, extra = surface
        entry = {"name": name, "kind": kind, "file": name + ".ts"}
        for part in extra.split(", ")[1:]:
            key, value = part.split(": ")
            entry[key] = value
        faults = [f for f in self.names["fault"] if f != name]
        if kind == "horizon":
            entry.update(self.drawn(
                ("extend", 0.15, ["flat", "tangent", "nearest"]), ("fill_holes", 0.1, ["all", rounded(self.least)]),
                ("base", 0.1, ["conformable", "erode", "onlap"]), ("smooth", 0.05, [1, 3]),
                ("resample", 0.05, lambda: rounded(self.length * self.chance.uniform(0.2, 1))),
                ("throw_at", 0.2, lambda: self.chance.choice(["auto", self.some(faults)]) if faults else None)))
            if "throw_at" in entry:
                entry.update(self.drawn(("smeared_throw", 0.3, ["cut", "keep"])))
        if kind == "fault":
            ends = ["to_box"] + ["to_fault " + f for f in faults] + ["to_horizon " + h for h in self.names["horizon"]]
            units = self.column[::2]
            entry.update(self.drawn(
                ("extend", 0.1, ["flat", "tangent", "nearest"]), ("extent", 0.3, ends),
                ("cuts", 0.1, lambda: units[:self.chance.randint(1, len(units))] if units else None)))
        if kind == "body":
            entry.update(self.drawn(("cuts", 0.3, ["all", "none"])))
        return entry

    def rules_asked(self):
        """The rules of the model itself, and others."""
        result = {key: float(value) if key == "trim_overshoot" else value for key, value in (rule.split(": ") for rule in self.rules)}
        horizons = self.names["horizon"]
        result.update(self.drawn(
            ("on_crossing", 0.15, ["leave", "clip_younger", "clip_older"]), ("trim_overshoot", 0.1, lambda: rounded(0.05 * self.least)),
            ("topography", 0.1, lambda: horizons[0] if horizons and "top" not in self.project["box"] else None), ("fault_blocks", 0.15, [True]),
            ("min_volume", 0.1, lambda: rounded(self.least ** 3 * self.chance.choice([1e-6, 1e-3]))), ("small_regions", 0.1, ["merge", "report"]),
            ("min_thickness", 0.15, lambda: rounded(self.least * self.chance.choice([0.002, 0.01]))), ("thin_layers", 0.1, ["keep", "collapse"]),
            ("stack", 0.2, ["auto", "keep"])))
        return result

    def sizes_asked(self):
        if self.chance.random() < 0.5:
            return self.length
        length, chance = self.length, self.chance
        surfaces = [s[0] for s in self.surfaces] + ["horizons", "faults", "zmin"]
        asked = {"global": length, "input_edges": chance.random() < 0.2}
        asked.update(self.drawn(
            ("units", 0.2, lambda: {u: rounded(0.6 * length) for u in self.some(self.column[::2])} if self.column else None),
            ("surfaces", 0.3, lambda: {s: chance.choice([rounded(0.6 * length), {"size": rounded(0.5 * length), "radius": rounded(0.3 * length)}]) for s in self.some(surfaces, 2)}),
            ("curves", 0.2, lambda: {c: rounded(0.5 * length) for c in self.some(["wells", "intersections", "borders", "fault_tips"], 2)}),
            ("near", 0.2, lambda: [{"at": self.inside(), "size": rounded(0.3 * length), "radius": rounded(0.2 * length)}]),
            ("on_surfaces", 0.1, [False]), ("curvature", 0.15, [20, 45]), ("gap_layers", 0.3, ["none", 0.5, 1]), ("gradation", 0.3, [0.2, 0.5, 1.0]),
            ("min", 0.2, lambda: rounded(0.2 * length)), ("max", 0.1, lambda: rounded(1.5 * length)),
            ("layers", 0.1, lambda: {u: chance.choice([1, 2]) for u in self.some(self.column[::2], 1)} if self.column else None),
            ("by_depth", 0.1, lambda: [[0, rounded(0.6 * length)], [rounded(self.least), rounded(length)]])))
        return asked

    def mesh(self):
        """One of: bare, conforming, within a tolerance (also by default), exact. What contradicts these is left out."""
        chance = self.chance
        draw = chance.random()
        if draw < 0.1:
            return {"refine": "none", **self.drawn(("preserve_boundary", 0.3, [True]), ("cluster_distance", 0.2, lambda: rounded(0.01 * self.least)))}
        sizes = self.sizes_asked()
        if draw < 0.15 and not (isinstance(sizes, dict) and "on_surfaces" in sizes):
            return {"mode": "conforming", "size": sizes}
        mesh = {"size": sizes, **self.drawn(
            ("quality", 0.5, ["fast", "default", "best"]), ("quality_measure", 0.2, ["dihedral", "radius_ratio", "mean_ratio"]),
            ("target_elements", 0.1, [3000, 20000]),
            ("cell_arrays", 0.15, lambda: self.some(["size", "min_dihedral", "max_dihedral", "radius_ratio", "mean_ratio", "aspect"])))}
        if draw < 0.4 or isinstance(sizes, dict) and "on_surfaces" in sizes:
            mesh["honour"] = "exact"
        else:
            mesh.update(self.drawn(("honour", 0.3, ["tolerance"]), ("tolerance", 0.3, lambda: rounded(self.length * chance.choice([0.005, 0.02, 0.1])))))
        return mesh

    def add_names(self):
        """Seeds, groups and attributes, by the names of the column."""
        units = self.column[::2]
        self.add("regions", self.likely(0.1, lambda: [{"name": "seed_%d" % k, "at": self.inside()} for k in range(self.chance.randint(1, 2))]))
        if not units:
            return
        self.add("groups", self.likely(0.15, lambda: {"group_%d" % k: self.some(units) for k in range(2)}))
        self.add("attributes", self.likely(0.15, lambda: {unit: {"density": 2000.0 + k, "vs": 1000.0} for k, unit in enumerate(units)}))

    def output(self):
        chance, faults = self.chance, self.names["fault"]
        output = self.drawn(
            ("groups", 0.2, ["whole", "pieces", "both"]), ("inner_faces", 0.1, [False]), ("curves", 0.1, [False]),
            ("region_array", 0.2, ["region", "MaterialIDs", "attribute"]), ("node_arrays", 0.1, [True]),
            ("compression", 0.2, ["none", "fast", "small"]), ("starter", 0.1, [True]), ("origin", 0.1, lambda: list(self.place(0, 0, 0))),
            ("split", 0.2, lambda: self.some(faults) if faults else None))
        if faults and "split" not in output and chance.random() < 0.08:
            output["fault_zone"] = {chance.choice(faults): {"thickness": rounded(0.02 * self.length), "layers": 2}}
        others, form = FORMATS, chance.random()
        if form < 0.15:
            output["partitions"], others = chance.choice([2, 5]), ["exodus"]
        elif form < 0.3:
            output["single_grid"] = True
        if "split" in output and "partitions" not in output and chance.random() < 0.4:
            output["cohesive"], others = True, ["inp", "exodus", "msh"]
        elif chance.random() < 0.1:
            output["order"], others = 2, ["exodus"] if "partitions" in output else ["inp", "exodus", "msh"]
        output.update({"directory": "out", "formats": ["vtu"] + self.formats(others)})
        return output

    def formats(self, others):
        """No two that write files of one name; few finite-volume grids, since most meshes are none."""
        names = self.chance.sample(others, min(len(others), self.chance.choice([0, 0, 1, 3])))
        if self.project["mesh"].get("mode") != "conforming":
            names = [name for name in names if name not in ("pflotran-explicit", "tough")]
        kept, stems = [], set()
        for name in names:
            if name[:3] not in stems:
                kept.append(name)
                stems.add(name[:3])
        return kept


if __name__ == "__main__":
    print(RandomOptions(int(sys.argv[1])).write(sys.argv[2]))
