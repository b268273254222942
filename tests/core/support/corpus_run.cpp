// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_run.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <mutex>
#include <thread>

namespace geomesh::test {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slowness = 10;  // of what sanitizers watch
#else
constexpr double slowness = 1;
#endif

/// Sets a cancel token after a time unless it is destroyed before.
class Watchdog {
 public:
  explicit Watchdog(double seconds)
      : thread_([this, seconds] {
          std::unique_lock lock(mutex_);
          if (!ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return done_; })) expired_ = true;
        }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    ended_.notify_one();
    thread_.join();
  }
  const std::atomic<bool>& expired() const { return expired_; }

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::atomic<bool> expired_{false};
  std::thread thread_;
};

}  // namespace

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

CorpusRun run_and_judge(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, double time_limit,
                        const RunContext& watch) {
  CorpusRun run;
  const Watchdog watchdog(slowness * time_limit);
  RunContext context;
  context.log = watch.log;
  context.stage = watch.stage;
  context.threads = 1;
  context.cancel = &watchdog.expired();
  const double start = thread_cpu_seconds();
  try {
    run.mesh = tetrahedralize(plc, options, context);
  } catch (const Error& e) {
    run.error = e.kind();
    run.trouble = e.kind() == ErrorKind::interrupted ? "hangs" : std::string("error: ") + e.what();
  } catch (const std::exception& e) {
    run.trouble = std::string("bug: ") + e.what();
  }
  run.cpu_seconds = thread_cpu_seconds() - start;
  if (run.mesh)
    for (const std::string& fault : check_tetrahedralization(plc, options, *run.mesh)) run.trouble += fault + "; ";
  return run;
}

TetrahedralizeOptions constrained_mode() { return {}; }
TetrahedralizeOptions preserving_mode() {
  TetrahedralizeOptions options;
  options.recover.preserve_boundary = true;
  return options;
}
TetrahedralizeOptions conforming_mode() {
  TetrahedralizeOptions options;
  options.recover.mode = MeshMode::conforming;
  return options;
}

void write_poly(const PiecewiseLinearComplex& plc, const std::string& path) {
  std::ofstream out(path);
  out.precision(17);
  out << plc.points.size() << " 3 0 0\n";
  for (std::size_t i = 0; i < plc.points.size(); ++i)
    out << i << ' ' << plc.points[i].x << ' ' << plc.points[i].y << ' ' << plc.points[i].z << '\n';
  out << plc.n_facets() << " 0\n";
  for (Index f = 0; f < plc.n_facets(); ++f) {
    std::size_t n_inner = 0;
    for (const auto& s : plc.facet_segments) n_inner += s.facet == f;
    out << plc.n_loops(f) + n_inner << ' ' << plc.n_loops(f) - 1 << '\n';
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
      out << plc.loop(l).size();
      for (VertexIndex v : plc.loop(l)) out << ' ' << v;
      out << '\n';
    }
    for (const auto& s : plc.facet_segments)
      if (s.facet == f) out << "2 " << s.a << ' ' << s.b << '\n';
    for (std::size_t h = 1; h < plc.n_loops(f); ++h) out << h << " 0 0 0\n";  // the readers here find holes by order
  }
  const auto seeds = [&](const auto& list, bool with_id) {
    out << list.size() << '\n';
    for (std::size_t i = 0; i < list.size(); ++i) {
      out << i << ' ' << list[i].point.x << ' ' << list[i].point.y << ' ' << list[i].point.z;
      if (with_id) out << ' ' << list[i].id << " -1";
      out << '\n';
    }
  };
  seeds(plc.hole_seeds, false);
  seeds(plc.region_seeds, true);
}

}  // namespace geomesh::test
