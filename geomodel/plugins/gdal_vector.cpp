// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lines and points from Shapefile, GeoPackage and GeoJSON with GDAL: a part of the module geomesh-gdal. Its
// interface is readers/vectors/vector_module.hpp.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <mutex>

#include "readers/vectors/vector_module.hpp"

namespace {

using geomesh::geomodel::VectorFeature;
using geomesh::geomodel::VectorFile;

struct CloseDataset {
  void operator()(GDALDataset* d) const { GDALClose(d); }
};

void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* text) {
  constexpr std::size_t most_warnings = 5;
  auto& warnings = static_cast<VectorFile*>(CPLGetErrorHandlerUserData())->warnings;
  if (level >= CE_Warning && warnings.size() < most_warnings) warnings.emplace_back(text);
}

/// While this object exists, GDAL's messages are stored for the file.
class Listening {
 public:
  explicit Listening(VectorFile& file) {
    CPLErrorReset();
    CPLPushErrorHandlerEx(collect, &file);
  }
  ~Listening() { CPLPopErrorHandler(); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
};

std::vector<geomesh::Vec3> points_of(const OGRSimpleCurve& curve) {
  std::vector<geomesh::Vec3> points;
  for (int i = 0; i < curve.getNumPoints(); ++i) points.push_back({curve.getX(i), curve.getY(i), curve.getZ(i)});
  return points;
}

void add_geometry(const OGRGeometry& geometry, VectorFeature& feature) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint: {
      const OGRPoint& p = *geometry.toPoint();
      if (!p.IsEmpty()) feature.points.push_back({p.getX(), p.getY(), p.getZ()});
      return;
    }
    case wkbLineString:
      feature.lines.push_back(points_of(*geometry.toLineString()));
      return;
    case wkbPolygon:
      for (const OGRLinearRing* ring : *geometry.toPolygon()) feature.lines.push_back(points_of(*ring));
      return;
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_geometry(*part, feature);
      return;
    default:
      if (!geometry.hasCurveGeometry()) return;
      if (const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry()); straight)
        add_geometry(*straight, feature);
  }
}

void add_columns(const OGRFeature& read, VectorFeature& feature) {
  for (int i = 0; i < read.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *read.GetFieldDefnRef(i);
    if (!read.IsFieldSetAndNotNull(i)) continue;
    const OGRFieldType type = field.GetType();
    if (type == OFTReal || type == OFTInteger || type == OFTInteger64)
      feature.numbers.emplace_back(field.GetNameRef(), read.GetFieldAsDouble(i));
    if (type == OFTString) feature.texts.emplace_back(field.GetNameRef(), read.GetFieldAsString(i));
  }
}

void describe_system(const OGRSpatialReference* system, VectorFile& file) {
  if (!system || !file.system.empty()) return;
  const char *authority = system->GetAuthorityName(nullptr), *code = system->GetAuthorityCode(nullptr);
  if (authority && code && EQUAL(authority, "EPSG")) {
    file.system = std::string("epsg:") + code;
  } else if (const char* name = system->GetName()) {
    file.system = name;
  }
  file.geographic = system->IsGeographic() != 0;
  if (system->IsProjected()) file.metres_per_unit = system->GetLinearUnits();
}

void read_layer(OGRLayer& layer, VectorFile& file) {
  describe_system(layer.GetSpatialRef(), file);
  for (const auto& read : layer) {
    const OGRGeometry* const geometry = read->GetGeometryRef();
    if (!geometry || geometry->IsEmpty()) continue;
    VectorFeature feature;
    feature.layer = layer.GetName();
    feature.has_z = geometry->Is3D() != 0;
    add_geometry(*geometry, feature);
    add_columns(*read, feature);
    file.features.push_back(std::move(feature));
  }
}

VectorFile read(const char* path) {
  static std::once_flag registered;
  std::call_once(registered, [] {
    CPLSetConfigOption("SHAPE_RESTORE_SHX", "NO");  // nothing is written beside the user's files
    RegisterOGRShape();
    RegisterOGRGeoPackage();
    RegisterOGRGeoJSON();
  });
  VectorFile file;
  try {
    const Listening listening(file);
    const char* const drivers[] = {"ESRI Shapefile", "GPKG", "GeoJSON", nullptr};
    const std::unique_ptr<GDALDataset, CloseDataset> data(
        static_cast<GDALDataset*>(GDALOpenEx(path, GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr)));
    if (!data) {
      file.error = std::string("cannot be read: ") + CPLGetLastErrorMsg();
      return file;
    }
    file.format = data->GetDriverName();
    for (OGRLayer* layer : data->GetLayers()) read_layer(*layer, file);
  } catch (const std::exception& e) {  // no exception may cross the interface
    file.error = e.what();
  }
  return file;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const geomesh::geomodel::VectorModule* geomesh_vector_reader() {
  static constexpr geomesh::geomodel::VectorModule module{GEOMESH_MODULE_VERSION, read};
  return &module;
}
