// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a project file as the program does, has the mesh judged, and prints regions and faults.
//     run_and_judge PROJECT.yaml FOLDER
#include <cstdio>
#include <geomesh/core/error.hpp>
#include <geomesh/geomodel/check.hpp>
#include <geomesh/geomodel/pipeline.hpp>

using namespace geomesh;

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    RunContext context;
    context.stage = [](std::string_view stage, bool begins) {
      if (begins) std::printf("%.*s\n", int(stage.size()), stage.data());
    };
    geomodel::ProjectRequest request;
    request.project = geomodel::read_project(argv[1]);
    request.directory = argv[2];
    const geomodel::JobResult job = geomodel::run_project(request, context);

    geomodel::CheckRequest check;
    check.mesh = job.files.front();  // NAME.vtu
    check.project = argv[1];
    const geomodel::CheckResult verdict = geomodel::check_mesh(check);
    for (const auto& region : verdict.regions) std::printf("%-20s %g m3\n", region.name.c_str(), region.volume);
    for (const auto& fault : verdict.faults) std::printf("fault %s: %s\n", fault.id.c_str(), fault.what.c_str());
    return verdict.faults.empty() ? 0 : 3;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
