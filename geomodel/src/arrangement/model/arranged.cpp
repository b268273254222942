// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/arranged.hpp"

#include <algorithm>
#include <numeric>

#include "arrangement/model/memory_bound.hpp"
#include "common/parallel.hpp"
#include "common/union_find.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

ExactPoint construct(const Complex& complex, const ExactFrame& frame, const Symbol& s) {
  const auto& p = complex.points;
  if (!s.is_line_plane()) return line_line_point(frame, p[s.a], p[s.b], p[s.c], p[s.d]);
  const Triangle& t = complex.facets[s.c];
  return line_plane_point(frame, p[s.a], p[s.b], {p[t[0]], p[t[1]], p[t[2]]});
}

/// Finds vertices at equal places; the one with the smallest index represents each place.
class Identification {
 public:
  explicit Identification(const ExactVertices& vertices) : vertices_(vertices) {}

  /// `candidates` may repeat.
  void run(std::vector<Index> candidates) {
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    parallel_sort(candidates.begin(), candidates.end(), [this](Index a, Index b) {
      const int order = compare_lexicographic(vertices_.rounded(a), vertices_.rounded(b));
      return order != 0 ? order < 0 : a < b;
    });
    alias_.resize(vertices_.size() - vertices_.n_given());
    std::iota(alias_.begin(), alias_.end(), static_cast<Index>(vertices_.n_given()));
    for (std::size_t begin = 0, end; begin < candidates.size(); begin = end) {
      for (end = begin + 1;
           end < candidates.size() && vertices_.rounded(candidates[begin]) == vertices_.rounded(candidates[end]);)
        ++end;
      join(candidates, begin, end);
    }
  }
  Index operator()(Index v) const { return vertices_.is_made(v) ? alias_[v - vertices_.n_given()] : v; }

 private:
  /// Unites vertices begin..end at equal exact places; they have equal doubles and are ascending.
  void join(const std::vector<Index>& rows, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin + 1; k < end; ++k)
      for (std::size_t m = begin; m < k; ++m)
        if ((*this)(rows[m]) == rows[m] && equal(vertices_.exact(rows[m]), vertices_.exact(rows[k]))) {
          alias_[rows[k] - vertices_.n_given()] = rows[m];
          break;
        }
  }
  const ExactVertices& vertices_;
  std::vector<Index> alias_;
};

/// Constructs each place where facets meet in a round of the arrangement, and identifies vertices at equal places.
class Places {
 public:
  Places(const Complex& complex, const Contacts& contacts, ExactVertices& vertices)
      : complex_(complex), contacts_(contacts), vertices_(vertices), identify_(vertices) {
    for (const FacetContact& c : contacts_.facets)
      for (std::size_t k = 0; k < c.n_ends; ++k) note(c.ends[k]);
    for (const SegmentContact& c : contacts_.segments) note(c.point);
    for (const FacetContact& c : contacts_.facets) note_corners(c.facet);
    for (const Overlap& o : contacts_.overlaps) {
      note_corners(o.a);
      note_corners(o.b);
    }
    parallel_sort(symbols_.begin(), symbols_.end());
    symbols_.erase(std::unique(symbols_.begin(), symbols_.end()), symbols_.end());
    std::vector<ExactPoint> made(symbols_.size());
    std::vector<Vec3> rounded(symbols_.size());
    const ExactFrame& frame = vertices_.frame();
    parallel_for(symbols_.size(), [&](std::size_t k) {
      made[k] = construct(complex_, frame, symbols_[k]);
      rounded[k] = frame.to_nearest(made[k]);
    });
    vertices_.append(std::move(made), std::move(rounded));
    identify();
  }

  /// Repeats the search for vertices at equal places after vertices were added.
  void identify() {
    std::vector<Index> candidates = active_;
    for (std::size_t v = vertices_.n_given(); v < vertices_.size(); ++v) candidates.push_back(static_cast<Index>(v));
    identify_.run(std::move(candidates));
  }

  /// Returns the one vertex that stands for all vertices at the place of v.
  Index operator()(Index v) const { return identify_(v); }
  Index row_of(const Symbol& s) const {
    if (s.is_point()) return s.a;
    const auto at = std::lower_bound(symbols_.begin(), symbols_.end(), s) - symbols_.begin();
    return identify_(static_cast<Index>(vertices_.n_given() + static_cast<std::size_t>(at)));
  }

