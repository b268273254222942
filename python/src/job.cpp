// SPDX-License-Identifier: MIT
#include "job.hpp"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

namespace geomesh::python {
namespace {

const char* word(LogLevel level) {
  return level == LogLevel::debug ? "debug" : level == LogLevel::info ? "info" : "warning";
}

/// Wraps the function object, because threads that do not hold the interpreter's lock make and destroy copies of it.
std::shared_ptr<py::object> shared_function(py::object function) {
  return {new py::object(std::move(function)), [](py::object* object) {
            const py::gil_scoped_acquire held;
            delete object;
          }};
}

using NumberArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Calls a Python field f(x, y, z) with arrays of the coordinates of `places`, and copies the result to `values`.
void call_field(const py::object& function, std::span<const Vec3> places, std::span<double> values) {
  std::array<NumberArray, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a] = NumberArray(static_cast<py::ssize_t>(places.size()));
    double* const out = axes[a].mutable_data();
    for (std::size_t i = 0; i < places.size(); ++i) out[i] = places[i][a];
  }
  const auto found = function(axes[0], axes[1], axes[2]).cast<NumberArray>();
  if (found.ndim() != 1 || static_cast<std::size_t>(found.size()) != values.size()) {
    PyErr_SetString(PyExc_TypeError,
                    "the function of a field is to return a number for each place of the arrays x, y, z");
    throw py::error_already_set();
  }
  std::copy_n(found.data(), values.size(), values.begin());
}

}  // namespace

Job::Job(const JobRequest& request) : request_(request) { attach(); }

void Job::attach() {
  context_.cancel = &cancelled_;
  context_.threads = request_.threads;
  if (!request_.progress.is_none()) {
    context_.stage = [this](std::string_view stage, bool begins) {
      const std::lock_guard lock(mutex_);
      if (begins) events_.push_back({Event::Kind::stage, std::string(stage), {}});
      tally_ = {std::string(stage), 0, 0, false};
    };
    context_.progress = [this](std::size_t done, std::size_t total) {
      const std::lock_guard lock(mutex_);
      tally_.done = done;
      tally_.total = total;
      tally_.fresh = true;
    };
  }
  if (!request_.log.is_none())
    context_.log = [this](LogLevel level, std::string_view text) {
      const std::lock_guard lock(mutex_);
      events_.push_back({Event::Kind::log, word(level), std::string(text)});
    };
}

void Job::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
  changed_.notify_all();
}

/// Waits up to 50 ms for the end of the work. Returns false when the work has ended.
bool Job::wait() {
  const py::gil_scoped_release released;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::milliseconds(50), [&] { return finished_; });
  return !finished_;
}

void Job::watch() {
  for (bool running = true; running;) {
    running = wait();
    if (failure_) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      deliver();
    } catch (py::error_already_set& error) {
      fail(std::move(error));
    }
  }
}

void Job::deliver() {
  std::vector<Event> events;
  Tally tally;
  {
    const std::lock_guard lock(mutex_);
    events.swap(events_);
    tally = std::exchange(tally_.fresh, false) ? tally_ : Tally{};
    if (!tally.stage.empty()) tally.fresh = true;
  }
  deliver_events(events, tally);
}

void Job::deliver_events(const std::vector<Event>& events, const Tally& tally) {
  for (const Event& event : events) {
    if (event.kind == Event::Kind::stage)
      request_.progress(event.name, 0, 0);
    else
      request_.log(event.name, event.text);
  }
  if (tally.fresh) request_.progress(tally.stage, tally.done, tally.total);
}

void Job::fail(py::error_already_set&& error) {
  if (!failure_) failure_.emplace(std::move(error));
  cancelled_ = true;
}

void Job::join(std::thread& worker) {
  const py::gil_scoped_release released;
  worker.join();
}

void Job::throw_if_failed() {
  if (failure_) throw std::move(*failure_);
  if (thrown_) std::rethrow_exception(thrown_);
}

std::function<double(const Vec3&)> Job::size_function(py::object function) {
  const std::shared_ptr<py::object> shared = shared_function(std::move(function));
  return [this, shared](const Vec3& p) {
    const py::gil_scoped_acquire held;
    if (failure_) throw Error(ErrorKind::interrupted, "interrupted");
    try {
      return (*shared)(p.x, p.y, p.z).cast<double>();
    } catch (py::error_already_set& error) {
      fail(std::move(error));
    } catch (const py::cast_error&) {
      PyErr_SetString(PyExc_TypeError, "the size function is to return a number for each place (x, y, z)");
      fail(py::error_already_set());
    }
    throw Error(ErrorKind::interrupted, "interrupted");
  };
}

std::function<void(std::span<const Vec3>, std::span<double>)> Job::field_function(py::object function) {
  const std::shared_ptr<py::object> shared = shared_function(std::move(function));
  return [this, shared](std::span<const Vec3> places, std::span<double> values) {
    const py::gil_scoped_acquire held;
    if (failure_) throw Error(ErrorKind::interrupted, "interrupted");
    try {
      call_field(*shared, places, values);
      return;
    } catch (py::error_already_set& error) {
      fail(std::move(error));
    } catch (const py::cast_error&) {
      PyErr_SetString(PyExc_TypeError, "the function of a field is to return an array of numbers");
      fail(py::error_already_set());
    }
    throw Error(ErrorKind::interrupted, "interrupted");
  };
}

}  // namespace geomesh::python
