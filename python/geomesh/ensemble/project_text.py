# SPDX-License-Identifier: GPL-3.0-or-later
"""The project as text that a realisation changes: every key and value that it does not change is kept as written."""
import copy
import os
from dataclasses import dataclass

import yaml

from ..core.errors import UsageError
from . import reader

_FILE_KEYS = ("file", "background")
_OWN_FRAME = ("crs", "unit", "z_unit", "z_datum")


@dataclass
class SurfaceEntry:
    name: str
    kind: str
    file: str
    object: str
    keys: dict


class ProjectText:
    """The project of a study: the data that the study needs, and copies of the project's text with changes."""

    def __init__(self, file):
        self.file, self.folder = file, os.path.dirname(os.path.abspath(file))
        self.name = os.path.splitext(os.path.basename(file))[0]
        if self.name == "project":
            self.name = os.path.basename(self.folder) or self.name
        self._node = reader.composed(file)
        if not isinstance(self._node, yaml.MappingNode):
            raise UsageError("%s: a map was expected" % file)
        plain = reader.Entry(copy.deepcopy(self._node), "", reader.Problems(file)).plain()
        self.crs = plain.get("crs") or {}
        self.surfaces = {str(s["name"]): _surface(s) for s in plain.get("surfaces") or [] if isinstance(s, dict) and "name" in s}
        self.wells = {str(w["name"]): self.path(str(w["file"])) for w in plain.get("wells") or []
                      if isinstance(w, dict) and "name" in w and "file" in w}
        self.column = [str(c) for c in plain.get("column") or []]
        self.box = _corners(plain.get("box"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self, study):
        """Returns every file that a realisation may read, in order."""
        names = [value.value for node in (self._node, study.mesh) for value in _file_names(node)]
        names += [str(v) for spec in study.surfaces if spec.file for v in spec.file.values]
        return sorted({path for path in map(self.path, names) if os.path.isfile(path)})

    def z_is_depth(self, surface):
        word = self.surfaces[surface].keys.get("z", self.crs.get("z") if isinstance(self.crs, dict) else None)
        return str(word) == "depth"

    def why_not_movable(self, surface):
        """Returns why a study cannot move a surface; None if it can."""
        entry = self.surfaces[surface]
        if not entry.file:
            return "the project has no file for the surface %s" % surface
        own = [key for key in _OWN_FRAME if key in entry.keys]
        if own:
            return ("the surface %s has its own `%s` in the project: a study moves surfaces in the project's system and unit alone; "
                    "convert the file first" % (surface, own[0]))
        if isinstance(self.crs, dict) and str(self.crs.get("unit", "m")) not in ("m", "metre", "meter"):
            return "a study moves surfaces of projects in metres alone; this one has unit %s" % self.crs["unit"]
        if isinstance(self.crs, dict) and str(self.crs.get("horizontal", "local")) == "geographic":
            return "a study does not move surfaces of projects in longitude and latitude"
        return None

    def complaint_about(self, path):
        """Returns why a path of `set` is invalid; None if it leads to a place in a map."""
        try:
            _place(copy.deepcopy(self._node), path)
        except UsageError as error:
            return str(error)
        return None

    def changed(self, mesh, keys, files):
        """Returns a copy of the project's node with `mesh` in place of its own, values at paths, and files of surfaces;
        a file of None removes the key, for a surface that is given in memory."""
        node = copy.deepcopy(self._node)
        if mesh is not None:
            _set(node, "mesh", copy.deepcopy(mesh))
        for path, value in keys.items():
            parent, key = _place(node, path)
            _set(parent, key, _node_of(value))
        return with_surface_files(node, files)

    def with_absolute_files(self, node):
        """Makes file names absolute, for a project that is written into another folder."""
        for value in _file_names(node):
            value.value = os.path.abspath(self.path(value.value))
        return node


def with_surface_files(node, files):
    """Changes the files of these surfaces in a project's node and returns the node. None removes the file of a surface."""
    for surface, file in files.items():
        entry = _named(_get(node, "surfaces"), surface)
        _remove(entry, "file")
        if file is not None:
            _set(entry, "file", _node_of(file))
    return node


def _file_names(node):
    """Returns the nodes that name a file, at any depth: of surfaces, wells, fault polygons, tops, fields and sizes."""
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        if key.value in _FILE_KEYS and isinstance(value, yaml.ScalarNode):
            yield value
        else:
            yield from _file_names(value)
    for value in node.value if isinstance(node, yaml.SequenceNode) else ():
        yield from _file_names(value)


def as_text(node):
    return yaml.serialize(node, Dumper=yaml.SafeDumper, allow_unicode=True)


def _surface(entry):
    return SurfaceEntry(str(entry["name"]), str(entry.get("kind", "")), str(entry.get("file") or ""), str(entry.get("object") or ""),
                        entry)


def _corners(box):
    try:
        corners = tuple(tuple(float(v) for v in box[side]) for side in ("min", "max"))
    except (KeyError, TypeError, ValueError):
        return None
    return corners if all(len(c) == 3 for c in corners) else None


def _node_of(value):
    if isinstance(value, yaml.Node):
        return value
    return yaml.compose(yaml.safe_dump(value, allow_unicode=True), Loader=yaml.SafeLoader)


def _get(node, key):
    if isinstance(node, yaml.MappingNode):
        for name, value in node.value:
            if name.value == key:
                return value
    return None


def _remove(node, key):
    node.value = [(name, value) for name, value in node.value if name.value != key]


def _set(node, key, value):
    for row, (name, _) in enumerate(node.value):
        if name.value == key:
            node.value[row] = (name, value)
            return
    node.value.append((yaml.ScalarNode("tag:yaml.org,2002:str", key), value))


def _named(sequence, name):
    """Returns the entry of a list that has this `name`."""
    for entry in sequence.value if isinstance(sequence, yaml.SequenceNode) else ():
        found = _get(entry, "name")
        if found is not None and found.value == name:
            return entry
    return None


def _place(node, path):
    """Returns (map, key) for a path of keys and names of list entries: surfaces.main_fault.smooth. Missing maps are
    created."""
    parts = path.split(".")
    for depth, part in enumerate(parts[:-1]):
        below = _named(node, part) if isinstance(node, yaml.SequenceNode) else _get(node, part)
        if below is None and isinstance(node, yaml.MappingNode):
            below = yaml.MappingNode("tag:yaml.org,2002:map", [])
            _set(node, part, below)
        if below is None:
            raise UsageError("the project has no entry called %s at %s" % (part, ".".join(parts[:depth])))
        node = below
    if not isinstance(node, yaml.MappingNode):
        raise UsageError("%s is no map in the project, so that nothing can be set in it" % ".".join(parts[:-1]))
    return node, parts[-1]
