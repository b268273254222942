// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/init.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/project.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {
std::filesystem::path fresh_folder(const std::string& name) {
  const auto folder = std::filesystem::path(GEOMESH_BINARY_DIR) / "test-init" / name;
  std::filesystem::remove_all(folder);
  return folder;
}
}  // namespace

TEST_CASE("every template of init makes a project that runs as it is", "[init]") {
  for (const std::string& name : template_names()) {
    INFO(name);
    const auto file = init_project(fresh_folder(name), name);
    ProjectRequest request;
    request.project = read_project(file);
    const JobResult result = run_project(request, RunContext{});
    REQUIRE(result.files.size() >= 4);
    for (const auto& written : result.files) CHECK(std::filesystem::file_size(written) > 0);
  }
}

TEST_CASE("init refuses an unknown template and a folder with a project, and says what it knows", "[init]") {
  const auto folder = fresh_folder("twice");
  try {
    init_project(folder, "no-such");
    FAIL("an unknown template was accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find("salt-dome") != std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists(folder));
  init_project(folder, "layers");
  CHECK_THROWS_AS(init_project(folder, "layers"), Error);
}
