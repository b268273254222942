# SPDX-License-Identifier: GPL-3.0-or-later
"""A value in the study file: a number, a parameter's name, or a distribution."""
from . import reader
from .draws import Fixed, Lognormal, Normal, Pick, Reference, Triangular, Uniform

_KINDS = ("normal", "uniform", "triangular", "lognormal", "pick")


def read_value(entry, parameters):
    """Returns the distribution of a value in the study file; Fixed(0), after reporting a mistake, if it is wrong."""
    if entry.is_map():
        return _distribution(entry)
    if entry.is_list():
        entry.mistake("a number, a parameter or a distribution was expected, such as {normal: [0, 20]}")
        return Fixed(0.0)
    number = reader.as_number(entry.node)
    if number is not None:
        return Fixed(number)
    word = entry.text()
    if word in parameters:
        return Reference(word)
    entry.mistake("%r is no number and no parameter%s" % (word, reader.meant(word, list(parameters))))
    return Fixed(0.0)


def _distribution(entry):
    found = dict(entry.items(_KINDS + ("within", "weights"), "distribution"))
    kinds = [kind for kind in _KINDS if kind in found]
    if len(kinds) != 1:
        entry.mistake("one distribution was expected: %s" % ", ".join(_KINDS))
        return Fixed(0.0)
    kind = kinds[0]
    for extra, owner in (("within", "normal"), ("weights", "pick")):
        if extra in found and kind != owner:
            found[extra].mistake("is allowed with `%s` alone" % owner)
    return {"normal": _normal, "uniform": _uniform, "triangular": _triangular, "lognormal": _lognormal, "pick": _pick}[kind](found)


def _numbers(entry, n, fits, expected):
    """Returns the n numbers of the entry if `fits` accepts them; otherwise reports a mistake and returns None."""
    values = entry.numbers(n)
    if values is not None and not fits(*values):
        entry.mistake(expected + " was expected")
        return None
    return values


def _uniform(found):
    bounds = _numbers(found["uniform"], 2, lambda least, largest: least <= largest, "[least, largest]")
    return Fixed(0.0) if bounds is None else Uniform(*bounds)


def _normal(found):
    values = _numbers(found["normal"], 2, lambda _, deviation: deviation >= 0, "[mean, standard deviation that is not negative]")
    bounds = found["within"].numbers(2) if "within" in found else None
    if values is None:
        return Fixed(0.0)
    if bounds is None:
        return Normal(*values)
    if not bounds[0] <= bounds[1] or Normal(*values).at(0.5) + 8 * values[1] < bounds[0] or values[0] - 8 * values[1] > bounds[1]:
        found["within"].mistake("[least, largest] was expected, within 8 standard deviations of the mean")
        return Fixed(0.0)
    return Normal(*values, *bounds)


def _lognormal(found):
    values = _numbers(found["lognormal"], 2, lambda median, deviation: median > 0 and deviation >= 0,
                      "[positive median, standard deviation of the logarithm]")
    return Fixed(0.0) if values is None else Lognormal(*values)


def _triangular(found):
    values = _numbers(found["triangular"], 3, lambda least, likely, largest: least <= likely <= largest and least < largest,
                      "[least, most likely, largest]")
    return Fixed(0.0) if values is None else Triangular(*values)


def _pick(found):
    if not found["pick"].is_list() or not found["pick"].node.value:
        found["pick"].mistake("a list was expected")
        return Fixed(0.0)
    values = tuple(entry.plain() for entry in found["pick"].elements())
    weights = (1.0,) * len(values)
    if "weights" in found:
        given = found["weights"].numbers(len(values))
        if given is None or min(given) < 0 or sum(given) <= 0:
            if given:
                found["weights"].mistake("weights may not be negative, and one is positive")
            return Pick(values, weights)
        weights = tuple(given)
    return Pick(values, weights)
