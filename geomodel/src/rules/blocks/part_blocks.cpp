// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/part_blocks.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/blocks/field_blocks.hpp"
#include "rules/blocks/throw_blocks.hpp"

namespace geomesh::geomodel {
namespace {

using Origin = PolygonSoup::Origin;

/// For each connected piece of a horizon, returns the area that stems from input triangles accepted by `counts`.
std::vector<double> area_of(const WorkingSoup& soup, const std::vector<Piece>& pieces,
                            const std::function<bool(const Origin&)>& counts) {
  std::vector<double> area(pieces.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const Index f : pieces[k].facets)
      for (const Origin& o : soup.origins[f])
        if (counts(o)) area[k] += soup.area(f);
  return area;
}

/// Cuts off the blocks of one horizon with throw at its faults.
class HorizonParting {
 public:
  HorizonParting(const Parting& parting, Index horizon)
      : p_(parting),
        horizon_(horizon),
        block_of_(parting.built.block_of_triangle[horizon]),
        kept_by_some_(parting.soup.soup.facets.size(), 0) {
    faults_ = parting.built.parted_at[horizon];
    for (const Index fault : faults_) fault_sides_.emplace_back(parting.surfaces[fault]);
  }

  void run() {
    const Index n_blocks = BuiltRows::n_blocks(block_of_);
    for (Index block = 0; block < n_blocks; ++block) part(block, n_blocks > 1);
    std::vector<Index> all(p_.soup.soup.facets.size());
    std::iota(all.begin(), all.end(), Index{0});
    leave_to_faults(all);
    const auto is_remade = [this](const Origin& o) {
      return o.surface == horizon_ && block_of_[o.triangle] == BuiltRows::of_no_block;
    };
    const double remade = p_.soup.remove(all, is_remade);
    if (remade > 0)
      p_.notes.push_back("horizon " + name() +
                         ": given at or beyond a fault that ends inside the model, made anew from its blocks: area " +
                         to_text(remade));
    std::vector<Index> left;
    for (const Index f : all)
      if (!kept_by_some_[f]) left.push_back(f);
    p_.removed[horizon_] += remade + p_.soup.remove(left, [this](const Origin& o) { return is_shared(o); });
  }

 private:
  const std::string& name() const { return p_.surfaces[horizon_].name; }
  bool is_given(const Origin& o) const { return o.triangle < p_.built.n_given_triangles[o.surface]; }
  bool is_shared(const Origin& o) const {
    return o.surface == horizon_ && block_of_[o.triangle] == BuiltRows::of_every_block;
  }

  void part(Index block, bool one_of_several) {
    const auto is_own = [this, block](const Origin& o) {
      return o.surface == horizon_ && block_of_[o.triangle] == block;
    };
    const auto is_mine = [&](Index f) {
      return std::any_of(p_.soup.origins[f].begin(), p_.soup.origins[f].end(),
                         [&](const Origin& o) { return is_own(o) || is_shared(o); });
    };
    const std::vector<Piece> pieces = pieces_of(p_.soup, is_mine, faults_, nullptr);
    if (pieces.empty()) return;
    const std::vector<double> given =
        area_of(p_.soup, pieces, [&](const Origin& o) { return is_own(o) && is_given(o); });
    const bool is_of_fields = p_.rules.of(horizon_).has_fault_domain();
    const std::vector<bool> is_kept =
        is_of_fields ? pieces_in_domain(p_, {horizon_, block}, pieces,
                                        [&](const Piece& piece) { return lies_on_own_side(piece, block, is_own); })
                     : kept_of(pieces, given, block, is_own);
    if (pieces.size() == 1 && one_of_several && is_kept[0] && !is_of_fields) {
      keep(pieces[0]);
      return drop_continuation(pieces[0], is_own);
    }
    double area = 0, overshoot = 0;
    Vec3 place;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (is_kept[k]) {
        keep(pieces[k]);
        continue;
      }
      if (given[k] > 0 && given[k] >= overshoot) place = p_.soup.centre(pieces[k].largest);
      area += p_.soup.remove(pieces[k].facets, is_own);
      overshoot += given[k];
    }
    p_.removed[horizon_] += area;
    p_.notes.push_back("horizon " + name() + ", block " + std::to_string(block + 1) +
                       ": ended at its faults, area beyond them removed " + to_text(area) +
                       (overshoot > 0 ? ", of which given (overshoot on the wrong side) " + to_text(overshoot) +
                                            " near " + to_text(place)
                                      : std::string()));
  }

  void keep(const Piece& piece) {
    for (const Index f : piece.facets) kept_by_some_[f] = 1;
  }

  /// Decides which pieces of a block are kept: those on the block's side of each fault that contain original triangles
  /// (any triangles, if the block has no original ones). If there is no such piece, the largest is kept, or none if the
  /// horizon may lie outside the model there.
  std::vector<bool> kept_of(const std::vector<Piece>& pieces, const std::vector<double>& given, Index block,
                            const std::function<bool(const Origin&)>& is_own) const {
    const bool any_given = std::any_of(given.begin(), given.end(), [](double area) { return area > 0; });
    const auto counts = [&](const Origin& o) { return is_own(o) && (!any_given || is_given(o)); };
    std::vector<bool> kept(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) kept[k] = lies_on_own_side(pieces[k], block, counts);
    const bool may_be_ended = !p_.rules.topography.empty() || !p_.rules.floor.empty();
    if (!may_be_ended && std::none_of(kept.begin(), kept.end(), [](bool k) { return k; }))
      kept[static_cast<std::size_t>(std::max_element(given.begin(), given.end()) - given.begin())] = true;
    return kept;
  }

