# SPDX-License-Identifier: GPL-3.0-or-later
"""Scalar fields of implicit models on regular grids: values between the nodes, and one field for each side of a fault."""
from __future__ import annotations

import itertools
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Sequence, Tuple

import numpy


class Lattice(NamedTuple):
    """A regular 3D grid of nodes: origin, spacing and counts along x, y, z."""
    origin: Any  # Coordinates of the first node.
    spacing: Any  # Distances between adjacent nodes along x, y, z.
    shape: Tuple[int, int, int]

    def places(self) -> Any:
        """Returns the coordinates of the lattice's nodes, shape (n, 3), z fastest."""
        axes = [o + d * numpy.arange(n) for o, d, n in zip(self.origin, self.spacing, self.shape)]
        return numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


class GridField:
    """A function of x, y, z that is trilinear between the nodes of a lattice. Beyond the border, the outermost cells
    are extrapolated."""

    def __init__(self, lattice: Lattice, values: Any) -> None:
        self.lattice, self.values = lattice, numpy.ascontiguousarray(values, dtype=float)

    def __call__(self, x: Any, y: Any, z: Any) -> Any:
        cells, shares = [], []
        for at, origin, spacing, n in zip((x, y, z), *self.lattice):
            along = (at - origin) / spacing
            cells.append(numpy.clip(numpy.floor(along).astype(int), 0, n - 2))
            shares.append(along - cells[-1])
        total = numpy.zeros(numpy.shape(x))
        for corner in itertools.product((0, 1), repeat=3):
            weight = numpy.prod([s if c else 1 - s for s, c in zip(shares, corner)], axis=0)
            total += weight * self.values[tuple(i + c for i, c in zip(cells, corner))]
        return total


class FaultField(NamedTuple):
    """A fault: the surface on which values given on a lattice are zero."""
    name: str
    values: Any


def _neighbour(values: Any, axis: int, step: int, outside: Any) -> Any:
    """Returns the value `step` nodes farther along an axis for each node of a lattice; `outside` beyond its border."""
    moved = numpy.full_like(values, outside)
    n = values.shape[axis]
    if abs(step) >= n:
        return moved
    to, of = [slice(None)] * 3, [slice(None)] * 3
    to[axis], of[axis] = (slice(0, n - step), slice(step, n)) if step > 0 else (slice(-step, n), slice(0, n + step))
    moved[tuple(to)] = values[tuple(of)]
    return moved


_DIRECTIONS = [(axis, sign) for axis in range(3) for sign in (1, -1)]


# Weights of the nearest nodes along an axis, by the degree of the polynomial through them and by the distance of
# extrapolation.
_BEYOND = ([[3, -3, 1], [6, -8, 3], [10, -15, 6]], [[2, -1], [3, -2], [4, -3]], [[1], [1], [1]])


def continued(values: Any) -> Any:
    """Returns the values at the nodes of a lattice with NaN replaced by finite ones. Up to three nodes from nodes with
    a value, which are all that a cell across a fault can have, values follow the polynomial of second degree through
    the three nearest nodes along an axis, or of lower degree if there are fewer. Farther away they are harmonic, so
    that a level set has no features there which would have to be meshed."""
    known = numpy.array(values, dtype=float)
    known[~numpy.isfinite(known)] = numpy.nan
    if numpy.isnan(known).all():
        raise ValueError("no value of the field is finite")
    near = known.copy()
    for distance, polynomials in enumerate(zip(*_BEYOND), start=1):
        for weights in polynomials:
            total, count = numpy.zeros(known.shape), numpy.zeros(known.shape, dtype=int)
            for axis, sign in _DIRECTIONS:
                guess = sum(w * _neighbour(known, axis, sign * (distance + k), numpy.nan) for k, w in enumerate(weights))
                found = numpy.isfinite(guess)
                total[found] += guess[found]
                count += found
            new = numpy.isnan(near) & (count > 0)
            near[new] = total[new] / count[new]
    return _harmonic(near)


