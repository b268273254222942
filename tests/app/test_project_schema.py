# SPDX-License-Identifier: GPL-3.0-or-later
"""The schema of the project file against every sample and template, and against what the reader of the program itself knows: a key or
a value that one of the two has and the other has not fails here."""
import copy
import glob
import json
import os
import re
import struct
import unittest

from geomesh_program import SOURCE, USAGE, ProgramTest, level, main

try:
    import jsonschema
    import yaml
except ImportError:
    jsonschema = None

UNKNOWN = "qqqqqqqqqqqq"

# One of everything: each object of the schema has to occur here.
FULL = {
    "name": "full",
    "crs": {"horizontal": "local", "z": "elevation", "unit": "m"},
    "box": {"min": [0, 0, 0], "max": [10, 10, 10]},
    "surfaces": [{"name": "top", "kind": "horizon", "file": "top.txt", "extend": "flat", "fill_holes": "all", "base": "erode",
                  "extrude": {"along": "y", "from": -1, "to": 11}, "gridding": {"method": "thin_plate"}, "smooth": 1, "fault_polygons": {"file": "gap.txt"}},
                 {"name": "old", "kind": "horizon", "field": "field.npy", "origin": [0, 0, 0], "spacing": 10, "value": 2, "domain": {"below": "top"}}],
    "wells": [{"name": "w", "file": "w.pl"}],
    "tops": {"file": "tops.csv"},
    "points": [{"name": "p", "at": [1, 2, 3]}],
    "fractures": {"families": [{"name": "steep", "dip": 80, "radius": 2, "count": 2}], "seed": 1},
    "column": ["upper", "top", "lower"],
    "rules": {"on_crossing": "leave"},
    "regions": [{"name": "own", "at": [1, 1, 1]}],
    "groups": {"all": ["upper", "lower"]},
    "attributes": {"upper": {"porosity": 0.25}},
    "colours": {"upper": "#e5c07b", "top": [10, 20, 30]},
    "mesh": {"mode": "constrained"},
    "output": {"directory": "out"},
}


def load_schema():
    with open(os.path.join(SOURCE, "docs", "project.schema.json")) as file:
        return json.load(file)


def listed_words(text):
    return sorted(re.split(r", | or ", text))


def resolved(schema, node):
    while "$ref" in node:
        node = schema["definitions"][node["$ref"].rsplit("/", 1)[1]]
    return node


def walk(schema, node, value, name, visit, but=()):
    """visit(node, value, name) for the schema's node at each place of `value` and at each property that an object there may have; the
    names are those of the program's messages (surfaces[1].kind). Of a list it is the first entry, and what others alone have, which is
    `but` for the first."""
    node = resolved(schema, node)
    visit(node, value, name)
    if isinstance(value, list) and value and "items" in node:
        others = {key: (row, part) for row, entry in enumerate(value[1:], 2) if isinstance(entry, dict) and isinstance(value[0], dict)
                  for key, part in entry.items() if isinstance(part, dict) and key not in value[0]}
        walk(schema, node["items"], value[0], name + "[1]", visit, others)
        for key, (row, part) in others.items():
            walk(schema, resolved(schema, node["items"])["properties"][key], part, "%s[%d].%s" % (name, row, key), visit)
    prefix = name + "." if name else ""
    for key, child in node.get("properties", {}).items():
        if key in but:
            continue
        walk(schema, child, value.get(key) if isinstance(value, dict) else None, prefix + key, visit)
    if isinstance(value, dict) and isinstance(node.get("additionalProperties"), dict):
        key = next(iter(value))
        walk(schema, node["additionalProperties"], value[key], prefix + key, visit)


