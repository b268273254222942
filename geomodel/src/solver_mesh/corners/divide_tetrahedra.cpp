// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/corners/divide_tetrahedra.hpp"

#include <algorithm>
#include <map>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

namespace {

/// Rows of the four tetrahedra into which one was divided around its centre, by the corner of it that each part lacks.
using Parts = std::array<Index, 4>;

Parts divide(ConstrainedTetrahedralization& mesh, std::size_t row) {
  const Tetrahedron t = mesh.tetrahedra[row];
  mesh.points.push_back(
      centre_that_divides(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]));
  mesh.input_vertex.push_back(no_vertex);
  mesh.origin.push_back(VertexOrigin::inside);
  const auto centre = static_cast<VertexIndex>(mesh.points.size() - 1);
  Parts parts{};
  for (std::size_t i = 0; i < 4; ++i) {
    parts[i] = static_cast<Index>(i == 0 ? row : mesh.tetrahedra.size());
    if (i > 0) {
      mesh.tetrahedra.emplace_back();
      mesh.component.push_back(mesh.component[row]);
    }
    mesh.tetrahedra[parts[i]] = t;
    mesh.tetrahedra[parts[i]][i] = centre;
  }
  return parts;
}

}  // namespace

Vec3 centre_that_divides(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 centre = 0.25 * ((a + b) + (c + d));
  const bool divides = orient3d(centre, b, c, d) == Sign::positive && orient3d(a, centre, c, d) == Sign::positive &&
                       orient3d(a, b, centre, d) == Sign::positive && orient3d(a, b, c, centre) == Sign::positive;
  if (!divides)
    throw Error(ErrorKind::cannot_mesh,
                "split: a tetrahedron near (" + short_words(a.x) + ", " + short_words(a.y) + ", " + short_words(a.z) +
                    ") has all its corners on the fault, and is too flat to be divided; give the fault a smaller mesh "
                    "size there, or leave it out of split",
                ErrorContext{{}, {}, {}, {a}, {}});
  return centre;
}

void divide_tetrahedra(ConstrainedTetrahedralization& mesh, const std::vector<std::size_t>& rows) {
  if (rows.empty()) return;
  // Each divided tetrahedron and its four parts, by the row of the divided tetrahedron.
  std::map<Index, std::pair<Tetrahedron, Parts>> divided;
  for (const std::size_t row : rows) {
    const Tetrahedron whole = mesh.tetrahedra[row];
    divided[static_cast<Index>(row)] = {whole, divide(mesh, row)};
  }
  const auto move = [&](const Triangle& face, Index& side) {
    const auto found = divided.find(side);
    if (found == divided.end()) return;
    const auto& [whole, parts] = found->second;
    for (std::size_t i = 0; i < 4; ++i)
      if (std::find(face.begin(), face.end(), whole[i]) == face.end()) side = parts[i];
  };
  for (ConstrainedTetrahedralization::Face& face : mesh.faces) {
    move(face.vertices, face.tetrahedron_below);
    move(face.vertices, face.tetrahedron_above);
  }
  mesh.delaunay = false;
}

}  // namespace geomesh::geomodel
