// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "recover/steiner_removal/sat_solver.hpp"

using geomesh::recover::Literal;
using geomesh::recover::Satisfiability;
using geomesh::recover::SatSolver;

namespace {

/// Clauses and choices over a few variables, kept beside the solver so that every assignment can be tried.
struct Formula {
  unsigned n_variables = 0;
  std::vector<std::vector<Literal>> clauses;
  std::vector<std::vector<std::uint32_t>> choices;
  std::vector<std::uint32_t> flags;  ///< of each choice

  template <class IsTrue>
  bool holds(const IsTrue& is_true) const {
    for (const auto& clause : clauses) {
      bool any = false;
      for (Literal l : clause) any = any || is_true(l.variable()) != l.is_negated();
      if (!any) return false;
    }
    for (std::size_t i = 0; i < choices.size(); ++i) {
      unsigned n = 0;
      for (std::uint32_t v : choices[i]) n += is_true(v);
      if (n > 1 || (n == 1 && flags[i] != SatSolver::no_variable && !is_true(flags[i]))) return false;
    }
    return true;
  }
  bool is_satisfiable() const {
    for (std::uint32_t a = 0; a < (1u << n_variables); ++a)
      if (holds([&](std::uint32_t v) { return ((a >> v) & 1u) != 0; })) return true;
    return false;
  }
  SatSolver solver() const {
    SatSolver out;
    for (unsigned v = 0; v < n_variables; ++v) {
      out.new_variable();
      if (v % 3 == 0) out.prefer_yes(v);
    }
    for (const auto& clause : clauses) out.add_clause(clause);
    for (std::size_t i = 0; i < choices.size(); ++i) out.add_choice(choices[i], flags[i]);
    return out;
  }
};

Formula random_formula(std::mt19937& random) {
  Formula out;
  out.n_variables = 4 + random() % 9;
  const unsigned n_clauses = out.n_variables * (2 + random() % 4);
  for (unsigned c = 0; c < n_clauses; ++c) {
    std::vector<Literal> clause;
    for (unsigned k = 0, n = 1 + random() % 4; k < n; ++k)
      clause.push_back(random() % 2 == 0 ? Literal::no(random() % out.n_variables)
                                         : Literal::yes(random() % out.n_variables));
    if (clause.size() == 1 && random() % 4 != 0) continue;
    out.clauses.push_back(clause);
  }
  for (unsigned e = random() % 4; e-- > 0;) {
    const std::uint32_t flag = random() % out.n_variables;
    out.flags.push_back(random() % 2 == 0 ? flag : SatSolver::no_variable);
    out.choices.emplace_back();
    for (std::uint32_t v = 0; v < out.n_variables; ++v)
      if (v != flag && random() % 3 == 0) out.choices.back().push_back(v);
  }
  return out;
}

/// Each of n + 1 pigeons in one of n holes, no two in one.
Formula pigeons(unsigned n) {
  Formula out;
  out.n_variables = n * (n + 1);
  for (unsigned pigeon = 0; pigeon <= n; ++pigeon) {
    out.clauses.emplace_back();
    for (unsigned hole = 0; hole < n; ++hole) out.clauses.back().push_back(Literal::yes(pigeon * n + hole));
  }
  for (unsigned hole = 0; hole < n; ++hole) {
    out.flags.push_back(SatSolver::no_variable);
    out.choices.emplace_back();
    for (unsigned pigeon = 0; pigeon <= n; ++pigeon) out.choices.back().push_back(pigeon * n + hole);
  }
  return out;
}

}  // namespace

TEST_CASE("random formulas are decided as by trying every assignment", "[sat]") {
  std::mt19937 random(7);
  unsigned n_satisfiable = 0;
  constexpr unsigned n_formulas = 3000;
  for (unsigned i = 0; i < n_formulas; ++i) {
    const Formula formula = random_formula(random);
    SatSolver solver = formula.solver();
    const bool expected = formula.is_satisfiable();
    n_satisfiable += expected;
    REQUIRE(solver.solve(100000) == (expected ? Satisfiability::satisfiable : Satisfiability::unsatisfiable));
    if (expected) REQUIRE(formula.holds([&](std::uint32_t v) { return solver.is_true(v); }));
  }
  CHECK(n_satisfiable > n_formulas / 5);
  CHECK(n_satisfiable < n_formulas - n_formulas / 5);
}

TEST_CASE("formulas that need long proofs are refuted, or left open within the limit", "[sat]") {
  SatSolver enough = pigeons(6).solver();
  CHECK(enough.solve(100000) == Satisfiability::unsatisfiable);
  SatSolver limited = pigeons(9).solver();
  CHECK(limited.solve(10) == Satisfiability::unknown);
}

TEST_CASE("an empty clause and contradicting units are unsatisfiable, no clause at all is satisfiable", "[sat]") {
  SatSolver free;
  free.new_variable();
  CHECK(free.solve(10) == Satisfiability::satisfiable);
  SatSolver empty;
  empty.new_variable();
  empty.add_clause({});
  CHECK(empty.solve(10) == Satisfiability::unsatisfiable);
  SatSolver units;
  units.new_variable();
  const Literal yes = Literal::yes(0), no = Literal::no(0);
  units.add_clause({&yes, 1});
  units.add_clause({&no, 1});
  CHECK(units.solve(10) == Satisfiability::unsatisfiable);
}
