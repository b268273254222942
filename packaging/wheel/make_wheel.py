#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_wheel.py REPOSITORY STAGE FOLDER: a wheel out of the staged Python package. Called by scripts/wheel.

Shared libraries that are not those of every Linux system go into geomesh3d.libs beside the package, under names with a hash of their
bytes, and are found from there by $ORIGIN. The tag tells the newest version of glibc among the symbols that any file of the wheel needs.
The licences of what is inside stand in the wheel's metadata.
"""
import base64
import email.message
import glob
import hashlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import zipfile

try:
    import tomllib
except ImportError:
    tomllib = None

# What PEP 600 lets a wheel expect of the system, as far as it comes up here.
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1",
                 "libgcc_s.so.1", "libstdc++.so.6", "libz.so.1"}
# libstdc++ and libgcc_s may be older on the system than those that the wheel was built with: they go in as well.
TO_BUNDLE_ANYWAY = {"libstdc++.so.6", "libgcc_s.so.1", "libz.so.1"}
MOST_BYTES = 40 * 10**6
# What a wheel under the GPL, version 3 or later, may carry: Debian's packages by the licence that each is taken under. A library of any
# other package ends the script, so that somebody reads its licence first.
LICENCES = {
    "libgcc-s1": "GPL-3 with the runtime library exception", "libstdc++6": "GPL-3 with the runtime library exception", "libgmp10": "LGPL-3+",
    "libgmpxx4ldbl": "LGPL-3+", "libmpfr6": "LGPL-3+", "libtbb12": "Apache-2.0", "libtbbbind-2-5": "Apache-2.0", "libyaml-cpp0.7": "MIT", "libpugixml1v5": "MIT",
    "libgeographiclib23": "MIT", "libgeographic23": "MIT", "liblz4-1": "BSD-2-clause", "liblzma5": "public domain", "zlib1g": "Zlib", "libmetis5": "Apache-2.0",
    "libhwloc15": "BSD-3-clause", "libudev1": "LGPL-2.1+", "libcap2": "BSD-3-clause"}


def run(*words):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout


def needed(file):
    return run("patchelf", "--print-needed", file).split()


def found_libraries(file):
    """Where the loader finds each library, by name."""
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", file), re.M))
    missing = re.findall(r"^\s*(\S+) => not found", run("ldd", file), re.M)
    if missing:
        raise SystemExit("%s needs %s, which is not here" % (file, ", ".join(missing)))
    return found


def glibc_of(file):
    """The newest version among the symbols of glibc that the file needs."""
    versions = re.findall(r"\(?GLIBC_(\d+)\.(\d+)", run("objdump", "-T", file))
    return max(((int(a), int(b)) for a, b in versions), default=(2, 0))


class Wheel:
    def __init__(self, repository, stage):
        self.repository = repository
        [package] = glob.glob(os.path.join(stage, "**", "geomesh", "__init__.py"), recursive=True)
        self.site = os.path.dirname(os.path.dirname(package))
        self.libs = os.path.join(self.site, "geomesh3d.libs")
        os.makedirs(self.libs)
        self.new_names, self.sources = {}, {}

    def bundle(self):
        files = [f for f in glob.glob(os.path.join(self.site, "geomesh", "**", "*"), recursive=True) if self.is_elf(f)]
        for file in files:
            self.take_libraries(file, os.path.relpath(self.libs, os.path.dirname(file)))
        self.elf_files = files + glob.glob(os.path.join(self.libs, "*"))

    @staticmethod
    def is_elf(path):
        if not os.path.isfile(path):
            return False
        with open(path, "rb") as file:
            return file.read(4) == b"\x7fELF"

    def take_libraries(self, file, way):
        found = found_libraries(file)
        for name in needed(file):
            if name in OF_THE_SYSTEM and name not in TO_BUNDLE_ANYWAY:
                continue
            subprocess.run(["patchelf", "--replace-needed", name, self.take(name, found[name]), file], check=True)
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/" + way if way != "." else "$ORIGIN", file], check=True)

    def take(self, name, path):
        """The name of the library in the wheel."""
        if name in self.new_names:
            return self.new_names[name]
        with open(path, "rb") as source:
            digest = hashlib.sha256(source.read()).hexdigest()[:8]
        stem, rest = name.split(".so", 1)
        new = "%s-%s.so%s" % (stem, digest, rest)
        self.new_names[name], self.sources[new] = new, os.path.realpath(path)
        target = os.path.join(self.libs, new)
        shutil.copy2(os.path.realpath(path), target)
        os.chmod(target, 0o755)
        subprocess.run(["patchelf", "--set-soname", new, target], check=True)
        self.take_libraries(target, ".")
        return new

    def verify(self):
        """Every library that a file names is one of the system or lies in the wheel, and nothing is looked for at places of this machine."""
        inside = {os.path.basename(f) for f in self.elf_files}
        for file in self.elf_files:
            outside = [name for name in needed(file) if name not in inside and name not in OF_THE_SYSTEM - TO_BUNDLE_ANYWAY]
            places = run("patchelf", "--print-rpath", file).strip()
            if outside or not all(place.startswith("$ORIGIN") for place in places.split(":") if place):
                raise SystemExit("%s needs %s and looks in %r" % (file, outside, places))

    def tag(self):
        major, minor = max(glibc_of(f) for f in self.elf_files)
        version = "cp%d%d" % sys.version_info[:2]
        machine = sysconfig.get_platform().split("-")[-1]
        return "%s-%s-manylinux_%d_%d_%s" % (version, version, major, minor, machine)

    def licences(self):
        """Texts by their names in the wheel: geomesh's own, and those of Debian's packages that the libraries come from."""
        texts = {"LICENSE": os.path.join(self.repository, "LICENSE"), "LICENSE.core": os.path.join(self.repository, "core", "LICENSE")}
        for library, path in self.sources.items():
            for place in (path, path.replace("/usr/lib", "/lib", 1)):
                asked = subprocess.run(["dpkg", "-S", place], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
                if asked.returncode == 0:
                    package = asked.stdout.split(":")[0]
                    if package not in LICENCES:
                        raise SystemExit("%s is of the package %s: read its licence and enter it in LICENCES" % (library, package))
                    texts["LICENSE." + package] = "/usr/share/doc/%s/copyright" % package
                    break
            else:
                raise SystemExit("the licence of %s is not known: %s is of no package" % (library, path))
        # Libraries of templates: their code is in the modules.
        for package in ("libcgal-dev", "libeigen3-dev", "nlohmann-json3-dev", "pybind11-dev", "libcli11-dev", "libboost-dev"):
            if os.path.exists("/usr/share/doc/%s/copyright" % package):
                texts["LICENSE." + package] = "/usr/share/doc/%s/copyright" % package
        return texts


def project(repository):
    """The table [project] of pyproject.toml."""
    if tomllib is None:
        raise SystemExit("scripts/wheel needs Python 3.11 or newer")
    with open(os.path.join(repository, "pyproject.toml"), "rb") as file:
        return tomllib.load(file)["project"]


def metadata(repository, table, licence_files):
    message = email.message.Message()
    message["Metadata-Version"] = "2.1"
    message["Name"], message["Version"], message["Summary"] = table["name"], table["version"], table["description"]
    message["License"] = table["license"]["text"]
    message["Requires-Python"] = table["requires-python"]
    for label, url in table.get("urls", {}).items():
        message["Project-URL"] = "%s, %s" % (label, url)
    for classifier in table["classifiers"]:
        message["Classifier"] = classifier
    for dependency in table["dependencies"]:
        message["Requires-Dist"] = dependency
    for extra, packages in table["optional-dependencies"].items():
        message["Provides-Extra"] = extra
        for package in packages:
            message["Requires-Dist"] = '%s ; extra == "%s"' % (package, extra)
    for name in sorted(licence_files):
        message["License-File"] = name
    message["Description-Content-Type"] = "text/markdown"
    with open(os.path.join(repository, "README.md"), encoding="utf-8") as file:
        return message.as_string() .rstrip("\n") + "\n\n" + file.read()


def write(wheel, table, folder):
    tag = wheel.tag()
    name = "%s-%s" % (table["name"], table["version"])
    texts = wheel.licences()
    info = name + ".dist-info/"
    made = {info + "METADATA": metadata(wheel.repository, table, texts).encode(),
            info + "WHEEL": ("Wheel-Version: 1.0\nGenerator: geomesh scripts/wheel\nRoot-Is-Purelib: false\nTag: %s\n" % tag).encode()}
    for licence, path in texts.items():
        with open(path, "rb") as file:
            made[info + "licenses/" + licence] = file.read()
    path = os.path.join(folder, "%s-%s.whl" % (name, tag))
    record = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        def put(inside, content, mode):
            entry = zipfile.ZipInfo(inside, (2020, 1, 1, 0, 0, 0))
            entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append("%s,sha256=%s,%d" % (inside, digest, len(content)))
        for file in sorted(glob.glob(os.path.join(wheel.site, "**", "*"), recursive=True)):
            inside = os.path.relpath(file, wheel.site)
            if os.path.isfile(file) and inside.split(os.sep)[0] in ("geomesh", "geomesh3d.libs") and "__pycache__" not in inside:
                with open(file, "rb") as source:
                    put(inside, source.read(), 0o755 if os.access(file, os.X_OK) else 0o644)
        for inside, content in made.items():
            put(inside, content, 0o644)
        put(info + "RECORD", ("\n".join(record) + "\n%sRECORD,,\n" % info).encode(), 0o644)
    return path


def main(repository, stage, folder):
    wheel = Wheel(repository, stage)
    wheel.bundle()
    wheel.verify()
    path = write(wheel, project(repository), folder)
    size = os.path.getsize(path)
    print("%s: %.1f MB, %d libraries: %s" % (os.path.basename(path), size / 1e6, len(wheel.new_names), ", ".join(sorted(wheel.new_names))))
    if size > MOST_BYTES:
        raise SystemExit("the wheel is larger than %d MB" % (MOST_BYTES // 10**6))


if __name__ == "__main__":
    main(*sys.argv[1:])
