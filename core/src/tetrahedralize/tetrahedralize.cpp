// SPDX-License-Identifier: MIT
#include "geomesh/core/tetrahedralize.hpp"

#include <algorithm>
#include <optional>

#include "classify/classify.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/predicates.hpp"
#include "recover/conforming/conforming.hpp"
#include "tetrahedralize/conforming_step.hpp"
#include "tetrahedralize/model_form.hpp"
#include "tetrahedralize/recovery_run.hpp"
#include "tetrahedralize/roofed_parts.hpp"

namespace geomesh {

namespace {

using recover::ConstrainedMesh;
using recover::Recovery;

void refuse_invalid(const PiecewiseLinearComplex& plc) {
  const std::vector<PlcFault> faults = validate_plc(plc);
  if (faults.empty()) return;
  std::string message = "the model is not valid: " + faults[0].message;
  if (faults.size() > 1) message += " (and " + std::to_string(faults.size() - 1) + " more faults)";
  throw Error(ErrorKind::invalid_input, message, faults[0].context);
}

bool recover_conforming(Recovery& recovery, const RecoverOptions& options, std::vector<Index>& given_up) {
  recover::ConformingRecovery conforming(recovery, options);
  const bool within_budget = conforming.run();
  given_up = conforming.facets_given_up();
  return within_budget;
}

ConstrainedTetrahedralization classify_regions(RecoveryRun& run, ConstrainedMesh& mesh,
                                               const PiecewiseLinearComplex& plc, const RunContext& context) {
  ConstrainedTetrahedralization out = classify::classify(mesh, run.model(), plc, context);
  out.recovery = run.statistics();
  out.recovery.tetrahedra_final = out.tetrahedra.size();
  for (VertexOrigin origin : out.origin) {
    out.recovery.steiner_on_segments += origin == VertexOrigin::on_segment;
    out.recovery.steiner_on_facets += origin == VertexOrigin::on_facet;
    out.recovery.steiner_inside += origin == VertexOrigin::inside;
  }
  out.delaunay_statistics = run.delaunay();
  return out;
}

/// A mesh, or the reason why there is none.
struct MeshingOutcome {
  std::optional<ConstrainedTetrahedralization> mesh;
  std::optional<Error> refusal;
  std::vector<Index> given_up;  ///< facets that conforming mode could not recover, if there is no mesh
};

/// Runs the stages of Cavalcanti and Mello 1999 in their order: triangulation (section 2), recovery (section 3),
/// classification (section 4).
MeshingOutcome mesh_in_mode(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                            const RunContext& context, const ConformingStep& conform) {
  const ModelForm form(plc, options.recover, context);
  RecoveryRun run(form.plc(), form.names(), options, context, conform);
  try {
    {
      const StageScope stage(context, "delaunay");
      run.triangulate();
    }
    RecoveryOutcome recovered;
    {
      const StageScope stage(context, "recover");
      recovered = run.recover();
    }
    if (recovered.refusal)
      return {std::nullopt, in_callers_terms(*recovered.refusal, form.names()),
              facets_in_callers_terms(run.statistics().facets_not_recovered, form.names())};
    const StageScope stage(context, "classify");
    ConstrainedTetrahedralization mesh = classify_regions(run, *recovered.mesh, form.plc(), context);
    mesh.delaunay = options.recover.mode == MeshMode::conforming && recover::is_locally_delaunay(*recovered.mesh);
    return {form.in_callers_terms(std::move(mesh)), std::nullopt, {}};
  } catch (const Error& e) {
    throw in_callers_terms(e, form.names());
  }
}

ConstrainedTetrahedralization mesh_or_throw(MeshingOutcome&& outcome) {
  if (outcome.refusal) throw *outcome.refusal;
  return std::move(*outcome.mesh);
}

/// Meshes without points on facets, with triangulations lifted off patches of needles (roofed_parts.hpp), or fails.
std::optional<ConstrainedTetrahedralization> mesh_with_roofs(const PiecewiseLinearComplex& plc,
                                                             const TetrahedralizeOptions& options,
                                                             const RunContext& context) {
  const CanonicalForm form = canonical_form(plc);
  const std::optional<RoofedParts> roofed = RoofedParts::of(form.plc, provenance_of(plc, form.names));
  if (!roofed) return std::nullopt;
  try {
    MeshingOutcome outcome = mesh_in_mode(roofed->plc(), options, context, recover_conforming);
    if (!outcome.mesh || !roofed->fill(*outcome.mesh)) return std::nullopt;
    return in_callers_terms(std::move(*outcome.mesh), form.names, plc);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::cannot_mesh && e.kind() != ErrorKind::invalid_input) throw;
    context.note(LogLevel::debug, std::string("meshing with roofs over plane parts ends: ") + e.what());
    return std::nullopt;
  }
}

}  // namespace

