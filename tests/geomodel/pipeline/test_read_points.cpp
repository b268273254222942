// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "pipeline/jobs/read_points.hpp"
#include "scratch.hpp"

using namespace geomesh;
using geomesh::geomodel::read_points;

namespace {
std::filesystem::path file_with(const std::string& text) {
  const auto path = geomesh::geomodel::testing::scratch_folder() / "test-points.txt";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}
}  // namespace

TEST_CASE("points are read with blanks, commas, a header, comments and further columns", "[points]") {
  const std::vector<Vec3> expected{{1, 2, 3}, {-4.5e-7, 5, 1e4}};
  CHECK(read_points(file_with("1 2 3\n-4.5e-7 5 1e4\n")) == expected);
  CHECK(read_points(file_with("x,y,z\n1,2,3\r\n-4.5e-7, 5, 1e4\r\n")) == expected);
  CHECK(read_points(file_with("# made by hand\n\n1\t2\t3\tname\n-4.5e-7;5;+1e4")) == expected);
}

TEST_CASE("a broken line of a point file is refused with its number", "[points]") {
  for (const char* text : {"1 2 3\n4 5\n", "1 2 3\n4 five 6\n", "1 2 3\n4 nan 6\n", "1 2 3\n4 5 inf\n"}) {
    INFO(text);
    try {
      read_points(file_with(text));
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::invalid_input);
      CHECK(std::string(error.what()).find(":2:") != std::string::npos);
    }
  }
}
