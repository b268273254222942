// SPDX-License-Identifier: GPL-3.0-or-later
#include "colours.hpp"

#include <unistd.h>

#include <cstdlib>

namespace geomesh::app {

Colours Colours::of(int descriptor) {
  const char *const no_colour = std::getenv("NO_COLOR"), *const terminal = std::getenv("TERM");
  Colours colours;
  colours.shown_ =
      isatty(descriptor) != 0 && !(no_colour && *no_colour) && !(terminal && std::string_view(terminal) == "dumb");
  return colours;
}

std::string Colours::painted(std::string_view code, std::string_view text) const {
  if (!shown_) return std::string(text);
  return "\033[" + std::string(code) + "m" + std::string(text) + "\033[0m";
}

}  // namespace geomesh::app
