// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The text of docs/project.schema.json, so that `geomesh init` can provide it to editors without a network or the
/// sources.
#pragma once

namespace geomesh::geomodel {

extern const char* const project_schema;

}  // namespace geomesh::geomodel
