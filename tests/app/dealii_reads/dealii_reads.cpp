// SPDX-License-Identifier: GPL-3.0-or-later
// `dealii_reads FILE.msh` prints what deal.II has in a Gmsh file: material ids with volumes, ids of the boundary with
// areas.
#include <deal.II/base/config.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <iostream>
#include <map>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  dealii::Triangulation<3> grid;
  dealii::GridIn<3> in;
  in.attach_triangulation(grid);
  std::ifstream file(argv[1]);
  in.read_msh(file);
  std::map<unsigned, std::pair<unsigned, double>> cells, faces;  // by id: number, volume or area
  for (const auto& cell : grid.active_cell_iterators()) {
    auto& own = cells[cell->material_id()];
    ++own.first;
    own.second += cell->measure();
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary()) {
        auto& side = faces[cell->face(f)->boundary_id()];
        ++side.first;
        side.second += cell->face(f)->measure();
      }
  }
  std::cout.precision(17);
  std::cout << "deal.II " << DEAL_II_PACKAGE_VERSION << "\npoints " << grid.n_used_vertices() << "\n";
  for (const auto& [id, own] : cells) std::cout << "material " << id << " " << own.first << " " << own.second << "\n";
  for (const auto& [id, own] : faces) std::cout << "boundary " << id << " " << own.first << " " << own.second << "\n";
}
