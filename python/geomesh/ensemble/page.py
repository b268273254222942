# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a study: percentiles, histograms of volumes, sections of probability, failures. One file, nothing loaded from elsewhere."""
import base64
import html
import struct
import zlib

import numpy

_STYLE = """body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em;color:#222}
table{border-collapse:collapse}td,th{padding:.2em .8em;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child{text-align:left}figure{display:inline-block;margin:0 1.5em 1.5em 0;vertical-align:top}
figcaption{font-size:13px;color:#555}img{image-rendering:pixelated;border:1px solid #ccc}"""
_WIDTH = 420  # width of each picture on the page (section or histogram), in pixels


def text(results):
    study = results.study
    parts = ["<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>%s</title><style>%s</style>" % (_safe(study.name), _STYLE),
             "<h1>%s</h1>" % _safe(study.name), _lead(results)]
    if results.done:
        parts += ["<h2>Volumes and quality</h2>", _statistics(results), "<h2>Volumes by unit</h2>"]
        parts += [_histogram(unit, results.volumes(unit)) for unit in results.units]
    if results.probability and results.probability.n:
        parts += ["<h2>Probability of each unit</h2>", _sections(results)]
    if results.failed:
        parts += ["<h2>Failures</h2>", _failures(results)]
    return "\n".join(parts) + "\n"


def _lead(results):
    counts = "%d realisations of %s, seed %d: %d done, %d failed" % (
        results.study.realisations, results.study.project.name, results.study.seed, len(results.done), len(results.failed))
    if results.missing:
        counts += ", <b>%d not run yet</b>" % len(results.missing)
    return "<p>%s.</p>" % counts


def _statistics(results):
    from .collect import SHARES, statistics
    head = "".join("<th>%s" % name for name in ("", "mean", "standard deviation", *("P%d" % s for s in SHARES)))
    rows = "".join("<tr><td>%s%s" % (_safe(row[0].replace("volume:", "volume of ")), "".join("<td>%.6g" % v for v in row[1:]))
                   for row in statistics(results))
    return "<table><tr>%s%s</table><p>P10 is the value that 10 %% of the realisations stay below.</p>" % (head, rows)


def _histogram(unit, values):
    from .collect import SHARES, percentile
    low, high = float(values.min()), float(values.max())
    if high == low:
        return "<figure><figcaption>%s: %.6g in every realisation</figcaption></figure>" % (_safe(unit), low)
    counts, _ = numpy.histogram(values, bins=24, range=(low, high))
    tall, step = 140.0, _WIDTH / 24.0
    bars = "".join('<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" fill="#6b8fb3"/>'
                   % (i * step, tall - tall * c / counts.max(), step - 1, tall * c / counts.max()) for i, c in enumerate(counts))
    lines = "".join('<line x1="%.1f" x2="%.1f" y1="0" y2="%.0f" stroke="#c33"/><text x="%.1f" y="11" font-size="10">P%d</text>'
                    % (at, at, tall, at + 2, share)
                    for share in SHARES for at in [(percentile(values, share) - low) / (high - low) * _WIDTH])
    svg = '<svg width="%d" height="%d" viewBox="0 0 %d %d">%s%s</svg>' % (_WIDTH, tall, _WIDTH, tall, bars, lines)
    return "<figure>%s<figcaption>%s: %.6g to %.6g</figcaption></figure>" % (svg, _safe(unit), low, high)


def _sections(results):
    cells, grid = results.study.grid.cells, results.study.grid
    middle = cells[1] // 2
    y = grid.low[1] + (middle + 0.5) * grid.spacing()[1]
    named = [("probability of " + unit, results.probability.of(unit), 1.0) for unit in results.units]
    named.append(("entropy (bits)", results.probability.entropy(results.units), max(1.0, numpy.log2(max(2, len(results.units))))))
    figures = [_figure("%s, section at y = %.6g" % (name, y), values[:, middle, :].T[::-1] / top, grid) for name, values, top in named]
    return "".join(figures) + "<p>White is 0, dark is %s; x runs to the right, z upwards.</p>" % "1, of the entropy the most possible"


def _figure(caption, shares, grid):
    height = _WIDTH * (grid.high[2] - grid.low[2]) / (grid.high[0] - grid.low[0])
    height = min(max(height, 100.0), 420.0)
    source = base64.b64encode(png(_coloured(shares))).decode()
    return '<figure><img width="%d" height="%d" alt="" src="data:image/png;base64,%s"><figcaption>%s</figcaption></figure>' % (
        _WIDTH, height, source, _safe(caption))


def _coloured(shares):
    """Returns colours from white through blue to nearly black."""
    stops = numpy.array([[255, 255, 255], [120, 165, 210], [20, 30, 70]], dtype=float)
    at = numpy.clip(shares, 0, 1)
    return numpy.stack([numpy.interp(at, [0, 0.5, 1], stops[:, c]) for c in range(3)], axis=2).round().astype(numpy.uint8)


def png(pixels):
    """Encodes an image of shape (rows, columns, 3) as PNG."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows, columns = pixels.shape[:2]
    lines = b"".join(b"\0" + pixels[row].tobytes() for row in range(rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def _failures(results):
    rows = "".join("<tr><td>%d<td>%s<td style=\"text-align:left\">%s<td><a href=\"failures/%d/project.yaml\">input</a>"
                   % (r["index"], r["failure"]["kind"], _safe(r["failure"]["message"]), r["index"]) for r in results.failed)
    return "<table><tr><th>realisation<th>kind<th>message<th>%s</table>" % rows


def _safe(text_):
    return html.escape(str(text_))
