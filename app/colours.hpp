// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Colours on a terminal: errors are red, warnings yellow, a positive verdict green.
#pragma once

#include <string>
#include <string_view>

namespace geomesh::app {

class Colours {
 public:
  Colours() = default;  ///< none
  /// Returns the colours for output to this file descriptor. There are none if it is not a terminal or a dumb one, or
  /// if the variable NO_COLOR is set and not empty (no-color.org).
  static Colours of(int descriptor);

  std::string error(std::string_view text) const { return painted("31;1", text); }
  std::string warning(std::string_view text) const { return painted("33;1", text); }
  std::string good(std::string_view text) const { return painted("32;1", text); }

 private:
  std::string painted(std::string_view code, std::string_view text) const;
  bool shown_ = false;
};

}  // namespace geomesh::app
