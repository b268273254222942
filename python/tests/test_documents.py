# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the Python code in the documents as it is printed."""
import os
import re
import shutil

import numpy
import pytest

SOURCE = os.environ["GEOMESH_SOURCE_DIR"]


def block_of_python(document, first_line):
    """Returns the fenced block of Python that begins with the given line."""
    with open(os.path.join(SOURCE, document), encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.M | re.S)
    found = [b for b in blocks if b.startswith(first_line)]
    assert len(found) == 1, "%s has %d blocks that begin with %s" % (document, len(found), first_line)
    return found[0]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    os.symlink(os.path.join(SOURCE, "samples"), tmp_path / "samples")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def has_display():
    return bool(os.environ.get("DISPLAY")) or shutil.which("xvfb-run") is not None


def can_draw():
    return has_display() and os.path.exists(os.path.join(os.path.dirname(os.environ["GEOMESH_PROGRAM"]), "geomesh-picture"))


def test_the_example_of_the_readme_makes_the_mesh_and_the_picture_of_the_salt_dome_in_twelve_lines(folder):
    code = block_of_python("README.md", "import geomesh")
    assert len(code.strip().splitlines()) <= 12
    if not can_draw():
        code = "\n".join(line for line in code.splitlines() if "picture" not in line)
    names = {}
    exec(code, names)
    assert len(names["mesh"].regions) == 5 and (folder / "salt_dome.vtu").exists()
    assert not can_draw() or (folder / "salt_dome.png").read_bytes()[:4] == b"\x89PNG"


def test_the_model_of_the_python_page_has_its_two_units_and_its_well(folder):
    names = {}
    exec(block_of_python("docs/python.md", "import numpy, geomesh"), names)
    mesh = names["mesh"]
    assert [r.name for r in mesh.regions] == ["upper", "lower"] and "W1" in [c.name for c in mesh.curves]
    assert numpy.isclose(sum(r.volume for r in mesh.regions), 4000 * 4000 * 3000)


def test_the_engine_calls_of_the_python_page_mesh_a_cube(capsys):
    exec(block_of_python("docs/python.md", "import numpy\nimport geomesh.core as core"), {})
    delaunay, constrained, refined = map(int, capsys.readouterr().out.split())
    assert 5 <= delaunay <= 6 and 5 <= constrained <= 6 and refined > 100
