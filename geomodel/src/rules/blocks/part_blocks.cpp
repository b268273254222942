// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/part_blocks.hpp"

#include <algorithm>
#include <set>

#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/blocks/field_blocks.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {
namespace {

using Origin = PolygonSoup::Origin;

/// For each connected piece, returns the area of the triangles that `counts` accepts.
std::vector<double> area_of(const WorkingSoup& soup, const std::vector<Piece>& pieces,
                            const std::function<bool(const Origin&)>& counts) {
  std::vector<double> area(pieces.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const Index f : pieces[k].facets)
      for (const Origin& o : soup.origins[f])
        if (counts(o)) area[k] += soup.area(f);
  return area;
}

/// Cuts one horizon with throw off at its faults.
class HorizonParting {
 public:
  HorizonParting(const Parting& parting, Index horizon)
      : p_(parting),
        horizon_(horizon),
        block_of_(parting.built.block_of_triangle[horizon]),
        faults_(parting.built.parted_at[horizon]),
        framework_(parting.built.throw_blocks[horizon]->framework),
        field_of_block_(parting.built.field_of_block[horizon]) {}

  void run() {
    std::set<Index> blocks(block_of_.begin(), block_of_.end());
    blocks.erase(BuiltRows::of_every_block);
    for (const Index block : blocks) part(block);
    leave_to_faults();
    p_.removed[horizon_] += area_;
    if (area_ > 0)
      p_.notes.push_back("horizon " + p_.surfaces[horizon_].name + ": blocks ended at its faults, area beyond them " +
                         to_text(area_) + " removed" +
                         (overshoot_ > 0 ? ", of which given (overshoot on the wrong side) " + to_text(overshoot_) +
                                               " near " + to_text(place_)
                                         : std::string()));
  }

 private:
  void part(Index block) {
    const auto is_own = [&](const Origin& o) {
      return o.surface == horizon_ && o.triangle < block_of_.size() && block_of_[o.triangle] == block;
    };
    const auto is_mine = [&](Index f) { return std::ranges::any_of(p_.soup.origins[f], is_own); };
    bool is_any_kept = false;
    const std::vector<Piece> pieces = pieces_of(p_.soup, is_mine, faults_, nullptr);
    for (const Piece& piece : pieces) {
      double inside = 0, outside = 0;
      for (const Index f : piece.facets) {
        const Vec3 centre = p_.soup.centre(f);
        if (framework_.block_at(centre) == no_index) continue;
        (owner_at(framework_, field_of_block_, centre) == block ? inside : outside) += p_.soup.area(f);
      }
      if (inside >= outside) {
        is_any_kept = true;
        continue;
      }
      count_overshoot(piece, is_own);
      area_ += p_.soup.remove(piece.facets, is_own);
    }
    if (!is_any_kept && !pieces.empty() && !field_of_block_.empty())
      refuse_field_outside(p_, {horizon_, block}, p_.soup.centre(pieces.front().largest));
  }

  template <class F>
  void count_overshoot(const Piece& piece, const F& is_own) {
    double given = 0;
    for (const Index f : piece.facets)
      for (const Origin& o : p_.soup.origins[f])
        if (is_own(o) && o.triangle < p_.built.n_given_triangles[horizon_]) given += p_.soup.area(f);
    if (given > 0 && overshoot_ == 0) place_ = p_.soup.centre(piece.largest);
    overshoot_ += given;
  }

  /// Triangles that lie on a fault which divides the horizon are left to the fault, because it is not defined to which
  /// block they belong.
  void leave_to_faults() {
    std::vector<Index> shared;
    for (Index f = 0; f < p_.soup.origins.size(); ++f)
      if (std::ranges::any_of(faults_, [&](Index fault) { return p_.soup.has(f, fault); })) shared.push_back(f);
    const double area = p_.soup.remove(shared, [this](const Origin& o) { return o.surface == horizon_; });
    if (area > 0)
      p_.notes.push_back("horizon " + p_.surfaces[horizon_].name +
                         ": lay on its faults, which have it now, over an area of " + to_text(area));
    p_.removed[horizon_] += area;
  }

  const Parting& p_;
  Index horizon_;
  const std::vector<Index>& block_of_;
  const std::vector<Index>& faults_;
  const BlockFramework& framework_;
  const std::vector<Index>& field_of_block_;
  double area_ = 0, overshoot_ = 0;
  Vec3 place_;
};

}  // namespace

void part_blocks(const Parting& parting, Index horizon) {
  const BuiltRows& built = parting.built;
  if (horizon < built.block_of_triangle.size() && !built.block_of_triangle[horizon].empty())
    HorizonParting(parting, horizon).run();
}

}  // namespace geomesh::geomodel
