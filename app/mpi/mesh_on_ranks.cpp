// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_on_ranks.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>

#include "archive.hpp"
#include "divide.hpp"
#include "formats/given_part.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "numbering.hpp"
#include "part.hpp"
#include "parts_report.hpp"
#include "pipeline/stage_recorder.hpp"
#include "strips.hpp"
#include "verify_parts.hpp"

namespace geomesh::app {

namespace {

namespace fs = std::filesystem;

/// Files of all ranks are first written into a separate folder beside their destination.
class StagedFiles {
 public:
  StagedFiles(fs::path stem, const Ranks& ranks)
      : stem_(std::move(stem)), folder_(stem_.parent_path() / ("." + stem_.filename().string() + ".unfinished")) {
    ranks.wait_for_all();  // no folder is created before all ranks have meshed their parts
    if (ranks.rank() == 0) {
      fs::create_directories(stem_.parent_path());
      fs::remove_all(folder_);
      fs::create_directory(folder_);
    }
    ranks.wait_for_all();
  }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  fs::path stem() const { return folder_ / stem_.filename(); }
  void add(const std::vector<fs::path>& files) { files_.insert(files_.end(), files.begin(), files.end()); }
  /// Gives the files their names after all ranks have written. If a rank has failed, no file is kept, and the rank that
  /// failed throws its error, which ends the others.
  std::vector<fs::path> finish(const std::exception_ptr& failure, const Ranks& ranks) {
    const std::vector<char> failed = ranks.gather_all(static_cast<char>(failure != nullptr));
    const bool has_failed = std::find(failed.begin(), failed.end(), 1) != failed.end();
    std::vector<fs::path> named;
    for (const fs::path& file : files_) {
      if (has_failed) break;
      named.push_back(stem_.parent_path() / file.filename());
      fs::rename(file, named.back());
    }
    ranks.wait_for_all();
    if (ranks.rank() == 0) fs::remove_all(folder_);
    ranks.wait_for_all();
    if (failure) std::rethrow_exception(failure);
    if (has_failed) ranks.wait_for_all();  // waits until the rank that failed has ended the program on all ranks
    return named;
  }

 private:
  fs::path stem_, folder_;
  std::vector<fs::path> files_;
};

RefineOptions options_of(const geomodel::Project& project) {
  RefineOptions options;
  options.quality = project.mesh.refinement.quality;
  options.quality_measure = project.mesh.refinement.quality_measure;
  options.max_elements = project.mesh.refinement.max_elements;
  return options;
}

/// Measures processor seconds since the last call.
class Watch {
 public:
  double lap() {
    const double now = geomodel::process_cpu_seconds(), spent = now - last_;
    last_ = now;
    return spent;
  }

