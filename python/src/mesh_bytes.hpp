// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Results of jobs as bytes and back, for pickles: between processes of one machine and one version of geomesh.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/geomodel/pipeline.hpp"

namespace geomesh::python {

/// Everything in the result. O(size of the mesh).
std::string bytes_of(const geomodel::JobResult& result);

/// Throws Error{usage} where the bytes were made by another version, or are damaged.
geomodel::JobResult result_of(std::string_view bytes);

}  // namespace geomesh::python
