# SPDX-License-Identifier: MIT
import subprocess
import sys
import threading
import time

import numpy
import pytest

import geomesh.core as core
from shapes import CUBE, CUBE_FACES, volumes


def test_core_alone_loads_neither_the_geology_nor_its_libraries():
    code = ("import sys, geomesh.core; maps = open('/proc/self/maps').read();"
            "sys.exit('geomesh._geomodel' in sys.modules or 'libvtk' in maps or 'libgdal' in maps)")
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0


def test_delaunay_reads_float64_points_in_place_and_its_arrays_are_views_of_one_memory():
    points = numpy.random.default_rng(1).random((500, 3))
    result = core.delaunay(points)
    assert result.points.__array_interface__["data"][0] == points.__array_interface__["data"][0]
    first, again = result.tetrahedra, result.tetrahedra
    assert first.__array_interface__["data"][0] == again.__array_interface__["data"][0]
    assert not first.flags.owndata and not first.flags.writeable


def test_delaunay_fills_the_hull_with_positive_tetrahedra_whose_neighbors_are_mutual():
    points = numpy.random.default_rng(2).random((300, 3))
    result = core.delaunay(points)
    volume = volumes(points, result.tetrahedra)
    assert volume.min() > 0
    for row, beside in enumerate(result.neighbors[:50]):
        for other in beside:
            assert other == -1 or row in result.neighbors[other]
    assert (result.neighbors == -1).sum() == len(result.hull)
    a, b, c = (points[result.hull[:, i]] for i in range(3))
    assert volume.sum() == pytest.approx(numpy.einsum("ij,ij->i", numpy.cross(a, b), c).sum() / 6)


def test_both_algorithms_and_any_number_of_threads_give_the_same_delaunay_tetrahedra():
    points = numpy.random.default_rng(3).random((400, 3))
    as_sets = [sorted(map(sorted, core.delaunay(points, **options).tetrahedra.tolist()))
               for options in ({}, {"algorithm": "flip"}, {"threads": 1})]
    assert as_sets[0] == as_sets[1] == as_sets[2]


def test_equal_points_are_told_by_the_first_of_them():
    points = numpy.vstack([CUBE, CUBE[3]])
    assert core.delaunay(points).representative.tolist() == [0, 1, 2, 3, 4, 5, 6, 7, 3]


def test_a_view_keeps_its_mesh_alive_after_the_result_is_gone():
    tetrahedra = core.delaunay(numpy.random.default_rng(4).random((2000, 3))).tetrahedra
    copy = tetrahedra.copy()
    core.delaunay(numpy.random.default_rng(5).random((2000, 3)))
    assert (tetrahedra == copy).all()


def test_a_cube_of_square_facets_is_meshed_with_its_eight_points_and_all_its_faces():
    mesh = core.tetrahedralize(CUBE, CUBE_FACES)
    assert len(mesh.points) == 8
    assert volumes(mesh.points, mesh.tetrahedra).sum() == pytest.approx(1)
    assert sorted(set(mesh.face_facet.tolist())) == list(range(6))
    assert mesh.statistics["facets_total"] == 6
    assert mesh.faces.strides[0] > mesh.faces.shape[1] * 4, "a view with the stride of the library's own faces"


def test_facets_with_holes_segments_regions_and_hole_seeds_are_understood():
    inner = CUBE * 0.5 + 0.25
    faces = CUBE_FACES + [[i + 8 for i in f] for f in CUBE_FACES]
    mesh = core.tetrahedralize(numpy.vstack([CUBE, inner]), faces, holes=[[0.5, 0.5, 0.5]], segments=[[0, 1]],
                               regions=[[0.1, 0.1, 0.1]])
    assert volumes(mesh.points, mesh.tetrahedra).sum() == pytest.approx(1 - 0.125)
    assert mesh.component_seed.tolist() == [0]
    assert {0, 1} == set(mesh.edges.ravel().tolist())
    window = [[[0, 2, 3, 1], [8, 10, 11, 9]]] + CUBE_FACES[1:] + [[8, 10, 11, 9]]
    points = numpy.vstack([CUBE, inner * [1, 1, 0]])
    assert volumes(*[getattr(core.tetrahedralize(points[:12], window), n) for n in ("points", "tetrahedra")]).sum() == \
        pytest.approx(1)