def _harmonic(values: Any) -> Any:
    """Returns the values on a grid with NaN replaced by means of their neighbours, from coarse grids to fine ones."""
    missing = numpy.isnan(values)
    if not missing.any():
        return values
    coarse = values[::2, ::2, ::2]
    start: Any = numpy.nanmean(values)
    if min(values.shape) > 4 and numpy.isfinite(coarse).any():
        field = GridField(Lattice((0, 0, 0), (2, 2, 2), coarse.shape), _harmonic(coarse))
        last = [2 * (n - 1) for n in coarse.shape]
        start = field(*numpy.meshgrid(*(numpy.minimum(numpy.arange(n), m) for n, m in zip(values.shape, last)), indexing="ij"))
    values = numpy.where(missing, start, values)
    for _ in range(40):
        sides = numpy.pad(values, 1, mode="edge")
        mean = sum(sides[tuple(slice(1 + s * (a == axis), n + 1 + s * (a == axis)) for a, n in enumerate(values.shape))]
                   for axis, s in _DIRECTIONS) / 6
        values[missing] = mean[missing]
    return values


def _upward(fault: FaultField, lattice: Lattice) -> int:
    """Returns 1 if the values of a fault increase upwards everywhere on it, -1 if they decrease, 0 if it is vertical or
    overturned."""
    gradient = numpy.gradient(fault.values, *lattice.spacing)
    near = numpy.zeros(fault.values.shape, dtype=bool)
    for axis, sign in _DIRECTIONS:
        near |= fault.values * _neighbour(fault.values, axis, sign, numpy.nan) <= 0
    rise = gradient[2][near] / numpy.sqrt(sum(g[near] ** 2 for g in gradient))
    rounding = 1e-9
    return 1 if (rise > rounding).all() else -1 if (rise < -rounding).all() else 0


def _eroded(mask: Any) -> Any:
    inner = mask.copy()
    for axis, sign in _DIRECTIONS:
        inner &= _neighbour(mask, axis, sign, False)
    return inner


def _blocks(mask: Any) -> Iterator[Tuple[Any, Tuple[int, ...]]]:
    """Returns the connected parts of a set of nodes, each with the node that is deepest inside it."""
    left = mask.copy()
    while left.any():
        core = left
        while _eroded(core).any():
            core = _eroded(core)
        deepest = tuple(int(i) for i in numpy.argwhere(core)[0])
        part = numpy.zeros_like(left)
        part[deepest] = True
        while True:
            grown = part.copy()
            for axis, sign in _DIRECTIONS:
                grown |= _neighbour(part, axis, sign, False)
            grown &= left
            if (grown == part).all():
                break
            part = grown
        left &= ~part
        yield part, deepest


class FieldPart(NamedTuple):
    """A field on one side of faults, the keys of `domain` for this side, and the lattice's nodes on it."""
    field: Callable[..., Any]
    domain: Dict[str, Any]
    nodes: Any


def parts_at_faults(lattice: Lattice, values: Any, own: Sequence[FaultField], every: Sequence[FaultField]) -> List[FieldPart]:
    """Returns one field for each side of the faults at which values jump, each extrapolated beyond them.

    Parameters
    ----------
    own : faults at which the values jump
    every : all faults of the model: if a fault is vertical, fields are distinguished by their blocks
    """
    upward = [_upward(fault, lattice) for fault in own]
    by_blocks = 0 in upward
    faults = list(every if by_blocks else own)
    parts = []
    for side in itertools.product((True, False), repeat=len(faults)):
        nodes = numpy.ones(values.shape, dtype=bool)
        for fault, is_positive in zip(faults, side):
            rounding = 1e-9 * numpy.abs(fault.values).max()  # nodes with |value| below this are on neither side of a fault
            nodes &= (fault.values > rounding) if is_positive else (fault.values < -rounding)
        if not numpy.isfinite(values[nodes]).any():
            continue
        if by_blocks:
            for block, deepest in _blocks(nodes):
                place = [float(o + d * i) for o, d, i in zip(lattice.origin, lattice.spacing, deepest)]
                parts.append((block, {"block": place}))
        else:
            domain: Dict[str, Any] = {}
            for fault, is_positive, sign in zip(faults, side, upward):
                domain.setdefault("above" if is_positive == (sign > 0) else "below", []).append(fault.name)
            parts.append((nodes, domain))
    return [FieldPart(GridField(lattice, continued(numpy.where(nodes, values, numpy.nan))), domain, nodes)
            for nodes, domain in parts if numpy.isfinite(values[nodes]).any()]


def takes(values: Any, value: float, nodes: Any) -> bool:
    """Returns whether a field's values at the given nodes lie on both sides of `value`."""
    known = values[nodes & numpy.isfinite(values)]
    return known.size > 0 and bool(known.min() < value < known.max())
