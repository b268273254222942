// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The formats, one or a family a file of this room: each says what it is, how it is written and how it is read.
#pragma once

#include "geomesh/geomodel/formats.hpp"

namespace geomesh::geomodel {

Format vtu_format();            // vtu.cpp
Format gmsh41_format();         // gmsh41.cpp
Format gmsh41_binary_format();  // gmsh41.cpp
Format gmsh22_format();         // gmsh22.cpp
Format gmsh22_binary_format();  // gmsh22.cpp
Format abaqus_format();         // abaqus_inp.cpp
Format exodus_format();         // exodus.cpp
Format med_format();            // med.cpp, with libmedc
Format xdmf_format();           // xdmf.cpp, with HDF5
Format ogs_format();            // opengeosys.cpp
Format openfoam_format();       // openfoam.cpp
Format mfem_format();           // mfem.cpp
Format pflotran_format();       // pflotran.cpp

}  // namespace geomesh::geomodel
