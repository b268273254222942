// SPDX-License-Identifier: MIT
/// @file
/// Conversion between arrays of numpy and of the library: input is checked and copied at most once, output is viewed.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::python {

namespace py = pybind11;

/// A float64 array of shape (n, 3) with consecutive rows: the caller's own if it already has this form.
using PointArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the rows as points, in the array's own memory. Throws Error{usage} if the shape is not (n, 3).
std::span<const Vec3> as_points(const PointArray& array, const char* what);

/// Returns the rows of an integer array of shape (n, columns), any integer type. Throws Error{usage} if the shape or
/// the type differs, or if a number is negative or too large for a row.
std::vector<VertexIndex> as_rows(const py::array& array, std::size_t columns, const char* what);
std::vector<Triangle> as_triangles(const py::array& array, const char* what);

/// Returns a read-only view of `n` items, each with `width` numbers from `first`, `stride` bytes apart; `owner` is kept
/// alive with it. Width 0: one number per item, and a view of one dimension.
template <class Number>
py::array view(const Number* first, std::size_t n, std::size_t width, std::size_t stride, const py::handle& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(n)}, strides{static_cast<py::ssize_t>(stride)};
  if (width > 0) {
    shape.push_back(static_cast<py::ssize_t>(width));
    strides.push_back(sizeof(Number));
  }
  py::array array(py::dtype::of<Number>(), shape, strides, first, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Returns a view of `width` numbers that begin at `member(item)` in each item of a vector.
template <class Item, class Member>
py::array view_member(const std::vector<Item>& items, std::size_t width, const py::handle& owner, Member&& member) {
  static const Item none{};
  return view(member(items.empty() ? none : items.front()), items.size(), width, sizeof(Item), owner);
}

inline py::array view_points(const std::vector<Vec3>& points, const py::handle& owner) {
  return view(reinterpret_cast<const double*>(points.data()), points.size(), 3, sizeof(Vec3), owner);
}
template <class Number>
py::array view_numbers(const std::vector<Number>& numbers, const py::handle& owner) {
  return view(numbers.data(), numbers.size(), 0, sizeof(Number), owner);
}
template <std::size_t width>
py::array view_rows(const std::vector<std::array<VertexIndex, width>>& rows, const py::handle& owner) {
  return view(reinterpret_cast<const VertexIndex*>(rows.data()), rows.size(), width, width * sizeof(VertexIndex),
              owner);
}

static_assert(sizeof(Vec3) == 3 * sizeof(double));

}  // namespace geomesh::python
