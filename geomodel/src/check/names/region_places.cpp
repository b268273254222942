// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/region_places.hpp"

#include <algorithm>
#include <tuple>

#include "check/exact/exact.hpp"

namespace geomesh::geomodel::checking {

bool comes_before(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

std::map<std::int32_t, RegionPlace> region_places(const CheckedMesh& mesh, std::size_t n_samples) {
  std::map<std::int32_t, std::vector<std::pair<double, Index>>> cells;  // six volumes, cell
  for (Index c = 0; c < mesh.cells.size(); ++c) {
    const Tetrahedron& v = mesh.cells[c];
    const double volume = six_volumes(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
    cells[mesh.file.region[c]].push_back({volume, c});
  }
  std::map<std::int32_t, RegionPlace> places;
  for (auto& [region, list] : cells) {
    RegionPlace place;
    place.least = mesh.point(mesh.cells[list[0].second][0]);
    place.greatest = place.least;
    const Vec3 from = place.least;
    double total = 0;
    Vec3 moment;
    for (const auto& [volume, cell] : list) {
      for (const VertexIndex v : mesh.cells[cell]) {
        if (comes_before(mesh.point(v), place.least)) place.least = mesh.point(v);
        if (comes_before(place.greatest, mesh.point(v))) place.greatest = mesh.point(v);
      }
      total += volume;
      moment = moment + volume * (centroid(mesh, mesh.cells[cell]) - from);
    }
    place.volume = total / 6;
    place.centroid = total > 0 ? from + (1 / total) * moment : from;
    const std::size_t n = std::min(n_samples, list.size());
    std::partial_sort(
        list.begin(), list.begin() + static_cast<std::ptrdiff_t>(n), list.end(),
        [](const auto& x, const auto& y) { return std::tie(y.first, x.second) < std::tie(x.first, y.second); });
    for (std::size_t i = 0; i < n; ++i) place.samples.push_back(centroid(mesh, mesh.cells[list[i].second]));
    places.emplace(region, std::move(place));
  }
  return places;
}

std::vector<std::int32_t> regions_at(const CheckedMesh& mesh, const Vec3& p) {
  std::vector<std::int32_t> regions;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Tetrahedron& v = mesh.cells[c];
    Box3 box, point;
    for (const VertexIndex i : v) box.add(mesh.point(i));
    point.add(p);
    if (!overlap(box, point)) continue;
    const bool holds = std::all_of(outward_face.begin(), outward_face.end(), [&](const auto& f) {
      return orientation(mesh.point(v[f[0]]), mesh.point(v[f[1]]), mesh.point(v[f[2]]), p) != Sign::positive;
    });
    if (holds && std::find(regions.begin(), regions.end(), mesh.file.region[c]) == regions.end())
      regions.push_back(mesh.file.region[c]);
  }
  return regions;
}

}  // namespace geomesh::geomodel::checking
