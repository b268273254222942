// SPDX-License-Identifier: GPL-3.0-or-later
// Background sizes: what is read, and what lies between the points.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <random>

#include "geomesh/core/error.hpp"
#include "grid_sizes/size_grid.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// A linear function, which linear interpolation has to give back.
double linear(const Vec3& p) { return 5 + 0.25 * p.x - 0.5 * p.y + p.z; }

std::vector<Vec3> lattice_points() {
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0, 4.0})
    for (const double x : {0.0, 2.0, 3.0, 7.0})
      for (const double y : {-1.0, 0.5}) points.push_back({x, y, z});
  return points;
}

SizeGrid grid_of(const std::vector<Vec3>& points) {
  std::vector<double> sizes;
  for (const Vec3& p : points) sizes.push_back(linear(p));
  return SizeGrid(points, sizes);
}

}  // namespace

TEST_CASE("sizes on a lattice are linear between its nodes, in any order of them", "[sizes]") {
  std::vector<Vec3> points = lattice_points();
  std::mt19937 random(3);
  std::shuffle(points.begin(), points.end(), random);
  const SizeGrid grid = grid_of(points);
  REQUIRE(grid.is_lattice());
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{7 * u(random), -1 + 1.5 * u(random), 4 * u(random)};
    CHECK(grid.at(p) == Approx(linear(p)).epsilon(1e-12));
  }
  for (const Vec3& p : points) CHECK(grid.at(p) == Approx(linear(p)).epsilon(1e-14));
  CHECK(grid.at({100, 0, 2}) == Approx(linear({7, 0, 2})));
  CHECK(grid.at({-100, -50, -50}) == Approx(linear({0, -1, 0})));
}

TEST_CASE("a map of sizes is a lattice of one level, a single point one everywhere", "[sizes]") {
  const SizeGrid map = grid_of({{0, 0, 3}, {1, 0, 3}, {0, 1, 3}, {1, 1, 3}});
  REQUIRE(map.is_lattice());
  CHECK(map.at({0.5, 0.25, 99}) == Approx(linear({0.5, 0.25, 3})));
  CHECK(grid_of({{1, 2, 3}}).at({9, 9, 9}) == Approx(linear({1, 2, 3})));
}

TEST_CASE("a point given twice is no lattice, though its value is zero", "[sizes]") {
  CHECK_FALSE(SizeGrid({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {0, 0, 1, 2}).is_lattice());
}

TEST_CASE("scattered sizes are those of the eight nearest points, weighted", "[sizes]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back({u(random), u(random), u(random)});
  const SizeGrid grid = grid_of(points);
  REQUIRE_FALSE(grid.is_lattice());
  for (int i = 0; i < 100; ++i) {
    const Vec3 p{2 * u(random) - 0.5, u(random), u(random)};
    std::vector<std::pair<double, double>> all;  // squared distance, size
    for (const Vec3& q : points) all.push_back({dot(p - q, p - q), linear(q)});
    std::sort(all.begin(), all.end());
    double sum = 0, weights = 0;
    for (int k = 0; k < 8; ++k) sum += all[k].second / all[k].first, weights += 1 / all[k].first;
    CHECK(grid.at(p) == Approx(sum / weights).epsilon(1e-9));
  }
  for (const Vec3& p : points) CHECK(grid.at(p) == linear(p));
}

TEST_CASE("sizes are read from text with and without header, and what is wrong is told with its line", "[sizes]") {
  const auto file = (scratch_folder() / "sizes.csv");
  const auto write = [&](const std::string& text) { std::ofstream(file) << text; };
  write("x,y,z,size\n0,0,0,2\n1,0,0,4\n");
  CHECK(read_size_grid(file).at({0.5, 7, 7}) == Approx(3));
  write("# comment\n\n0 0 0 2\n1 0 0 4 extra\n");
  CHECK(read_size_grid(file).at({0.25, 0, 0}) == Approx(2.5));
  const auto message = [&](const std::string& text) {
    write(text);
    try {
      read_size_grid(file);
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::invalid_input);
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(message("0 0 0 2\n1 0 0 -4\n").find(":2: a size above zero") != std::string::npos);
  CHECK(message("0 0 0 2\n1 0 0\n").find(":2: four numbers") != std::string::npos);
  CHECK(message("x y z size\n").find("holds no sizes") != std::string::npos);
  CHECK(message("0 0 0 nan\n0 0 0 nan\n").find("four numbers") != std::string::npos);
}

TEST_CASE("sizes are read from the arrays of a VTK image and a VTK mesh", "[sizes]") {
  const auto image = (scratch_folder() / "sizes.vti");
  std::ofstream(image)
      << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<ImageData WholeExtent=\"0 1 0 1 0 1\" Origin=\"10 0 0\" Spacing=\"2 2 2\">\n"
         "<Piece Extent=\"0 1 0 1 0 1\"><PointData><DataArray type=\"Float64\" Name=\"size\" format=\"ascii\">\n"
         "1 2 1 2 3 4 3 4\n</DataArray></PointData></Piece></ImageData></VTKFile>\n";
  const SizeGrid grid = read_size_grid(image);
  CHECK(grid.is_lattice());
  CHECK(grid.at({11, 1, 0}) == Approx(1.5));
  CHECK(grid.at({12, 1, 1}) == Approx(3));
  const auto mesh = (scratch_folder() / "sizes.vtu");
  const auto write_mesh = [&](const std::string& array) {
    std::ofstream(mesh)
        << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>"
           "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
           "NumberOfComponents=\"3\" format=\"ascii\">\n"
           "0 0 0 4 0 0 0 4 0 0 0 4\n</DataArray></Points><Cells>"
           "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
           "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
           "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray></Cells>\n<CellData>"
           "<DataArray type=\"Float64\" Name=\""
        << array << "\" format=\"ascii\">7</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>\n";
  };
  write_mesh("size");
  CHECK(read_size_grid(mesh).n_points() == 1);
  CHECK(read_size_grid(mesh).at({1, 1, 1}) == 7);
  write_mesh("porosity");
  CHECK_THROWS_WITH(read_size_grid(mesh), Catch::Contains("no point or cell array \"size\""));
}
