// SPDX-License-Identifier: GPL-3.0-or-later
// Removes parts of surfaces inside bodies, declared in arrangement/clip/clip.hpp.
#include <algorithm>
#include <sstream>

#include "arrangement/clip/body_shape.hpp"
#include "arrangement/clip/clip.hpp"
#include "arrangement/clip/facet_components.hpp"
#include "arrangement/clip/lost_beside_body.hpp"
#include "arrangement/clip/scarps.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

class BodyCutter {
 public:
  BodyCutter(ClipContext context, const Complex& complex)
      : context_(context), arranged_(context.arranged), complex_(complex), is_cutter_(context.surfaces.size(), 0) {}

  void add(BodyShape&& shape) {
    winding_.emplace_back(complex_.points, shape.triangles);
    is_cutter_[shape.surface] = context_.surfaces[shape.surface].cuts_all;
    bodies_.push_back(std::move(shape));
  }

  void resolve_self_crossing(std::size_t body) {
    const BodyShape& shape = bodies_[body];
    if (!shape.closed) {
      context_.result.warnings.push_back(
          "body " + context_.surfaces[shape.surface].name +
          " crosses itself and is open: its inner walls are kept, as what they enclose is not defined");
      return;
    }
    std::vector<std::uint8_t> own(arranged_.facets.size(), 0), none(arranged_.facets.size(), 0);
    for (std::size_t f = 0; f < own.size(); ++f)
      for (const Origin& o : arranged_.origins.of(f)) own[f] |= o.surface == shape.surface;
    const auto component = components(arranged_, own, none, [](auto edge) { return edge.size() == 2; });
    std::vector<std::uint8_t> is_inner, inner(own.size(), 0);
    for (const Index f : largest_facets(arranged_, component)) is_inner.push_back(has_body_on_both_sides(body, f));
    double removed = 0;
    for (std::size_t f = 0; f < own.size(); ++f) {
      if (!own[f]) continue;
      inner[f] = is_inner[component[f]];
      if (inner[f]) removed += facet_area(arranged_, f);
    }
    remove_origins(arranged_, inner, [&](Index, const Origin& o) { return o.surface == shape.surface; });
    if (removed == 0) return;
    std::ostringstream text;
    text << "body " << context_.surfaces[shape.surface].name
         << " crosses itself; what lies inside by its winding number counts as the body, and " << removed
         << " of area of its inner walls was removed";
    context_.result.warnings.push_back(text.str());
    context_.result.area_clipped_by_bodies[shape.surface] += removed;
  }

  void cut() {
    std::vector<std::uint8_t> chosen(arranged_.facets.size(), 0), barrier(arranged_.facets.size(), 0);
    const std::vector<std::uint8_t> stays = scarps(arranged_, context_.surfaces);
    for (std::size_t f = 0; f < chosen.size(); ++f)
      for (const Origin& o : arranged_.origins.of(f)) {
        chosen[f] |= is_cut(o.surface);
        barrier[f] |= is_cutter_[o.surface];
      }
    for (std::size_t f = 0; f < chosen.size(); ++f)
      if (barrier[f] || stays[f]) chosen[f] = 0;  // a facet on a body is not strictly inside that body
    const auto component = components(arranged_, chosen, barrier, [&](auto edge) {
      return std::none_of(edge.begin(), edge.end(), [&](const FacetEdge& e) { return barrier[e.facet] != 0; });
    });
    std::vector<Index> body_of;  // per component
    for (const Index f : largest_facets(arranged_, component)) body_of.push_back(body_around(f));
    std::vector<std::uint8_t> inside(chosen.size(), 0);
    for (std::size_t f = 0; f < chosen.size(); ++f) {
      if (!chosen[f]) continue;
      inside[f] = body_of[component[f]] != no_index;
      if (inside[f]) note_cut(f, body_of[component[f]]);
    }
    report_cuts();
    if (context_.tolerance > 0) note_lost(inside, [&](std::size_t f) { return body_of[component[f]]; });
    remove_origins(arranged_, inside, [this](Index, const Origin& o) { return is_cut(o.surface); });
  }

  const Displacement& lost() const { return lost_; }

 private:
  bool is_cut(Index surface) const {
    const TriangulatedSurface& s = context_.surfaces[surface];
    return (s.kind == SurfaceKind::horizon || s.kind == SurfaceKind::fault) && !s.ends_model;
  }
  RayDirection direction(const BodyShape& shape, std::size_t axis) const {
    return shape.closed ? RayDirection{axis, true} : *shape.open_direction;
  }

