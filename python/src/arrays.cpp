// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include "geomesh/core/error.hpp"

namespace geomesh::python {
namespace {

std::string shape_words(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

template <class Number>
bool fits(Number value) {
  if constexpr (std::is_signed_v<Number>)
    if (value < 0) return false;
  return static_cast<std::uint64_t>(value) < no_vertex - 1;  // two numbers mean "no vertex" and "infinite vertex"
}

template <class Number>
std::vector<VertexIndex> rows_of(const py::array& array, const char* what) {
  const auto typed = py::array_t<Number, py::array::c_style>::ensure(array);
  std::vector<VertexIndex> rows(static_cast<std::size_t>(typed.size()));
  const Number* const values = typed.data();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!fits(values[i]))
      throw Error(ErrorKind::usage, std::string(what) + ": " + std::to_string(values[i]) +
                                        " is no row of points; rows count from 0, and triangles have no filling");
    rows[i] = static_cast<VertexIndex>(values[i]);
  }
  return rows;
}

}  // namespace

std::span<const Vec3> as_points(const PointArray& array, const char* what) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw Error(ErrorKind::usage,
                std::string(what) + ": an array of shape (n, 3) was expected, found " + shape_words(array));
  return {reinterpret_cast<const Vec3*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

std::vector<VertexIndex> as_rows(const py::array& array, std::size_t columns, const char* what) {
  if (array.size() == 0) return {};
  if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(columns))
    throw Error(ErrorKind::usage, std::string(what) + ": an array of shape (n, " + std::to_string(columns) +
                                      ") was expected, found " + shape_words(array));
  const char kind = array.dtype().kind();
  const auto bytes = array.dtype().itemsize();
  if (kind == 'i') return bytes == 4 ? rows_of<std::int32_t>(array, what) : rows_of<std::int64_t>(array, what);
  if (kind == 'u') return bytes == 4 ? rows_of<std::uint32_t>(array, what) : rows_of<std::uint64_t>(array, what);
  throw Error(ErrorKind::usage, std::string(what) + ": whole numbers were expected (an integer array), found dtype " +
                                    py::str(array.dtype()).cast<std::string>());
}

std::vector<Triangle> as_triangles(const py::array& array, const char* what) {
  const std::vector<VertexIndex> rows = as_rows(array, 3, what);
  std::vector<Triangle> triangles(rows.size() / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) triangles[t] = {rows[3 * t], rows[3 * t + 1], rows[3 * t + 2]};
  return triangles;
}

}  // namespace geomesh::python
