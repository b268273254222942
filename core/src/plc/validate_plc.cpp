// SPDX-License-Identifier: MIT
// Checks the invariants of a PiecewiseLinearComplex that are declared in geomesh/core/plc.hpp.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/sort_unique.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {

namespace {

class Validator {
 public:
  explicit Validator(const PiecewiseLinearComplex& plc) : plc_(plc) {}

  std::vector<PlcFault> run() {
    check_points();
    check_facets();
    if (!faults_.empty()) return std::move(faults_);
    check_segments();
    check_repeated_triangles();
    return std::move(faults_);
  }

 private:
  void fault(std::string message, ErrorContext context) { faults_.push_back({std::move(message), std::move(context)}); }
  bool in_range(VertexIndex v) const { return v < plc_.points.size(); }

  void check_points() {
    for (VertexIndex v = 0; v < plc_.points.size(); ++v) {
      const Vec3& p = plc_.points[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        fault("vertex " + std::to_string(v) + " has a coordinate that is not finite", {{}, {}, {v}, {}});
    }
    if (!faults_.empty()) return;
    if (!exponents_are_safe(plc_.points))
      fault("the coordinates span more orders of magnitude than exact arithmetic in doubles holds", {});
    std::vector<VertexIndex> order(plc_.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](VertexIndex a, VertexIndex b) {
      const int c = compare_lexicographic(plc_.points[a], plc_.points[b]);
      return c != 0 ? c < 0 : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (plc_.points[order[i - 1]] == plc_.points[order[i]])
        fault("vertices " + std::to_string(order[i - 1]) + " and " + std::to_string(order[i]) +
                  " are equal: merge them first",
              {{}, {}, {order[i - 1], order[i]}, {plc_.points[order[i]]}});
  }

  void check_facets() {
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      if (plc_.n_loops(f) == 0) fault("facet " + std::to_string(f) + " has no loop", {{f}, {}, {}, {}});
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) check_loop(f, plc_.loop(l));
      if (!faults_.empty() || plc_.n_loops(f) != 1 || plc_.outer_loop(f).size() != 3) continue;
      const auto t = plc_.outer_loop(f);
      if (collinear(plc_.points[t[0]], plc_.points[t[1]], plc_.points[t[2]]))
        fault("facet " + std::to_string(f) + " is a triangle of no area",
              {{f}, {}, {t[0], t[1], t[2]}, {plc_.points[t[0]], plc_.points[t[1]], plc_.points[t[2]]}});
    }
  }
  void check_loop(Index f, std::span<const VertexIndex> loop) {
    const bool is_triangle = loop.size() == 3 && loop[0] != loop[1] && loop[1] != loop[2] && loop[2] != loop[0];
    if (is_triangle && std::all_of(loop.begin(), loop.end(), [&](VertexIndex v) { return in_range(v); })) return;
    const std::string name = "facet " + std::to_string(f);
    for (VertexIndex v : loop)
      if (!in_range(v))
        return fault(name + " names vertex " + std::to_string(v) + ", which does not exist", {{f}, {}, {}, {}});
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (loop[i] == loop[(i + 1) % loop.size()])
        fault(name + " repeats a vertex in a row", {{f}, {}, {loop[i]}, {plc_.points[loop[i]]}});
    std::vector<VertexIndex> distinct(loop.begin(), loop.end());
    sort_unique(distinct);
    if (distinct.size() < 3) fault(name + " has a loop of fewer than three vertices", {{f}, {}, distinct, {}});
  }

  void check_segments() {
    const auto check = [&](const std::string& name, VertexIndex a, VertexIndex b) {
      if (!in_range(a) || !in_range(b)) {
        fault(name + " names a vertex that does not exist", {});
      } else if (a == b) {
        fault(name + " joins a vertex with itself", {{}, {}, {a}, {plc_.points[a]}});
      }
    };
    for (Index s = 0; s < plc_.segments.size(); ++s)
      check("segment " + std::to_string(s), plc_.segments[s].a, plc_.segments[s].b);
    for (const auto& s : plc_.facet_segments) check("a segment inside facet " + std::to_string(s.facet), s.a, s.b);
    for (const auto& p : plc_.facet_points)
      if (!in_range(p.v)) fault("a point inside facet " + std::to_string(p.facet) + " does not exist", {});
    for (VertexIndex v : plc_.isolated_points)
      if (!in_range(v)) fault("isolated vertex " + std::to_string(v) + " does not exist", {});
  }

  struct Entry {
    Triangle key;  ///< sorted
    Index facet;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  /// Returns the triangular facets, grouped by their smallest vertex: those of vertex v begin in row begin[v].
  std::vector<Entry> triangles_by_vertex(std::vector<std::size_t>& begin) const {
    std::vector<Entry> entries;
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      if (plc_.n_loops(f) != 1 || plc_.outer_loop(f).size() != 3) continue;
      const auto t = plc_.outer_loop(f);
      Triangle key{t[0], t[1], t[2]};
      std::sort(key.begin(), key.end());
      entries.push_back({key, f});
    }
    begin.assign(plc_.points.size() + 1, 0);
    for (const Entry& e : entries) ++begin[e.key[0] + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Entry> out(entries.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const Entry& e : entries) out[next[e.key[0]]++] = e;
    return out;
  }
  void check_repeated_triangles() {
    std::vector<std::size_t> begin;
    std::vector<Entry> entries = triangles_by_vertex(begin);
    for (VertexIndex v = 0; v < plc_.points.size(); ++v)
      std::sort(entries.data() + begin[v], entries.data() + begin[v + 1]);
    for (std::size_t i = 1; i < entries.size(); ++i)
      if (entries[i - 1].key == entries[i].key)
        fault("facets " + std::to_string(entries[i - 1].facet) + " and " + std::to_string(entries[i].facet) +
                  " are the same triangle",
              {{entries[i - 1].facet, entries[i].facet}, {}, {}, {plc_.points[entries[i].key[0]]}});
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<PlcFault> faults_;
};

}  // namespace

std::vector<PlcFault> validate_plc(const PiecewiseLinearComplex& plc) { return Validator(plc).run(); }

}  // namespace geomesh
