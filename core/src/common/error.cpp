// SPDX-License-Identifier: MIT
#include "geomesh/core/error.hpp"

#include <cstring>

namespace geomesh::detail {

void fail_check(const char* invariant, const char* file, int line) {
  const char* slash = std::strrchr(file, '/');
  throw InternalError(std::string("internal error: ") + invariant + " does not hold (" + (slash ? slash + 1 : file) +
                      ":" + std::to_string(line) + ")");
}

}  // namespace geomesh::detail
