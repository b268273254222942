// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stages/refine_model.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "fractures/plane_polygons.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine_conforming.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/name_regions.hpp"
#include "rules/order/deposition.hpp"
#include "solver_mesh/corners/shape_values.hpp"

namespace geomesh::geomodel {

namespace {

/// Keeps the smaller of two requested sizes; of equal sizes the one with the larger radius.
void ask(AskedSize& at, const AskedSize& asked) {
  if (!(asked.size > 0)) return;
  if (at.size <= 0 || asked.size < at.size || (asked.size == at.size && asked.radius > at.radius)) at = asked;
}

[[noreturn]] void refuse_name(const char* what, const std::string& name, const std::set<std::string>& known) {
  const std::string meant = was_meant(name, {known.begin(), known.end()});
  constexpr std::size_t most = 30;
  std::string list;
  std::size_t n = 0;
  for (const std::string& k : known)
    if (++n <= most) list += (list.empty() ? "" : ", ") + k;
  throw Error(ErrorKind::usage, std::string("mesh.size: no ") + what + " of the model is named '" + name + "'" +
                                    (meant.empty() ? ";" : meant) + " known are " + list + (n > most ? ", ..." : ""));
}

/// Returns the region to which each component of the mesh belongs. Throws if one of the names in `words` is neither
/// that of a region nor of a unit.
std::vector<const Region*> regions_of_components(const NamedRegions& named, const std::set<std::string>& words) {
  std::set<std::string> known;
  for (const Region& r : named.regions) known.insert({r.name, r.unit});
  known.erase("");
  for (const std::string& name : words)
    if (!known.contains(name)) refuse_name("unit or region", name, known);
  std::vector<const Region*> regions;
  for (const std::int32_t id : named.id_of_component)
    regions.push_back(&named.regions[static_cast<std::size_t>(id - 1)]);
  return regions;
}

/// Returns the value that the settings give for a region, else the value for its unit.
template <class Value>
Value value_of(const Region& r, const std::map<std::string, Value>& values) {
  const auto own = values.find(r.name), unit = values.find(r.unit);
  return own != values.end() ? own->second : unit != values.end() ? unit->second : Value{};
}

double wavelength_size_of(const Region& r, const NamedSizes& sizes, const NamingRules& naming) {
  const double size = wavelength_size(sizes, value_of(r, naming.attributes));
  if (size > 0) return size;
  throw Error(ErrorKind::usage, "mesh.size.frequency: the region '" + r.name +
                                    "' has no velocity; give its unit one in 'attributes', as " +
                                    (r.unit.empty() ? r.name : r.unit) + ": {vp: 3000}");
}

/// Determines for each component the target size inside it, and the requested number of elements across it.
void ask_of_components(const ModelRecords& model, const ConstrainedTetrahedralization& mesh, const NamingRules& rules,
                       SizeOptions& size) {
  const NamedSizes& asked = model.arranged.refinement.size;
  if (asked.units.empty() && asked.layers.empty() && !(asked.frequency > 0)) return;
  std::vector<std::string> told_later;  // warnings of naming, dropped because naming the final mesh repeats them
  const Column column = make_column(rules.column, model.arranged.surfaces, told_later);
  const NamingRules naming = with_heights(rules, model.arranged.surfaces, model.built.rows, model.built.rules);
  const NamedRegions named = name_regions(
      {mesh, model.arranged.arrangement.soup, model.arranged.plc, model.arranged.surfaces}, naming, column, told_later);
  std::set<std::string> words;
  for (const auto& [name, value] : asked.units) words.insert(name);
  for (const auto& [name, value] : asked.layers) words.insert(name);
  for (const Region* r : regions_of_components(named, words)) {
    double least = value_of(*r, asked.units).size;
    const double by_waves = asked.frequency > 0 ? wavelength_size_of(*r, asked, rules) : 0;
    if (by_waves > 0 && !(least > 0 && least < by_waves)) least = by_waves;
    size.component_size.push_back(least);
    size.component_layers.push_back(value_of(*r, asked.layers));
  }
  if (asked.layers.empty()) size.component_layers.clear();
}

std::string kind_word(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::horizon:
      return "horizons";
    case SurfaceKind::fault:
      return "faults";
    case SurfaceKind::body:
      return "bodies";
    default:
      return {};
  }
}

/// Returns the target size on each patch: the smallest among those of the surfaces to which the patch belongs.
std::vector<AskedSize> patch_sizes(const ModelRecords& model, const std::vector<Index>& facet_patch) {
  const auto& asked = model.arranged.refinement.size.surfaces;
  std::vector<AskedSize> sizes;
  if (asked.empty()) return sizes;
  std::set<std::string> known;
  for (const TriangulatedSurface& s : model.arranged.surfaces) known.insert(s.name);
  known.insert({"horizons", "faults", "bodies"});
  for (const auto& [name, size] : asked)
    if (!known.contains(name)) refuse_name("surface", name, known);
  for (Index f = 0; f < facet_patch.size(); ++f) {
    if (facet_patch[f] >= sizes.size()) sizes.resize(facet_patch[f] + 1);
    for (const PolygonSoup::Origin& o : origins_of(model.arranged.arrangement.soup, model.arranged.plc, f))
      for (const std::string& word :
           {model.arranged.surfaces[o.surface].name, kind_word(model.arranged.surfaces[o.surface].kind)})
        if (const auto at = asked.find(word); at != asked.end()) ask(sizes[facet_patch[f]], at->second);
  }
  return sizes;
}

std::string plural(const std::string& kind) { return kind + "s"; }

std::vector<AskedSize> segment_sizes(const ModelRecords& model) {
  const auto& asked = model.arranged.refinement.size.curves;
  std::vector<AskedSize> sizes;
  if (asked.empty()) return sizes;
  std::set<std::string> known{"wells", "intersections", "borders", "fault_tips"};
  for (const SoupCurve& c : model.arranged.plc.curves) known.insert(c.name);
  for (const auto& [name, size] : asked)
    if (!known.contains(name)) refuse_name("curve", name, known);
  sizes.resize(model.arranged.plc.plc.segments.size());
  for (Index s = 0; s < sizes.size(); ++s)
    for (const Index c : model.arranged.plc.segment_curves[s])
      for (const std::string& name : {model.arranged.plc.curves[c].name, plural(model.arranged.plc.curves[c].kind)})
        if (const auto at = asked.find(name); at != asked.end()) ask(sizes[s], at->second);
  return sizes;
}

/// Returns the names of the surfaces to which facets belong, for example "top, fault".
std::string names_of_facets(const ModelRecords& model, const std::vector<Index>& facets) {
  std::set<std::string> names;
  for (const Index f : facets)
    for (const PolygonSoup::Origin& o : origins_of(model.arranged.arrangement.soup, model.arranged.plc, f))
      names.insert(model.arranged.surfaces[o.surface].name);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Describes surfaces that are kept exactly because they could not be proven to be within the tolerance.
std::string words_of_kept(const ModelRecords& model, const RefineResult& result) {
  if (result.all_kept) {
    return "no mesh of surfaces within the tolerance could be proven to be one, so that all surfaces are kept exactly: "
           "short edges and needles of the input are kept, so elements as poor remain. Choose smaller sizes or another "
           "tolerance";
  }
  if (!result.kept.empty()) {
    std::vector<Index> facets;
    for (const KeptPlace& k : result.kept) facets.push_back(k.facet);
    const Vec3 at = result.kept.front().place + model.inputs.origin;
    return std::to_string(facets.size()) + " triangles of " + names_of_facets(model, facets) +
           " are kept exactly: remeshed they could not be proven to be within the tolerance. The first is at (" +
           short_words(at.x) + ", " + short_words(at.y) + ", " + short_words(at.z) +
           "). Smaller sizes there would let them be remeshed";
  }
  return {};
}

/// Refines the model. If an error names facets, it is thrown again with the names of their surfaces.
RefineResult refine_naming_surfaces(const ModelRecords& model, ConstrainedTetrahedralization mesh,
                                    const RefineOptions& options, const RunContext& context) {
  try {
    return refine_and_improve(model.arranged.plc.plc, std::move(mesh), options, context);
  } catch (const Error& error) {
    const std::string list = names_of_facets(model, error.context().facets);
    if (list.empty()) throw;
    throw Error(error.kind(), std::string(error.what()) + " (surfaces: " + list + ")", error.context());
  }
}

/// Returns points that must not move while surfaces are remeshed: named points, and the corners of fractures.
std::vector<VertexIndex> fixed_points(const ModelRecords& model) {
  const PolygonSoup& soup = model.arranged.arrangement.soup;
  std::vector<VertexIndex> fixed;
  for (const auto& p : soup.isolated_points) fixed.push_back(p.v);
  const std::vector<bool> polygons = plane_polygons(model.arranged.surfaces, model.built.rules);
  if (std::find(polygons.begin(), polygons.end(), true) == polygons.end()) return fixed;
  std::vector<bool> is_corner;  // by point of all surfaces, one after another: whether it is the corner of a fracture
  for (std::size_t s = 0; s < polygons.size(); ++s)
    is_corner.resize(is_corner.size() + model.arranged.surfaces[s].points.size(), polygons[s]);
  for (VertexIndex v = 0; v < soup.points.size(); ++v)
    if (soup.input_point[v] < is_corner.size() && is_corner[soup.input_point[v]]) fixed.push_back(v);
  return fixed;
}

}  // namespace

std::vector<Index> facet_parents(const Arranged& arranged) {
  std::map<std::vector<std::pair<Index, Index>>, Index> number;
  std::vector<Index> parents;
  for (Index f = 0; f < arranged.plc.plc.n_facets(); ++f) {
    std::vector<std::pair<Index, Index>> triangles;
    for (const PolygonSoup::Origin& o : origins_of(arranged.arrangement.soup, arranged.plc, f))
      triangles.emplace_back(o.surface, o.triangle);
    const bool is_piece =
        arranged.plc.facet_soup_offsets[f + 1] - arranged.plc.facet_soup_offsets[f] == 1 && !triangles.empty();
    parents.push_back(is_piece
                          ? number.try_emplace(std::move(triangles), static_cast<Index>(number.size())).first->second
                          : no_index);
  }
  return parents;
}

std::vector<Index> segment_curves(const ModelPlc& plc) {
  std::map<std::vector<Index>, Index> number;
  std::vector<Index> curves;
  for (const std::vector<Index>& names : plc.segment_curves) {
    const bool has_well =
        std::any_of(names.begin(), names.end(), [&](Index c) { return plc.curves[c].kind == "well"; });
    curves.push_back(has_well || names.empty()
                         ? no_index
                         : number.try_emplace(names, static_cast<Index>(number.size())).first->second);
  }
  return curves;
}

const std::vector<std::string>& known_cell_arrays() {
  static const std::vector<std::string> names{"size",         "min_dihedral", "max_dihedral",
                                              "radius_ratio", "mean_ratio",   "aspect"};
  return names;
}

std::string contradiction(const RefinementSettings& settings, const RecoverOptions& recover) {
  const bool wants_size =
      std::find(settings.cell_arrays.begin(), settings.cell_arrays.end(), "size") != settings.cell_arrays.end();
  for (auto at = settings.cell_arrays.begin(); at != settings.cell_arrays.end(); ++at)
    if (std::find(settings.cell_arrays.begin(), at, *at) != at)
      return "the cell array '" + *at + "' is requested twice";
  if (!settings.refine)
    return wants_size ? "the cell array 'size' holds the requested sizes, which exist only where the mesh is refined"
                      : "";
  if (!settings.sizes_on_surfaces) {
    if (settings.honour == Honour::tolerance)
      return "within a tolerance surfaces are remeshed to the sizes, so 'no sizes on surfaces' (on_surfaces: false) "
             "contradicts it; leave out one of them";
    if (recover.mode == MeshMode::conforming)
      return "mode conforming adds points on surfaces, so 'no sizes on surfaces' (on_surfaces: false) contradicts it; "
             "leave out one of them";
  }
  if (recover.mode == MeshMode::conforming) {
    if (settings.honour == Honour::tolerance)
      return "mode conforming keeps the input's facets, so a tolerance for surfaces (honour: tolerance) contradicts "
             "it; leave out one of them";
    if (settings.quality != QualityLevel::standard || settings.quality_measure != QualityMeasure::dihedral ||
        settings.time_budget > 0)
      return "mode conforming refines to sizes and keeps the mesh Delaunay: quality, quality_measure and time_budget "
             "have no meaning "
             "with it, since improving "
             "elements moves points and flips faces";
  }
  if (recover.preserve_boundary)
    return "preserve_boundary and refinement exclude each other: refinement adds points on surfaces";
  return "";
}

RefineOptions refine_options(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                             const NamingRules& naming) {
  const RefinementSettings& settings = model.arranged.refinement;
  RefineOptions options;
  options.honour = settings.honour;
  options.tolerance = settings.tolerance.left();
  options.tolerance_share = settings.tolerance.left_share();
  options.size_surfaces = settings.sizes_on_surfaces;
  options.balance_surfaces = !model.inputs.curved_faces;
  options.quality = settings.quality;
  options.quality_measure = settings.quality_measure;
  options.time_budget = settings.time_budget;
  options.max_elements = settings.max_elements;
  for (const Index p : model.arranged.plc.facet_patch) options.facet_patch.push_back(p - 1);
  options.facet_parent = facet_parents(model.arranged);
  options.segment_curve = segment_curves(model.arranged.plc);
  if (std::any_of(model.arranged.surfaces.begin(), model.arranged.surfaces.end(),
                  [](const auto& s) { return s.kind == SurfaceKind::box; }))
    // Fixed points are named points and corners of fractures. Other points inside a side of the box remain from removed
    // parts of surfaces, and may move.
    options.fixed_points = fixed_points(model);
  options.size = settings.size.base;
  for (const PlaceSize& near : settings.size.near)
    options.size.sources.push_back({near.place - model.inputs.origin, near.asked.size, near.asked.radius});
  ask_of_components(model, mesh, naming, options.size);
  options.size.patch_size = patch_sizes(model, options.facet_patch);
  options.size.segment_size = segment_sizes(model);
  return options;
}

RefineResult refine_model(const ModelRecords& model, ConstrainedTetrahedralization mesh, const RefineOptions& options,
                          const RunContext& context) {
  const PiecewiseLinearComplex& plc = model.arranged.plc.plc;
  if (model.inputs.options.recover.mode == MeshMode::conforming)
    return refine_conforming(plc, mesh, model.inputs.options, options, context);
  RefineResult result = refine_naming_surfaces(model, std::move(mesh), options, context);
  const auto warn = [&](std::string text) {
    context.note(LogLevel::warning, text);
    result.warnings.push_back(std::move(text));
  };
  if (std::string kept = words_of_kept(model, result); !kept.empty()) warn(std::move(kept));
  if (result.statistics.out_of_time)
    warn("the time budget ended the improvement of elements early: the mesh is valid, some elements could be better");
  return result;
}

std::vector<CellArray> make_cell_arrays(const std::vector<std::string>& names,
                                        const ConstrainedTetrahedralization& mesh, const SizeField* size) {
  std::vector<CellArray> arrays;
  for (const std::string& name : names) arrays.push_back({name, {}});
  for (std::size_t t = 0; t < mesh.tetrahedra.size() && !arrays.empty(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    const TetrahedronShape shape = tetrahedron_shape(a, b, c, d);
    for (CellArray& array : arrays)
      array.values.push_back(array.name == "size" ? size->at(0.25 * ((a + b) + (c + d)), mesh.component[t])
                                                  : shape_value(array.name, shape).value());
  }
  return arrays;
}

}  // namespace geomesh::geomodel
