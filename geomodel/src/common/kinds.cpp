// SPDX-License-Identifier: GPL-3.0-or-later
// Names the kinds of surfaces, declared in geomesh/geomodel/surface.hpp.
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

const char* to_string(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::surface:
      return "surface";
    case SurfaceKind::horizon:
      return "horizon";
    case SurfaceKind::fault:
      return "fault";
    case SurfaceKind::body:
      return "body";
    case SurfaceKind::box:
      return "box";
  }
  return "surface";
}

}  // namespace geomesh::geomodel
