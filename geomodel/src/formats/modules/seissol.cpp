// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a mesh for SeisSol in its PUML layout (built only if HDF5 is available): NAME.puml.h5, and NAME.puml.xdmf for
// ParaView. The group of a tetrahedron is its region's id. Each face of a tetrahedron has a boundary condition: 1 free
// surface (zmax, and other boundaries that face upwards, such as a topography), 5 absorbing (all other boundaries), 3
// the first fault, 65 and on further faults, 0 none. Source: "Mesh Input Formats" and "Fault tagging" of the SeisSol
// documentation.
#include <algorithm>
#include <map>
#include <set>

#include "formats/modules/format_module.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/face_sides.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/hdf5_writer.hpp"
#include "writers/text_buffer.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::int32_t free_surface = 1, first_fault = 3, absorbing = 5, further_faults = 65, last_condition = 255;
/// SeisSol's faces of a tetrahedron are 021, 013, 123, 032: the number of the face opposite each vertex.
constexpr std::array<unsigned, 4> face_opposite{2, 3, 1, 0};

class Conditions {
 public:
  explicit Conditions(const ModelMesh& mesh) : mesh_(mesh), of_cell_(mesh.tetrahedra.size(), 0) {
    number_faults();
    mark_outside();
    mark_faces();
  }
  const std::vector<std::int32_t>& of_cells() const { return of_cell_; }
  const std::map<std::int32_t, std::int32_t>& of_faults() const { return of_fault_; }

 private:
  /// Numbers the faults that have faces in the mesh, in the order of the project.
  void number_faults() {
    std::set<std::int32_t> used;
    for (const auto& face : mesh_.faces) {
      const auto& members = mesh_.surface_sets[static_cast<std::size_t>(face.surface_set)];
      used.insert(members.begin(), members.end());
    }
    std::int32_t next = first_fault;
    for (const NamedSurface& surface : mesh_.surfaces) {
      if (surface.kind != SurfaceKind::fault || !used.contains(surface.id)) continue;
      if (next > last_condition)
        throw Error(ErrorKind::usage, "seissol: the file can distinguish at most " + std::to_string(of_fault_.size()) +
                                          " faults apart; give several faults one name, or leave some out");
      of_fault_[surface.id] = next;
      next = next == first_fault ? further_faults : next + 1;
    }
  }
  void set(std::size_t tetrahedron, unsigned opposite, std::int32_t condition) {
    const unsigned shift = 8 * face_opposite[opposite];
    auto bits = static_cast<std::uint32_t>(of_cell_[tetrahedron]);
    bits = (bits & ~(0xFFu << shift)) | static_cast<std::uint32_t>(condition) << shift;
    of_cell_[tetrahedron] = static_cast<std::int32_t>(bits);
  }
  /// Marks all boundary faces as absorbing; faces that lie on no named surface remain so.
  void mark_outside() {
    const std::vector<Neighbours> across = tetrahedra_across(mesh_.tetrahedra);
    for (std::size_t t = 0; t < across.size(); ++t)
      for (unsigned i = 0; i < 4; ++i)
        if (across[t][i] == no_neighbour) set(t, i, absorbing);
  }
  void mark_faces() {
    std::vector<Triangle> faces;
    for (const auto& face : mesh_.faces) faces.push_back(face.vertices);
    const auto sides = tetrahedra_at_faces(mesh_.tetrahedra, faces);
    for (std::size_t f = 0; f < sides.size(); ++f) {
      const std::int32_t condition = condition_of(mesh_.faces[f], sides[f]);
      for (const TetrahedronSide& side : sides[f])
        if (side.tetrahedron != no_side && condition != 0) set(side.tetrahedron, side.opposite, condition);
    }
  }
  std::int32_t condition_of(const ModelMesh::Face& face, const std::array<TetrahedronSide, 2>& sides) const {
    const auto& members = mesh_.surface_sets[static_cast<std::size_t>(face.surface_set)];
    if (sides[0].tetrahedron == no_side || sides[1].tetrahedron == no_side)
      return is_free(face, members) ? free_surface : absorbing;
    for (const std::int32_t id : members)
      if (const auto fault = of_fault_.find(id); fault != of_fault_.end()) return fault->second;
    return 0;
  }
  bool is_free(const ModelMesh::Face& face, const std::vector<std::int32_t>& members) const {
    for (const NamedSurface& surface : mesh_.surfaces)
      if (surface.kind == SurfaceKind::box && std::find(members.begin(), members.end(), surface.id) != members.end())
        return surface.name == "zmax";
    const auto& [a, b, c] = face.vertices;  // the normal of a boundary face points outwards
    return cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]).z > 0;
  }

  const ModelMesh& mesh_;
  std::vector<std::int32_t> of_cell_;
  std::map<std::int32_t, std::int32_t> of_fault_;
};

