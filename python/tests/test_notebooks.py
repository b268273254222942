# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the cells of the notebooks of docs/tutorials as they are printed; in the nightly preset nbconvert executes them
too."""
import importlib.util
import json
import os
import shutil
import subprocess
import sys

import pytest

FOLDER = os.path.join(os.environ["GEOMESH_SOURCE_DIR"], "docs", "tutorials")
NOTEBOOKS = sorted(name for name in os.listdir(FOLDER) if name.endswith(".ipynb"))
NIGHTLY = os.environ.get("GEOMESH_NIGHTLY", "0") == "1"


def cells_of(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return [cell for cell in json.load(file)["cells"] if cell["cell_type"] == "code"]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_the_cells_of_a_notebook_run_in_order(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    for cell in cells_of(name):
        exec("".join(cell["source"]), names)
    assert len(names["mesh"].tetrahedra) > 1000
    assert any(file.suffix == ".vtu" for file in tmp_path.iterdir())


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_committed_without_outputs(name):
    assert [cell for cell in cells_of(name) if cell["outputs"] or cell["execution_count"]] == []


@pytest.mark.skipif(not NIGHTLY, reason="skipped: nbconvert executes notebooks in the nightly preset")
@pytest.mark.parametrize("name", NOTEBOOKS)
def test_nbconvert_executes_a_notebook(name, tmp_path):
    for module in ("nbconvert", "ipykernel"):
        if importlib.util.find_spec(module) is None:
            pytest.skip("skipped: no " + module)
    shutil.copy(os.path.join(FOLDER, name), tmp_path)  # the notebook runs in a folder of its own
    done = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--inplace", name], cwd=tmp_path,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
    assert done.returncode == 0, done.stdout
    with open(tmp_path / name, encoding="utf-8") as file:
        outputs = [output for cell in json.load(file)["cells"] for output in cell.get("outputs", [])]
    assert "faces of base_sandstone" in "".join("".join(output.get("text", "")) for output in outputs)
    shown = ["".join(output.get("data", {}).get("text/html", "")) for output in outputs]
    assert any("<iframe" in page for page in shown)
    assert any("<table" in page and "sandstone" in page for page in shown)
