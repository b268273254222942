// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts results of jobs to bytes and back, for pickling on one machine with one version of geomesh.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/geomodel/pipeline.hpp"

namespace geomesh::python {

/// Encodes the result of a job, with its mesh, as bytes. O(size of the mesh).
std::string bytes_of(const geomodel::JobResult& result);

/// Decodes a result from bytes. Throws Error{usage} if the bytes were made by another version, or are damaged.
geomodel::JobResult result_of(std::string_view bytes);

}  // namespace geomesh::python