 private:
  double last_ = geomodel::process_cpu_seconds();
};

std::vector<std::string> names_on_all(const std::vector<fs::path>& own, const Ranks& ranks) {
  std::vector<std::string> names;
  for (const fs::path& file : own) names.push_back(file.filename().string());
  Packer packer;
  packer(names);
  std::vector<std::string> all;
  for (const Bytes& bytes : ranks.gather_all(packer.take())) {
    std::vector<std::string> of_rank;
    Unpacker unpacker(bytes);
    unpacker(of_rank);
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  }
  return all;
}

/// Lets a rank fail at a given point, for tests.
void fail_if_asked(const Ranks& ranks) {
  const char* const asked = std::getenv("GEOMESH_MPI_FAIL_ON_RANK");
  if (asked && std::to_string(ranks.rank()) == asked)
    throw Error(ErrorKind::cannot_mesh, "this rank fails, as GEOMESH_MPI_FAIL_ON_RANK asks");
}

/// Data with which all ranks start, made by rank 0, with the rank of each tetrahedron.
struct Start {
  SparseModel sparse;
  std::vector<std::int32_t> rank_of;
};

Start start_on_all(const geomodel::Project& project, const fs::path& stem, const Ranks& ranks,
                   const RunContext& context, SparseRun& run) {
  Start start;
  if (ranks.rank() == 0) {
    geomodel::require_writable(stem.string() + ".report.json");
    start.sparse = make_sparse_model(project, context, run);
    Watch watch;
    start.rank_of = divide(start.sparse, ranks.size());
    run.divide_seconds = watch.lap();
  }
  run.broadcast_bytes = broadcast(start.sparse, project, ranks);
  Packer packer;
  packer(start.rank_of);
  Bytes bytes = packer.take();
  ranks.broadcast(bytes);
  run.broadcast_bytes += bytes.size();
  Unpacker unpacker(bytes);
  unpacker(start.rank_of);
  return start;
}

/// Writes the part of this rank. Returns any error, so that the other ranks can be informed before it is thrown.
std::exception_ptr write_part(const geomodel::Project& project, NumberedPart& numbered, const Ranks& ranks,
                              StagedFiles& files) {
  try {
    fail_if_asked(ranks);
    const geomodel::MeshParts parts(numbered.mesh, std::move(numbered.part));
    for (const std::string& format : project.output.formats)
      files.add(
          geomodel::write_given_part(numbered.mesh, parts, ranks.rank(), format, files.stem(), project.output.options));
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> mesh_on_ranks(const RanksRequest& request, const Ranks& ranks, const RunContext& context) {
  if (ranks.rank() != 0) ranks.wait_for_all();  // mistakes in the project are reported once, by rank 0
  geomodel::Project project = geomodel::read_project(request.project);
  const std::vector<std::string> left_out = leave_out_page(project);
  refuse_what_ranks_lack(project);
  if (ranks.rank() == 0) ranks.wait_for_all();
  const fs::path stem = request.directory.value_or(project.output.directory) / project.name;
  SparseRun run;
  Start start = start_on_all(project, stem, ranks, context, run);
  for (const std::string& text : left_out) {
    run.warnings.push_back(text);
    context.note(LogLevel::warning, text);
  }

  RankCost cost;
  cost.start_seconds = geomodel::process_cpu_seconds();
  Watch watch;
  const RefineOptions options = options_of(project);
  const RankModel model(std::move(start.sparse));
  cost.model_seconds = watch.lap();
  RankMesh mesh = part_of_rank(model, start.rank_of, ranks.rank());
  {
    TetrahedraPart part = with_model(std::move(mesh), model);
    refine_part(part, model.sparse.size, options, context);
    mesh = without_model(std::move(part));
  }
  cost.refine_seconds = watch.lap();
  const StripsResult strips = improve_strips(mesh, model, options, ranks, context);
  cost.n_strip = strips.n_tetrahedra;
  cost.strips_seconds = watch.lap();

  const MeshFaces faces(mesh);
  const VerifiedParts verified = verify_parts(model, mesh, faces, ranks);
  const PartShapes own_shapes = shapes_of(mesh);
  const geomodel::SolverVerdict own_verdict = judge_part(model, mesh);
  NumberedPart numbered = number_part(model, mesh, faces, ranks);
  for (std::size_t k = 0; k < verified.volume_of_region.size(); ++k)
    numbered.mesh.regions[k].volume = verified.volume_of_region[k];
  mesh = {};
  cost.n_own = numbered.n_own;
  cost.n_ghosts = numbered.mesh.tetrahedra.size() - numbered.n_own;
  const std::uint64_t n_points = numbered.part.n_nodes;
  cost.verify_seconds = watch.lap();
  StagedFiles files(stem, ranks);
  const std::exception_ptr failure = write_part(project, numbered, ranks, files);
  cost.write_seconds = watch.lap();
  cost.cpu_seconds = geomodel::process_cpu_seconds();
  cost.peak_bytes = geomodel::process_peak_bytes();
  cost.sent_bytes = ranks.sent_bytes();

  PartsReport report{model.sparse,
                     run,
                     verified,
                     numbered.mesh,
                     {},
                     ranks.gather_all(cost),
                     ranks.gather_all(own_verdict),
                     n_points,
                     strips.n_never_free,
                     {}};
  for (const PartShapes& s : ranks.gather_all(own_shapes)) report.shapes.add(s);
  const std::vector<fs::path> named = files.finish(failure, ranks);
  report.files = names_on_all(named, ranks);
  if (ranks.rank() != 0) return {};
  geomodel::write_text_file(stem.string() + ".report.json", to_json(report));
  std::vector<std::string> lines = summary_of(report);
  for (const std::string& name : report.files) lines.push_back("wrote " + (stem.parent_path() / name).string());
  lines.push_back("wrote " + stem.string() + ".report.json");
  return lines;
}

}  // namespace geomesh::app
