# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of ways to break an output, each with the faults of which the checker must name one at least."""

CORRUPTIONS = {}


def corruption(*faults):
    """Registers a way to break a model, and the faults of which one at least must be named."""
    def register(function):
        CORRUPTIONS[function.__name__] = (function, faults)
        return function
    return register


def exchange(values, a, b):
    values[a], values[b] = values[b], values[a]
