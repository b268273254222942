// SPDX-License-Identifier: MIT
/// @file
/// One run of the library under Python: without the interpreter's lock, with progress, and ended by Ctrl-C.
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

/// What a caller in Python gives besides the data.
struct JobRequest {
  py::object progress = py::none();  ///< called as progress(stage, done, total); total 0 where it is not known
  py::object log = py::none();       ///< called as log(level, text): "debug", "info", "warning"
  unsigned threads = 0;              ///< 0: all cores
};

/// Runs the work in a thread of its own while the calling thread passes progress on and looks for signals, 20 times a
/// second. Callbacks run in the calling thread, so they may do what they like; where one throws, the run is cancelled
/// and the exception passed on. Call with the interpreter's lock held.
class Job {
 public:
  explicit Job(const JobRequest& request);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// `work(context)`; rethrows what it throws.
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

  /// A size function of Python as the library wants it: f(x, y, z) gives a length; what is not positive asks for
  /// nothing. May outlive the job only unused.
  std::function<double(const Vec3&)> size_function(py::object function);

  /// A scalar field of Python as the library wants it: f(x, y, z) of three arrays of one length gives an array of that
  /// length. May outlive the job only unused.
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
  std::mutex mutex_;  ///< of all below
  std::condition_variable changed_;
  std::vector<Event> events_;
  Tally tally_;
  bool finished_ = false;
  std::exception_ptr thrown_;
  std::optional<py::error_already_set> failure_;  ///< of a callback, or KeyboardInterrupt; touched with the lock held
};

/// Turns the library's errors into those of geomesh.core.errors, for a module being initialised. `describe` may add to
/// the exception object (surfaces, triangles).
void register_errors(void (*describe)(const Error& error, py::object& exception) = nullptr);

}  // namespace geomesh::python
