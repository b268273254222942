# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio on Python 3.13 and newer: its reader of .vtu files needs a base64 decoder that stops at the first padding.

meshio 5.3 hands the text of an array and of all arrays after it to base64.b64decode. Python decoded up to the first '='
until 3.12; since 3.13 it goes on and fails. Files of VTK itself fail likewise.
"""
import base64
import types


def decode_to_padding(text, *arguments, **keys):
    """As base64.b64decode did before Python 3.13: what follows the first padding is ignored."""
    end = text.find("=" if isinstance(text, str) else b"=")
    return base64.b64decode(text if end < 0 else text[:end + -end % 4], *arguments, **keys)


def mend(meshio):
    """meshio itself, with a reader of .vtu files that works on every Python."""
    meshio.vtu._vtu.base64 = types.SimpleNamespace(b64decode=decode_to_padding, b64encode=base64.b64encode)
    return meshio
