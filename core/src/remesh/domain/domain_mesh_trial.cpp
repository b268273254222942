// SPDX-License-Identifier: MIT
// DomainMesh's trials: what is noted of each change, and how changes are taken back.
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

void DomainMesh::begin_trial() { journal_.open({n_vertices(), n_slots(), clock_}); }

void DomainMesh::undo_trial() {
  points_.resize(journal_.start().n_vertices);
  kinds_.resize(points_.size());
  supports_.resize(points_.size());
  cell_of_.resize(points_.size());
  changed_.resize(points_.size());
  for (const SavedVertex& s : journal_.vertices()) {
    points_[s.vertex] = s.point;
    kinds_[s.vertex] = s.kind;
    supports_[s.vertex] = s.support;
    cell_of_[s.vertex] = s.incident;
    changed_[s.vertex] = s.changed;
  }
  for (auto event = journal_.slots().rbegin(); event != journal_.slots().rend(); ++event)
    if (event->what == SlotEvent::What::freed)
      mesh_.take_back_freed(event->cell);
    else if (event->what == SlotEvent::What::reused)
      mesh_.free_cell(event->cell);
    else
      mesh_.drop_slots_from(event->cell);
  attributes_.component.resize(mesh_.n_slots());
  attributes_.tags.resize(mesh_.n_slots());
  attributes_.shape.resize(mesh_.n_slots());
  for (const SavedCell& s : journal_.cells()) {
    mesh_.cells()[s.cell] = s.links;
    attributes_.component[s.cell] = s.component;
    attributes_.tags[s.cell] = s.tags;
    attributes_.shape[s.cell] = s.shape;
  }
  for (auto curve = journal_.curves().rbegin(); curve != journal_.curves().rend(); ++curve)
    if (curve->curve == no_index)
      curves_.erase({curve->a, curve->b});
    else
      curves_.insert({curve->a, curve->b}, curve->curve);
  clock_ = journal_.start().clock;
  journal_.close();
}

}  // namespace geomesh::remesh
