// SPDX-License-Identifier: GPL-3.0-or-later
// A program of somebody else: a surface in memory to a named mesh in memory.
#include <cstdio>

#include "geomesh/geomodel/given.hpp"
#include "geomesh/geomodel/pipeline.hpp"

int main() {
  using namespace geomesh::geomodel;
  GivenProject given;
  given.text =
      "{box: {min: [0, 0, -1000], max: [1000, 1000, 0]}, surfaces: [{name: top, kind: horizon}], column: [upper, top, "
      "lower], mesh: {refine: none}}";
  given.inputs["top"] = std::make_shared<const FileContents>(given_surface(
      "top", {{-1, -1, -400}, {1001, -1, -400}, {1001, 1001, -400}, {-1, 1001, -400}}, {{0, 1, 2}, {0, 2, 3}}));
  ProjectRequest request;
  request.project = read_given_project(given);
  request.outputs = ProjectRequest::Outputs::kept;
  const JobResult result = run_project(request, {});
  for (const Region& region : result.mesh.regions) std::printf("%s %.0f\n", region.name.c_str(), region.volume);
  const auto& regions = result.mesh.regions;
  return regions.size() == 2 && regions[0].name == "upper" && regions[0].volume == 400e6 && regions[1].volume == 600e6
             ? 0
             : 1;
}
