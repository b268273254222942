// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/tolerance_ledger.hpp"

#include <algorithm>
#include <utility>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

ToleranceLedger ToleranceLedger::of_length(double length) {
  ToleranceLedger ledger;
  ledger.left_ = length;
  return ledger;
}

ToleranceLedger ToleranceLedger::of_sizes(double share) {
  ToleranceLedger ledger;
  ledger.share_ = share;
  return ledger;
}

double ToleranceLedger::bound() const {
  double sum = requested();
  for (const ToleranceUse& use : uses_)
    if (use.by_own_key) sum += use.taken;
  return sum;
}

void ToleranceLedger::follow_size(double largest) {
  if (follows_sizes()) left_ = share_ * largest;
}

void ToleranceLedger::take(ToleranceUse use) {
  if (!use.by_own_key && use.taken > 0) {
    if (!(use.taken <= left_))
      throw InternalError("tolerance: " + use.stage + " uses " + std::to_string(use.taken) + " of " +
                          std::to_string(left_) + " that are left");
    const double rest = 1 - use.taken / left_;
    left_ *= rest;
    share_ *= rest;
    taken_ += use.taken;
  }
  uses_.push_back(std::move(use));
}

void ToleranceLedger::limit_share(double share) { share_ = follows_sizes() ? std::min(share_, share) : share; }

}  // namespace geomesh::geomodel