  /// As in Arranged.
  std::vector<std::array<Index, 2>> contact_ends() const {
    std::vector<std::array<Index, 2>> out(contacts_.facets.size());
    parallel_for(out.size(), [&](std::size_t k) { out[k] = resolve(contacts_.facets[k]); });
    return out;
  }

 private:
  void note(const Symbol& s) {
    if (s.is_point())
      active_.push_back(s.a);
    else
      symbols_.push_back(s);
  }
  void note_corners(Index facet) {
    active_.insert(active_.end(), complex_.facets[facet].begin(), complex_.facets[facet].end());
  }

  std::array<Index, 2> resolve(const FacetContact& c) const {
    std::array<Index, 2> ends{row_of(c.ends[0]), no_index};
    for (std::size_t k = 1; k < c.n_ends; ++k) {
      const Index v = row_of(c.ends[k]);
      if (v == ends[0] || v == ends[1]) continue;
      GEOMESH_CHECK(ends[1] == no_index);  // closed triangles that are not coplanar meet in a point or a segment
      ends[1] = v;
    }
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    return ends;
  }

  const Complex& complex_;
  const Contacts& contacts_;
  ExactVertices& vertices_;
  Identification identify_;
  std::vector<Index> active_;  ///< corners of facets that meet others, where intersection points may lie
  std::vector<Symbol> symbols_;
};

/// Clusters of facets that overlap, and facets that only cross others, in the order of their least facet indices.
class Clusters {
 public:
  Clusters(const Complex& complex, const Contacts& contacts) {
    UnionFind clusters(complex.facets.size());
    for (const Overlap& o : contacts.overlaps) clusters.unite(o.a, o.b);
    for (const FacetContact& c : contacts.facets) members_.emplace_back(clusters.find(c.facet), c.facet);
    for (const Overlap& o : contacts.overlaps) {
      members_.emplace_back(clusters.find(o.a), o.a);
      members_.emplace_back(clusters.find(o.b), o.b);
    }
    parallel_sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    for (std::size_t k = 0; k < members_.size(); ++k)
      if (k == 0 || members_[k].first != members_[k - 1].first) begin_.push_back(k);
    begin_.push_back(members_.size());
  }

  std::size_t size() const { return begin_.size() - 1; }
  Index least_facet(std::size_t cluster) const { return members_[begin_[cluster]].second; }
  /// Returns, for each facet, whether it overlaps or crosses other facets, so that it belongs to a cluster.
  std::vector<std::uint8_t> is_member(std::size_t n_facets) const {
    std::vector<std::uint8_t> out(n_facets, 0);
    for (const auto& m : members_) out[m.second] = 1;
    return out;
  }
  /// Returns a cluster of facets with the contacts on them; `contact_ends` are the end vertices of all contacts.
  ClusterInput input(std::size_t cluster, const Contacts& contacts,
                     const std::vector<std::array<Index, 2>>& contact_ends) const {
    ClusterInput input;
    for (std::size_t k = begin_[cluster]; k < begin_[cluster + 1]; ++k) {
      const Index facet = members_[k].second;
      input.members.push_back(facet);
      const auto begin = std::lower_bound(contacts.facets.begin(), contacts.facets.end(), facet,
                                          [](const FacetContact& c, Index f) { return c.facet < f; });
      for (auto c = begin; c != contacts.facets.end() && c->facet == facet; ++c) {
        const auto& ends = contact_ends[static_cast<std::size_t>(c - contacts.facets.begin())];
        if (ends[1] == no_index)
          input.points.push_back(ends[0]);
        else
          input.constraints.push_back({ends[0], ends[1], c->line});
      }
    }
    return input;
  }

 private:
  std::vector<std::pair<Index, Index>> members_;  ///< pairs (least facet of a cluster, one of its facets), sorted
  std::vector<std::size_t> begin_;
};

/// Sorts vertices on a well's segment from its first end to its second.
void sort_along(std::vector<Index>& rows, const PolygonSoup::Segment& segment, const ExactVertices& vertices) {
  const Vec3 &a = vertices.rounded(segment.a), &b = vertices.rounded(segment.b);
  std::size_t axis = 0;
  while (a[axis] == b[axis]) ++axis;
  const Sign along = a[axis] < b[axis] ? Sign::negative : Sign::positive;
  std::sort(rows.begin(), rows.end(), [&](Index v, Index w) {
    return v != w && compare_coordinate(vertices.exact(v), vertices.exact(w), axis) == along;
  });
}

