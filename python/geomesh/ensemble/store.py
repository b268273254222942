# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of realisations, one file each, complete or absent."""
import json
import os
import shutil
import tempfile

from ..core.errors import UsageError

FAILURES = "failures"
_IN_ONE_FOLDER = 1000


def write_whole(file, content):
    """Writes a temporary file, then renames it, so that other processes see all of it or nothing."""
    folder = os.path.dirname(file) or "."
    os.makedirs(folder, exist_ok=True)
    handle, part = tempfile.mkstemp(dir=folder, prefix=".part-")
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(content if isinstance(content, bytes) else content.encode("utf-8"))
            out.flush()
            os.fsync(out.fileno())
        os.chmod(part, 0o644)
        os.replace(part, file)
    except BaseException:
        os.unlink(part)
        raise


class Store:
    """The folder of a study's results."""

    def __init__(self, directory, digest):
        self.directory, self._digest = directory, digest

    def file(self, index):
        return os.path.join(self.directory, "realisations", "%05d" % (index // _IN_ONE_FOLDER), "%d.json" % index)

    def put(self, record):
        write_whole(self.file(record["index"]), json.dumps(record, sort_keys=True))

    def get(self, index):
        """Returns the record of a realisation, or None if there is none. Raises UsageError for one of another study."""
        try:
            with open(self.file(index), encoding="utf-8") as text:
                record = json.load(text)
        except FileNotFoundError:
            return None
        if record["study"] != self._digest:
            raise UsageError("%s holds results of another study: the study file, the project or one of its surfaces has changed "
                             "since. Give another folder (-o DIR), or remove this one" % self.directory)
        return record

    def drop_failed(self, index):
        record = self.get(index)
        if record is not None and record["status"] == "failed":
            shutil.rmtree(self.failure_folder(index), ignore_errors=True)
            os.unlink(self.file(index))

    def failure_folder(self, index):
        return os.path.join(self.directory, FAILURES, str(index))

    def missing(self, indices):
        return [index for index in indices if self.get(index) is None]
