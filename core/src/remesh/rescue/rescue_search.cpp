// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue_search.hpp"

#include "remesh/rescue/rescued_place.hpp"
#include "remesh/rescue/trial.hpp"

namespace geomesh::remesh {

namespace {

/// What a trial of a search is worth: nothing, no free cell, or one that is elsewhere now, from which to go on.
enum class Outcome : std::uint8_t { none, mended, elsewhere };

class Searcher {
 public:
  Searcher(Toolbox& tools, CellIndex seed, const RescueRule& rule, RescueSearch& search)
      : tools_(tools), search_(search), place_(tools, seed, rule) {}

  bool run() {
    for (std::size_t k = 0; k < search_.trials_a_cell && search_.trials_left > 0 && !search_.out_of_time(); ++k) {
      --search_.trials_left;
      if (search_once() == Outcome::mended) return true;
    }
    return false;
  }

 private:
  /// Openings and repair in turns. Each opening is about the worst cell that the repair before has left; the first may
  /// be a clearing.
  Outcome search_once() {
    Trial trial(tools_);
    Chooser& choose = search_.choose;
    place_.set_scope(choose.below(4) != 0 ? MendScope::own : MendScope::touched);
    tools_.bad_cells_may_spread = false;
    const bool clears = choose.below(rescue_limits.trials_a_clearing) == 0;
    CellIndex target = place_.seed().cell;
    for (unsigned k = 0; k < rescue_limits.most_openings && target != no_cell; ++k) {
      const bool is_open = k == 0 && clears ? place_.clear() : open(target);
      if (!is_open) return Outcome::none;
      place_.mend_all();
      if (const Outcome outcome = judge_trial(); outcome != Outcome::none) {
        trial.keep();
        return outcome;
      }
      if (place_.after().deficit > place_.before().deficit + rescue_limits.hopeless) return Outcome::none;
      place_.forget_given_up();
      target = place_.next_bad();
    }
    return Outcome::none;
  }

  bool open(CellIndex target) {
    for (unsigned k = 0; k < rescue_limits.most_vain_openings; ++k)
      if (open_about_cell(tools_, target, search_.choose)) return true;
    return false;
  }

  /// Beside cells that cannot be mended the worst tells nothing, and their number not much. What counts is that nothing
  /// is left that is not forced. Where one such cell has made way for another, and the place is hardly worse, that one
  /// is the seed from now on.
  Outcome judge_trial() {
    if (place_.is_seed_as_it_was()) return Outcome::none;
    const Tally was = place_.before(), is = place_.after();
    if (is.is_less_bad_than(was)) return Outcome::mended;
    if (is.worst < was.worst || is.n_bad > was.n_bad + rescue_limits.forced_instead) return Outcome::none;
    const std::vector<CellIndex> free = search_.judge.find_among(tools_.mesh, place_.bad_cells_of_trial());
    if (free.empty()) return Outcome::mended;
    if (free.size() > 1 || is.n_bad > was.n_bad || is.deficit > was.deficit + rescue_limits.detour)
      return Outcome::none;
    place_.set_seed(free.front());
    return Outcome::elsewhere;
  }

  Toolbox& tools_;
  RescueSearch& search_;
  RescuedPlace place_;
};

}  // namespace

bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search) {
  return Searcher(tools, c, rule, search).run();
}

}  // namespace geomesh::remesh