void list_facets_off_delaunay(ConstrainedTetrahedralization& mesh) {
  std::vector<Index>& list = mesh.recovery.facets_not_recovered;
  for (const ConstrainedTetrahedralization::Face& face : mesh.faces) {
    if (face.tetrahedron_above == no_index || face.tetrahedron_below == no_index) continue;
    const Tetrahedron &above = mesh.tetrahedra[face.tetrahedron_above],
                      &below = mesh.tetrahedra[face.tetrahedron_below];
    const auto opposite = std::find_if(below.begin(), below.end(), [&](VertexIndex v) {
      return std::find(face.vertices.begin(), face.vertices.end(), v) == face.vertices.end();
    });
    const auto point = [&](VertexIndex v) -> const Vec3& { return mesh.points[v]; };
    if (in_sphere(point(above[0]), point(above[1]), point(above[2]), point(above[3]), point(*opposite)) ==
        Sign::positive)
      list.push_back(face.facet);
  }
  sort_unique(list);
}

ConstrainedTetrahedralization tetrahedralize_conforming(const PiecewiseLinearComplex& plc,
                                                        const TetrahedralizeOptions& options, const RunContext& context,
                                                        const ConformingStep& step) {
  ConstrainedTetrahedralization out = mesh_or_throw(mesh_in_mode(plc, options, context, step));
  list_facets_off_delaunay(out);
  return out;
}

ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                             const RunContext& context) {
  if (options.recover.preserve_boundary && options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage, "conforming mode adds points to the boundary: it cannot preserve it");
  refuse_invalid(plc);
  if (options.recover.preserve_boundary)
    if (std::optional<ConstrainedTetrahedralization> roofed = mesh_with_roofs(plc, options, context))
      return std::move(*roofed);
  MeshingOutcome outcome = mesh_in_mode(plc, options, context, recover_conforming);
  if (options.recover.mode == MeshMode::constrained) return mesh_or_throw(std::move(outcome));
  if (!outcome.refusal || outcome.refusal->kind() != ErrorKind::cannot_mesh) {
    ConstrainedTetrahedralization out = mesh_or_throw(std::move(outcome));
    list_facets_off_delaunay(out);
    return out;
  }
  context.note(LogLevel::warning,
               "conforming mode: small angles need too many points; the model is meshed in constrained mode instead");
  // Constrained mode starts without the crowded points that conforming mode has added near small angles.
  TetrahedralizeOptions constrained = options;
  constrained.recover.mode = MeshMode::constrained;
  ConstrainedTetrahedralization out = mesh_or_throw(mesh_in_mode(plc, constrained, context, recover_conforming));
  out.recovery.facets_not_recovered = outcome.given_up;
  list_facets_off_delaunay(out);
  if (out.recovery.facets_not_recovered.empty())  // although all facets are Delaunay, cells between them may not be
    for (Index f = 0; f < plc.n_facets(); ++f) out.recovery.facets_not_recovered.push_back(f);
  return out;
}

}  // namespace geomesh
