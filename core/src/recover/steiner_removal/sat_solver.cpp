// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/sat_solver.hpp"

#include <algorithm>

namespace geomesh::recover {

namespace {

constexpr std::uint32_t no_occurrence = 0xFFFFFFFFu, no_watch = 0xFFFFFFFFu;

/// Returns term i (from 0) of the restart sequence 1 1 2 1 1 2 4 ... of Luby, Sinclair and Zuckerman 1993.
std::size_t luby(std::size_t i) {
  std::size_t size = 1, power = 0;
  while (size < i + 1) {
    size = 2 * size + 1;
    ++power;
  }
  while (size - 1 != i) {
    size = (size - 1) / 2;
    --power;
    i %= size;
  }
  return std::size_t{1} << power;
}

}  // namespace

std::uint32_t SatSolver::new_variable() {
  const std::uint32_t v = static_cast<std::uint32_t>(values_.size());
  values_.push_back(-1);
  phase_.push_back(0);
  level_of_.push_back(0);
  reason_.push_back(no_reason);
  activity_.push_back(0);
  seen_.push_back(0);
  first_choice_.push_back(no_occurrence);
  first_flag_.push_back(no_occurrence);
  first_watch_.resize(first_watch_.size() + 2, no_watch);
  heap_place_.push_back(-1);
  heap_insert(v);
  return v;
}

void SatSolver::reserve(std::size_t n_variables, std::size_t n_clauses, std::size_t n_literals) {
  for (std::vector<std::int8_t>* v : {&values_, &phase_}) v->reserve(n_variables);
  for (std::vector<std::uint32_t>* v : {&level_of_, &reason_, &first_choice_, &first_flag_, &heap_})
    v->reserve(n_variables);
  activity_.reserve(n_variables);
  seen_.reserve(n_variables);
  heap_place_.reserve(n_variables);
  trail_.reserve(n_variables);
  first_watch_.reserve(2 * n_variables);
  clauses_.reserve(n_clauses);
  watches_.reserve(2 * n_clauses);
  literals_.reserve(n_literals);
  choices_.reserve(n_clauses);
  chosen_.reserve(n_literals);
  occurrences_.reserve(n_literals + n_clauses);
}

void SatSolver::add_clause(std::span<const Literal> literals) {
  if (literals.empty()) {
    contradictory_ = true;
  } else if (literals.size() == 1) {
    if (value(literals[0]) == 0) contradictory_ = true;
    if (value(literals[0]) < 0) assign(literals[0], no_reason);
  } else {
    store_clause(literals);
  }
}

void SatSolver::add_choice(std::span<const std::uint32_t> variables, std::uint32_t flag) {
  if (variables.empty() || (variables.size() == 1 && flag == no_variable)) return;
  const std::uint32_t choice = static_cast<std::uint32_t>(choices_.size()),
                      begin = static_cast<std::uint32_t>(chosen_.size());
  chosen_.insert(chosen_.end(), variables.begin(), variables.end());
  choices_.push_back({begin, static_cast<std::uint32_t>(chosen_.size()), flag});
  for (std::uint32_t v : variables) add_occurrence(first_choice_[v], choice);
  if (flag != no_variable) add_occurrence(first_flag_[flag], choice);
}

void SatSolver::add_occurrence(std::uint32_t& first, std::uint32_t choice) {
  occurrences_.push_back({choice, first});
  first = static_cast<std::uint32_t>(occurrences_.size() - 1);
}

std::uint32_t SatSolver::store_clause(std::span<const Literal> literals) {
  const std::uint32_t c = static_cast<std::uint32_t>(clauses_.size());
  clauses_.push_back({static_cast<std::uint32_t>(literals_.size()), static_cast<std::uint32_t>(literals.size())});
  literals_.insert(literals_.end(), literals.begin(), literals.end());
  for (std::uint32_t k = 0; k < 2; ++k) {
    watches_.push_back({literals[1 - k], no_watch});
    watch(literals[k], 2 * c + k);
  }
  return c;
}

void SatSolver::watch(Literal watched, std::uint32_t watch) {
  std::uint32_t& first = first_watch_[(~watched).code()];
  watches_[watch].next = first;
  first = watch;
}

void SatSolver::assign(Literal l, std::uint32_t reason) {
  values_[l.variable()] = l.is_negated() ? 0 : 1;
  level_of_[l.variable()] = level();
  reason_[l.variable()] = reason;
  trail_.push_back(l);
}

/// Propagates all assignments. Returns false on a conflict: one literal in conflict_ must be true, but all are false.
bool SatSolver::propagate() {
  while (propagated_ < trail_.size()) {
    const Literal l = trail_[propagated_++];
    if (!(l.is_negated() ? propagate_flag(l.variable()) : propagate_choices(l.variable())) || !propagate_clauses(l))
      return false;
  }
  return true;
}

/// Makes the literal `effect` true because `cause` is true. Returns false if `effect` is already false.
bool SatSolver::imply(Literal cause, Literal effect) {
  const int v = value(effect);
  if (v == 0) conflict_ = {~cause, effect};
  if (v < 0) assign(effect, by_literal | cause.code());
  return v != 0;
}

/// After a variable has become true, makes all others of its at-most-one constraints false, and their flags true.
bool SatSolver::propagate_choices(std::uint32_t variable) {
  const Literal cause = Literal::yes(variable);
  for (std::uint32_t o = first_choice_[variable]; o != no_occurrence; o = occurrences_[o].next) {
    const Choice& choice = choices_[occurrences_[o].choice];
    for (std::uint32_t k = choice.begin; k < choice.end; ++k)
      if (chosen_[k] != variable && !imply(cause, Literal::no(chosen_[k]))) return false;
    if (choice.flag != no_variable && !imply(cause, Literal::yes(choice.flag))) return false;
  }
  return true;
}

/// After the flag of an at-most-one constraint has become false, makes all variables of the constraint false.
bool SatSolver::propagate_flag(std::uint32_t flag) {
  for (std::uint32_t o = first_flag_[flag]; o != no_occurrence; o = occurrences_[o].next) {
    const Choice& choice = choices_[occurrences_[o].choice];
    for (std::uint32_t k = choice.begin; k < choice.end; ++k)
      if (!imply(Literal::no(flag), Literal::no(chosen_[k]))) return false;
  }
  return true;
}

/// Visits the clauses in which the negation of `made_true` is watched.
bool SatSolver::propagate_clauses(Literal made_true) {
  const Literal falsified = ~made_true;
  std::uint32_t* link = &first_watch_[made_true.code()];
  while (*link != no_watch) {
    const std::uint32_t w = *link;
    if (value(watches_[w].blocker) == 1) {
      link = &watches_[w].next;
      continue;
    }
    Literal* l = literals_.data() + clauses_[w / 2].begin;
    if (l[0] == falsified) std::swap(l[0], l[1]);
    watches_[w].blocker = l[0];
    if (value(l[0]) != 1 && find_other_watch(w / 2)) {
      *link = watches_[w].next;
      watch(l[1], w);
      continue;
    }
    link = &watches_[w].next;
    if (value(l[0]) == 1) continue;
    if (value(l[0]) == 0) {
      conflict_.assign(l, l + clauses_[w / 2].size);
      return false;
    }
    assign(l[0], w / 2);
  }
  return true;
}

/// Exchanges the second literal of a clause for a later one that is not false. Returns false if there is none.
bool SatSolver::find_other_watch(std::uint32_t clause) {
  Literal* l = literals_.data() + clauses_[clause].begin;
  for (std::uint32_t k = 2; k < clauses_[clause].size; ++k) {
    if (value(l[k]) == 0) continue;
    std::swap(l[1], l[k]);
    return true;
  }
  return false;
}

/// Collects in conflict_ the false literals because of which the literal `implied` had to be true.
void SatSolver::collect_reason(std::uint32_t reason, Literal implied) {
  conflict_.clear();
  if (reason & by_literal) {
    conflict_.push_back(~Literal::from_code(reason & ~by_literal));
    return;
  }
  const Clause& c = clauses_[reason];
  for (std::uint32_t k = 0; k < c.size; ++k)
    if (literals_[c.begin + k] != implied) conflict_.push_back(literals_[c.begin + k]);
}

/// Learns the clause of the first unique implication point, with the asserted literal in front, and undoes assignments
/// down to the level at which the clause asserts this literal.
void SatSolver::learn() {
  learned_.assign(1, Literal());
  std::size_t open = 0, place = trail_.size();
  Literal l;
  for (;;) {
    for (const Literal& k : conflict_) {
      const std::uint32_t v = k.variable();
      if (seen_[v] || level_of_[v] == 0) continue;
      seen_[v] = 1;
      bump(v);
      if (level_of_[v] == level()) {
        ++open;
      } else {
        learned_.push_back(k);
      }
    }
    do l = trail_[--place];
    while (!seen_[l.variable()]);
    seen_[l.variable()] = 0;
    if (--open == 0) break;
    collect_reason(reason_[l.variable()], l);
  }
  learned_[0] = ~l;
  std::uint32_t back = 0;
  for (std::size_t k = 1; k < learned_.size(); ++k) {
    seen_[learned_[k].variable()] = 0;
    if (level_of_[learned_[k].variable()] > back) {
      back = level_of_[learned_[k].variable()];
      std::swap(learned_[1], learned_[k]);
    }
  }
  undo_to(back);
  assign(learned_[0], learned_.size() == 1 ? no_reason : store_clause(learned_));
  increment_ /= 0.95;
}

void SatSolver::undo_to(std::uint32_t level) {
  if (this->level() <= level) return;
  for (std::size_t i = trail_.size(); i-- > level_begin_[level];) {
    const std::uint32_t v = trail_[i].variable();
    phase_[v] = values_[v];
    values_[v] = -1;
    if (heap_place_[v] < 0) heap_insert(v);
  }
  trail_.resize(level_begin_[level]);
  level_begin_.resize(level);
  propagated_ = trail_.size();
}

void SatSolver::bump(std::uint32_t variable) {
  constexpr double largest = 1e100;
  if ((activity_[variable] += increment_) > largest) {
    for (double& a : activity_) a /= largest;
    increment_ /= largest;
  }
  if (heap_place_[variable] >= 0) heap_up(static_cast<std::size_t>(heap_place_[variable]));
}

/// Assigns the unassigned variable that comes first in the order of decision. Returns false if there is none.
bool SatSolver::decide() {
  while (!heap_.empty()) {
    const std::uint32_t v = heap_[0];
    heap_place_[v] = -1;
    heap_[0] = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      heap_place_[heap_[0]] = 0;
      heap_down(0);
    }
    if (values_[v] >= 0) continue;
    level_begin_.push_back(static_cast<std::uint32_t>(trail_.size()));
    assign(phase_[v] == 0 ? Literal::no(v) : Literal::yes(v), no_reason);
    return true;
  }
  return false;
}