/// One exact round: computes the places of contacts, splits clusters of facets, and assembles the resulting complex.
class Round {
 public:
  Round(const Complex& complex, const Contacts& contacts, const RunContext& context, std::size_t max_bytes)
      : complex_(complex),
        contacts_(contacts),
        context_(context),
        memory_(max_bytes, contacts.size() * MemoryUse::per_contact),
        result_{ExactVertices(complex.points, ExactFrame(complex.points)), {}, {}, {}, {}, {}, {}},
        places_(complex, contacts, result_.vertices) {}

  Arranged run() {
    result_.contact_ends = places_.contact_ends();
    context_.check_cancelled();
    const Clusters clusters(complex_, contacts_);
    triangulate(clusters);
    context_.check_cancelled();
    number_made_points();
    gather_facets(clusters);
    split_segments();
    result_.isolated_points = complex_.isolated_points;
    return std::move(result_);
  }

 private:
  void triangulate(const Clusters& clusters) {
    pieces_.resize(clusters.size());
    parallel_for(pieces_.size(), [&](std::size_t k) {
      if (context_.cancel && context_.cancel->load(std::memory_order_relaxed)) return;
      pieces_[k] = triangulate_cluster(complex_, result_.vertices, clusters.input(k, contacts_, result_.contact_ends));
      memory_.take(pieces_[k].facets.size(), MemoryUse::per_facet,
                   complex_.points[complex_.facets[clusters.least_facet(k)][0]]);
    });
  }

  /// Adds points made in clusters of overlapping facets, in the clusters' order, and unites vertices at equal places.
  void number_made_points() {
    std::vector<ExactPoint> made;
    std::vector<Vec3> rounded;
    auto row = static_cast<Index>(result_.vertices.size());
    for (ClusterPieces& p : pieces_) {
      for (Triangle& t : p.facets)
        for (VertexIndex& v : t)
          if (v & ClusterPieces::made_here) v = row + (v & ~ClusterPieces::made_here);
      row += static_cast<Index>(p.made.size());
      std::move(p.made.begin(), p.made.end(), std::back_inserter(made));
      rounded.insert(rounded.end(), p.made_rounded.begin(), p.made_rounded.end());
    }
    if (made.empty()) return;
    result_.vertices.append(std::move(made), std::move(rounded));
    places_.identify();
  }

  void gather_facets(const Clusters& clusters) {
    const std::vector<std::uint8_t> is_member = clusters.is_member(complex_.facets.size());
    std::size_t cluster = 0;
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      if (!is_member[f]) {
        result_.facets.push_back(complex_.facets[f]);
        result_.origins.push(complex_.origins.of(f));
        result_.changed.push_back(0);
      } else if (cluster < pieces_.size() && clusters.least_facet(cluster) == f) {
        const ClusterPieces& p = pieces_[cluster++];
        for (std::size_t k = 0; k < p.facets.size(); ++k) {
          result_.facets.push_back({places_(p.facets[k][0]), places_(p.facets[k][1]), places_(p.facets[k][2])});
          result_.origins.push(p.origins.of(k));
          result_.changed.push_back(1);
        }
      }
    }
  }

  void split_segments() {
    auto contact = contacts_.segments.begin();
    for (Index s = 0; s < complex_.segments.size(); ++s) {
      const PolygonSoup::Segment& segment = complex_.segments[s];
      std::vector<Index> on{segment.a, segment.b};
      for (; contact != contacts_.segments.end() && contact->segment == s; ++contact)
        on.push_back(places_.row_of(contact->point));
      std::sort(on.begin(), on.end());
      on.erase(std::unique(on.begin(), on.end()), on.end());
      sort_along(on, segment, result_.vertices);
      for (std::size_t k = 0; k + 1 < on.size(); ++k) result_.segments.push_back({on[k], on[k + 1], segment.polyline});
    }
  }

  const Complex& complex_;
  const Contacts& contacts_;
  const RunContext& context_;
  MemoryUse memory_;
  Arranged result_;
  Places places_;
  std::vector<ClusterPieces> pieces_;
};

}  // namespace

void ExactVertices::append(std::vector<ExactPoint>&& points, std::vector<Vec3>&& rounded) {
  std::move(points.begin(), points.end(), std::back_inserter(made_));
  made_rounded_.insert(made_rounded_.end(), rounded.begin(), rounded.end());
}

Arranged arrange_round(const Complex& complex, const Contacts& contacts, const RunContext& context,
                       std::size_t max_bytes) {
  return Round(complex, contacts, context, max_bytes).run();
}

}  // namespace geomesh::geomodel::arrangement
