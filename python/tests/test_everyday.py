# SPDX-License-Identifier: GPL-3.0-or-later
"""Everyday features of a Python package: versions, reading files back, pickles, tables, notebooks, conversion, types."""
import copy
import doctest
import html
import importlib
import json
import os
import pickle
import re
import subprocess
import sys
import types

import numpy
import pytest

import geomesh
from shapes import sheet, volumes

BOX = [[0, 0, -1000], [1000, 1000, 0]]
SOURCE = os.environ["GEOMESH_SOURCE_DIR"]


def tilted(x, y):
    return -400 + 0.1 * x


def layered(**keys):
    model = geomesh.Model(box=BOX, column=["upper", "top", "lower"], **keys)
    return model.add_surface("top", *sheet(tilted))


@pytest.fixture(scope="module")
def mesh():
    """A model of two units with an attribute and shapes, a fault that ends inside, a well and a named place."""
    model = layered(attributes={"upper": {"density": 2000.0}, "lower": {"density": 2600.0}})
    model.add_surface("fault", [[500, 200, -800], [500, 800, -800], [520, 800, -100], [520, 200, -100]], [[0, 1, 2], [0, 2, 3]],
                      kind="fault")
    model.add_well("W1", [[300, 300, 0], [300, 310, -900]]).add_point("gauge", (700, 700, -700))
    return model.mesh(size=300, cell_arrays=["size", "min_dihedral"])


def same(one, other):
    for name in ("points", "point_kind", "input_vertex", "tetrahedra", "region", "faces", "face_surface", "face_surface_set", "face_patch",
                 "face_region_minus", "face_region_plus", "face_source_triangle", "curve_edges", "curve_of_edge"):
        assert numpy.array_equal(getattr(one, name), getattr(other, name)), name
    for name in ("surface_sets", "groups", "regions", "surfaces", "curves", "marked_points", "name", "unit", "shift", "statistics", "warnings"):
        assert getattr(one, name) == getattr(other, name), name
    assert json.dumps(one.attributes) == json.dumps(other.attributes)
    assert sorted(one.cell_arrays) == sorted(other.cell_arrays)
    for name, values in one.cell_arrays.items():
        assert numpy.array_equal(values, other.cell_arrays[name])


def test_the_version_is_that_of_the_project():
    with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
        assert geomesh.__version__ == re.search(r"project\(geomesh[^)]*VERSION (\S+)", file.read()).group(1)
    assert geomesh.core.__version__ == geomesh.__version__


@pytest.mark.parametrize("name", ["model.vtu", "model.msh", "model.e", "model.inp"])
def test_a_mesh_file_is_read_back_with_names_and_measures(mesh, tmp_path, name):
    again = geomesh.read(mesh.write(tmp_path / name)[0])
    assert isinstance(again, geomesh.Mesh) and "read" not in repr(again)
    assert volumes(again.points, again.tetrahedra).min() > 0
    for region in mesh.regions:
        assert again.regions[region.name].n_tetrahedra == region.n_tetrahedra
        assert again.regions[region.name].volume == pytest.approx(region.volume)
    faces = [s.name for s in mesh.surfaces if s.area > 0]
    named = {re.sub(r"\.(faces|minus)$", "", s.name): s.area for s in again.surfaces}
    for name_of in faces:
        assert named[name_of] == pytest.approx(mesh.surfaces[name_of].area)
    again.write(tmp_path / "again.vtu")
    assert geomesh.check(tmp_path / "again.vtu")["passes"]


def test_reading_brings_the_report_beside_the_mesh_and_tells_what_is_not_read(tmp_path):
    mesh = layered().run(tmp_path, formats=["vtu"], size=400)
    again = geomesh.read(tmp_path / "model.vtu")
    assert again.statistics["tetrahedra"] == len(mesh.tetrahedra)
    (tmp_path / "model.docx").write_text("")
    with pytest.raises(geomesh.UsageError, match=r"docx.*\.vtu"):
        geomesh.read(tmp_path / "model.docx")
    with pytest.raises(geomesh.UsageError):
        geomesh.read(tmp_path / "nothing.vtu")
    with pytest.raises(TypeError, match="geomesh.read"):
        geomesh.Mesh("model.vtu")


