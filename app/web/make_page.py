#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes geomesh.html: one file with the page, the program, and samples in it, so that it works from any server and from a folder.

    make_page.py PROGRAM.js PROGRAM.wasm VERSION OUT.html
"""
import base64
import gzip
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.join(os.path.dirname(os.path.dirname(HERE)), "samples")
SHOWN = {"salt-dome": "Salt dome", "faulted-layers": "Faulted layers", "well-tops": "Horizons from well tops", "wells": "Layers with wells"}
MOST_BYTES = 15_000_000


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def files_of_sample(name):
    """Path, beginning with the sample's folder: text."""
    found = {}
    for where, folders, names in os.walk(os.path.join(SAMPLES, name)):
        folders.sort()
        for each in sorted(names):
            if each == "project.yaml" or where.endswith("surfaces"):
                path = os.path.join(where, each)
                found[os.path.relpath(path, SAMPLES).replace(os.sep, "/")] = read(path)
    return found


def packed(data):
    """Compressed, as text; the same bytes for the same data."""
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def main():
    script, program, version, output = sys.argv[1:]
    with open(program, "rb") as file:
        wasm = file.read()
    samples = [{"title": title, "files": files_of_sample(name)} for name, title in SHOWN.items()]
    parts = {
        "STYLE": read(os.path.join(HERE, "page.css")),
        "SCRIPT": read(os.path.join(HERE, "page.js")),
        "WORKER": read(script) + "\n" + read(os.path.join(HERE, "worker.js")),
        "SAMPLES": json.dumps(samples).replace("<", "\\u003c"),
        "PROGRAM": packed(wasm),
        "VERSION": "geomesh " + version,
    }
    page = read(os.path.join(HERE, "page.html"))
    for name, text in parts.items():
        if "</script" in text:
            sys.exit("%s would end its element: it has </script in it" % name)
        before, after = page.split("@%s@" % name)
        page = before + text + after
    data = page.encode()
    if len(data) >= MOST_BYTES:
        sys.exit("the page has %.1f MB: at most %.0f MB are promised" % (len(data) / 1e6, MOST_BYTES / 1e6))
    with open(output, "wb") as file:
        file.write(data)
    print("%s: %.1f MB, of which the program %.1f MB (%.1f MB unpacked)" % (output, len(data) / 1e6, len(parts["PROGRAM"]) / 1e6, len(wasm) / 1e6))


if __name__ == "__main__":
    main()