void write_h5(const ModelMesh& mesh, const Conditions& conditions, const std::filesystem::path& file) {
  const std::size_t n = mesh.tetrahedra.size();
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    Hdf5Writer h5(temporary, file,
                  mesh.points.size() * sizeof(Vec3) + n * (4 * sizeof(std::int64_t) + 2 * sizeof(std::int32_t)));
    h5.put("geometry", H5T_NATIVE_DOUBLE, mesh.points.data(), mesh.points.size(), 3);
    h5.put_pieces("connect", H5T_NATIVE_INT64, n, 4,
                  [&](const auto& give) { give(H5T_NATIVE_UINT32, mesh.tetrahedra.data(), n); });
    h5.put("group", H5T_NATIVE_INT32, mesh.tet_region.data(), n, 1);
    h5.put("boundary", H5T_NATIVE_INT32, conditions.of_cells().data(), n, 1);
    h5.close();
  });
}

std::string xdmf_text(const ModelMesh& mesh, const std::string& h5) {
  const std::size_t n = mesh.tetrahedra.size();
  TextBuffer text;
  const auto item = [&](const char* type, int precision, const char* set) {
    text << "<DataItem NumberType=\"" << type << "\" Precision=\"" << precision << "\" Format=\"HDF\" Dimensions=\""
         << (set == std::string_view("geometry") ? mesh.points.size() : n)
         << (set == std::string_view("geometry")  ? " 3"
             : set == std::string_view("connect") ? " 4"
                                                  : "")
         << "\">" << h5 << ":/" << set << "</DataItem>";
  };
  text << "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
       << "<Grid Name=\"puml mesh\" GridType=\"Uniform\">\n<Topology TopologyType=\"Tetrahedron\" NumberOfElements=\""
       << n << "\">";
  item("Int", 8, "connect");
  text << "</Topology>\n<Geometry GeometryType=\"XYZ\">";
  item("Float", 8, "geometry");
  text << "</Geometry>\n<Attribute Name=\"group\" Center=\"Cell\">";
  item("Int", 4, "group");
  text << "</Attribute>\n<Attribute Name=\"boundary\" Center=\"Cell\">";
  item("Int", 4, "boundary");
  text << "</Attribute>\n</Grid>\n</Domain>\n</Xdmf>\n";
  return text.text();
}

std::vector<std::filesystem::path> write(const ModelMesh& mesh, const WriteOptions&,
                                         const std::filesystem::path& stem) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Tetrahedron) == 4 * sizeof(VertexIndex));
  const Conditions conditions(mesh);
  const std::filesystem::path file = stem.string() + ".puml.h5", xdmf = stem.string() + ".puml.xdmf";
  WrittenFiles written;
  write_h5(mesh, conditions, file);
  written.add(file);
  write_text_file(xdmf, xdmf_text(mesh, file.filename().string()));
  written.add(xdmf);
  std::vector<SidecarGroup> sidecar;
  for (const Region& region : mesh.regions)
    sidecar.push_back({"group", 3, region.id, region.name, region.name, {region.id}});
  for (const NamedSurface& surface : mesh.surfaces)
    if (const auto fault = conditions.of_faults().find(surface.id); fault != conditions.of_faults().end())
      sidecar.push_back({"boundary", 2, fault->second, surface.name, surface.name, {surface.id}});
  written.add(write_sidecar(mesh, sidecar, file));
  return written.keep();
}

}  // namespace

}  // namespace geomesh::geomodel

GEOMESH_FORMAT_MODULE(geomesh::geomodel::write, nullptr, nullptr)
