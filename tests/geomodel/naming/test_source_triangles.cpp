// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangle of a surface a face stands for.
#include <catch2/catch.hpp>

#include "naming/source_triangles.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

TEST_CASE("a facet that lies along several triangles names the nearest one at each place", "[sets]") {
  // Found by seed 910930 of the random models (--light): a facet of a fault took one triangle of a horizon, 87 m off.
  TriangulatedSurface strip;
  strip.name = "h";
  strip.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {20, 0, 0}};
  strip.triangles = {{0, 1, 2}, {1, 3, 2}};
  const std::vector<TriangulatedSurface> surfaces = {strip};
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {20, 0, 0}, {10, 10, 0}};
  soup.facets = {{0, 1, 2}};
  soup.origins = {{0, 0, false}};
  soup.origin_offsets = {0, 1};
  const ModelPlc plc = make_plc(soup, surfaces, {});
  const ConstrainedTetrahedralization mesh;

  const MeshedModel exact{mesh, soup, plc, surfaces};
  CHECK(SourceTriangles(exact).of(0, {9, 1, 0}) == 0);
  CHECK(SourceTriangles(exact).of(0, {9, 1, 1e-12}) == 0);
  CHECK(SourceTriangles(exact).of(0, {12, 1, 0}) == 1);

  const MeshedModel moved{mesh, soup, plc, surfaces, 3};
  CHECK(SourceTriangles(moved).of(0, {12, 1, 0}) == 0);  // within what surfaces moved by
  CHECK(SourceTriangles(moved).of(0, {14, 1, 0}) == 1);
}

TEST_CASE("a polygon of a file is told by its row, wherever the place in it", "[sets]") {
  // The surface of a .poly file has the first three corners of each facet in place of a triangle.
  TriangulatedSurface file;
  file.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 10, 5}};
  file.triangles = {{0, 1, 2}, {2, 3, 4}};
  const std::vector<TriangulatedSurface> surfaces = {file};
  PolygonSoup soup;
  soup.points = file.points;
  soup.facets = file.triangles;
  soup.origins = {{0, 0, false}, {0, 1, false}};
  soup.origin_offsets = {0, 1, 2};
  ModelPlc plc;
  plc.plc.points = file.points;
  plc.plc.add_polygon(std::vector<std::vector<VertexIndex>>{{0, 1, 2, 3}}, 0);
  plc.plc.add_triangle({2, 3, 4});
  plc.facet_soup = {0, 1};
  plc.facet_soup_offsets = {0, 1, 2};
  const ConstrainedTetrahedralization mesh;
  const MeshedModel meshed{mesh, soup, plc, surfaces};
  CHECK(SourceTriangles(meshed).of(0, {1, 9, 0}) == 0);  // nearer to the other facet than to the first three corners
}
