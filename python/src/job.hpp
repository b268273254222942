// SPDX-License-Identifier: MIT
/// @file
/// One run of the library under Python: without the interpreter's lock, with progress, and cancelled by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::python {

namespace py = pybind11;

/// Callbacks and number of threads that a caller in Python passes to every function that does long work.
struct JobRequest {
  py::object progress = py::none();  ///< called as progress(stage, done, total); total is 0 if it is not known
  py::object log = py::none();       ///< called as log(level, text): "debug", "info", "warning"
  unsigned threads = 0;              ///< 0: all cores
};

/// Runs the work in a thread of its own while the calling thread reports progress and checks for signals, 20 times a
/// second. Callbacks run in the calling thread, so they are unrestricted; if one throws, the run is cancelled and the
/// exception passed on. Call with the interpreter's lock held.
class Job {
 public:
  explicit Job(const JobRequest& request);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Runs `work(context)` in a thread of its own, waits for its end and rethrows its exceptions.
  template <class Work>
  auto run(Work&& work) {
    using Result = decltype(work(std::declval<const RunContext&>()));
    std::optional<Result> result;
    std::thread worker([&] {
      try {
        result.emplace(work(context_));
      } catch (...) {
        thrown_ = std::current_exception();
      }
      finish();
    });
    watch();
    join(worker);
    throw_if_failed();
    return std::move(*result);
  }

  /// Converts a size function of Python to that of the library: f(x, y, z) returns a length; a value that is not
  /// positive requests nothing. It must not be called after the job has ended.
  std::function<double(const Vec3&)> size_function(py::object function);

  /// Converts a scalar field of Python to that of the library: f(x, y, z) of three arrays of one length returns an
  /// array of that length. It must not be called after the job has ended.
  std::function<void(std::span<const Vec3>, std::span<double>)> field_function(py::object function);

 private:
  struct Event {
    enum class Kind { stage, log } kind;
    std::string name, text;
  };
  struct Tally {
    std::string stage;
    std::size_t done = 0, total = 0;
    bool fresh = false;
  };
  void attach();
  void finish();
  void watch();
  bool wait();
  void deliver();
  void deliver_events(const std::vector<Event>& events, const Tally& tally);
  void fail(py::error_already_set&& error);
  static void join(std::thread& worker);
  void throw_if_failed();

  JobRequest request_;
  RunContext context_;
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;  ///< locked by a thread that uses the members below
  std::condition_variable changed_;
  std::vector<Event> events_;
  Tally tally_;
  bool finished_ = false;
  std::exception_ptr thrown_;
  /// Exception of a callback, or KeyboardInterrupt; accessed with the lock held.
  std::optional<py::error_already_set> failure_;
};

/// Converts the library's errors to those of geomesh.core.errors, for a module being initialised. `describe` may add to
/// the exception object (surfaces, triangles).
void register_errors(void (*describe)(const Error& error, py::object& exception) = nullptr);

}  // namespace geomesh::python
