// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads JSON that other programs wrote.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

namespace geomesh::geomodel {

/// Parses JSON text; returns a discarded value if the text is not JSON. Values that are nested deeper than any file for
/// this program are dropped, because recursion over deep nesting would overflow the stack.
template <class Input>
nlohmann::json parse_foreign_json(Input&& input) {
  constexpr int most_depth = 64;
  const auto is_shallow = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) { return depth <= most_depth; };
  return nlohmann::json::parse(std::forward<Input>(input), is_shallow, false);
}

}  // namespace geomesh::geomodel