def test_meshes_are_pickled_and_copied_whole(mesh):
    for other in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh), copy.copy(mesh)):
        same(mesh, other)
    assert not numpy.shares_memory(copy.deepcopy(mesh).points, mesh.points)
    own = pickle.loads(pickle.dumps(mesh))
    assert numpy.array_equal(own.points, mesh.points) and own.write is not None


def test_a_damaged_or_foreign_pickle_is_refused(mesh):
    state = mesh._result.__getstate__()
    for bad in (state[:-1], state[:100], b"", state + b"x", state.replace(b"geomesh mesh 1", b"geomesh mesh 0", 1)):
        with pytest.raises(geomesh.UsageError, match="pickled"):
            type(mesh._result).__new__(type(mesh._result)).__setstate__(bad)


def test_a_mesh_travels_to_another_process(mesh, tmp_path):
    with open(tmp_path / "mesh.pickle", "wb") as file:
        pickle.dump(mesh, file)
    code = "import pickle; m = pickle.load(open('mesh.pickle', 'rb')); print(len(m.tetrahedra), m.regions['lower'].volume)"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert done.stdout.split() == [str(len(mesh.tetrahedra)), repr(mesh.regions["lower"].volume)], done.stderr


def test_models_are_pickled_and_copied_with_their_arrays():
    heights = numpy.full((12, 12), -700.0)
    heights[3, 3] = numpy.nan
    model = layered().add_grid("deep", heights, origin=(-100, -100), spacing=110, fill_holes="all")
    model.add_surface("middle", sheet(lambda x, y: -550 + 0 * x)[0], kind="horizon").add_well("W1", [[300, 300, 0], [300, 310, -900]])
    model.column = ["a", "top", "b", "middle", "c", "deep", "d"]
    whole = model.mesh(size=400)
    for other in (pickle.loads(pickle.dumps(model)), copy.deepcopy(model), copy.copy(model)):
        assert other.project() == model.project() and repr(other) == repr(model)
        again = other.mesh(size=400)
        assert numpy.array_equal(again.points, whole.points) and numpy.array_equal(again.tetrahedra, whole.tetrahedra)
    other = copy.deepcopy(model)
    other.add_point("gauge", (500, 500, -500))
    assert model.mesh(size=400).marked_points == []


def test_write_takes_the_options_of_a_project(mesh, tmp_path):
    meshio = pytest.importorskip("meshio")
    second = meshio.read(mesh.write(tmp_path / "second.vtu", order=2)[0])
    assert {c.type for c in second.cells} == {"tetra10"}
    mesh.write(tmp_path / "split.vtu", split="fault")
    split = geomesh.read(tmp_path / "split.vtu")
    assert {"fault.minus", "fault.plus"} <= {s.name for s in split.surfaces}
    mesh.write(tmp_path / "cohesive.vtu", split=["fault"], cohesive=True)
    assert "wedge" in {c.type for c in meshio.read(tmp_path / "cohesive.vtu").cells}
    mesh.write(tmp_path / "zone.vtu", fault_zone={"fault": {"thickness": 5.0, "layers": 2}})
    assert geomesh.read(tmp_path / "zone.vtu").regions["fault.zone"].volume > 0
    whole, pieces = (meshio.read(mesh.write(tmp_path / (g + ".msh"), groups=g)[0]).field_data for g in ("whole", "pieces"))
    assert len(pieces) > len(whole)
    assert mesh.write(tmp_path / "m.mesh", format="medit")[1].endswith(".sol")
    assert mesh.write(tmp_path / "m.e")[0].endswith("m.e")
    page = mesh.write(tmp_path / "m.html")[0]
    with open(page, encoding="utf-8") as file:
        assert "lower" in file.read()


