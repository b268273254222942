// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/vtk_data.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

#include "vtk_files/typed.hpp"

namespace geomesh::geomodel {

std::size_t size_of(VtkType type) {
  return with_type(type, [](auto zero) { return sizeof zero; });
}

std::string name_of(VtkType type) {
  static constexpr const char* names[] = {"signed char", "unsigned char", "short", "unsigned short",
                                          "int",         "unsigned int",  "long",  "unsigned long",
                                          "float",       "double",        "bit",   "string"};
  return names[static_cast<std::size_t>(type)];
}

double VtkColumn::number(std::size_t i) const {
  return with_type(type, [&](auto zero) {
    std::memcpy(&zero, bytes.data() + i * sizeof zero, sizeof zero);
    return static_cast<double>(zero);
  });
}

std::vector<double> VtkColumn::numbers() const {
  std::vector<double> all(n_tuples * n_components);
  with_type(type, [&](auto value) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
      all[i] = static_cast<double>(value);
    }
  });
  return all;
}

namespace {

template <class T>
std::int64_t whole(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    constexpr double most = 9007199254740992;  // 2^53, the largest integer up to which all integers are doubles
    const bool is_whole = value >= -most && value <= most && std::floor(value) == value;
    return is_whole ? static_cast<std::int64_t>(value) : -1;
  } else {
    return std::in_range<std::int64_t>(value) ? static_cast<std::int64_t>(value) : -1;
  }
}

}  // namespace

std::vector<std::int64_t> VtkColumn::whole_numbers() const {
  std::vector<std::int64_t> all(n_tuples * n_components);
  with_type(type, [&](auto value) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
      all[i] = whole(value);
    }
  });
  return all;
}

const VtkColumn* VtkTable::numbers(std::string_view name) const {
  for (const VtkColumn& column : columns)
    if (column.name == name && !column.is_text()) return &column;
  return nullptr;
}

const VtkColumn* VtkTable::texts(std::string_view name) const {
  for (const VtkColumn& column : columns)
    if (column.name == name && column.is_text()) return &column;
  return nullptr;
}

void VtkTable::put(VtkColumn column) {
  for (VtkColumn& known : columns)
    if (known.name == column.name) {
      known = std::move(column);
      return;
    }
  columns.push_back(std::move(column));
}

}  // namespace geomesh::geomodel
