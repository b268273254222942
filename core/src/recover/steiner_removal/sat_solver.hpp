// SPDX-License-Identifier: MIT
/// @file
/// A small solver for propositional formulas in conjunctive normal form: conflict-driven clause learning with two
/// watched literals, activities and restarts (Marques-Silva and Sakallah 1999, "GRASP"; Moskewicz et al. 2001, "Chaff";
/// Een and Sorensson 2003, "An extensible SAT-solver"). "At most one of these" is a separate kind of constraint,
/// because it would otherwise cause nearly all clauses of a filling. Deterministic; designed for some thousand
/// variables and as many conflicts, so learned clauses are never deleted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace geomesh::recover {

/// A literal: variable v itself (code 2v) or negated (code 2v + 1).
class Literal {
 public:
  Literal() = default;
  static Literal yes(std::uint32_t variable) { return from_code(2 * variable); }
  static Literal no(std::uint32_t variable) { return from_code(2 * variable + 1); }
  std::uint32_t variable() const { return code_ >> 1; }
  bool is_negated() const { return code_ & 1u; }
  std::uint32_t code() const { return code_; }
  Literal operator~() const { return from_code(code_ ^ 1u); }
  bool operator==(const Literal&) const = default;
  static Literal from_code(std::uint32_t code) {
    Literal l;
    l.code_ = code;
    return l;
  }

 private:
  std::uint32_t code_ = 0;
};

enum class Satisfiability { satisfiable, unsatisfiable, unknown };

/// Invariants between calls of solve(): only consequences of the clauses alone are assigned; each clause of two or more
/// literals is watched by its first two.
class SatSolver {
 public:
  static constexpr std::uint32_t no_variable = 0xFFFFFFFFu;

  /// Adds a variable. It is first tried as false (prefer_yes changes this). Variables are decided in the order of their
  /// creation until conflicts change the order.
  std::uint32_t new_variable();
  /// Reserves memory for `n_clauses` clauses of `n_literals` literals in all, and as much for at-most-one constraints.
  void reserve(std::size_t n_variables, std::size_t n_clauses, std::size_t n_literals);
  void prefer_yes(std::uint32_t variable) { phase_[variable] = 1; }
  std::size_t n_variables() const { return values_.size(); }

  /// Adds the constraint that at least one of `literals` is true. Must be called before solve().
  void add_clause(std::span<const Literal> literals);
  /// Adds the constraint that at most one of `variables` is true, and that `flag` (another variable, or no_variable) is
  /// true if one of them is. Must be called before solve().
  void add_choice(std::span<const std::uint32_t> variables, std::uint32_t flag = no_variable);

  /// Decides whether the formula can be satisfied. Returns unknown after `max_conflicts` conflicts.
  Satisfiability solve(std::size_t max_conflicts);
  /// Returns the value of a variable of the formula, after solve() has returned satisfiable.
  bool is_true(std::uint32_t variable) const { return values_[variable] == 1; }

 private:
  static constexpr std::uint32_t no_reason = 0xFFFFFFFFu;
  static constexpr std::uint32_t by_literal =
      0x80000000u;  ///< bit of a stored reason for a literal: set if the reason is a literal instead of a clause

  /// Entry of the list of clauses that watch a literal. Clause c has the entries 2c and 2c + 1, one for each of its two
  /// watched literals.
  struct Watch {
    Literal blocker;  ///< another literal of the clause: if it is true the clause need not be examined
    std::uint32_t next;
  };
  struct Clause {
    std::uint32_t begin, size;
  };
  /// A constraint of the formula: at most one of its variables is true.
  struct Choice {
    std::uint32_t begin, end, flag;
  };
  /// An occurrence of a variable in an at-most-one constraint, or as the flag of one.
  struct Occurrence {
    std::uint32_t choice, next;
  };

  /// Returns the value of a literal of the formula: -1 if unassigned, else 0 or 1.
  int value(Literal l) const {
    return values_[l.variable()] < 0 ? -1 : values_[l.variable()] ^ static_cast<int>(l.is_negated());
  }
  std::uint32_t level() const { return static_cast<std::uint32_t>(level_begin_.size()); }
  void assign(Literal l, std::uint32_t reason);
  std::uint32_t store_clause(std::span<const Literal> literals);
  void watch(Literal watched, std::uint32_t watch);
  bool propagate();
  bool propagate_clauses(Literal falsified);
  bool propagate_choices(std::uint32_t variable);
  bool propagate_flag(std::uint32_t flag);
  bool imply(Literal cause, Literal effect);
  bool find_other_watch(std::uint32_t clause);
  void add_occurrence(std::uint32_t& first, std::uint32_t choice);
  void learn();
  void collect_reason(std::uint32_t reason, Literal implied);
  void undo_to(std::uint32_t level);
  void bump(std::uint32_t variable);
  bool decide();

  void heap_up(std::size_t i);
  void heap_down(std::size_t i);
  void heap_insert(std::uint32_t variable);
  bool heap_less(std::uint32_t a, std::uint32_t b) const {
    return activity_[a] != activity_[b] ? activity_[a] > activity_[b] : a < b;
  }

  std::vector<Literal> literals_;
  std::vector<Clause> clauses_;
  std::vector<Watch> watches_;
  std::vector<std::uint32_t> first_watch_;  ///< for each literal: watches of the clauses that watch its negation
  std::vector<std::uint32_t> chosen_;       ///< variables of all at-most-one constraints, one after the other
  std::vector<Choice> choices_;
  std::vector<Occurrence> occurrences_;
  std::vector<std::uint32_t> first_choice_, first_flag_;  ///< by variable: first occurrence in choices, and as flag
  std::vector<std::int8_t> values_, phase_;
  std::vector<std::uint32_t> level_of_, reason_;
  std::vector<Literal> trail_;
  std::vector<std::uint32_t> level_begin_;
  std::size_t propagated_ = 0;
  std::vector<Literal> conflict_;  ///< literals of the clause that the assignment violates, all false
  bool contradictory_ = false;

  std::vector<double> activity_;
  double increment_ = 1;
  std::vector<std::uint32_t> heap_;
  std::vector<std::int32_t> heap_place_;

  std::vector<std::uint8_t> seen_;
  std::vector<Literal> learned_;
};

}  // namespace geomesh::recover
