// SPDX-License-Identifier: GPL-3.0-or-later
// geomesh-mpi: makes one mesh on the ranks of an MPI run. If a rank fails, all of them end, with its message.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "geomesh/core/error.hpp"
#include "mesh_on_ranks.hpp"
#include "ranks.hpp"

namespace {

using geomesh::app::Ranks;

constexpr int status_bug = 1;

[[noreturn]] void end_all(const Ranks& ranks, const char* kind, const char* text, int status) {
  std::fprintf(stderr, "%s on rank %d: %s\n", kind, ranks.rank(), text);
  std::fflush(stderr);
  Ranks::abort(status);
}

/// Prints the warnings of rank 0 and its stages as they begin, unless `is_quiet`.
void attach_log(geomesh::RunContext& context, const Ranks& ranks, bool is_quiet) {
  if (ranks.rank() != 0 || is_quiet) return;
  context.log = [](geomesh::LogLevel level, std::string_view text) {
    if (level == geomesh::LogLevel::warning) std::cerr << "warning: " << text << "\n";
  };
  context.stage = [](std::string_view stage, bool begins) {
    if (begins) std::cerr << stage << "\n";
  };
}

}  // namespace

int main(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  CLI::App app("Meshes one model on the ranks of an MPI run: mpirun -n N geomesh-mpi PROJECT.yaml", "geomesh-mpi");
  geomesh::app::RanksRequest request;
  unsigned threads = 1;
  bool is_quiet = false;
  std::string directory;
  app.add_option("project", request.project, "The project file")->required();
  app.add_option("-o", directory, "Output folder (default: the project's output.directory)")->type_name("DIR");
  app.add_option("--threads", threads, "Threads of each rank; 0: all cores")->capture_default_str();
  app.add_flag("-q,--quiet", is_quiet, "Say nothing but errors");
  app.set_version_flag("--version", "geomesh-mpi " GEOMESH_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (ranks.rank() != 0) return error.get_exit_code() == 0 ? 0 : static_cast<int>(geomesh::ErrorKind::usage);
    return app.exit(error) == 0 ? 0 : static_cast<int>(geomesh::ErrorKind::usage);
  }
  if (!directory.empty()) request.directory = directory;
  geomesh::RunContext context;
  context.threads = threads;
  attach_log(context, ranks, is_quiet);
  try {
    for (const std::string& line : mesh_on_ranks(request, ranks, context))
      if (!is_quiet) std::cout << line << "\n";
    return 0;
  } catch (const geomesh::Error& error) {
    end_all(ranks, "error", error.what(), static_cast<int>(error.kind()));
  } catch (const std::bad_alloc&) {
    end_all(ranks, "error", "out of memory: take more ranks, or larger sizes",
            static_cast<int>(geomesh::ErrorKind::cannot_mesh));
  } catch (const std::filesystem::filesystem_error& error) {
    end_all(ranks, "error", error.what(), static_cast<int>(geomesh::ErrorKind::usage));
  } catch (const std::exception& error) {
    end_all(ranks, "internal error", error.what(), status_bug);
  }
}
