# SPDX-License-Identifier: GPL-3.0-or-later
"""Random numbers that depend on the study's seed, the realisation's index and the name of the parameter, and on nothing
else. Adding a parameter to a study does not change the draws of the others. The stream of a name is Philox keyed by
a hash; distributions are inverted from uniform numbers here, so that another version of numpy draws the same.
"""
import bisect
import hashlib
import math
from dataclasses import dataclass
from statistics import NormalDist
from typing import Tuple

import numpy

_STANDARD = NormalDist()


class Stream:
    """Random numbers, uniform and normal, for one named parameter in one realisation."""

    def __init__(self, seed, index, name):
        key = hashlib.sha256(("%d/%d/%s" % (seed, index, name)).encode()).digest()[:16]
        self._bits = numpy.random.Philox(key=int.from_bytes(key, "little"))

    def uniforms(self, count):
        """Returns numbers in the open interval from 0 to 1: multiples of 2^-53 minus a half of it."""
        raw = self._bits.random_raw(count)
        return ((raw >> numpy.uint64(11)).astype(numpy.float64) + 0.5) * 2.0 ** -53

    def uniform(self):
        return float(self.uniforms(1)[0])

    def normals(self, count):
        return numpy.array([_STANDARD.inv_cdf(min(u, 1 - 2.0 ** -53)) for u in self.uniforms(count).tolist()])


@dataclass(frozen=True)
class Fixed:
    value: object

    def at(self, u):
        return self.value


@dataclass(frozen=True)
class Reference:
    """The value of a parameter of the study, drawn once per realisation."""
    name: str


@dataclass(frozen=True)
class Uniform:
    low: float
    high: float

    def at(self, u):
        return self.low + u * (self.high - self.low)


@dataclass(frozen=True)
class Normal:
    """`low` and `high` truncate the distribution, whose shape in between is not changed."""
    mean: float
    sd: float
    low: float = -math.inf
    high: float = math.inf

    def at(self, u):
        if self.sd == 0:
            return self.mean
        whole = NormalDist(self.mean, self.sd)
        below, above = whole.cdf(self.low), whole.cdf(self.high)
        share = min(max(below + u * (above - below), 2.0 ** -54), 1 - 2.0 ** -53)
        return min(max(whole.inv_cdf(share), self.low), self.high)


@dataclass(frozen=True)
class Lognormal:
    """Log-normal distribution, given by `median` and the standard deviation of the natural logarithm."""
    median: float
    sd_log: float

    def at(self, u):
        return self.median * math.exp(self.sd_log * _STANDARD.inv_cdf(min(u, 1 - 2.0 ** -53)))


@dataclass(frozen=True)
class Triangular:
    low: float
    mode: float
    high: float

    def at(self, u):
        width, rise = self.high - self.low, self.mode - self.low
        if u * width <= rise:
            return self.low + math.sqrt(u * width * rise)
        return self.high - math.sqrt((1 - u) * width * (self.high - self.mode))


@dataclass(frozen=True)
class Pick:
    """Distribution of a value that is one of several given ones, with probabilities proportional to weights."""
    values: Tuple
    weights: Tuple

    def at(self, u):
        sums, total = [], 0.0
        for weight in self.weights:
            total += weight
            sums.append(total)
        return self.values[min(bisect.bisect_right(sums, u * total), len(self.values) - 1)]


class Draws:
    """The values drawn in one realisation, each once, by its name in the study file."""

    def __init__(self, seed, index, parameters):
        self._seed, self._index, self._parameters = seed, index, parameters
        self.values = {}

    def value(self, name, distribution):
        """Returns the value called `name` (such as surfaces.salt.shift.z), or that of a parameter to which it refers."""
        if isinstance(distribution, Reference):
            return self.value("parameters." + distribution.name, self._parameters[distribution.name])
        if isinstance(distribution, Fixed):
            return distribution.value
        if name not in self.values:
            self.values[name] = distribution.at(self.stream(name).uniform())
        return self.values[name]

    def stream(self, name):
        return Stream(self._seed, self._index, name)
