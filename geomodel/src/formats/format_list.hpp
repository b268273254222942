// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The list of mesh formats. Each format, or family of formats, has one file in this folder that says what it is, how
/// it is written and how it is read. A new format needs a file in this folder and two lines here.
#pragma once

#include "geomesh/geomodel/formats.hpp"

namespace geomesh::geomodel {

Format vtu_format();                // vtk/vtu.cpp
Format geos_format();               // vtk/geos.cpp
Format gmsh41_format();             // gmsh41.cpp
Format gmsh41_binary_format();      // gmsh41.cpp
Format gmsh22_format();             // gmsh22.cpp
Format gmsh22_binary_format();      // gmsh22.cpp
Format abaqus_format();             // abaqus_inp.cpp
Format exodus_format();             // exodus/, modules/at_need.cpp
Format med_format();                // modules/med.cpp, modules/at_need.cpp
Format xdmf_format();               // modules/xdmf.cpp, modules/at_need.cpp
Format ogs_format();                // opengeosys.cpp
Format openfoam_format();           // openfoam.cpp
Format mfem_format();               // mfem.cpp
Format pflotran_format();           // pflotran.cpp
Format tetgen_format();             // tetgen.cpp
Format pflotran_explicit_format();  // pflotran_explicit.cpp
Format tough_format();              // tough.cpp
Format flac3d_format();             // codes/flac3d.cpp
Format feflow_format();             // codes/feflow.cpp
Format comsol_format();             // codes/comsol.cpp
Format avs_format();                // codes/avs.cpp
Format medit_format();              // codes/medit.cpp
Format medit_binary_format();       // codes/medit.cpp
Format gocad_tsolid_format();       // codes/gocad_tsolid.cpp
Format gocad_tsurf_format();        // surfaces/gocad_tsurf.cpp
Format glb_format();                // surfaces/glb.cpp
Format obj_format();                // surfaces/obj.cpp
Format stl_format();                // surfaces/stl.cpp
Format seissol_format();            // modules/at_need.cpp
Format vtkhdf_format();             // modules/at_need.cpp

/// All mesh formats in the order of the documents. Formats in modules are listed even if the module is missing.
inline constexpr Format (*listed_formats[])() = {
    vtu_format,      gmsh41_format, gmsh41_binary_format, gmsh22_format,       gmsh22_binary_format,
    abaqus_format,   exodus_format, med_format,           xdmf_format,         ogs_format,
    openfoam_format, mfem_format,   pflotran_format,      tetgen_format,       pflotran_explicit_format,
    tough_format,    geos_format,   flac3d_format,        feflow_format,       comsol_format,
    avs_format,      medit_format,  medit_binary_format,  gocad_tsolid_format, gocad_tsurf_format,
    glb_format,      obj_format,    stl_format,           seissol_format,      vtkhdf_format,
};

}  // namespace geomesh::geomodel
