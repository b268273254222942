// SPDX-License-Identifier: MIT
#include "tetrahedralize/recovery_attempts.hpp"

#include <algorithm>

#include "recover/model/recovery_budget.hpp"

namespace geomesh {

namespace {

unsigned most_attempts(const RecoverOptions& options) {
  if (options.mode == MeshMode::conforming) return 1;  // constrained mode follows
  return std::min(options.max_attempts, recover::recovery_budget.attempts);
}

}  // namespace

const char* Attempt::difference() const {
  if (order == InsertionOrder::hard_parts_first) return "Steiner points held exactly, hard parts recovered first";
  if (places == SteinerPlaces::exact) return "Steiner points held exactly";
  return "Steiner points rounded as they are made";
}

Attempt attempt_of(unsigned number, const RecoverOptions& options, const recover::HardPartsFirst& hard_parts) {
  Attempt out;
  out.number = number;
  if (options.mode == MeshMode::constrained && options.max_attempts > 1) out.places = SteinerPlaces::exact;
  if (number > 1 && hard_parts.has_learned()) out.order = InsertionOrder::hard_parts_first;
  return out;
}

std::optional<Attempt> attempt_after(const Attempt& attempt, const RecoverOptions& options,
                                     const recover::HardPartsFirst& hard_parts) {
  if (attempt.number + 1 >= most_attempts(options)) return std::nullopt;
  return attempt_of(attempt.number + 1, options, hard_parts);
}

}  // namespace geomesh