@pytest.mark.parametrize("keys, words", [
    (dict(order=3), "order"), (dict(colour="red"), "colour"), (dict(groups="some"), "groups"), (dict(split=["nothing"]), "nothing"),
    (dict(cohesive=True), "split"), (dict(format="docx"), "docx"), (dict(single_grid="yes please"), "single_grid"),
    (dict(fault_zone={"fault": {"width": 3}}), "thickness"), (dict(format="stl", order=2), "second order")])
def test_write_tells_what_is_wrong_with_an_option(mesh, tmp_path, keys, words):
    with pytest.raises(geomesh.UsageError, match=words):
        mesh.write(tmp_path / "m.vtu", **keys)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("form", ["gmsh", "gmsh22"])
def test_to_meshio_is_written_as_gmsh_with_names_and_read_by_gmsh(mesh, tmp_path, form):
    meshio = pytest.importorskip("meshio")
    there = mesh.to_meshio()
    assert numpy.shares_memory(there.points, mesh.points)
    there.write(tmp_path / "m.msh", file_format=form)
    back = geomesh.read(tmp_path / "m.msh")
    for region in mesh.regions:
        assert back.regions[region.name].volume == pytest.approx(region.volume)
    assert back.surfaces["top"].area == pytest.approx(mesh.surfaces["top"].area)
    curves = {c.name for c in mesh.curves if (mesh.curve_of_edge == c.id).any()}
    assert curves <= {c.name for c in back.curves}


def test_a_body_and_its_surface_keep_two_names_in_meshio(tmp_path):
    pytest.importorskip("meshio")
    corners = numpy.array([[x, y, z] for z in (-700.0, -300.0) for y in (300.0, 700.0) for x in (300.0, 700.0)])
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    mesh = geomesh.Model(box=BOX).add_surface("salt", corners, numpy.array(faces), kind="body").mesh()
    names = mesh.to_meshio().field_data
    assert names["salt"].tolist()[1] == 3 and names["salt.surface"].tolist() == [mesh.surfaces["salt"].id, 2]


class Data(dict):
    """Point, cell or field data of a stand-in for PyVista, which stores what is assigned."""


class Grid:
    def __init__(self, cells, kinds, points):
        self.cells, self.kinds, self.points = numpy.asarray(cells), kinds, points
        self.cell_data, self.point_data, self.field_data = Data(), Data(), Data()


class PolyData:
    is_manifold = False

    def __init__(self, points, faces=None, lines=None):
        self.points, self.faces, self.lines = points, faces, lines
        self.cell_data, self.point_data, self.field_data = Data(), Data(), Data()

    @property
    def bounds(self):
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        return [low[0], high[0], low[1], high[1], low[2], high[2]]


class MultiBlock(dict):
    pass


@pytest.fixture
def pyvista(monkeypatch):
    """A stand-in with the names that geomesh uses, since PyVista itself is not in Debian 12."""
    class DataSet:
        pass
    module = types.SimpleNamespace(UnstructuredGrid=Grid, MultiBlock=MultiBlock, DataSet=DataSet,
                                   PolyData=type("PolyData", (PolyData, DataSet), {}))
    monkeypatch.setitem(sys.modules, "pyvista", module)
    return module


