# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess

import numpy
import pytest

import geomesh
from shapes import CUBE, CUBE_FACES, sheet, volumes

BOX = [[0, 0, -1000], [1000, 1000, 0]]
SOURCE = os.environ["GEOMESH_SOURCE_DIR"]


def tilted(x, y):
    return -400 + 0.1 * x


def layered(**keys):
    model = geomesh.Model(box=BOX, column=["upper", "top", "lower"], **keys)
    return model.add_surface("top", *sheet(tilted))


def ball(radius=200.0, center=(500.0, 500.0, -600.0)):
    t = (1 + 5 ** 0.5) / 2
    points = numpy.array([(s, u * t, 0) for s in (-1, 1) for u in (-1, 1)] +
                         [(0, s, u * t) for s in (-1, 1) for u in (-1, 1)] +
                         [(u * t, 0, s) for s in (-1, 1) for u in (-1, 1)])
    hull = geomesh.core.delaunay(points).hull
    return points / numpy.linalg.norm(points[0]) * radius + center, hull


def test_arrays_become_a_mesh_of_named_regions_seen_through_views():
    mesh = layered().mesh(size=300)
    assert [r.name for r in mesh.regions] == ["upper", "lower"]
    assert mesh.regions[0].volume == pytest.approx(350e6) and mesh.regions[1].volume == pytest.approx(650e6)
    for array in (mesh.points, mesh.tetrahedra, mesh.region, mesh.faces, mesh.face_surface, mesh.curve_edges):
        assert not array.flags.owndata and not array.flags.writeable
    assert mesh.points.__array_interface__["data"][0] == mesh.points.__array_interface__["data"][0]
    assert (mesh.face_region_minus.__array_interface__["data"][0] - mesh.faces.__array_interface__["data"][0]) < 32
    assert volumes(mesh.points, mesh.tetrahedra).min() > 0
    assert mesh.names[mesh.regions[1].id] == "lower"
    assert mesh.statistics["tetrahedra"] == len(mesh.tetrahedra)
    upper = mesh.tetrahedra[mesh.tetrahedra_of("upper")]
    assert volumes(mesh.points, upper).sum() == pytest.approx(350e6)
    top = mesh.points[mesh.faces[mesh.faces_of("top")]]
    assert numpy.abs(top[..., 2] - tilted(top[..., 0], 0)).max() < 1e-9


def test_a_model_of_arrays_and_a_project_of_files_give_the_same_mesh_byte_for_byte(tmp_path):
    points, triangles = sheet(lambda x, y: -300 + 20 * numpy.sin(x / 200) * numpy.cos(y / 150), n=12)
    with open(tmp_path / "top.off", "w") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(triangles)))
        for p in points:
            file.write("%r %r %r\n" % tuple(map(float, p)))
        for t in triangles:
            file.write("3 %d %d %d\n" % tuple(t))
    (tmp_path / "model.yaml").write_text(
        "box: {min: [0, 0, -1000], max: [1000, 1000, 0]}\ncolumn: [upper, top, lower]\n"
        "surfaces:\n  - {name: top, kind: horizon, file: top.off}\nmesh: {size: 150}\n")
    model = geomesh.Model(box=BOX, column=["upper", "top", "lower"]).add_surface("top", points, triangles)
    of_files = geomesh.run(tmp_path / "model.yaml")
    of_arrays = model.run(tmp_path / "arrays", size=150)
    assert (of_files.tetrahedra == of_arrays.tetrahedra).all() and (of_files.points == of_arrays.points).all()
    assert (tmp_path / "out" / "model.vtu").read_bytes() == (tmp_path / "arrays" / "model.vtu").read_bytes()
    program = os.environ["GEOMESH_PROGRAM"]
    if os.path.exists(program):
        subprocess.run([program, str(tmp_path / "model.yaml"), "-o", str(tmp_path / "program"), "--quiet"], check=True)
        assert (tmp_path / "program" / "model.vtu").read_bytes() == (tmp_path / "out" / "model.vtu").read_bytes()


def test_run_of_a_sample_keeps_the_mesh_in_memory_and_writes_nothing_where_asked(tmp_path):
    mesh = geomesh.run(os.path.join(SOURCE, "samples", "layer-cake", "project.yaml"), tmp_path, write=False)
    assert len(mesh.tetrahedra) > 0 and mesh.files == [] and os.listdir(tmp_path) == []


def test_a_grid_gives_the_surface_of_its_nodes_and_nan_leaves_a_hole():
    heights = numpy.full((13, 13), -500.0)
    model = geomesh.Model(box=BOX, column=["upper", "top", "lower"])
    model.add_grid("top", heights, origin=(-100, -100), spacing=100)
    assert model.mesh().regions[0].volume == pytest.approx(500e6)
    north_up = geomesh.Model(box=BOX, column=["upper", "top", "lower"])
    north_up.add_grid("top", heights + numpy.arange(13)[:, None], origin=(-100, 1100), spacing=(100, -100))
    mesh = north_up.mesh()
    faces = mesh.points[mesh.faces[mesh.faces_of("top")]]
    assert numpy.abs(faces[..., 2] - (-500 + (1100 - faces[..., 1]) / 100)).max() < 1e-9
    heights[5:8, 5:8] = numpy.nan
    holed = geomesh.Model(box=BOX, column=["upper", "top", "lower"])
    holed.add_grid("top", heights, origin=(-100, -100), spacing=100, fill_holes="all")
    assert len(holed.mesh().regions) == 2


