// SPDX-License-Identifier: MIT
#include "tetrahedralize/recovery_attempts.hpp"

#include <algorithm>

#include "recover/model/recovery_budget.hpp"

namespace geomesh {

namespace {

/// With doubles near their places.
unsigned most_attempts(const RecoverOptions& options) {
  if (options.mode == MeshMode::conforming) return 1;  // constrained mode follows
  return std::min(options.max_attempts, recover::recovery_budget.attempts);
}

}  // namespace

const char* Attempt::difference() const {
  if (doubles == recover::DoublesTried::all_of_star)
    return "Steiner points held exactly, all doubles of their stars tried";
  if (order == InsertionOrder::hard_parts_first) return "Steiner points held exactly, hard parts recovered first";
  if (places == SteinerPlaces::exact) return "Steiner points held exactly";
  return "Steiner points rounded as they are made";
}

Attempt attempt_of(unsigned number, const recover::HardPartsFirst& hard_parts) {
  Attempt out;
  out.number = number;
  if (number > 0) out.places = SteinerPlaces::exact;
  if (number > 1 && hard_parts.has_learned()) out.order = InsertionOrder::hard_parts_first;
  return out;
}

std::optional<Attempt> attempt_after(const Attempt& attempt, const RecoverOptions& options,
                                     const recover::HardPartsFirst& hard_parts, const Hopeless& hopeless) {
  const bool tried_all = attempt.doubles == recover::DoublesTried::all_of_star;
  if (!tried_all && !hopeless.near_places && attempt.number + 1 < most_attempts(options))
    return attempt_of(attempt.number + 1, hard_parts);
  if (most_attempts(options) < recover::recovery_budget.attempts) return std::nullopt;  // the caller has another way
  if (tried_all && (hopeless.all_of_star || attempt.number >= recover::recovery_budget.attempts_all_of_star))
    return std::nullopt;
  Attempt out;
  out.number = tried_all ? attempt.number + 1 : 1;
  out.places = SteinerPlaces::exact;
  out.doubles = recover::DoublesTried::all_of_star;
  return out;
}

}  // namespace geomesh