@unittest.skipIf(jsonschema is None, "skipped: the Python packages jsonschema and yaml are not installed")
class ProjectSchema(ProgramTest):
    def setUp(self):
        super().setUp()
        self.schema = load_schema()
        self.validator = jsonschema.Draft7Validator(self.schema)
        self.write("top.ts", level("top", 5))
        self.write("tops.csv", "well,horizon,depth\nw,top,2\n")
        self.write("w.pl", "GOCAD PLine 1\nHEADER {\nname:w\n}\nILINE\nVRTX 1 3 4 9\nVRTX 2 3 4 1\nSEG 1 2\nEND\n")
        self.write("gap.txt", "3 4\n5 4\n5 6\n")
        self.write("top.txt", "-1 5\n11 5\n")
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 2), }".ljust(117) + "\n"
        with open(self.path("field.npy"), "wb") as file:  # its value is z
            file.write(b"\x93NUMPY\x01\x00v\x00" + header.encode() + struct.pack("<8d", *(0, 10) * 4))

    def faults(self, project):
        return ["%s: %s" % ("/".join(map(str, e.path)), e.message) for e in self.validator.iter_errors(project)]

    def run_project(self, project, status):
        return self.run_program(self.write("full.yaml", yaml.safe_dump(project, sort_keys=False)), "--stop-after", "read", status=status)

    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(self.schema)

    def test_samples_agree(self):
        files = sorted(glob.glob(os.path.join(SOURCE, "samples", "*", "project.yaml")))
        self.assertGreater(len(files), 10)
        for name in files:
            with open(name) as file:
                text = file.read()
            self.assertEqual(self.faults(yaml.safe_load(text)), [], name)
            self.assertTrue(text.startswith("# yaml-language-server: $schema=../../docs/project.schema.json\n"), name)

    def test_templates_agree_and_bring_the_schema(self):
        help_text = self.run_program("init", "x", "--template", "no-such", status=USAGE)
        names = re.search(r"known are (.*)", help_text).group(1).split(", ")
        self.assertGreaterEqual(len(names), 3)
        for name in names:
            self.run_program("init", self.path(name), "--template", name)
            with open(self.path(name, "project.yaml")) as file:
                text = file.read()
            self.assertEqual(self.faults(yaml.safe_load(text)), [], name)
            self.assertIn("# yaml-language-server: $schema=project.schema.json\n", text)
            with open(self.path(name, "project.schema.json")) as file:
                self.assertEqual(json.load(file), self.schema)

    def test_every_property_is_described(self):
        def visit(node, _, name):
            for key, child in node.get("properties", {}).items():
                if key not in ("name", "at") and "type" in child and child["type"] != "object":
                    self.assertIn("description", child, name + "." + key)
        walk(self.schema, self.schema, FULL, "", visit)

    def test_the_reader_takes_what_the_schema_takes(self):
        self.assertEqual(self.faults(FULL), [])
        self.run_project(FULL, 0)

    def test_keys_are_those_of_the_reader(self):
        project, wanted = copy.deepcopy(FULL), {}

        def visit(node, value, name):
            if "properties" not in node:
                return
            self.assertIsInstance(value, dict, "FULL has no example of the object '%s'" % name)
            self.assertIs(node.get("additionalProperties"), False, name)
            wanted[name] = sorted(node["properties"])
            value[UNKNOWN] = 1
        walk(self.schema, self.schema, project, "", visit)
        found = {}
        for line in self.run_project(project, USAGE).splitlines():
            match = re.search(r"unknown key '%s'(?: in (\S+))?; known are (.*)" % UNKNOWN, line)
            if match:
                found[match.group(1) or ""] = listed_words(match.group(2))
        self.assertEqual(found, wanted)

    def test_choices_are_those_of_the_reader(self):
        wanted = {}
        project = copy.deepcopy(FULL)

        def visit(node, value, name):
            if not isinstance(value, dict):
                return
            for key, child in node.get("properties", {}).items():
                choices = resolved(self.schema, child).get("enum", [])
                if len(choices) > 1:
                    value[key] = UNKNOWN
                    wanted[(name + "." if name else "") + key] = sorted(choices)
        walk(self.schema, self.schema, project, "", visit)
        self.assertGreater(len(wanted), 6)
        found = {}
        for line in self.run_project(project, USAGE).splitlines():
            match = re.search(r"full\.yaml:\d+:\d+: (\S+): (.*) was expected, found '%s'" % UNKNOWN, line)
            if match:
                found[match.group(1)] = listed_words(match.group(2))
        self.assertEqual(found, wanted)

    def test_formats_are_those_of_the_reader(self):
        project = dict(FULL, output={"formats": [UNKNOWN]})
        printed = self.run_project(project, USAGE)
        words = re.search(r"output\.formats\[1\]: (.*) was expected, found", printed).group(1)
        self.assertEqual(listed_words(words), sorted(self.schema["properties"]["output"]["properties"]["formats"]["items"]["enum"]))

    def test_both_refuse_the_same_mistakes(self):
        def surface(**changes):
            return {"surfaces": [dict(FULL["surfaces"][0], **changes)]}
        mistakes = [
            {"surfaces": [{"name": "top", "kind": "horizon"}]}, surface(kind="salt"), surface(name="a,b"), surface(name=" top"),
            surface(fill_holes=-1), surface(fill_holes="some"), surface(extent="to_fault"), surface(extent="beyond"), surface(base="erodes"),
            surface(crs="mars"), surface(unit="ms"), surface(z="time"), surface(z_datum="kb"), surface(columns=3), surface(no_data="some"),
            surface(extrude={"along": "z", "from": 0, "to": 1}), surface(resample=0), surface(smooth=1.5),
            surface(gridding={"spacing": -1}), {"crs": {"z_scale": 0}}, {"crs": {"horizontal": "utm 32"}},
            {"box": {"min": [0, 0, 0]}}, {"box": {"min": [0, 0], "max": [1, 1, 1]}}, {"box": {"min": [0, 0, "a"], "max": [1, 1, 1]}},
            {"column": ["upper", "top", "upper"]}, {"rules": {"trim_overshoot": -5}}, {"rules": {"fault_blocks": "perhaps"}},
            {"rules": {"min_volume": "big"}}, {"groups": {"all": "upper"}}, {"colours": {"upper": "#e5c0"}}, {"colours": {"upper": [1, 2]}}, {"colours": {"upper": [1, 2, 300]}}, {"attributes": {"upper": {"region": 1}}},
            {"attributes": {"upper": {"porosity": "high"}}}, {"attributes": {"upper": 3}}, {"output": {"formats": []}},
            {"output": {"origin": [1, 2]}}, {"mesh": {"cluster_distance": "far"}}, {"mesh": {"preserve_boundary": 1}},
            {"points": [{"name": "p"}]},
            {"surfaces": [{"name": "top", "kind": "horizon", "field": "field.vti"}]},
            {"fractures": {"families": [{"name": "steep", "radius": 2, "count": 2}]}},
            {"fractures": {"families": [{"name": "steep", "radius": 2}], "seed": 1}}, {"fractures": {"corners": 2, "file": "f.csv"}},
            {"regions": [{"at": [1, 2, 3]}]}, {"wells": [{"name": "w"}]}, {"surfaces": "top.ts"},
        ]
        for mistake in mistakes:
            project = dict(FULL, **mistake)
            self.assertNotEqual(self.faults(project), [], mistake)
            self.run_project(project, USAGE)
        nothing = {"name": "nothing"}
        self.assertNotEqual(self.faults(nothing), [])
        self.run_project(nothing, USAGE)


if __name__ == "__main__":
    main()
