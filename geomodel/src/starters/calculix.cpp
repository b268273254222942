// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a starter input for CalculiX 2.20: `ccx STEM.job`. Source: its manual, *HEAT TRANSFER and *SOLID SECTION.
#include "geomesh/geomodel/writers.hpp"
#include "starters/starter_model.hpp"
#include "starters/starters.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

void add_materials(const StarterModel& model, TextBuffer& text) {
  for (std::size_t r = 0; r < model.regions.size(); ++r) {
    const StarterMaterial& m = model.regions[r].material;
    const double shear = m.density.value * m.vs.value * m.vs.value;
    const double wave = m.density.value * m.vp.value * m.vp.value;
    const double poisson = (wave - 2 * shear) / (2 * (wave - shear));
    text << "** " << model.regions[r].group.name << ": conductivity " << origin_of(m.conductivity) << "; density "
         << origin_of(m.density) << "; elasticity by vp and vs, " << origin_of(m.vp) << "\n"
         << "*MATERIAL, NAME=material_" << r + 1 << "\n*CONDUCTIVITY\n"
         << m.conductivity.value << "\n*DENSITY\n"
         << m.density.value << "\n*ELASTIC\n"
         << 2 * shear * (1 + poisson) << ", " << poisson << "\n*SOLID SECTION, MATERIAL=material_" << r + 1
         << ", ELSET=" << model.regions[r].group.name << "\n";
  }
}

void add_condition(const StarterModel& model, const std::string& surface, double temperature, TextBuffer& text) {
  for (const StarterGroup& group : model.groups_of(surface, "nset"))
    text << group.name << ", 11, 11, " << temperature << "\n";
}

}  // namespace

std::filesystem::path write_calculix_starter(const ModelMesh& mesh, const std::filesystem::path& stem) {
  const std::filesystem::path mesh_file = stem.string() + ".inp", file = stem.string() + ".job.inp";
  const StarterModel model = starter_model(mesh, mesh_file, "elset");
  TextBuffer text;
  text << "** Steady heat flow through the model. Run: ccx " << stem.filename().string() << ".job\n"
       << "** Lengths in the unit of the mesh (" << mesh.unit << "), materials in SI units: scale one of them where "
       << "that is not m.\n*INCLUDE, INPUT=" << mesh_file.filename().string() << "\n";
  add_materials(model, text);
  text << "*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\n";
  add_condition(model, model.highest, temperature_above, text);
  if (model.lowest != model.highest) add_condition(model, model.lowest, temperature_below, text);
  text << "*NODE FILE\nNT\n*EL FILE\nHFL\n*END STEP\n";
  write_text_file(file, text.text());
  return file;
}

}  // namespace geomesh::geomodel
