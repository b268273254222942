// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a starter project for OpenGeoSys 6, run as `ogs STEM.ogs.prj`. Source: the documentation of its process
// "Steady-State Diffusion".
#include "geomesh/geomodel/writers.hpp"
#include "starters/starter_model.hpp"
#include "starters/starters.hpp"
#include "writers/text_buffer.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns the name by which OpenGeoSys refers to a mesh: its file's name without the last extension.
std::string mesh_name(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void add_meshes(const std::string& bulk, const std::vector<StarterGroup>& sides, TextBuffer& text) {
  text << "  <meshes>\n    <mesh>" << xml_text(bulk) << "</mesh>\n";
  for (const StarterGroup& side : sides) text << "    <mesh>" << xml_text(side.name) << "</mesh>\n";
  text << "  </meshes>\n";
}

void add_media(const StarterModel& model, TextBuffer& text) {
  text << "  <media>\n";
  for (const StarterRegion& region : model.regions)
    text << "    <medium id=\"" << region.group.name << "\">\n      <!-- " << xml_text(region.group.full_name)
         << ": conductivity in W/(m K), " << origin_of(region.material.conductivity)
         << " -->\n      <properties>\n        <property><name>diffusion</name><type>Constant</type><value>"
         << region.material.conductivity.value
         << "</value></property>\n        <property><name>reference_temperature</name><type>Constant</type>"
            "<value>293.15</value></property>\n      </properties>\n    </medium>\n";
  text << "  </media>\n";
}

void add_condition(const std::vector<StarterGroup>& sides, const char* parameter, TextBuffer& text) {
  for (const StarterGroup& side : sides)
    text << "        <boundary_condition><mesh>" << xml_text(mesh_name(side.name))
         << "</mesh><type>Dirichlet</type><parameter>" << parameter << "</parameter></boundary_condition>\n";
}

constexpr const char* process = R"xml(  <processes>
    <process>
      <name>heat</name>
      <type>STEADY_STATE_DIFFUSION</type>
      <integration_order>2</integration_order>
      <process_variables>
        <process_variable>temperature</process_variable>
      </process_variables>
      <secondary_variables>
        <secondary_variable internal_name="darcy_velocity" output_name="heat_flux"/>
      </secondary_variables>
    </process>
  </processes>
)xml";

constexpr const char* loop_begin = R"xml(  <time_loop>
    <processes>
      <process ref="heat">
        <nonlinear_solver>picard</nonlinear_solver>
        <convergence_criterion><type>DeltaX</type><norm_type>NORM2</norm_type><abstol>1e-8</abstol></convergence_criterion>
        <time_discretization><type>BackwardEuler</type></time_discretization>
        <time_stepping><type>SingleStep</type></time_stepping>
      </process>
    </processes>
    <output>
      <type>VTK</type>
      <prefix>)xml";

constexpr const char* loop_end = R"xml(</prefix>
      <variables><variable>temperature</variable><variable>heat_flux</variable></variables>
    </output>
  </time_loop>
)xml";

constexpr const char* solvers = R"xml(  <nonlinear_solvers>
    <nonlinear_solver>
      <name>picard</name>
      <type>Picard</type>
      <max_iter>10</max_iter>
      <linear_solver>cg</linear_solver>
    </nonlinear_solver>
  </nonlinear_solvers>
  <linear_solvers>
    <linear_solver>
      <name>cg</name>
      <eigen>
        <solver_type>CG</solver_type>
        <precon_type>DIAGONAL</precon_type>
        <max_iteration_step>10000</max_iteration_step>
        <error_tolerance>1e-12</error_tolerance>
      </eigen>
    </linear_solver>
  </linear_solvers>
</OpenGeoSysProject>
)xml";

void add_parameter(const char* name, double value, TextBuffer& text) {
  text << "    <parameter><name>" << name << "</name><type>Constant</type><value>" << value << "</value></parameter>\n";
}

}  // namespace

std::filesystem::path write_ogs_starter(const ModelMesh& mesh, const std::filesystem::path& stem) {
  const std::filesystem::path bulk = stem.string() + ".ogs.vtu", file = stem.string() + ".ogs.prj";
  const StarterModel model = starter_model(mesh, bulk, "MaterialIDs");
  const bool has_two = model.lowest != model.highest;
  std::vector<StarterGroup> above = model.groups_of(model.highest, "mesh"), below, all = above;
  if (has_two) below = model.groups_of(model.lowest, "mesh");
  all.insert(all.end(), below.begin(), below.end());
  TextBuffer text;
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Steady heat flow through the model. Run: ogs "
       << xml_text(file.filename().string()) << " -->\n<OpenGeoSysProject>\n";
  add_meshes(bulk.filename().string(), all, text);
  text << process;
  add_media(model, text);
  text << loop_begin << xml_text(stem.filename().string()) << loop_end << "  <parameters>\n";
  add_parameter("above", temperature_above, text);
  add_parameter("below", temperature_below, text);
  text << "  </parameters>\n  <process_variables>\n    <process_variable>\n      <name>temperature</name>\n"
       << "      <components>1</components>\n      <order>" << (mesh.midpoints.empty() ? 1 : 2)
       << "</order>\n      <initial_condition>above</initial_condition>\n      <boundary_conditions>\n";
  add_condition(above, "above", text);
  add_condition(below, "below", text);
  text << "      </boundary_conditions>\n    </process_variable>\n  </process_variables>\n" << solvers;
  write_text_file(file, text.text());
  return file;
}

}  // namespace geomesh::geomodel
