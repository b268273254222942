// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_judge.hpp"

#include <algorithm>
#include <cmath>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

OrientedKey oriented_key(Triangle t) {
  bool even = true;
  const auto order = [&](int i, int k) {
    if (t[i] > t[k]) {
      std::swap(t[i], t[k]);
      even = !even;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {t, even};
}

Judgement::Judgement(const PiecewiseLinearComplex& p, const TetrahedralizeOptions& o,
                     const ConstrainedTetrahedralization& r)
    : plc(p), options(o), mesh(r) {
  double largest = 0;
  for (const Vec3& q : plc.points)
    for (double x : {q.x, q.y, q.z}) largest = std::max(largest, std::fabs(x));
  ulp = std::nextafter(largest, 2 * largest + 1) - largest;
  cell_faces.reserve(4 * mesh.tetrahedra.size());
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    for (const auto& f : faces_from_inside) cell_faces.push_back({oriented_key({t[f[0]], t[f[1]], t[f[2]]}), c});
  }
  std::sort(cell_faces.begin(), cell_faces.end(), [](const CellFace& a, const CellFace& b) {
    return a.key.sorted != b.key.sorted ? a.key.sorted < b.key.sorted : a.key.even > b.key.even;
  });
  for (const auto& f : mesh.faces) facet_faces.push_back({oriented_key(f.vertices).sorted, f.facet});
  std::sort(facet_faces.begin(), facet_faces.end(),
            [](const FacetFace& a, const FacetFace& b) { return a.sorted < b.sorted; });
}

void Judgement::fault(const std::string& check, const std::string& text) {
  if (check != last_check_) n_of_check_ = 0;
  last_check_ = check;
  if (++n_of_check_ <= 20) faults.push_back(check + ": " + text);
}

Index Judgement::cell_above(const Triangle& t) const {
  const OrientedKey key = oriented_key(t);
  auto it = std::lower_bound(cell_faces.begin(), cell_faces.end(), key.sorted,
                             [](const CellFace& f, const Triangle& s) { return f.key.sorted < s; });
  for (; it != cell_faces.end() && it->key.sorted == key.sorted; ++it)
    if (it->key.even == key.even) return it->cell;
  return no_index;
}

Index Judgement::facet_of(const Triangle& sorted) const {
  const auto it = std::lower_bound(facet_faces.begin(), facet_faces.end(), sorted,
                                   [](const FacetFace& f, const Triangle& s) { return f.sorted < s; });
  return it != facet_faces.end() && it->sorted == sorted ? it->facet : no_index;
}

std::vector<std::string> check_tetrahedralization(const PiecewiseLinearComplex& plc,
                                                  const TetrahedralizeOptions& options,
                                                  const ConstrainedTetrahedralization& result) {
  if (result.input_vertex.size() != result.points.size() || result.origin.size() != result.points.size() ||
      result.component.size() != result.tetrahedra.size())
    return {"arrays: lengths disagree"};
  for (const Tetrahedron& t : result.tetrahedra)
    for (VertexIndex v : t)
      if (v >= result.points.size()) return {"arrays: a cell names a point that does not exist"};
  for (const auto& f : result.faces)
    for (VertexIndex v : f.vertices)
      if (v >= result.points.size() || f.facet >= plc.n_facets())
        return {"arrays: a face names a point or facet that does not exist"};
  Judgement j(plc, options, result);
  judge_points(j);
  judge_cells(j);
  judge_facets(j);
  judge_segments(j);
  judge_components(j);
  judge_volumes(j);
  judge_delaunay(j);
  return j.faults;
}

}  // namespace geomesh::test
