# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, grids and the page of a study, made from the available results. Their bytes depend on the results alone;
times are in separate files."""
import csv
import io
import os

import numpy

from . import page, unit_grid
from .store import write_whole

SHARES = (10, 50, 90)
_QUALITY = ("tetrahedra", "points", "min_dihedral", "max_dihedral", "min_radius_ratio")


class Results:
    """Records of the realisations of a study, in the order of their indices."""

    def __init__(self, study, store):
        self.study = study
        self.records, self.missing = [], []
        self.probability = unit_grid.Probability(study.grid) if study.grid else None
        for index in range(1, study.realisations + 1):
            record = store.get(index)
            if record is None:
                self.missing.append(index)
                continue
            grid = record.pop("grid", None)
            if grid is not None:
                self.probability.add(grid, list(record["units"]))
            self.records.append(record)
        self.done = [r for r in self.records if r["status"] == "done"]
        self.failed = [r for r in self.records if r["status"] == "failed"]
        self.units = self._units()
        self.drawn = sorted({name for r in self.records for name in r["drawn"]})

    def _units(self):
        """Returns units in the order of the project's column, followed by others in the order in which they occur."""
        met = {unit: None for r in self.done for unit in r["units"]}
        return [u for u in self.study.project.column if u in met] + sorted(u for u in met if u not in self.study.project.column)

    def volumes(self, unit):
        return numpy.array([r["units"].get(unit, 0.0) for r in self.done])


def percentile(values, share):
    """Returns the value below which `share` per cent of the realisations are, linear between ranks."""
    return float(numpy.percentile(values, share)) if len(values) else float("nan")


def write_all(results, directory):
    """Writes all files that summarise the results of a study; returns their names."""
    files = {"table.csv": _table(results), "times.csv": _times(results), "summary.csv": _summary(results),
             "index.html": page.text(results)}
    if results.probability and results.probability.n:
        arrays = [("probability:" + unit, results.probability.of(unit)) for unit in results.units]
        arrays.append(("entropy", results.probability.entropy(results.units)))
        files["probability.vti"] = unit_grid.vti_text(results.study.grid, arrays)
    hdf5 = _hdf5(results)
    if hdf5 is not None:
        files["results.h5"] = hdf5
    for name, content in files.items():
        write_whole(os.path.join(directory, name), content)
    return sorted(files), hdf5 is not None


def _csv(header, rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return text.getvalue()


def _number(value):
    return "" if value is None else repr(value) if isinstance(value, float) else value


def _table(results):
    header = ["realisation", "status", "failure", "message"] + list(results.drawn)
    header += ["volume:" + unit for unit in results.units] + list(_QUALITY)
    rows = []
    for r in results.records:
        failure = r.get("failure", {})
        row = [r["index"], r["status"], failure.get("kind", ""), failure.get("message", "").replace("\n", " | ")]
        row += [_number(r["drawn"].get(name)) for name in results.drawn]
        row += [_number(r["units"].get(unit, 0.0)) if r["status"] == "done" else "" for unit in results.units]
        rows.append(row + [_number(r.get(key)) for key in _QUALITY])
    return _csv(header, rows)


def _times(results):
    return _csv(["realisation", "wall_s", "cpu_s"], [[r["index"], "%.3f" % r["wall_s"], "%.3f" % r["cpu_s"]] for r in results.records])


def statistics(results):
    """Returns (quantity, mean, standard deviation, P10, P50, P90) for every volume and for the quality."""
    rows = []
    for unit in results.units:
        rows.append(("volume:" + unit, results.volumes(unit)))
    for key in _QUALITY:
        rows.append((key, numpy.array([float(r[key]) for r in results.done if r.get(key) is not None])))
    return [(name, float(v.mean()), float(v.std()), *(percentile(v, s) for s in SHARES)) for name, v in rows if len(v)]


def _summary(results):
    header = ["what", "mean", "standard_deviation"] + ["P%d" % s for s in SHARES]
    return _csv(header, [[row[0]] + [_number(v) for v in row[1:]] for row in statistics(results)])


def _hdf5(results):
    """Returns the results of all realisations as bytes of an HDF5 file; None if h5py is not installed."""
    try:
        import h5py
    except ImportError:
        return None
    buffer = io.BytesIO()
    text = h5py.string_dtype()
    with h5py.File(buffer, "w") as file:
        file.attrs["study"], file.attrs["seed"] = results.study.name, results.study.seed
        _put(file, "realisation", numpy.array([r["index"] for r in results.records], dtype=numpy.int64))
        _put(file, "done", numpy.array([r["status"] == "done" for r in results.records], dtype=numpy.uint8))
        _put(file, "failure", [r.get("failure", {}).get("message", "") for r in results.records], text)
        for unit in results.units:
            _put(file, "volume/" + _link(unit), _column(results, lambda r, u=unit: r["units"].get(u, 0.0)))
        for key in _QUALITY:
            _put(file, "quality/" + key, _column(results, lambda r, k=key: r.get(k)))
        for name in results.drawn:
            _put_drawn(file, name, [r["drawn"].get(name) for r in results.records], text)
        for key in ("wall_s", "cpu_s"):
            _put(file, "time/" + key, numpy.array([r[key] for r in results.records]))
        if results.probability and results.probability.n:
            for unit in results.units:
                _put(file, "probability/" + _link(unit), results.probability.of(unit).astype(numpy.float32))
    return buffer.getvalue()


def _column(results, value):
    found = [value(r) if r["status"] == "done" else None for r in results.records]
    return numpy.array([numpy.nan if v is None else v for v in found], dtype=float)


def _put_drawn(file, name, values, text):
    numbers = all(v is None or (isinstance(v, (int, float)) and not isinstance(v, bool)) for v in values)
    if numbers:
        _put(file, "drawn/" + _link(name), numpy.array([numpy.nan if v is None else v for v in values], dtype=float))
    else:
        _put(file, "drawn/" + _link(name), ["" if v is None else str(v) for v in values], text)


def _put(file, name, values, dtype=None):
    file.create_dataset(name, data=values, dtype=dtype, track_times=False)


def _link(name):
    return name.replace("/", "_")
