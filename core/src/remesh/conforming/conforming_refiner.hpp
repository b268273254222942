// SPDX-License-Identifier: MIT
/// @file
/// Refinement to sizes that keeps the mesh Delaunay. Circumcentres of cells and faces, and middles of segments, are
/// inserted into the Delaunay triangulation of conforming recovery (Ruppert 1995; Shewchuk 1998; Si 2009 for sizes).
///
/// A place in the diametral sphere of a subsegment, or of a face of a facet, gets no point; that subsegment or face is
/// split instead (encroachment). No point is put nearer to another than `min_spacing` times the target size there.
/// Refinement therefore ends for any input angles, because only finitely many points fit. Cells at small angles that
/// would need ever smaller elements are left as they are.
///
/// An insertion may still remove parts of segments or facets. Conforming recovery restores them with points of its own,
/// on concentric shells around sharp vertices; these count towards its budgets.
#pragma once

#include <functional>
#include <optional>

#include "geomesh/core/size_field.hpp"
#include "recover/conforming/conforming.hpp"
#include "remesh/domain/mesh_elements.hpp"

namespace geomesh::remesh {

/// The components below and above each facet; no_index outside the model, or if the component varies along the facet.
using FacetComponents = std::vector<std::array<Index, 2>>;

class ConformingRefiner : public recover::ConformingRecovery {
 public:
  /// Largest circumradius of cells and faces, and largest length of subsegments, relative to the target size.
  static constexpr double max_radius = 0.75, max_length = 1.3;
  /// Cells whose circumradius is more than this factor times their shortest edge are split too, if spacing allows.
  static constexpr double max_radius_to_edge = 2;
  static constexpr double min_spacing = 0.45;

  /// `components`: those beside each facet of recovery.plc. `size` expects the caller's coordinates and components.
  ConformingRefiner(recover::Recovery& recovery, const RecoverOptions& options, const SizeField& size,
                    FacetComponents components, std::size_t max_cells);

  /// Refines the mesh to the target sizes; run() must have been called before. Returns false if refinement stopped
  /// because the mesh had more than max_cells elements.
  bool refine();

  struct Counts {
    std::size_t on_segments = 0, on_facets = 0, inside = 0;
    std::size_t rounds = 0;
    /// Number of cells left larger than requested, because spacing or budgets forbid more points.
    std::size_t too_large = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  struct Place {
    Vec3 p;
    std::vector<CellIndex> cavity;
  };
  struct FaceOfFacet {
    Triangle vertices;
    Index facet;  ///< subfacet
  };

  // conforming_refiner.cpp
  void refine_segments();
  std::size_t refine_facets();
  std::size_t refine_cells();
  void recover_what_was_lost();
  std::size_t label_cells();
  void flood(CellIndex start, Index label);
  bool wants_point(CellIndex c, Vec3& centre) const;
  double size_at(const Vec3& p, Index component) const { return size_.at(recovery_.names.frame.leave(p), component); }
  double size_on_facet(const Vec3& p, Index facet) const;
  Index facet_of(CellIndex c, unsigned face) const;

  // conforming_insertions.cpp
  bool split_long(Index subsegment);
  bool insert_in_face(FaceOfFacet face);
  bool insert_in_cell(CellIndex c, const Vec3& centre);
  std::optional<Place> find_place(const Vec3& p, CellIndex start, double size);
  Index encroached_subsegment(const Place& place) const;
  std::optional<FaceOfFacet> encroached_face(const Place& place) const;
  std::optional<FaceOfFacet> next_face(const FaceOfFacet& face, VertexIndex a, VertexIndex b);
  void put(const Place& place, recover::VertexRecord record, const std::function<void(VertexIndex)>& declare,
           const std::vector<Index>& on_subfacets, std::array<VertexIndex, 2> split);
  bool renew_faces(VertexIndex x, Index subfacet, const std::vector<Triangle>& lost, std::array<VertexIndex, 2> split);

  const SizeField& size_;
  FacetComponents components_;
  std::size_t max_cells_;
  std::vector<Index> label_;  ///< component of each cell slot; see label_cells()
  Counts counts_;
};

}  // namespace geomesh::remesh
