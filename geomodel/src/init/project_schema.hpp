// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The text of docs/project.schema.json, which `geomesh init` provides to editors without network or sources.
#pragma once

namespace geomesh::geomodel {

extern const char* const project_schema;

}  // namespace geomesh::geomodel
