// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// JSON that others wrote.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

namespace geomesh::geomodel {

/// Discarded where the text is no JSON. What is nested deeper than any file here needs is left out: values are copied
/// and printed by functions that call themselves, and deep ones overrun the stack.
template <class Input>
nlohmann::json parse_foreign_json(Input&& input) {
  constexpr int most_depth = 64;
  const auto is_shallow = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) { return depth <= most_depth; };
  return nlohmann::json::parse(std::forward<Input>(input), is_shallow, false);
}

}  // namespace geomesh::geomodel
