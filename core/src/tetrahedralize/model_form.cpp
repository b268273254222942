// SPDX-License-Identifier: MIT
#include "tetrahedralize/model_form.hpp"

#include <string>
#include <utility>

#include "plc/coplanar_patches.hpp"
#include "plc/flat_patch.hpp"

namespace geomesh {

namespace {

using Face = ConstrainedTetrahedralization::Face;

AxisFrame compose(const AxisFrame& outer, const AxisFrame& inner) {
  AxisFrame out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.axis[i] = outer.axis[inner.axis[i]];
    out.direction[i] = inner.direction[i] * outer.direction[inner.axis[i]];
  }
  return out;
}

/// Composes two maps of indices: `inner` leads to the complex with merged facets, `outer` from the complex before
/// merging to the caller's.
ModelNames compose(const ModelNames& outer, const ModelNames& inner, const MergedFacets& merged) {
  ModelNames out;
  out.frame = compose(outer.frame, inner.frame);
  for (const VertexIndex v : inner.vertex) out.vertex.push_back(outer.vertex[v]);
  for (std::size_t f = 0; f < inner.facet.size(); ++f) {
    const Index first = merged.members_of(inner.facet[f]).front();
    out.facet.push_back(outer.facet[first]);
    out.facet_is_reversed.push_back(inner.facet_is_reversed[f] != outer.facet_is_reversed[first]);
  }
  for (std::size_t s = 0; s < inner.segment.size(); ++s) {
    out.segment.push_back(outer.segment[inner.segment[s]]);
    out.segment_is_reversed.push_back(inner.segment_is_reversed[s] != outer.segment_is_reversed[inner.segment[s]]);
  }
  return out;
}

/// Determines for each mesh face of a merged facet to which of the merged triangles it belongs.
class MemberNaming {
 public:
  MemberNaming(const PiecewiseLinearComplex& plc, const MergedFacets& merged, ConstrainedTetrahedralization& mesh)
      : plc_(plc), merged_(merged), mesh_(mesh) {}

  void run() {
    std::vector<Face>& faces = mesh_.faces;  // by facet
    for (std::size_t i = 0, j = 0; i < faces.size(); i = j) {
      while (j < faces.size() && faces[j].facet == faces[i].facet) ++j;
      const auto members = merged_.members_of(faces[i].facet);
      if (members.size() == 1)
        for (std::size_t k = i; k < j; ++k) faces[k].facet = members.front();
      else
        name_faces({faces.data() + i, j - i}, members);
    }
  }

 private:
  void name_faces(std::span<Face> faces, std::span<const Index> members) {
    std::vector<Triangle> triangles;
    for (const Index f : members) {
      const auto loop = plc_.outer_loop(f);
      triangles.push_back({loop[0], loop[1], loop[2]});
    }
    const std::optional<FlatPatch> patch = FlatPatch::of(plc_.points, std::move(triangles));
    GEOMESH_CHECK(patch);  // the triangles of a merged facet formed a valid patch before
    for (Face& face : faces) {
      const Index t = triangle_of(face, *patch);
      face.facet = members[t];
      if (!patch->is_turned(t)) continue;
      std::swap(face.vertices[1], face.vertices[2]);
      std::swap(face.tetrahedron_below, face.tetrahedron_above);
    }
  }

  Index triangle_of(const Face& face, const FlatPatch& patch) const {
    std::array<Vec3, 3> corners;
    std::vector<VertexIndex> near;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh_.points[face.vertices[k]];
      if (const VertexIndex v = mesh_.input_vertex[face.vertices[k]]; v != no_vertex) near.push_back(v);
    }
    return patch.triangle_at_centroid(corners, near);
  }

  const PiecewiseLinearComplex& plc_;
  const MergedFacets& merged_;
  ConstrainedTetrahedralization& mesh_;
};

}  // namespace

ModelForm::ModelForm(const PiecewiseLinearComplex& plc, const RecoverOptions& options, const RunContext& context)
    : given_(plc), form_(canonical_form(plc)) {
  if (options.mode == MeshMode::constrained && !options.preserve_boundary) merge(context);
}

void ModelForm::merge(const RunContext& context) {
  MergedFacets merged =
      merge_coplanar_facets(form_.plc, provenance_of(given_, form_.names), most_crossings_of_kept_edge);
  if (!merged.has_merged()) return;
  std::size_t n_polygons = 0, n_triangles = 0;
  for (Index m = 0; m < merged.plc.n_facets(); ++m)
    if (const std::size_t n = merged.members_of(m).size(); n > 1) {
      ++n_polygons;
      n_triangles += n;
    }
  context.note(LogLevel::info, std::to_string(n_triangles) + " coplanar facets are meshed as " +
                                   std::to_string(n_polygons) + " polygons, because long needles cross among them");
  CanonicalForm form = canonical_form(merged.plc);
  names_ = compose(form_.names, form.names, merged);
  before_merging_ = std::exchange(form_, std::move(form));
  merged_ = std::move(merged);
}

ConstrainedTetrahedralization ModelForm::in_callers_terms(ConstrainedTetrahedralization mesh) const {
  if (!merged_) return geomesh::in_callers_terms(std::move(mesh), form_.names, given_);
  mesh = geomesh::in_callers_terms(std::move(mesh), form_.names, merged_->plc);
  MemberNaming(before_merging_->plc, *merged_, mesh).run();
  mesh.recovery.facets_total = given_.n_facets();
  return geomesh::in_callers_terms(std::move(mesh), before_merging_->names, given_);
}

}  // namespace geomesh
