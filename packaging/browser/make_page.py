#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_page.py PROGRAM.js SAMPLE OUT.html: one page that holds the compiled program and a sample, and fetches nothing.

PROGRAM.wasm stands beside PROGRAM.js. SAMPLE is the folder of a sample.
"""
import base64
import gzip
import json
import os
import sys

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page")


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def packed(data):
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def in_script(text):
    """Text inside of <script>: what would end the element is written otherwise."""
    if "<!--" in text:
        raise ValueError("a comment of HTML would begin inside of a script")
    return text.replace("</script", "<\\/script")


def sample_files(folder):
    """[path, text] of the project and its surfaces; paths begin with the name of the folder."""
    found = []
    for where, folders, names in os.walk(folder):
        folders[:] = [name for name in sorted(folders) if name != "out"]
        for name in sorted(names):
            if name == "project.yaml" or where != folder:
                path = os.path.join(where, name)
                found.append([os.path.relpath(path, os.path.dirname(folder)), text_of(path)])
    return found


def main():
    program, sample, out = sys.argv[1:]
    with open(os.path.splitext(program)[0] + ".wasm", "rb") as file:
        binary = file.read()
    page = text_of(os.path.join(HERE, "page.html"))
    parts = {"WORKER": in_script(text_of(os.path.join(HERE, "worker.js"))), "EMSCRIPTEN": in_script(text_of(program)),
             "PROGRAM": packed(binary), "SAMPLE": packed(json.dumps(sample_files(os.path.abspath(sample))).encode()),
             "PAGE": in_script(text_of(os.path.join(HERE, "page.js")))}
    for name, text in parts.items():
        before, after = page.split("@%s@" % name)
        page = before + text + after
    os.makedirs(os.path.dirname(os.path.abspath(out)), exist_ok=True)
    with open(out, "w", encoding="utf-8") as file:
        file.write(page)
    print("wrote %s, %.1f MB" % (out, len(page.encode()) / 1e6))


if __name__ == "__main__":
    main()