def test_points_without_triangles_are_gridded_and_wells_and_points_are_in_the_mesh():
    rng = numpy.random.default_rng(1)
    xy = rng.uniform(-100, 1100, (200, 2))
    model = geomesh.Model(box=BOX, column=["upper", "top", "lower"])
    model.add_surface("top", numpy.column_stack([xy, tilted(xy[:, 0], 0)]), extend="tangent")
    model.add_well("W1", [[300, 300, 0], [320, 310, -900]]).add_point("gauge", (700, 700, -100))
    mesh = model.mesh(size={"global": 400, "curves": {"wells": {"size": 60}}})
    assert mesh.regions[0].volume == pytest.approx(350e6, rel=1e-3)
    well = [c for c in mesh.curves if c.name == "W1"][0]
    assert well.kind == "well" and well.length == pytest.approx(numpy.linalg.norm([20, 10, 900]))
    assert mesh.points[mesh.marked_points[0].vertex].tolist() == [700, 700, -100]
    assert (mesh.curve_of_edge == well.id).sum() > 10


def test_a_size_function_of_places_is_followed_in_the_coordinates_of_the_project():
    model = layered(output={"origin": [500, 0, 0]})
    mesh = model.mesh(size=lambda x, y, z: 60 if x < 250 else 400)
    assert mesh.shift == (500, 0, 0)
    x = mesh.points[mesh.tetrahedra].mean(axis=1)[:, 0] + 500
    assert (x < 250).sum() > 3 * (x > 500).sum()


def test_objects_of_other_packages_are_understood_by_their_attributes():
    points, triangles = sheet(tilted)
    flat = numpy.column_stack([numpy.full(len(triangles), 3), triangles]).ravel()

    class Of:
        def __init__(self, **attributes):
            self.__dict__.update(attributes)
    forms = [Of(points=points, faces=flat),                                   # attributes as PyVista has them,
             Of(points=points, cells=[Of(type="triangle", data=triangles)]),  # as meshio has them,
             Of(vertices=points, edges=triangles),                            # as GemPy,
             Of(vertices=points, triangles=triangles, name="x"),              # as LoopStructural
             Of(vertices=points, faces=triangles),                            # and as trimesh
             (points, triangles)]
    expected = layered().mesh()
    for form in forms:
        mesh = geomesh.Model(box=BOX, column=["upper", "top", "lower"]).add_surface("top", form).mesh()
        assert (mesh.points == expected.points).all() and (mesh.tetrahedra == expected.tetrahedra).all()
    with pytest.raises(geomesh.UsageError, match="no triangulated surface is known in a Of"):
        geomesh.Model(box=BOX).add_surface("top", Of(numbers=3))


def test_bodies_and_files_work_beside_arrays(tmp_path):
    meshio = pytest.importorskip("meshio")
    points, hull = ball()
    meshio.write(tmp_path / "salt.stl", meshio.Mesh(points, [("triangle", hull)]), binary=True)
    mesh = layered().add_surface("salt", tmp_path / "salt.stl", kind="body").mesh()
    assert "salt" in [r.name for r in mesh.regions]
    name, read, triangles = geomesh.read_surfaces(tmp_path / "salt.stl")[0]
    assert read.shape == (12, 3) and triangles.shape == (20, 3)


def test_a_mesh_goes_to_meshio_and_to_files_that_pass_the_check(tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = layered().mesh(size=300)
    files = mesh.write(tmp_path / "model.vtu")
    assert os.path.exists(tmp_path / "model.vtu") and len(files) >= 3
    assert geomesh.check(tmp_path / "model.vtu")["passes"]
    there = mesh.to_meshio()
    assert numpy.shares_memory(there.points, mesh.points)
    assert there.field_data["lower"].tolist() == [2, 3]
    mesh.write(tmp_path / "model.msh")
    back = meshio.read(tmp_path / "model.msh")
    assert sum(len(c.data) for c in back.cells if c.type == "tetra") == len(mesh.tetrahedra)
    with pytest.raises(geomesh.UsageError, match="vtu"):
        mesh.write(tmp_path / "model.docx")


def test_all_mistakes_of_a_model_come_at_once_with_the_names_of_their_keys():
    model = layered(colour="red").add_surface("fault", *sheet(tilted), kind="fold")
    with pytest.raises(geomesh.UsageError) as caught:
        model.mesh(quality="perfect")
    for word in ("colour", "fold", "perfect"):
        assert word in str(caught.value)


def test_broken_arrays_are_refused_with_the_surface_and_the_triangle():
    points, triangles = sheet(tilted)
    triangles[7, 1] = 999
    with pytest.raises(geomesh.InvalidInput) as caught:
        geomesh.Model(box=BOX).add_surface("top", points, triangles)
    assert caught.value.surfaces == ["top"] and caught.value.triangles == [("top", 7)]
    points[3, 2] = numpy.inf
    with pytest.raises(geomesh.InvalidInput, match="point 3"):
        geomesh.Model(box=BOX).add_surface("top", points, sheet(tilted)[1])


def test_more_elements_than_allowed_is_an_error_of_its_own_kind():
    with pytest.raises(geomesh.CannotMesh):
        layered().mesh(size=10, max_elements=1000)


def test_progress_tells_the_stages_in_order_and_the_log_tells_warnings():
    stages, lines = [], []
    layered().mesh(size=200, progress=lambda stage, done, total: stages.append(stage),
                   log=lambda level, text: lines.append((level, text)))
    order = [s for i, s in enumerate(stages) if i == 0 or stages[i - 1] != s]
    assert order[:3] == ["read", "build", "intersect"] and "refine" in order and "verify" in order
    assert any(level == "info" for level, _ in lines)


def test_a_cube_given_as_squares_is_split_into_triangles():
    model = geomesh.Model(box=BOX).add_surface("block", CUBE * 300 + [300, 300, -700], numpy.array(CUBE_FACES),
                                               kind="body")
    mesh = model.mesh()
    block = [r for r in mesh.regions if r.name == "block"][0]
    assert block.volume == pytest.approx(300 ** 3)
