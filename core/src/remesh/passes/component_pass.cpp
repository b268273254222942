// SPDX-License-Identifier: MIT
// Inserts points inside all components concurrently. Declared in passes.hpp.
#include <atomic>
#include <deque>
#include <numeric>
#include <optional>
#include <thread>

#include "common/parallel.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

/// A component and the tools with which it is refined.
struct Work {
  MeshPart part;
  RefineStatistics statistics;
  std::optional<Toolbox> tools;
  std::atomic<std::size_t> n_cells;
  double volume = 0;
};

double volume_of(const DomainMesh& mesh) {
  double sum = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    const Tetrahedron& t = mesh.vertices(c);
    const Vec3& a = mesh.point(t[0]);
    sum += dot(cross(mesh.point(t[1]) - a, mesh.point(t[2]) - a), mesh.point(t[3]) - a);
  }
  return sum;
}

class ComponentRefiner {
 public:
  ComponentRefiner(Toolbox& tools, std::size_t max_cells, const RunContext& context)
      : tools_(tools), max_cells_(max_cells), context_(context) {
    for (MeshPart& part : tools.mesh.take_apart()) {
      Work& work = works_.emplace_back();
      work.part = std::move(part);
      work.tools.emplace(work.part.mesh, tools.guard, tools.lengths.field(), work.statistics);
      work.n_cells = work.part.mesh.n_cells();
      work.volume = volume_of(work.part.mesh);
    }
  }

  std::size_t run() {
    const std::vector<std::size_t> order = largest_first();
    std::atomic<std::size_t> next = 0;
    const unsigned threads = tools_.lengths.asks_caller() ? 1 : thread_count(context_.threads);
    for_each_task(std::min<std::size_t>(threads, order.size()), threads, [&](std::size_t) {
      for (std::size_t k; (k = next++) < order.size();) refine(works_[order[k]]);
    });
    return put_together();
  }

 private:
  /// Orders components by decreasing volume, so that a large one is not left to one core at the end.
  std::vector<std::size_t> largest_first() const {
    std::vector<std::size_t> order(works_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return works_[a].volume > works_[b].volume; });
    return order;
  }

  void refine(Work& work) {
    RunContext context;
    context.cancel = context_.cancel;
    context.threads = 1;
    context.progress = [&](std::size_t n_cells, std::size_t) {
      work.n_cells = n_cells;
      report();
    };
    work.part.mesh.sort_cells();
    refine_inside(*work.tools, max_cells_, context);
  }

  /// Checks the limit of cells over all components. Reports progress if called by the caller's own thread.
  void report() const {
    std::size_t n = 0;
    for (const Work& work : works_) n += work.n_cells;
    check_limit(n);
    if (std::this_thread::get_id() == caller_) context_.report(n, 0);
  }

  void check_limit(std::size_t n_cells) const {
    if (n_cells > max_cells_) throw_too_many_cells(max_cells_);
  }

  /// Joins the components and returns the number of new points. The target sizes at these points are stored, too.
  std::size_t put_together() {
    std::vector<MeshPart> parts;
    std::vector<double> known;
    std::size_t n_new = 0;
    for (Work& work : works_) {
      const std::vector<double> of_part =
          work.tools->lengths.known_from(static_cast<VertexIndex>(work.part.vertices.size()));
      known.insert(known.end(), of_part.begin(), of_part.end());
      n_new += work.statistics.points_inside;
      work.tools.reset();
      parts.push_back(std::move(work.part));
    }
    const auto first = static_cast<VertexIndex>(tools_.mesh.n_vertices());
    tools_.mesh.put_together(std::move(parts), context_.threads);
    tools_.lengths.add_known(first, known);
    tools_.statistics.points_inside += n_new;
    check_limit(tools_.mesh.n_cells());
    return n_new;
  }

  Toolbox& tools_;
  std::size_t max_cells_;
  const RunContext& context_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::deque<Work> works_;
};

}  // namespace

std::size_t refine_components_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context) {
  return ComponentRefiner(tools, max_cells, context).run();
}

}  // namespace geomesh::remesh
