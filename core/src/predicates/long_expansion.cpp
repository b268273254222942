// SPDX-License-Identifier: MIT
#include "predicates/long_expansion.hpp"

#include <algorithm>

namespace geomesh::exact {

LongExpansion quotient(const LongExpansion& n, const LongExpansion& d, double part) {
  constexpr int most_terms = 12;
  const double divisor = d.estimate();
  if (divisor == 0) return 0.5;
  LongExpansion out, rest = n;
  for (int i = 0; i < most_terms && !rest.is_zero(); ++i) {
    const double term = rest.estimate() / divisor;
    const double whole = std::fabs(out.estimate()), from_one = std::fabs((LongExpansion(1) - out).estimate());
    if (i > 0 && std::fabs(term) < part * std::min(whole, from_one)) break;
    if (std::fabs(term) < 0x1p-250) break;
    out = out + LongExpansion(term);
    rest = n - d * out;
  }
  return out;
}

}  // namespace geomesh::exact
