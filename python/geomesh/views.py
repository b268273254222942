# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of meshes: the viewer of the report page in a notebook or a browser, and pictures drawn by the program."""
from __future__ import annotations

import html
import os
import shutil
import subprocess
import sys
import tempfile
import webbrowser
from typing import Any, List, Optional, Tuple

from . import _geomodel
from .core.errors import UsageError

Size = Tuple[int, int]


def program() -> str:
    """Returns the program geomesh: GEOMESH_PROGRAM, that on the path, or that of the build folder which contains this
    package."""
    built = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(_geomodel.__file__))), "bin", "geomesh")
    for found in (os.environ.get("GEOMESH_PROGRAM"), shutil.which("geomesh"), built):
        if found and os.access(found, os.X_OK):
            return found
    raise UsageError("pictures are drawn by the program geomesh, which is not on the path: install the packages geomesh "
                     "and geomesh-picture, or set GEOMESH_PROGRAM. Mesh.plot and a page (write(\"mesh.html\")) need neither")


def draw(result: _geomodel.JobResult, file: str, view: str, size: Size, options: "dict[str, Any]") -> None:
    """Draws a mesh into a PNG file with ``geomesh picture``."""
    words: List[str] = ["-o", os.path.abspath(file), "--view=" + view, "--size=%dx%d" % tuple(size)]
    words += ["--%s=%s" % (key.replace("_", "-"), value) for key, value in options.items()]
    with tempfile.TemporaryDirectory() as folder:
        mesh = result.write("vtu", os.path.join(folder, "mesh"), {})[0]
        done = subprocess.run([program(), "picture", mesh] + words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
    if done.returncode != 0:
        raise UsageError("no picture was drawn: " + done.stdout.strip())


def in_frame(page: str, height: int) -> str:
    """Returns a whole page as part of another one, which the styles and scripts of the page do not affect."""
    return ('<iframe srcdoc="%s" style="width: 100%%; height: %dpx; border: 0" title="the mesh"></iframe>' %
            (html.escape(page, quote=True), height))


def is_notebook() -> bool:
    """Returns whether the calling program is a notebook, which shows the last value of a cell."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")


class View:
    """The rotatable picture of a mesh, as :meth:`geomesh.Mesh.plot` returns it. A notebook shows it.

    Attributes
    ----------
    page : str
        A whole HTML document, which loads nothing from elsewhere.
    height : int
        Pixels that it takes in a notebook.
    """

    def __init__(self, page: str, height: int = 560) -> None:
        self.page = page
        self.height = height
        self._file: Optional[str] = None

    def _repr_html_(self) -> str:
        return in_frame(self.page, self.height)

    def __repr__(self) -> str:
        return "<geomesh.View of %d kB: .save(file) or .show()>" % (len(self.page) // 1000)

    def save(self, file: "os.PathLike[str] | str") -> str:
        """Writes the HTML page of the picture to a file, and returns the name of the file."""
        with open(file, "w", encoding="utf-8") as out:
            out.write(self.page)
        return os.fspath(file)

    def show(self) -> bool:
        """Opens the page in a browser. Returns False if there is none."""
        if self._file is None:
            handle, self._file = tempfile.mkstemp(prefix="geomesh_", suffix=".html")
            os.close(handle)
            self.save(self._file)
        return webbrowser.open("file://" + self._file)
