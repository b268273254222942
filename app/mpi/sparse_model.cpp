// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse_model.hpp"

#include <algorithm>
#include <cmath>

#include "archive.hpp"
#include "geomesh/core/error.hpp"
#include "grid_sizes/size_grid.hpp"
#include "pipeline/jobs/run_stages.hpp"

namespace geomesh::geomodel {

template <class A>
void pass(A& archive, Region& r) {
  archive(r.id, r.name, r.inside, r.n_tetrahedra, r.volume, r.unit, r.volume_of_input);
}
template <class A>
void pass(A& archive, RegionAttribute& a) {
  archive(a.name, a.by_region);
}
template <class A>
void pass(A& archive, RegionGroup& g) {
  archive(g.name, g.regions);
}
template <class A>
void pass(A& archive, NamedSurface& s) {
  archive(s.id, s.name, s.kind, s.area);
}
template <class A>
void pass(A& archive, NamedCurve& c) {
  archive(c.id, c.name, c.kind, c.length);
}
template <class A>
void pass(A& archive, ModelMesh::MarkedPoint& p) {
  archive(p.v, p.id, p.name);
}
template <class A>
void pass(A& archive, NodeSet& s) {
  archive(s.id, s.name, s.nodes);
}
template <class A>
void pass(A& archive, ModelMesh& m) {
  archive(m.name, m.points, m.point_kind, m.input_vertex, m.tetrahedra, m.tet_region, m.faces, m.surface_sets,
          m.curve_edges, m.marked_points, m.regions, m.attributes, m.groups, m.surfaces, m.curves, m.node_sets,
          m.origin, m.unit);
}

}  // namespace geomesh::geomodel