def test_to_pyvista_hands_over_everything_by_name(mesh, pyvista):
    blocks = mesh.to_pyvista()
    assert list(blocks) == ["mesh", "surfaces", "curves", "points"]
    grid = blocks["mesh"]
    assert numpy.shares_memory(grid.points, mesh.points) and numpy.shares_memory(grid.cell_data["region"], mesh.region)
    assert (grid.cells.reshape(-1, 5)[:, 1:] == mesh.tetrahedra).all() and (grid.kinds == 10).all()
    assert set(grid.cell_data["density"][mesh.tetrahedra_of("lower")]) == {2600.0}
    assert numpy.array_equal(grid.cell_data["min_dihedral"], mesh.cell_arrays["min_dihedral"])
    assert grid.field_data["region_names"].tolist() == [r.name for r in mesh.regions]
    assert set(blocks["surfaces"]) == {s.name for s in mesh.surfaces if s.area > 0}
    for name, surface in blocks["surfaces"].items():
        rows = surface.faces.reshape(-1, 4)
        assert (rows[:, 0] == 3).all()
        corners = surface.points[rows[:, 1:]]
        area = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        assert area == pytest.approx(mesh.surfaces[name].area)
        assert numpy.array_equal(mesh.points[surface.point_data["mesh_point"]], surface.points)
        assert numpy.array_equal(mesh.faces[surface.cell_data["mesh_face"]], surface.point_data["mesh_point"][rows[:, 1:]])
    well = blocks["curves"]["W1"]
    ends = well.points[well.lines.reshape(-1, 3)[:, 1:]]
    assert numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(mesh.curves["W1"].length)
    assert blocks["points"].point_data["name"].tolist() == ["gauge"]


def test_the_accessor_meshes_a_surface_of_pyvista(pyvista):
    geomesh.register_pyvista()
    geomesh.register_pyvista()  # twice is once
    points, triangles = sheet(tilted)
    flat = numpy.column_stack([numpy.full(len(triangles), 3), triangles]).ravel()
    surface = pyvista.PolyData(points, flat)
    assert len(surface.geomesh.mesh(size=400, box=BOX).regions) == 2
    model = surface.geomesh.add_to(geomesh.Model(box=BOX, column=["upper", "top", "lower"]), "top")
    assert [r.name for r in model.mesh().regions] == ["upper", "lower"]


def test_a_pyvista_with_a_way_of_its_own_is_asked_in_that_way(monkeypatch):
    asked = []
    module = types.SimpleNamespace(DataSet=type("DataSet", (), {}),
                                   register_dataset_accessor=lambda name, kind: lambda accessor: asked.append((name, kind, accessor)))
    monkeypatch.setitem(sys.modules, "pyvista", module)
    geomesh.register_pyvista()
    assert [(name, kind) for name, kind, _ in asked] == [("geomesh", module.DataSet)]


def test_tables_print_and_become_data_frames(mesh):
    text = repr(mesh.regions)
    lines = text.splitlines()
    assert lines[0].split() == ["id", "name", "unit", "inside", "n_tetrahedra", "volume"] and len(lines) == 1 + len(mesh.regions)
    assert "<th>volume</th>" in mesh.regions._repr_html_() and "<td>upper</td>" in mesh.regions._repr_html_()
    assert mesh.regions["lower"] is not None and mesh.regions[0].id == 1 and len(mesh.regions) == 2
    with pytest.raises(KeyError, match="upper"):
        mesh.regions["nothing"]
    assert repr(geomesh.Table([], ["id", "name"])) == "id  name"
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(mesh.regions)
    assert list(frame.columns) == ["id", "name", "unit", "inside", "n_tetrahedra", "volume"]
    assert frame.set_index("name").volume["lower"] == mesh.regions["lower"].volume


def test_a_notebook_shows_the_viewer_in_a_frame(mesh):
    shown = mesh._repr_html_()
    page = html.unescape(re.search(r'srcdoc="([^"]*)"', shown).group(1))
    assert page.startswith("<!doctype html>") and 'id="viewer"' in page and "min_dihedral" not in page.split("<script")[0]
    model = json.loads(re.search(r'<script type="application/json" id="model">(.*?)</script>', page, re.S).group(1))
    assert {"upper", "lower"} <= {r["name"] for r in model["regions"]}
    assert not re.search(r"""(?:src|href)=["']?https?:""", page)
    assert repr(mesh) == "<geomesh.Mesh 'model': %d tetrahedra, %d points, 2 regions>" % (len(mesh.tetrahedra), len(mesh.points))


