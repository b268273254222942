// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/facet_bisection.hpp"

#include <map>
#include <set>
#include <unordered_set>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

class Bisection {
 public:
  Bisection(Complex& complex, double longest) : complex_(complex), longest_(longest) {
    for (const auto& s : complex.segments) held_.insert(edge_key(s.a, s.b));
  }

  bool run(const std::function<bool(Index)>& is_asked) {
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      const EdgeKey edge = longest_edge(f);
      if (length_of(edge) > longest_ && is_asked(f)) mark(edge);
    }
    if (middle_.empty()) return false;
    close_marks();
    split();
    return true;
  }

 private:
  EdgeKey edge(const Triangle& t, std::size_t k) const { return edge_key(t[(k + 1) % 3], t[(k + 2) % 3]); }
  double length_of(const EdgeKey& e) const { return length(complex_.points[e.second] - complex_.points[e.first]); }
  /// The edge opposite to this corner is the longest; of equal ones that of the least vertices, from whatever side.
  std::size_t corner_across(const Triangle& t) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      const EdgeKey e = edge(t, k), b = edge(t, best);
      if (length_of(e) > length_of(b) || (length_of(e) == length_of(b) && e < b)) best = k;
    }
    return best;
  }
  EdgeKey longest_edge(Index f) const { return edge(complex_.facets[f], corner_across(complex_.facets[f])); }

  bool mark(const EdgeKey& e) {
    if (held_.contains(e) || !middle_.try_emplace(e, no_vertex).second) return false;
    return true;
  }

  /// Where an edge of a facet is marked its longest one is, too.
  void close_marks() {
    for (bool changed = true; changed;) {
      changed = false;
      for (Index f = 0; f < complex_.facets.size(); ++f) {
        const Triangle& t = complex_.facets[f];
        for (std::size_t k = 0; k < 3; ++k)
          if (middle_.contains(edge(t, k))) {
            changed |= mark(longest_edge(f));
            break;
          }
      }
    }
  }

  VertexIndex middle_of(const EdgeKey& e) {
    const auto at = middle_.find(e);
    if (at == middle_.end()) return no_vertex;
    if (at->second != no_vertex) return at->second;
    const Vec3 p = 0.5 * (complex_.points[e.first] + complex_.points[e.second]);
    if (!places_.insert(p).second) {
      middle_.erase(at);
      return no_vertex;
    }
    complex_.points.push_back(p);
    complex_.input_point.push_back(no_index);
    return at->second = static_cast<VertexIndex>(complex_.points.size() - 1);
  }

  void split() {
    places_.insert(complex_.points.begin(), complex_.points.end());
    std::vector<Triangle> facets;
    OriginLists origins;
    std::vector<std::uint8_t> dirty;
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      pieces_.clear();
      split_facet(complex_.facets[f]);
      for (const Triangle& t : pieces_) {
        facets.push_back(t);
        origins.push(complex_.origins.of(f));
        dirty.push_back(pieces_.size() > 1 ? std::uint8_t{1} : complex_.dirty_facet[f]);
      }
    }
    complex_.facets = std::move(facets);
    complex_.origins = std::move(origins);
    complex_.dirty_facet = std::move(dirty);
  }

  /// At the longest of its marked edges, then the halves at theirs.
  void split_facet(const Triangle& t) {
    std::size_t best = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const EdgeKey e = edge(t, k);
      if (!middle_.contains(e)) continue;
      if (best == 3 || length_of(e) > length_of(edge(t, best))) best = k;
    }
    const VertexIndex m = best == 3 ? no_vertex : middle_of(edge(t, best));
    if (m == no_vertex) {
      if (best != 3) return split_facet(t);  // that middle was taken
      pieces_.push_back(t);
      return;
    }
    const VertexIndex a = t[best], b = t[(best + 1) % 3], c = t[(best + 2) % 3];
    split_facet({a, b, m});
    split_facet({a, m, c});
  }

  Complex& complex_;
  double longest_;
  std::set<EdgeKey> held_;                 ///< of wells
  std::map<EdgeKey, VertexIndex> middle_;  ///< of edges that are marked
  std::unordered_set<Vec3, PointHash> places_;
  std::vector<Triangle> pieces_;
};

}  // namespace

bool bisect_facets(Complex& complex, double longest, const std::function<bool(Index)>& is_asked) {
  return Bisection(complex, longest).run(is_asked);
}

}  // namespace geomesh::geomodel::arrangement