namespace geomesh::app {

namespace {

[[noreturn]] void refuse(const geomodel::Project& project, const std::string& what) {
  throw Error(ErrorKind::usage, project.file.filename().string() + ": " + what +
                                    " is not there on ranks; leave it out, or mesh by geomesh, in one process");
}

/// Number of elements above which the model is meshed with doubled sizes and its edges are halved once, which reduces
/// the work that rank 0 does alone to a quarter. Smaller meshes are made quickly, and with better shapes without it.
constexpr double large_mesh = 1e6;
/// Features of the input may require edges that are much shorter than the doubled sizes, so that halves would be
/// shorter than requested. If more than the share `many_short` of the edges on surfaces is shorter than `short_edge`
/// times the doubled size, edges are not halved.
constexpr double many_short = 0.05, short_edge = 0.55;
/// Growth of sizes in the interior, per unit of distance. It leaves few tetrahedra between the surfaces, with shapes
/// that still allow a border between parts.
constexpr double growth = 0.7, slow_growth = 0.3;
/// Least number of tetrahedra of the sparse mesh. The largest tetrahedra are then a small share of a part, so that
/// parts can have equal sizes. The number of ranks has no influence, so that surfaces do not depend on it.
constexpr double least_cells = 20000;
constexpr double least_ratio = 2, most_ratio = 12;

double ratio_for(double elements) { return std::clamp(std::cbrt(elements / least_cells), least_ratio, most_ratio); }

/// Estimates the number of elements of one size in a volume.
double elements_of(const geomodel::Inputs& model) {
  const double size = model.refinement.size.base.global;
  const Vec3 extent = model.volume.bounds.max - model.volume.bounds.min;
  constexpr double elements_a_cube = 11;
  return size > 0 ? elements_a_cube * extent.x * extent.y * extent.z / (size * size * size)
                  : model.refinement.derived_elements;
}

}  // namespace

std::vector<std::string> leave_out_page(geomodel::Project& project) {
  std::vector<std::string>& formats = project.output.formats;
  if (formats.size() < 2 || std::erase(formats, "html") == 0) return {};
  return {
      "ranks write no page: the format html is left out; `geomesh PROJECT.yaml --preview` makes one of a coarse mesh"};
}

void refuse_what_ranks_lack(const geomodel::Project& project) {
  const geomodel::RefinementSettings& refinement = project.mesh.refinement;
  const geomodel::WriteOptions& options = project.output.options;
  if (!refinement.refine) refuse(project, "a mesh without refinement (refine: none)");
  if (project.mesh.options.recover.mode == MeshMode::conforming) refuse(project, "mesh.mode: conforming");
  if (refinement.target_elements > 0) refuse(project, "mesh.target_elements");
  if (refinement.time_budget > 0) refuse(project, "mesh.time_budget");
  if (!refinement.sizes_on_surfaces) refuse(project, "mesh.size.on_surfaces: false");
  if (!refinement.cell_arrays.empty()) refuse(project, "mesh.cell_arrays");
  if (project.crs.z_scale != 1) refuse(project, "crs.z_scale");
  if (options.order == geomodel::ElementOrder::second) refuse(project, "output.order: 2");
  if (options.starter) refuse(project, "output.starter");
  if (!options.split.empty()) refuse(project, "output.split");
  if (!options.fault_zones.empty()) refuse(project, "output.fault_zones");
  if (!options.fields.empty()) refuse(project, "output.fields");
  if (options.single_grid) refuse(project, "output.single_grid");
  if (options.fractures_only) refuse(project, "output.fractures_only");
  if (options.partitions > 1) refuse(project, "output.partitions, which is the number of ranks,");
  for (const std::string& format : project.output.formats)
    if (format != "vtu" && format != "exodus" && format != "msh" && format != "msh-binary")
      refuse(project, "the format " + format);
}

namespace {

/// Returns the share of short edges among the edges of faces, each counted as often as it has faces.
double share_of_short_edges(const geomodel::ModelMesh& mesh, const SizeField& size) {
  std::size_t n = 0, n_short = 0;
  for (const auto& face : mesh.faces)
    for (unsigned i = 0; i < 3; ++i) {
      const Vec3 &a = mesh.points[face.vertices[i]], &b = mesh.points[face.vertices[(i + 1) % 3]];
      const double least = short_edge * size.at(0.5 * (a + b));
      ++n;
      n_short += dot(b - a, b - a) < least * least;
    }
  return n > 0 ? static_cast<double>(n_short) / static_cast<double>(n) : 0;
}

}  // namespace

SparseModel make_sparse_model(const geomodel::Project& project, const RunContext& context, SparseRun& run) {
  geomodel::StageRecorder recorder(context, "");
  geomodel::Journal prepared(recorder.context());
  const geomodel::Inputs inputs = geomodel::read_project_model(project, prepared);
  const geomodel::Built built = geomodel::build_model(inputs, prepared);
  const geomodel::Arranged arranged = geomodel::intersect(inputs, built, prepared);
  const double elements = elements_of(inputs);  // about so many
  const auto mesh_with = [&](unsigned halvings) {
    geomodel::Arranged start = arranged;
    // The tetrahedra of the sparse mesh are replaced when its edges have been halved, so their shapes matter little.
    if (halvings > 0) start.refinement.quality = QualityLevel::fast;
    geomodel::Journal journal = prepared;
    geomodel::VerifiedModel meshed = geomodel::mesh_and_verify(
        {inputs, built, start}, {halvings > 0 ? growth : slow_growth, ratio_for(elements), std::exp2(halvings)},
        journal);
    run.input_json = meshed.description;
    run.notes = journal.notes();
    run.warnings = journal.warnings();
    run.stages = recorder.records();
    run.estimated_elements = meshed.refined.statistics.estimated_elements;
    return SparseModel{std::move(meshed.mesh), std::move(meshed.refined.mesh.component),
                       std::move(meshed.refined.size_field), halvings};
  };
  SparseModel sparse = mesh_with(elements < large_mesh ? 0 : 1);
  if (sparse.halvings > 0 && share_of_short_edges(sparse.mesh, sparse.size) > many_short) sparse = mesh_with(0);
  sparse.size = sparse.size.times(std::exp2(-static_cast<double>(sparse.halvings)));
  return sparse;
}

namespace {

/// Returns the target sizes that are a function of position. Every rank reads them from the file itself.
std::function<double(const Vec3&)> size_by_place(const geomodel::Project& project, const geomodel::ModelMesh& mesh) {
  geomodel::RefinementSettings settings = project.mesh.refinement;
  if (settings.size.background.empty() && settings.size.by_depth.empty()) return {};
  geomodel::load_background(settings.size, project.output.origin);
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  geomodel::settle_sizes(settings, bounds, project.naming.attributes, project.output.origin);
  return settings.size.base.background;
}

}  // namespace

std::size_t broadcast(SparseModel& model, const geomodel::Project& project, const Ranks& ranks) {
  SizeField::Limits limits = model.size.limits();
  std::vector<SizeSource> sources = model.size.sources();
  const auto all = [&](auto& archive) {
    archive(model.mesh, model.component, sources, limits.global, limits.min_size, limits.max_size, limits.gradation,
            limits.component_size, model.halvings);
  };
  Bytes bytes;
  if (ranks.rank() == 0) {
    Packer packer;
    all(packer);
    bytes = packer.take();
  }
  ranks.broadcast(bytes);
  if (ranks.rank() == 0) return bytes.size();
  Unpacker unpacker(bytes);
  all(unpacker);
  limits.background = size_by_place(project, model.mesh);
  model.size = SizeField(std::move(sources), std::move(limits));
  return bytes.size();
}

}  // namespace geomesh::app