def test_refine_follows_a_size_function_of_places():
    triangles = numpy.array([(f[0], f[i], f[i + 1]) for f in CUBE_FACES for i in (1, 2)])
    mesh = core.refine(CUBE, triangles, size=lambda x, y, z: 0.05 if x < 0.3 else 0.4)
    x = mesh.points[mesh.tetrahedra].mean(axis=1)[:, 0]
    assert (x < 0.3).sum() > 5 * (x > 0.7).sum()
    assert volumes(mesh.points, mesh.tetrahedra).sum() == pytest.approx(1)


def test_an_exception_in_a_size_function_ends_the_run_and_arrives_as_it_was_raised():
    def size(x, y, z):
        raise LookupError("no size there")
    with pytest.raises(LookupError, match="no size there"):
        core.refine(CUBE, CUBE_FACES, size=size)


def test_an_exception_in_the_progress_callback_ends_the_run():
    def progress(stage, done, total):
        raise StopIteration("enough")
    with pytest.raises(StopIteration):
        core.refine(CUBE, CUBE_FACES, size=0.02, progress=progress)


def test_crossing_facets_are_refused_with_their_rows_and_the_place():
    points = numpy.vstack([CUBE, [[0.2, 0.5, 0.5], [0.8, 0.5, 0.5], [0.5, 0.5, 1.5]]])
    with pytest.raises(core.InvalidInput) as caught:
        core.tetrahedralize(points, CUBE_FACES + [[8, 9, 10]])
    assert 6 in caught.value.facets
    assert caught.value.places.shape[1] == 3 and len(caught.value.places) > 0
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, core.Error)


@pytest.mark.parametrize("points, facets", [
    ([[0, 0], [1, 0]], [[0, 1, 2]]),
    (CUBE, numpy.array([[0, 1, -2]])),
    (CUBE, numpy.array([[0.0, 1.0, 2.0]])),
    (CUBE, numpy.array([[0, 1, 2, 3, 4]])),
])
def test_arrays_of_another_shape_or_type_are_refused_as_usage_errors(points, facets):
    with pytest.raises(core.UsageError):
        core.tetrahedralize(points, facets)


def test_rows_beyond_the_points_and_coordinates_that_are_no_numbers_are_refused():
    with pytest.raises(core.InvalidInput):
        core.tetrahedralize(CUBE, numpy.array([[0, 1, 99]]))
    with pytest.raises(core.InvalidInput):
        core.delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, float("nan")]])


def test_other_python_threads_run_while_a_mesh_is_made():
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.01)
    thread = threading.Thread(target=tick)
    points = numpy.random.default_rng(6).random((200_000, 3))
    thread.start()
    begin = time.monotonic()
    core.delaunay(points, threads=1)
    spent = time.monotonic() - begin
    stop.set()
    thread.join()
    assert sum(t > begin for t in ticks) > 0.1 * spent / 0.01


INTERRUPTED = """
import os, signal, threading, time, numpy, geomesh.core as core
points = numpy.random.default_rng(7).random((4_000_000, 3))
sent = []
def send():
    time.sleep(1)
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=send).start()
try:
    core.delaunay(points, threads=1)
except KeyboardInterrupt:
    print(time.process_time() - sent[0])
"""


def test_control_c_ends_a_long_run_within_two_seconds_of_work():
    done = subprocess.run([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True)
    assert done.returncode == 0
    assert float(done.stdout) < 2, "seconds of processor time: those of the clock depend on what else runs"
