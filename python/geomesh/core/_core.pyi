from typing import Any, Dict, List
import numpy
import numpy.typing as npt

__version__: str

class Delaunay:
    points: npt.NDArray[numpy.float64]
    tetrahedra: npt.NDArray[numpy.uint32]
    neighbors: npt.NDArray[numpy.int32]
    hull: npt.NDArray[numpy.uint32]
    representative: npt.NDArray[numpy.uint32]
    statistics: Dict[str, int]

class Tetrahedralization:
    points: npt.NDArray[numpy.float64]
    tetrahedra: npt.NDArray[numpy.uint32]
    component: npt.NDArray[numpy.uint32]
    component_seed: npt.NDArray[numpy.uint32]
    input_vertex: npt.NDArray[numpy.uint32]
    origin: npt.NDArray[numpy.uint8]
    faces: npt.NDArray[numpy.uint32]
    face_facet: npt.NDArray[numpy.uint32]
    face_below: npt.NDArray[numpy.uint32]
    face_above: npt.NDArray[numpy.uint32]
    edges: npt.NDArray[numpy.uint32]
    edge_segment: npt.NDArray[numpy.uint32]
    statistics: Dict[str, Any]
    warnings: List[str]

class PlcArguments:
    def __init__(self, points: Any, triangles: Any, polygons: Any, segments: Any, regions: Any, holes: Any) -> None: ...

def delaunay(points: npt.ArrayLike, algorithm: str, cluster_distance: float, options: Dict[str, Any]) -> Delaunay: ...
def tetrahedralize(plc: PlcArguments, options: Dict[str, Any]) -> Tetrahedralization: ...
def refine(plc: PlcArguments, options: Dict[str, Any]) -> Tetrahedralization: ...