  /// Returns whether most of the area of a piece of a block, from triangles that `counts` accepts, lies on the block's
  /// side of each fault. Such pieces are kept: the block left the box and came back, or has several parts.
  bool lies_on_own_side(const Piece& piece, Index block, const std::function<bool(const Origin&)>& counts) const {
    const std::vector<bool>& sides = p_.built.sides_of_block[horizon_][block];
    std::vector<double> balance(fault_sides_.size(), 0);
    double area = 0;
    for (const Index f : piece.facets)
      for (const Origin& o : p_.soup.origins[f]) {
        if (!counts(o)) continue;
        area += p_.soup.area(f);
        for (std::size_t k = 0; k < balance.size(); ++k)
          balance[k] += p_.built.is_on_both_sides(horizon_, block, k)
                            ? p_.soup.area(f)
                            : (fault_sides_[k].is_above(p_.soup.centre(f)) == sides[k] ? 1 : -1) * p_.soup.area(f);
      }
    return area > 0 && std::all_of(balance.begin(), balance.end(), [](double b) { return b > 0; });
  }

  /// Removes the horizon's triangles that lie on one of its faults, because it is not defined to which block they
  /// belong. They remain part of the fault.
  void leave_to_faults(const std::vector<Index>& facets) {
    std::vector<Index> shared;
    for (const Index f : facets)
      if (std::any_of(faults_.begin(), faults_.end(), [&](Index fault) { return p_.soup.has(f, fault); }))
        shared.push_back(f);
    const double area = p_.soup.remove(shared, [this](const Origin& o) { return o.surface == horizon_; });
    if (area > 0)
      p_.notes.push_back("horizon " + name() + ": lay on its faults, which have it now, over an area of " +
                         to_text(area));
    p_.removed[horizon_] += area;
  }

  /// Removes a block's extension that no fault separates from it, because it would run through the other blocks.
  void drop_continuation(const Piece& piece, const std::function<bool(const Origin&)>& is_own) {
    p_.removed[horizon_] += p_.soup.remove(piece.facets, [&](const Origin& o) { return is_own(o) && !is_given(o); });
    std::string faults;
    for (const Index fault : faults_) faults += (faults.empty() ? "" : ", ") + p_.surfaces[fault].name;
    p_.warnings.push_back("horizon " + name() + " is not divided by the faults across which it is to have throw (" +
                          faults + "): a block near " + to_text(p_.soup.centre(piece.largest)) +
                          " is kept as given; let the faults reach through the model (extent: to_box)");
  }

  const Parting& p_;
  Index horizon_;
  const std::vector<Index>& block_of_;
  std::vector<std::uint8_t> kept_by_some_;  ///< per facet
  std::vector<Index> faults_;
  std::vector<FaultSides> fault_sides_;  ///< of these
};

/// Removes the extension of a fault that was made only to separate blocks, and warns if that leaves a gap.
void remove_continuation(const Parting& p, Index fault) {
  const Index first = p.built.first_only_parting[fault];
  const auto is_made = [fault, first](const Origin& o) { return o.surface == fault && o.triangle >= first; };
  const auto has = [&](Index f, auto&& accepts) {
    return std::any_of(p.soup.origins[f].begin(), p.soup.origins[f].end(), accepts);
  };
  const auto has_throw = [&](Index s) {
    return s < p.built.block_of_triangle.size() && !p.built.block_of_triangle[s].empty();
  };
  std::vector<double> open(p.surfaces.size(), 0);
  std::vector<Vec3> place(p.surfaces.size());
  for_each_edge(p.soup.uses, [&](std::span<const EdgeUse> edge) {
    std::vector<Index> horizons;
    bool crosses = false, closed = false;
    for (const EdgeUse& u : edge) {
      for (const Origin& o : p.soup.origins[u.facet])
        if (has_throw(o.surface)) horizons.push_back(o.surface);
      crosses = crosses || has(u.facet, is_made);
      closed = closed || has(u.facet, [&](const Origin& o) {
                 return (o.surface == fault && o.triangle < first) || p.surfaces[o.surface].kind == SurfaceKind::box;
               });
    }
    if (!crosses || closed) return;
    for (const Index h : horizons)
      if (std::count(horizons.begin(), horizons.end(), h) == 1) {
        place[h] = p.soup.soup.points[edge[0].a];
        open[h] += norm(p.soup.soup.points[edge[0].b] - place[h]);
      }
  });
  for (std::size_t h = 0; h < open.size(); ++h)
    if (open[h] > 0)
      p.warnings.push_back(
          "horizon " + p.surfaces[h].name + " is not divided by fault " + p.surfaces[fault].name +
          " alone: beyond the end of the fault its blocks lie at different heights over a length of " +
          to_text(open[h]) + " m, near " + to_text(place[h]) +
          "; let the fault reach through the model (extent: to_box), or give the horizon round its end");
  std::vector<Index> made;
  for (Index f = 0; f < p.soup.origins.size(); ++f)
    if (has(f, is_made)) made.push_back(f);
  p.removed[fault] += p.soup.remove(made, is_made);
}

}  // namespace

void part_blocks(const Parting& parting, Index horizon) {
  const BuiltRows& built = parting.built;
  if (horizon < built.block_of_triangle.size() && !built.block_of_triangle[horizon].empty())
    HorizonParting(parting, horizon).run();
}

void remove_continuations(const Parting& parting) {
  const BuiltRows& built = parting.built;
  for (Index s = 0; s < built.first_only_parting.size(); ++s)
    if (built.first_only_parting[s] < parting.surfaces[s].triangles.size()) remove_continuation(parting, s);
}

}  // namespace geomesh::geomodel
