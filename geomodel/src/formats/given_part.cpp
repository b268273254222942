// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/given_part.hpp"

#include <limits>

#include "formats/gmsh41_parts.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

std::vector<std::filesystem::path> write_given_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                    const std::string& format, const std::filesystem::path& stem,
                                                    const WriteOptions& options) {
  if (format == "vtu") return write_vtu_part(mesh, parts, number, options, stem);
  if (format == "msh" || format == "msh-binary")
    return write_gmsh41_parts(make_solver_mesh(mesh, options), parts, options, stem,
                              format == "msh" ? Encoding::text : Encoding::binary);
  if (format != "exodus") throw Error(ErrorKind::usage, "the format " + format + " is not written part by part here");
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  if (parts.n_cells_of_whole() >= most || parts.n_nodes_of_whole() >= most)
    throw Error(ErrorKind::usage, "exodus is written with numbers of 32 bits here, and the mesh has more elements");
  return write_exodus_part(mesh, parts, options, stem);
}

}  // namespace geomesh::geomodel
