// SPDX-License-Identifier: MIT
#include "improve/improve.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "quality/shape.hpp"

namespace geomesh::remesh {

namespace {

/// What a level does, pass by pass.
struct Schedule {
  unsigned regularizing_passes;  ///< smoothing of all vertices with flips between
  unsigned repair_passes;
  double target_angle;     ///< cells below (in the weighted measure) are repaired
  double insertion_angle;  ///< below this also by new points
  unsigned smoothing_steps;
  unsigned last_passes;  ///< over the worst alone, with points closer to others
  double progress;  ///< share of the poor cells of the best pass so far to which the next must bring their number
};

Schedule schedule_of(QualityLevel level) {
  switch (level) {
    case QualityLevel::fast:
      return {1, 2, 20, 0, 6, 0, 0.9};
    case QualityLevel::best:
      return {4, 60, 36, 30, 20, 20, 1.02};
    default:
      return {3, 8, 32, 26, 12, 8, 0.9};
  }
}

constexpr unsigned first_pass_with_points = 2;
constexpr double enough_visits = 1.5;  ///< of poor cells, by the number of all, before a lack of progress ends the repair
constexpr double worst_angle = 16;  ///< progress is measured on cells below this too
constexpr double rescue_angle = 12;
constexpr std::array rescue_rooms{0.15, 0.03};

struct BadCell {
  double shape;
  CellIndex cell;
  Tetrahedron vertices;
};

class Improver {
 public:
  Improver(Toolbox& tools, const RefineOptions& options, const RunContext& context)
      : tools_(tools),
        mesh_(tools.mesh),
        context_(context),
        schedule_(schedule_of(options.quality)),
        budget_(options.time_budget),
        start_(std::chrono::steady_clock::now()) {}

  void run() {
    for (unsigned k = 0; k < schedule_.regularizing_passes && !out_of_time(); ++k) regularize();
    std::size_t idle = 0, fewest = mesh_.n_cells(), fewest_worst = mesh_.n_cells();
    for (unsigned k = 0; k < schedule_.repair_passes && idle < 2 && !out_of_time(); ++k) {
      const std::vector<BadCell> bad = cells_below(shape_of_angle(schedule_.target_angle));
      // Where surfaces force poor shapes everywhere, repair only moves them about: passes that do not lower their number end it.
      const std::size_t worst = count_below(bad, shape_of_angle(worst_angle));
      const auto falls = [&](std::size_t now, std::size_t least) {
        return static_cast<double>(now) <= schedule_.progress * static_cast<double>(least);
      };
      const bool costly = static_cast<double>(visited_) > enough_visits * static_cast<double>(mesh_.n_cells());
      if (costly && k > first_pass_with_points && !falls(bad.size(), fewest) && !falls(worst, fewest_worst)) break;
      fewest = std::min(fewest, bad.size());
      fewest_worst = std::min(fewest_worst, worst);
      context_.report(k, schedule_.repair_passes);
      const std::size_t n = repair(bad, k);
      ++tools_.statistics.passes;
      idle = n == 0 ? idle + 1 : 0;
    }
    if (schedule_.last_passes > 0) rescue_worst();
  }

 private:
  /// The few cells that are still slivers may have points nearer to others than sizes ask: worse than that is a bad angle.
  void rescue_worst() {
    for (const double room : rescue_rooms) {
      room_ = room;
      failed_at_.clear();
      for (unsigned k = 0; k < schedule_.last_passes && !out_of_time(); ++k) {
        if (repair(cells_below(shape_of_angle(rescue_angle)), first_pass_with_points) == 0) break;
        ++tools_.statistics.passes;
      }
    }
  }

  bool out_of_time() {
    context_.check_cancelled();
    if (!(budget_ > 0)) return false;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (spent > budget_) tools_.statistics.out_of_time = true;
    return tools_.statistics.out_of_time;
  }