Satisfiability SatSolver::solve(std::size_t max_conflicts) {
  constexpr std::size_t restart_unit = 64;
  std::size_t n_conflicts = 0, n_restarts = 0, until_restart = restart_unit;
  if (contradictory_) return Satisfiability::unsatisfiable;
  for (;;) {
    if (propagate()) {
      if (until_restart == 0) {
        until_restart = restart_unit * luby(++n_restarts);
        undo_to(0);
      }
      if (!decide()) return Satisfiability::satisfiable;
      continue;
    }
    if (level() == 0) return Satisfiability::unsatisfiable;
    if (++n_conflicts > max_conflicts) return Satisfiability::unknown;
    learn();
    until_restart -= until_restart > 0;
  }
}

void SatSolver::heap_insert(std::uint32_t variable) {
  heap_place_[variable] = static_cast<std::int32_t>(heap_.size());
  heap_.push_back(variable);
  heap_up(heap_.size() - 1);
}

void SatSolver::heap_up(std::size_t i) {
  const std::uint32_t v = heap_[i];
  for (; i > 0 && heap_less(v, heap_[(i - 1) / 2]); i = (i - 1) / 2) {
    heap_[i] = heap_[(i - 1) / 2];
    heap_place_[heap_[i]] = static_cast<std::int32_t>(i);
  }
  heap_[i] = v;
  heap_place_[v] = static_cast<std::int32_t>(i);
}

void SatSolver::heap_down(std::size_t i) {
  const std::uint32_t v = heap_[i];
  for (std::size_t child = 2 * i + 1; child < heap_.size(); child = 2 * i + 1) {
    if (child + 1 < heap_.size() && heap_less(heap_[child + 1], heap_[child])) ++child;
    if (!heap_less(heap_[child], v)) break;
    heap_[i] = heap_[child];
    heap_place_[heap_[i]] = static_cast<std::int32_t>(i);
    i = child;
  }
  heap_[i] = v;
  heap_place_[v] = static_cast<std::int32_t>(i);
}

}  // namespace geomesh::recover