  /// Returns whether the inside of the body is on both sides of the facet. The winding numbers just above and just
  /// below the facet differ by the contribution of the triangles that coincide with it.
  bool has_body_on_both_sides(std::size_t body, std::size_t f) const {
    const BodyShape& shape = bodies_[body];
    const Triangle& t = arranged_.facets[f];
    const Projection frame = projection_of(arranged_.vertices.rounded(t[0]), arranged_.vertices.rounded(t[1]),
                                           arranged_.vertices.rounded(t[2]));
    std::vector<Index> own;
    for (const Origin& o : arranged_.origins.of(f))
      if (o.surface == shape.surface) own.push_back(o.triangle);
    const RayDirection ray = RayDirection{3 - frame.i - frame.j, true};
    const ExactPoint q = facet_centroid(arranged_, t);
    std::sort(own.begin(), own.end());
    const int beyond =
        winding_[body](arranged_.vertices.frame(), q, arranged_.vertices.frame().to_nearest(q), ray, own);
    int own_sum = 0;
    for (const Index triangle : own) own_sum += winding_[body].contribution(triangle, ray.axis);
    return beyond != 0 && beyond + own_sum != 0;
  }

  Index body_around(std::size_t f) const {
    const ExactPoint q = facet_centroid(arranged_, arranged_.facets[f]);
    const Vec3 p = arranged_.vertices.frame().to_nearest(q);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!context_.surfaces[bodies_[b].surface].cuts_all) continue;
      const Box3& box = winding_[b].box();
      bool near = true;
      for (std::size_t i = 0; i < 3; ++i) near &= p[i] >= box.min[i] && p[i] <= box.max[i];
      if (near && winding_[b](arranged_.vertices.frame(), q, p, direction(bodies_[b], 2)) != 0)
        return bodies_[b].surface;
    }
    return no_index;
  }

  void note_cut(std::size_t f, Index body) {
    for (const Origin& o : arranged_.origins.of(f)) {
      if (!is_cut(o.surface)) continue;
      Spot& spot = cuts_[{o.surface, body}];
      if (spot.count == 0)
        spot = {"cut by body", o.surface, body, 0, 0, arranged_.vertices.rounded(arranged_.facets[f][0])};
      ++spot.count;
      spot.measure += facet_area(arranged_, f);
      context_.result.area_clipped_by_bodies[o.surface] += facet_area(arranged_, f);
    }
  }
  /// Records how far facets inside bodies are from the rest of their surface. `body_of` returns the body around a
  /// facet.
  template <typename BodyOf>
  void note_lost(const std::vector<std::uint8_t>& inside, BodyOf&& body_of) {
    std::map<Index, std::map<Index, CutOff>> cut_off;  // facets that bodies cut off, by body and surface
    std::vector<std::vector<Index>> left(context_.surfaces.size());
    for (Index f = 0; f < arranged_.facets.size(); ++f)
      for (const Origin& o : arranged_.origins.of(f)) {
        if (!inside[f])
          left[o.surface].push_back(f);
        else if (is_cut(o.surface))
          cut_off[body_of(f)][o.surface].gone.push_back(f);
      }
    for (const BodyShape& shape : bodies_) {
      const auto by_this = cut_off.find(shape.surface);
      if (by_this == cut_off.end()) continue;
      const BodyAsGiven body(context_.surfaces[shape.surface], shape, context_.tolerance);
      for (auto& [surface, cut] : by_this->second) {
        cut.left = left[surface];
        const Displacement here = body.lost(arranged_, cut);
        if (here.largest > lost_.largest) lost_ = here;
      }
    }
  }
  void report_cuts() {
    for (const auto& cut : cuts_) context_.result.spots.push_back(cut.second);
  }

  ClipContext context_;
  Arranged& arranged_;
  const Complex& complex_;
  std::vector<BodyShape> bodies_;
  std::vector<WindingNumber> winding_;
  std::vector<std::uint8_t> is_cutter_;  ///< for each surface, whether it is a body with an inside that cuts all others
  std::map<std::pair<Index, Index>, Spot> cuts_;
  Displacement lost_;
};

}  // namespace

Displacement cut_by_bodies(ClipContext context, const Complex& complex, const Ingested& ingested,
                           const std::optional<Box3>& box, const std::vector<std::uint8_t>& crosses_itself) {
  BodyCutter cutter(context, complex);
  std::vector<Index> rows;
  bool any_cuts = false;
  for (Index s = 0; s < context.surfaces.given.size(); ++s) {
    const TriangulatedSurface& surface = context.surfaces[s];
    if (surface.kind != SurfaceKind::body || surface.triangles.empty()) continue;
    BodyShape shape = body_shape(complex, ingested, context.surfaces, s, box);
    if (!shape.closed) {
      std::ostringstream text;
      text << "body " << surface.name << " is not closed: a border of length " << shape.border_length
           << " is open near " << to_text(shape.border_place);
      text << (shape.open_direction ? "; it lies outside the box, so inside is still defined there"
                                    : "; what is inside it is not defined, so it cuts nothing");
      context.result.warnings.push_back(text.str());
    }
    if (!shape.has_inside()) continue;
    any_cuts |= surface.cuts_all;
    cutter.add(std::move(shape));
    rows.push_back(s);
  }
  for (std::size_t b = 0; b < rows.size(); ++b)
    if (crosses_itself[rows[b]]) cutter.resolve_self_crossing(b);
  if (any_cuts) cutter.cut();
  return cutter.lost();
}

}  // namespace geomesh::geomodel::arrangement
