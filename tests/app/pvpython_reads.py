# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by ParaView's pvpython, not by python3: `pvpython pvpython_reads.py FILE...` prints as JSON what ParaView has in each file.

A file has blocks, each with its path of names, the number of points, values of field arrays `region:NAME` and the like, and sums of point arrays `nodes:NAME`.
Its cells are rows [dimension, value, number, length or area or volume], one for each value of the first array (0 where the block has a name).
They are measured by ParaView's filter CellSize. Ghosts are left out.
"""
import json
import sys

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkGenericCell
from vtkmodules.util.numpy_support import vtk_to_numpy

MEASURES = {1: "Length", 2: "Area", 3: "Volume"}


def arrays(data):
    return [data.GetArray(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i) is not None]


def cells_of(name, grid):
    data = grid.GetCellData()
    own = numpy.ones(grid.GetNumberOfCells(), dtype=bool)
    if data.HasArray("vtkGhostType"):
        own = vtk_to_numpy(data.GetArray("vtkGhostType")) == 0
    tags = numpy.zeros(len(own), dtype=int) if name else vtk_to_numpy(data.GetArray(0))
    dimension_of = numpy.zeros(256, dtype=int)
    for kind in {grid.GetCellType(c) for c in range(len(own))}:
        dimension_of[kind] = vtkGenericCell.InstantiateCell(kind).GetCellDimension()
    dimensions = dimension_of[[grid.GetCellType(c) for c in range(len(own))]]
    found = []
    for dimension, measure in MEASURES.items():
        sizes = vtk_to_numpy(data.GetArray(measure))
        for tag in numpy.unique(tags[own & (dimensions == dimension)]).tolist():
            rows = own & (dimensions == dimension) & (tags == tag)
            found.append([dimension, tag, int(rows.sum()), float(sizes[rows].sum())])
    return found


def block(name, grid):
    ids = {a.GetName(): int(a.GetTuple1(0)) for a in arrays(grid.GetFieldData()) if ":" in a.GetName()}
    nodes = {a.GetName()[6:]: int(vtk_to_numpy(a).sum()) for a in arrays(grid.GetPointData()) if a.GetName().startswith("nodes:")}
    return {"name": name, "points": grid.GetNumberOfPoints(), "ids": ids, "nodes": nodes, "cells": cells_of(name, grid) if grid.GetNumberOfCells() else []}


def blocks(name, data):
    """Of a tree of blocks each with its path; a collection has pieces of data sets."""
    if data is None:
        return []
    if data.IsA("vtkMultiBlockDataSet"):
        n, get, meta = data.GetNumberOfBlocks(), data.GetBlock, data.GetMetaData
    elif data.IsA("vtkPartitionedDataSetCollection"):
        n, get, meta = data.GetNumberOfPartitionedDataSets(), data.GetPartitionedDataSet, data.GetMetaData
    elif data.IsA("vtkPartitionedDataSet"):
        return [b for i in range(data.GetNumberOfPartitions()) for b in blocks(name, data.GetPartition(i))]
    else:
        return [block(name, data)]
    key = vtkCompositeDataSet.NAME()
    return [b for i in range(n) for b in blocks(name + [meta(i).Get(key) if meta(i) else ""], get(i))]


def read(path):
    reader = simple.OpenDataFile(path)
    for kind in ("ElementBlocks", "SideSets", "NodeSets"):
        if hasattr(reader, kind):
            setattr(reader, kind, getattr(reader, kind).Available)
    sizes = simple.CellSize(Input=reader)
    sizes.UpdatePipeline()
    return blocks([], sizes.GetClientSideObject().GetOutputDataObject(0))


json.dump({"version": str(simple.GetParaViewVersion()), "files": [read(path) for path in sys.argv[1:]]}, sys.stdout)
