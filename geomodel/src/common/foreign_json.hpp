// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads JSON that other programs wrote.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

namespace geomesh::geomodel {

/// Returns a discarded value if the text is not JSON. Values nested deeper than any file here needs are dropped,
/// because recursive functions copy and print values, and deep nesting overflows the stack.
template <class Input>
nlohmann::json parse_foreign_json(Input&& input) {
  constexpr int most_depth = 64;
  const auto is_shallow = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) { return depth <= most_depth; };
  return nlohmann::json::parse(std::forward<Input>(input), is_shallow, false);
}

}  // namespace geomesh::geomodel
