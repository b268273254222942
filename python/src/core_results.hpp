// SPDX-License-Identifier: MIT
/// @file
/// The results of geomesh.core: those of the library, as numpy views.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "arrays.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::python {

/// A Delaunay tetrahedralization without its ghosts.
struct DelaunayResult {
  PointArray points;  ///< the caller's own array if it was float64 and contiguous
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::array<std::int32_t, 4>> neighbors;  ///< neighbours opposite each vertex; -1 on the hull
  std::vector<Triangle> hull;                          ///< faces on the hull; their normals point outwards
  std::vector<VertexIndex> representative;
  DelaunayStatistics statistics;
};

/// Returns the finite cells in the order of their slots.
DelaunayResult without_ghosts(PointArray points, DelaunayTetrahedralization&& whole);

struct MeshResult {
  ConstrainedTetrahedralization mesh;
  std::vector<std::string> warnings;
  py::dict statistics;  ///< a Python object, to be made only while the interpreter's lock is held
};

py::dict statistics_of(const ConstrainedTetrahedralization& mesh);
py::dict statistics_of(const RefineResult& result);

void define_results(py::module_& module);

}  // namespace geomesh::python
