// SPDX-License-Identifier: GPL-3.0-or-later
// Writes starter parameters for PyLith 4, run as `pylith STEM.pylith.cfg`. The lowest outer surface is fixed, the
// highest is displaced downwards by one unit. Source: PyLith's user guide, "MeshIOCubit", "IsotropicLinearElasticity",
// "DirichletTimeDependent".
#include "geomesh/geomodel/writers.hpp"
#include "starters/starter_model.hpp"
#include "starters/starters.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

void add_material(const StarterRegion& region, std::size_t number, TextBuffer& text) {
  const StarterMaterial& m = region.material;
  text
      << "\n[pylithapp.problem.materials.material_" << number << "]\n# " << region.group.full_name << ": density "
      << origin_of(m.density) << "; vp " << origin_of(m.vp) << "; vs " << origin_of(m.vs) << "\n"
      << "description = " << region.group.name << "\nlabel_value = " << region.group.id
      << "\nbulk_rheology = pylith.materials.IsotropicLinearElasticity\n"
      << "db_auxiliary_field = spatialdata.spatialdb.UniformDB\ndb_auxiliary_field.description = " << region.group.name
      << "\ndb_auxiliary_field.values = [density, vs, vp]\ndb_auxiliary_field.data = [" << m.density.value
      << "*kg/m**3, " << m.vs.value << "*m/s, " << m.vp.value << "*m/s]\n"
      << "auxiliary_subfields.density.basis_order = 0\nbulk_rheology.auxiliary_subfields.bulk_modulus.basis_order = 0\n"
      << "bulk_rheology.auxiliary_subfields.shear_modulus.basis_order = 0\n";
}

void add_condition(const StarterGroup& group, const char* name, double up, TextBuffer& text) {
  text << "\n[pylithapp.problem.bc." << name << "]\nlabel = " << group.name << "\nlabel_value = " << group.id
       << "\nconstrained_dof = [0, 1, 2]\ndb_auxiliary_field = spatialdata.spatialdb.UniformDB\n"
       << "db_auxiliary_field.description = " << name << "\ndb_auxiliary_field.values = [initial_amplitude_x, "
       << "initial_amplitude_y, initial_amplitude_z]\ndb_auxiliary_field.data = [0.0*m, 0.0*m, " << up << "*m]\n";
}

}  // namespace

std::filesystem::path write_pylith_starter(const ModelMesh& mesh, const std::filesystem::path& stem) {
  const std::filesystem::path mesh_file = stem.string() + ".e", file = stem.string() + ".pylith.cfg";
  const StarterModel model = starter_model(mesh, mesh_file, "element block");
  TextBuffer text;
  text << "# Settling of the model under a displacement of its highest surface. Run: pylith "
       << file.filename().string() << "\n# The mesh is in " << mesh.unit << ".\n[pylithapp.metadata]\nbase = []\n"
       << "description = Starter input written with the mesh.\nauthors = [geomesh]\nversion = 1.0.0\n"
       << "pylith_version = [>=3.0]\narguments = [" << file.filename().string() << "]\n"
       << "\n[pylithapp.mesh_generator]\nreader = pylith.meshio.MeshIOCubit\nreader.filename = "
       << mesh_file.filename().string() << "\nreader.use_nodeset_names = True\nreader.coordsys.space_dim = 3\n"
       << "\n[pylithapp.problem]\ndefaults.quadrature_order = 1\nmaterials = [";
  for (std::size_t r = 0; r < model.regions.size(); ++r) text << (r ? ", " : "") << "material_" << r + 1;
  text << "]\n";
  for (std::size_t r = 0; r < model.regions.size(); ++r) add_material(model.regions[r], r + 1, text);
  const auto above = model.groups_of(model.highest, "node set"), below = model.groups_of(model.lowest, "node set");
  const bool has_two = model.lowest != model.highest && !above.empty() && !below.empty();
  text << "\n[pylithapp.problem]\nbc = [" << (has_two ? "above, below" : "below")
       << "]\nbc.below = pylith.bc.DirichletTimeDependent\n"
       << (has_two ? "bc.above = pylith.bc.DirichletTimeDependent\n" : "");
  if (!below.empty()) add_condition(below.front(), "below", 0, text);
  if (has_two) add_condition(above.front(), "above", -1, text);
  write_text_file(file, text.text());
  return file;
}

}  // namespace geomesh::geomodel