def test_plot_opens_a_browser_outside_of_a_notebook_and_none_inside(mesh, monkeypatch, tmp_path):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    view = mesh.plot()
    assert len(opened) == 1 and opened[0].startswith("file://")
    with open(opened[0][len("file://"):], encoding="utf-8") as file:
        assert file.read() == view.page
    os.remove(opened[0][len("file://"):])
    assert open(view.save(tmp_path / "mesh.html"), encoding="utf-8").read() == view.page
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=object())))
    assert "<iframe" in mesh.plot(height=300)._repr_html_() and len(opened) == 1


def test_the_picture_of_a_mesh_is_drawn_once_or_not_at_all(mesh, monkeypatch):
    drawn = []

    def draw(result, file, view, size, options):
        drawn.append(size)
        with open(file, "wb") as out:
            out.write(b"\x89PNG")
    monkeypatch.setattr("geomesh.views.draw", draw)
    own = copy.copy(mesh)
    assert own._repr_png_() == own._repr_png_() == b"\x89PNG" and len(drawn) == 1
    monkeypatch.undo()
    monkeypatch.setenv("GEOMESH_PROGRAM", "/bin/false")
    assert copy.copy(mesh)._repr_png_() is None


def test_errors_have_no_positions_of_a_text_that_nobody_wrote():
    model = layered().add_surface("top", *sheet(tilted))
    with pytest.raises(geomesh.UsageError) as caught:
        model.mesh(quality="perfect")
    text = str(caught.value)
    assert not re.search(r"\d+:\d+:|line \d", text), text
    assert "surfaces[2].name: the name 'top' is used already" in text and "quality" in text
    with pytest.raises(geomesh.UsageError) as caught:
        geomesh.Model(box=BOX, column=["top", "top", "lower"]).add_surface("top", *sheet(tilted)).mesh()
    assert not re.search(r"\d+:\d+:|line \d", str(caught.value)), str(caught.value)


class Tqdm:
    """A stand-in for tqdm with the members that are used."""
    made = []

    def __init__(self, total, bar_format):
        self.total, self.n, self.seen, self.closed = total, 0, [], 0
        Tqdm.made.append(self)

    def set_description_str(self, text, refresh):
        self.seen.append((text, self.n))

    def close(self):
        self.closed += 1


def test_one_bar_shows_the_whole_run_and_is_closed(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Tqdm))
    monkeypatch.setattr(Tqdm, "made", [])
    layered().mesh(size=200, progress=True)
    bar, = Tqdm.made
    places = [n for _, n in bar.seen]
    assert places == sorted(places) and bar.n == bar.total and bar.closed == 1 and bar.seen[-1][0] == "done"
    assert [text for text, _ in bar.seen if text == "refine"]
    with pytest.raises(geomesh.UsageError):
        layered().mesh(quality="perfect", progress=True)
    assert Tqdm.made[1].closed == 1 and Tqdm.made[1].n < bar.total