  std::vector<BadCell> cells_below(double limit) const {
    std::vector<BadCell> bad;
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
      if (mesh_.is_live(c) && mesh_.shape_of(c) < limit) bad.push_back({mesh_.shape_of(c), c, mesh_.vertices(c)});
    std::sort(bad.begin(), bad.end(),
              [](const BadCell& a, const BadCell& b) { return a.shape != b.shape ? a.shape < b.shape : a.cell < b.cell; });
    return bad;
  }
  static std::size_t count_below(const std::vector<BadCell>& sorted, double limit) {
    return static_cast<std::size_t>(
        std::partition_point(sorted.begin(), sorted.end(), [&](const BadCell& b) { return b.shape < limit; }) - sorted.begin());
  }
  bool unchanged(const BadCell& b) const { return mesh_.is_live(b.cell) && mesh_.vertices(b.cell) == b.vertices; }

  /// Flips where cells are poor, then every vertex towards a more even place: raises the mean, which worst-first repair leaves
  /// alone.
  void regularize() {
    for (const BadCell& b : cells_below(shape_of_angle(40)))
      if (unchanged(b)) flip(b.cell);
    const SmoothRule rule{schedule_.smoothing_steps / 2, shape_of_angle(25), true, shape_of_angle(35)};
    smooth_all(tools_, rule, context_.threads, [this] { return out_of_time(); });
  }

  bool flip(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    for (const auto& e : edge_vertices)
      if (remove_edge(tools_, c, t[e[0]], t[e[1]])) return true;
    for (unsigned i = 0; i < 4; ++i)
      if (remove_face(tools_, c, i)) return true;
    return false;
  }

  std::size_t repair(const std::vector<BadCell>& bad, unsigned pass) {
    std::size_t n = 0;
    for (const BadCell& b : bad) {
      if (++visited_ % 64 == 0 && out_of_time()) break;
      if (!unchanged(b) || known_hopeless(b.cell)) continue;
      if (repair_cell(b, pass))
        ++n;
      else if (pass >= first_pass_with_points)
        remember_failure(b.cell);
    }
    return n;
  }

  /// Everything was tried in vain, and nothing about the cell has changed since.
  bool known_hopeless(CellIndex c) {
    if (c >= failed_at_.size() || failed_at_[c] == 0) return false;
    for (const VertexIndex v : mesh_.vertices(c)) {
      mesh_.star(v, tools_.work.marks, tools_.work.cells);
      for (const CellIndex k : tools_.work.cells)
        if (mesh_.changed_at(k) > failed_at_[c]) return false;
    }
    return true;
  }
  void remember_failure(CellIndex c) {
    if (c >= failed_at_.size()) failed_at_.resize(mesh_.n_slots() + mesh_.n_slots() / 8 + 1, 0);
    failed_at_[c] = mesh_.tick();
  }

  bool repair_cell(const BadCell& b, unsigned pass) {
    if (flip(b.cell)) return true;
    const SmoothRule rule{schedule_.smoothing_steps, shape_of_angle(schedule_.target_angle + 4), false, 0};
    bool moved = false;
    for (const VertexIndex v : b.vertices) moved |= smooth_vertex(tools_, v, rule);
    if (moved || pass == 0) return moved;
    if (collapse(b)) return true;
    return pass >= first_pass_with_points && b.shape < shape_of_angle(schedule_.insertion_angle) && add_point(b);
  }

  bool collapse(const BadCell& b) {
    for (const auto& e : edge_vertices) {
      const VertexIndex u = b.vertices[e[0]], v = b.vertices[e[1]];
      if (try_collapse(tools_, u, v, CollapseRule::improve) || try_collapse(tools_, v, u, CollapseRule::improve)) return true;
    }
    return false;
  }

  bool add_point(const BadCell& b) {
    for (const auto& e : edge_vertices)
      if (split_to_improve(tools_, b.cell, b.vertices[e[0]], b.vertices[e[1]], room_)) return true;
    return insert_to_improve(tools_, b.cell, room_);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  const RunContext& context_;
  Schedule schedule_;
  double budget_;
  double room_ = usual_room;
  std::size_t visited_ = 0;  // poor cells, over all passes
  std::vector<std::uint64_t> failed_at_;  // by cell: the mesh's time then; 0: never
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  Improver(tools, options, context).run();
}

}  // namespace geomesh::remesh
