// SPDX-License-Identifier: MIT
/// @file
/// Typed errors that carry the offending items. They may be thrown anywhere; the application catches them once, in
/// app/, and maps them to an exit status.
#pragma once

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Kinds of errors, by who can correct them. Each kind has one exit status of the command line.
enum class ErrorKind {
  usage = 2,  ///< error in the command line or project file (a missing file, an unknown key, an unsupported option)
  invalid_input = 3,  ///< invalid data (NaN, crossing facets where crossings are not allowed, ...)
  cannot_mesh = 4,    ///< valid or repaired input that cannot be meshed as requested (nothing enclosed, too thin, ...)
  interrupted = 130,  ///< the cancel token was set
};

/// A part of an unfinished mesh and the constraints there, so that the place where meshing failed can be viewed.
struct MeshExcerpt {
  std::vector<Vec3> points;
  /// Tetrahedra, which are positive with exact coordinates; those in `points` are rounded.
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> triangles;  ///< facets and parts of facets that the mesh should contain
  std::vector<Index> facet;         ///< for each triangle, its facet of the PLC
  std::vector<std::array<VertexIndex, 2>>
      segments;                       ///< segments, parts of segments and edges of facets that the mesh should contain
  std::vector<VertexIndex> culprits;  ///< vertices of the items that caused the error
};

/// Places and items to which an error refers, for messages and for dumps. All lists may be empty.
struct ErrorContext {
  std::vector<Index> facets;          ///< indices of facets of the PLC or triangle soup, or of triangles of a surface
  std::vector<Index> segments;        ///< segments of the PLC
  std::vector<VertexIndex> vertices;  ///< vertices of the PLC
  std::vector<Vec3> places;           ///< coordinates where the error occurred, the most relevant first
  std::shared_ptr<const MeshExcerpt> excerpt = {};  ///< the mesh around the error; null if there is none
};

/// The only exception type for errors that a user can correct. `what()` is a sentence that a user of the program
/// understands: what is wrong, where, and what to do about it.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, ErrorContext context = {})
      : std::runtime_error(message), kind_(kind), context_(std::move(context)) {}
  ErrorKind kind() const { return kind_; }
  const ErrorContext& context() const { return context_; }

 private:
  ErrorKind kind_;
  ErrorContext context_;
};

/// A violated invariant: a bug of geomesh, never a mistake of the user (exit status 1).
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {
[[noreturn]] void fail_check(const char* invariant, const char* file, int line);
}

}  // namespace geomesh

/// Checks of invariants, by cost. GEOMESH_CHECK takes constant time and is always on. GEOMESH_EXPENSIVE_CHECK takes
/// linear time or more, and is on only in builds with GEOMESH_EXPENSIVE_CHECKS (the debug preset). A failed check
/// throws an InternalError that names the invariant.
#define GEOMESH_CHECK(invariant) \
  ((invariant) ? static_cast<void>(0) : ::geomesh::detail::fail_check(#invariant, __FILE__, __LINE__))
#ifdef GEOMESH_EXPENSIVE_CHECKS
#define GEOMESH_EXPENSIVE_CHECK(invariant) GEOMESH_CHECK(invariant)
#else
#define GEOMESH_EXPENSIVE_CHECK(invariant) static_cast<void>(0)
#endif