def test_without_tqdm_there_is_a_line_for_each_stage(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    layered().mesh(progress=True)
    lines = capsys.readouterr().err.splitlines()
    assert "read ..." in lines and len(lines) == len([l for i, l in enumerate(lines) if i == 0 or lines[i - 1] != l])


def test_nan_vertices_of_isosurfaces_are_dropped_and_those_of_arrays_refused():
    points, triangles = sheet(tilted, n=8)
    whole = geomesh.Model(box=BOX).add_surface("top", *sheet(tilted, n=8)).mesh()
    points = numpy.concatenate([points, [[numpy.nan] * 3, [1.0, 2.0, numpy.nan]]])
    triangles = numpy.concatenate([triangles, [[0, len(points) - 2, 1], [len(points) - 1, 2, 3]]])
    shuffled = numpy.random.default_rng(1).permutation(len(points))
    place = numpy.argsort(shuffled)
    isosurface = types.SimpleNamespace(name="top", vertices=points[shuffled], triangles=place[triangles])
    mesh = geomesh.Model(box=BOX).add_surface("top", isosurface).mesh()
    assert mesh.surfaces["top"].area == pytest.approx(whole.surfaces["top"].area)
    with pytest.raises(geomesh.InvalidInput):
        geomesh.Model(box=BOX).add_surface("top", points, triangles)
    bounds = types.SimpleNamespace(global_origin=BOX[0], global_maximum=BOX[1])
    loop = types.SimpleNamespace(bounding_box=bounds, get_stratigraphic_surfaces=lambda: [isosurface], get_fault_surfaces=lambda: [])
    bridged = geomesh.bridges.from_loopstructural(loop, extend=None).mesh()
    assert bridged.surfaces["top"].area == pytest.approx(whole.surfaces["top"].area)


def test_spacings_may_be_negative_in_both_directions():
    x, y = numpy.meshgrid(numpy.linspace(-100, 1100, 7), numpy.linspace(-100, 1100, 7))
    heights = -400 + 0.1 * x + 0.05 * y
    model = geomesh.Model(box=BOX)
    whole = model.add_grid("top", heights, origin=(-100, -100), spacing=200).mesh()
    for turned, origin, spacing in ((heights[::-1], (-100, 1100), (200, -200)), (heights[:, ::-1], (1100, -100), (-200, 200)),
                                    (heights[::-1, ::-1], (1100, 1100), -200)):
        mesh = geomesh.Model(box=BOX).add_grid("top", turned, origin=origin, spacing=spacing).mesh()
        assert numpy.array_equal(mesh.points, whole.points) and numpy.array_equal(mesh.tetrahedra, whole.tetrahedra)
    with pytest.raises(geomesh.UsageError, match="rotation"):
        geomesh.Model(box=BOX).add_grid("top", heights, spacing=(200, -200), rotation=10)
    with pytest.raises(geomesh.UsageError, match="spacing"):
        geomesh.Model(box=BOX).add_grid("top", heights, spacing=(1, 2, 3))


@pytest.mark.parametrize("module", ["model", "mesh", "tables", "handover", "views", "pyvista_accessor"])
def test_examples_of_docstrings_run(module):
    found = doctest.testmod(importlib.import_module("geomesh." + module), optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert found.failed == 0
    assert found.attempted > 0 or module in ("handover", "views", "pyvista_accessor")


USER = """
import geomesh
from typing import Dict, List

model = geomesh.Model(box=[[0, 0, -1], [1, 1, 0]], column=["a", "top", "b"])
mesh = model.add_grid("top", [[-0.5, -0.5], [-0.5, -0.5]]).mesh(size=lambda x, y, z: 0.5, progress=True)
reveal_type(mesh.points)
reveal_type(mesh.regions)
reveal_type(mesh.regions[0].volume)
reveal_type(geomesh.read("a.vtu"))
files: List[str] = mesh.write("b.msh", order=2, split=["fault"], groups="pieces")
names: Dict[int, str] = mesh.names
version: str = geomesh.__version__
mesh.wrong
model.mesh(threads="many")
"""


def test_mypy_sees_the_types_of_the_package(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "user.py").write_text(USER)
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "user.py"], cwd=tmp_path,
                          capture_output=True, text=True, timeout=600,
                          env=dict(os.environ, MYPYPATH=os.path.join(SOURCE, "python")))
    lines = [line for line in done.stdout.splitlines() if line.startswith("user.py")]
    errors = [line for line in lines if ": error:" in line]
    assert len(errors) == 2 and '"Mesh" has no attribute "wrong"' in errors[0] and '"threads"' in errors[1], done.stdout
    told = [re.search(r'is "(.*)"', line).group(1) for line in lines if ": note: Revealed" in line]
    assert "floating" in told[0] and told[1].startswith("geomesh.tables.Table[") and "geomesh.mesh.Region" in told[1] and told[2] == "builtins.float"
    assert told[3] == "geomesh.mesh.Mesh"
