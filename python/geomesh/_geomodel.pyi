from typing import Any, Dict, List, Optional, Tuple
import numpy
import numpy.typing as npt

class Given:
    surfaces: List[Tuple[str, npt.NDArray[numpy.float64], npt.NDArray[numpy.uint32]]]
    point_sets: List[Tuple[str, npt.NDArray[numpy.float64]]]
    polylines: List[Tuple[str, npt.NDArray[numpy.float64]]]
    z_is_named: bool
    def moved(self, kind: str, row: int, points: npt.NDArray[numpy.float64]) -> "Given": ...

def read_given(file: str) -> Given: ...

class JobResult:
    points: npt.NDArray[numpy.float64]
    point_kind: npt.NDArray[numpy.uint8]
    input_vertex: npt.NDArray[numpy.int32]
    tetrahedra: npt.NDArray[numpy.uint32]
    region: npt.NDArray[numpy.int32]
    cell_arrays: Dict[str, npt.NDArray[numpy.float64]]
    faces: npt.NDArray[numpy.uint32]
    face_surface: npt.NDArray[numpy.int32]
    face_surface_set: npt.NDArray[numpy.int32]
    face_patch: npt.NDArray[numpy.int32]
    face_region_minus: npt.NDArray[numpy.int32]
    face_region_plus: npt.NDArray[numpy.int32]
    face_source_triangle: npt.NDArray[numpy.int32]
    surface_sets: List[List[int]]
    curve_edges: npt.NDArray[numpy.uint32]
    curve_of_edge: npt.NDArray[numpy.int32]
    name: str
    unit: str
    shift: Tuple[float, float, float]
    regions: List[Tuple[int, str, str, List[str], int, float]]
    surfaces: List[Tuple[int, str, str, float]]
    curves: List[Tuple[int, str, str, float]]
    marked_points: List[Tuple[int, str, int]]
    attributes: Dict[str, List[float]]
    report: str
    summary: List[str]
    warnings: List[str]
    files: List[str]
    point_arrays: Dict[str, npt.NDArray[numpy.float64]]
    groups: Dict[str, List[int]]
    def write(self, format: str, stem: str, keywords: Dict[str, Any]) -> List[str]: ...
    def viewer_page(self) -> str: ...

def surface(name: str, points: npt.ArrayLike, triangles: npt.ArrayLike) -> Given: ...
def point_set(name: str, points: npt.ArrayLike) -> Given: ...
def polyline(name: str, points: npt.ArrayLike) -> Given: ...
def grid(name: str, heights: npt.ArrayLike, origin: List[float], spacing: List[float], rotation: float) -> Given: ...
def run_given(text: str, name: str, folder: str, inputs: Dict[str, Given], options: Dict[str, Any]) -> JobResult: ...
def run_file(file: str, options: Dict[str, Any]) -> JobResult: ...
def read_surfaces(file: str) -> List[Tuple[str, npt.NDArray[numpy.float64], npt.NDArray[numpy.uint32]]]: ...
def check(mesh: str, project: str) -> str: ...
def mesh_formats() -> List[str]: ...
def known_extensions() -> List[str]: ...
def format_of_extension(extension: str) -> str: ...
def read_mesh(file: str) -> JobResult: ...
