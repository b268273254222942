// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/overshoots.hpp"

#include <algorithm>
#include <map>
#include <ranges>

#include "naming/region_facts.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/planar/reach.hpp"

namespace geomesh::geomodel {
namespace {

bool is_of(const Piece& piece, Index facet) {
  return std::binary_search(piece.facets.begin(), piece.facets.end(), facet);
}

std::vector<EdgeEnds> contacts_of(const WorkingSoup& working, const Piece& piece, const std::vector<Index>& cutters) {
  std::vector<EdgeEnds> contacts;
  for_each_edge(working.uses, [&](std::span<const EdgeUse> edge) {
    bool mine = false, other = false;
    for (const EdgeUse& u : edge) {
      mine = mine || is_of(piece, u.facet);
      other = other || std::ranges::any_of(cutters, [&](Index c) { return working.has(u.facet, c); });
    }
    const auto& points = working.soup.points;
    if (mine && other) contacts.push_back({points[edge[0].a], points[edge[0].b]});
  });
  return contacts;
}

bool is_given(const WorkingSoup& working, Index facet, const MeantEnd& end) {
  return end.part.empty() || std::ranges::any_of(working.origins[facet], [&](const PolygonSoup::Origin& o) {
           return o.surface == end.surface && end.part[o.triangle] == given_part;
         });
}

bool reaches_beyond_contacts(const WorkingSoup& working, const Piece& piece, const MeantEnd& end) {
  const std::vector<EdgeEnds> contacts = contacts_of(working, piece, end.cutters);
  const auto& points = working.soup.points;
  return std::ranges::any_of(piece.facets, [&](Index f) {
    const Triangle& t = working.soup.facets[f];
    return is_given(working, f, end) && reaches_beyond({points[t[0]], points[t[1]], points[t[2]]}, contacts, end.limit);
  });
}

/// Returns whether another surface ends on this piece of surface s and on nothing else. Without the piece, that surface
/// would end in the open.
bool something_ends_on(const WorkingSoup& working, const Piece& piece, Index s) {
  bool found = false;
  for_each_edge(working.uses, [&](std::span<const EdgeUse> edge) {
    if (found) return;
    bool mine = false, is_held = false;
    std::map<Index, int> others;  // for each other surface: number of its remaining facets at the edge
    for (const EdgeUse& u : edge) {
      const bool of_piece = is_of(piece, u.facet);
      mine = mine || of_piece;
      for (const PolygonSoup::Origin& o : working.origins[u.facet]) {
        if (o.surface != s) ++others[o.surface];
        is_held = is_held || (o.surface == s && !of_piece);
      }
    }
    found = mine && !is_held && others.size() == 1 && others.begin()->second == 1;
  });
  return found;
}

}  // namespace

std::vector<Piece> overshoots_of(const WorkingSoup& working, const MeantEnd& end) {
  std::vector<Piece> pieces = pieces_of(working, end.surface, end.cutters, nullptr);
  std::map<Index, double> largest;  // by block
  const auto block_of = [&](const Piece& piece) {
    return end.blocks == nullptr ? 0 : end.blocks->block_at(working.centre(piece.largest));
  };
  for (const Piece& piece : pieces) {
    double& area = largest[block_of(piece)];
    area = std::max(area, piece.area);
  }
  std::erase_if(pieces, [&](const Piece& piece) {
    return piece.free_border == 0 || piece.contact == 0 || piece.area == largest[block_of(piece)] ||
           reaches_beyond_contacts(working, piece, end) || something_ends_on(working, piece, end.surface);
  });
  return pieces;
}

double remove_overshoots(WorkingSoup& working, const MeantEnd& end, const std::string& name,
                         std::vector<std::string>& notes) {
  double area = 0;
  const std::vector<Piece> pieces = overshoots_of(working, end);
  if (pieces.empty()) return 0;
  const Vec3 place = working.centre(pieces.back().largest);
  for (const Piece& piece : pieces) area += working.remove(piece.facets, end.surface);
  notes.push_back("surface " + name + ": " + std::to_string(pieces.size()) + " overshooting pieces removed (area " +
                  to_text(area) + ", one near " + to_text(place) + ")");
  return area;
}

}  // namespace geomesh::geomodel
