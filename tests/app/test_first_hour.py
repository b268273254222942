# SPDX-License-Identifier: GPL-3.0-or-later
"""The first hour of a geologist: one model from raw files, and the mistakes that people make with it, each with what it is told.

A row of MISTAKES changes the project or its files; `status` is that of the run, `said` are words that must be printed, `unsaid` words that
must not: what would mislead, or would say one cause again."""
import math
import re

from geomesh_program import BAD_INPUT, DONE, USAGE, ProgramTest, main

X0, Y0, NX, NY, STEP = 430000.0, 5800000.0, 13, 11, 500.0  # nodes of the grids: 6 by 5 km

PROJECT = """name: model
crs: {horizontal: utm 32N, z: elevation, unit: m}
box: {min: [430000, 5800000, -2500], max: [436000, 5805000, 0]}
surfaces:
  - {name: seafloor, kind: horizon, file: seafloor.csv}
  - {name: top_chalk, kind: horizon, file: top_chalk.zmap}
  - {name: base_chalk, kind: horizon, file: base_chalk.asc}
  - {name: F1, kind: fault, file: F1.csv}
  - {name: salt, kind: body, file: salt.ts}
column: [water, seafloor, tertiary, top_chalk, chalk, base_chalk, bunter]
wells:
  - {name: W1, file: W1.pl}
output: {directory: out, formats: [vtu]}
"""


def height(base, x, y):
    return base + 40 * math.sin((x - X0) / 1900) + 0.01 * (y - Y0)


def nodes(base):
    """Rows from the south, each from the west."""
    return [[(X0 + i * STEP, Y0 + j * STEP, height(base, X0 + i * STEP, Y0 + j * STEP)) for i in range(NX)] for j in range(NY)]


def csv(base, row="%.2f,%.2f,%.2f", header="x,y,z\n", change=lambda p: p):
    return header + "".join(row % change(p) + "\n" for line in nodes(base) for p in line)


def zmap(base, null="-9999.0", holes=(), hole="1.0E+30"):
    """Column by column from the west, each from the north."""
    lines = nodes(base)
    text = "! a grid\n@top HEADER, GRID, 5\n15, %s, , 4, 1\n%d, %d, %r, %r, %r, %r\n0.0, 0.0, 0.0\n@\n" % (
        null, NY, NX, X0, X0 + (NX - 1) * STEP, Y0, Y0 + (NY - 1) * STEP)
    values = ["%15.4f" % lines[j][i][2] if (i, j) not in holes else hole.rjust(15) for i in range(NX) for j in reversed(range(NY))]
    return text + "\n".join("".join(values[k:k + 5]) for k in range(0, len(values), 5)) + "\n"


def esri(base, no_data="", holes=(), hole="-99999", step=STEP):
    """Cells whose centres are the nodes."""
    lines = nodes(base)
    head = "ncols %d\nnrows %d\nxllcorner %r\nyllcorner %r\ncellsize %r\n%s" % (NX, NY, X0 - step / 2, Y0 - step / 2, step, no_data)
    rows = [" ".join("%.3f" % lines[j][i][2] if (i, j) not in holes else hole for i in range(NX)) for j in reversed(range(NY))]
    return head + "\n".join(rows) + "\n"


def dome(open_at_top=False, name="salt", end="\n"):
    """A closed octahedron-like dome of rings about an axis, its poles at -600 and -2200."""
    n, rings = 12, [(-800, 350), (-1200, 600), (-1700, 650), (-2000, 400)]
    cx, cy = 434000.0, 5802000.0
    points = [(cx + r * math.cos(2 * math.pi * k / n), cy + r * math.sin(2 * math.pi * k / n), z) for z, r in rings for k in range(n)]
    points += [(cx, cy, -600), (cx, cy, -2200)]
    top, bottom = len(points) - 2, len(points) - 1
    triangles = []
    for a in range(len(rings) - 1):
        for k in range(n):
            p, q, r, s = a * n + k, a * n + (k + 1) % n, (a + 1) * n + k, (a + 1) * n + (k + 1) % n
            triangles += [(p, r, s), (p, s, q)]
    last = (len(rings) - 1) * n
    for k in range(n):
        if not open_at_top:
            triangles.append((top, k, (k + 1) % n))
        triangles.append((bottom, last + (k + 1) % n, last + k))
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.3f %.3f %.3f" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["TRGL %d %d %d" % tuple(v + 1 for v in t) for t in triangles]
    return end.join(lines + ["END", ""])


def fault_points():
    """A plane that dips to the east, from above the box to below it."""
    return "x,y,z\n" + "".join("%.1f,%.1f,%.1f\n" % (431500 + 60 * i, 5799500 + 500 * j, 200 - 100 * i) for i in range(30) for j in range(13))


def write_files(test):
    test.write("seafloor.csv", csv(-300))
    test.write("top_chalk.zmap", zmap(-1000))
    test.write("base_chalk.asc", esri(-1500))
    test.write("F1.csv", fault_points())
    test.write("salt.ts", dome())
    test.write("W1.pl", "GOCAD PLine 1\nHEADER {\nname:W1\n}\nILINE\nVRTX 1 431000 5801000 0\nVRTX 2 431200 5801100 -2000\nSEG 1 2\nEND\n")


def project(*changes):
    text = PROJECT
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


HOLES = [(i, j) for i in (5, 6, 7) for j in (4, 5)]
LATIN = "Südrandstörung"


class Mistake:
    def __init__(self, name, changes=(), files=(), status=DONE, said=(), unsaid=(), times=()):
        self.name, self.changes, self.files = name, changes, files
        self.status, self.said, self.unsaid, self.times = status, said, unsaid, times


def seafloor(text):
    return [("seafloor.csv", text)]


MISTAKES = [
    Mistake("six typos in one file",
            [("kind: fault", "knd: fault"), ("column:", "colunm:"), ("wells:", "wels:"), ("min: [430000, 5800000, -2500]", "min: [430000, 5800000, deep]"),
             ("seafloor.csv}", "seaflor.csv}"), ("formats: [vtu]", "formats: [vtuu]")], status=USAGE,
            said=["model.yaml:8:", "was 'kind' meant?", "was 'column' meant?", "was 'wells' meant?", "'deep'", "was 'seafloor.csv' meant?", "'vtuu'"]),
    Mistake("missing files", [("file: W1.pl", "file: w1.csv"), ("file: salt.ts", "file: Salt.TS")], status=USAGE,
            said=["there is no file 'w1.csv'", "was 'W1.pl' meant?", "was 'salt.ts' meant?"], unsaid=["F1.csv"]),
    Mistake("feet read as metres", files=[("base_chalk.asc", esri(-1500 / 0.3048))],
            said=["base_chalk lies outside the box", "feet where metres were understood", "'z_unit'", "warning"],
            unsaid=["never meets"], times=[("feet where metres", 1)]),
    Mistake("heights of one horizon in kilometres", [("file: top_chalk.zmap", "file: top_chalk.csv")],
            files=[("top_chalk.csv", csv(-1000, row="%.2f,%.2f,%.6f", change=lambda p: (p[0], p[1], p[2] / 1000)))],
            said=["horizon top_chalk lies within z -1.0", "a thousandth of those of the other horizons", "kilometres where metres were understood", "'z_unit: km'"],
            times=[("kilometres where", 1)]),
    Mistake("feet read as metres, all of them",
            files=[("base_chalk.asc", esri(-5000 / 0.3048)), ("top_chalk.zmap", zmap(-4000 / 0.3048)), ("seafloor.csv", csv(-3000 / 0.3048))],
            status=BAD_INPUT, changes=[("-2500]", "-6500]")] + [("max: [436000, 5805000, 0]", "max: [436000, 5805000, -2500]")],
            said=["no horizon of the column lies in the box", "feet where metres were understood", "z_unit"], times=[("feet where metres", 1)]),
    Mistake("feet read as metres, in a box that is deep enough", [("-2500]", "-6500]")], files=[("top_chalk.zmap", zmap(-1000 / 0.3048))],
            said=["horizon top_chalk lies against the order of the column", "feet where metres were understood", "'z_unit: ft'"], times=[("feet where metres", 1)]),
    Mistake("the column upside down",
            [("[water, seafloor, tertiary, top_chalk, chalk, base_chalk, bunter]", "[bunter, base_chalk, chalk, top_chalk, tertiary, seafloor, water]")],
            said=["is listed before", "from the youngest to the oldest", "units of the column"]),
    Mistake("a column without units", [("[water, seafloor, tertiary, top_chalk, chalk, base_chalk, bunter]", "[seafloor, top_chalk, base_chalk]")],
            status=USAGE, said=["units and horizons must alternate"]),
    Mistake("two horizons left out of the column", [("[water, seafloor, tertiary, top_chalk, chalk, base_chalk, bunter]", "[chalk, base_chalk, bunter]")],
            said=["seafloor, top_chalk stand in no column", "seafloor above base_chalk", "top_chalk above base_chalk", "column: [unit, horizon, unit, ...]"]),
    Mistake("a kind in capitals", [("kind: fault, file: F1.csv", "kind: Fault, file: F1.csv, extent: to_box")], status=USAGE,
            said=["was 'fault' meant?"], unsaid=["only a fault has an extent"]),
    Mistake("a kind that is none", [("kind: body", "kind: dome")], status=USAGE, said=["horizon, fault or body was expected, found 'dome'"]),
    Mistake("longitude and latitude exchanged", files=seafloor("longitude,latitude,z\n" + "".join("52.%03d,8.%03d,-300\n" % (400 + j, 70 + i) for i in range(5) for j in range(5))),
            status=BAD_INPUT, said=["seafloor: ", "exchanged they would lie in it", "columns: {longitude: 2, latitude: 1"]),
    Mistake("degrees under x and y", files=seafloor("x,y,z\n" + "".join("8.%03d,52.%03d,-300\n" % (70 + i, 400 + j) for i in range(5) for j in range(5))),
            status=BAD_INPUT, said=["seafloor: ", "look like longitude and latitude", "crs: geographic"]),
    Mistake("easting and northing exchanged", files=seafloor(csv(-300, change=lambda p: (p[1], p[0], p[2]))),
            said=["seafloor lies outside the box", "with x and y exchanged it would lie over the model", "columns: {x: 2, y: 1, z: 3}"],
            unsaid=["never meets"], times=[("with x and y exchanged", 1)]),
    Mistake("a body without its crown", files=[("salt.ts", dome(open_at_top=True))],
            said=["body salt is open inside the model", "to which it is drawn out straight", "fill_holes: all", "before the nearest side of the box"]),
    Mistake("a horizon that does not reach the box", files=seafloor(csv(-300, change=lambda p: (X0 + 0.6 * (p[0] - X0), p[1], p[2]))),
            said=["seafloor", "extend", "warning"]),
    Mistake("a size with its unit", [("output:", "mesh: {size: 300m}\noutput:")], status=USAGE, said=["a number was expected, found '300m'"]),
    Mistake("tabs", [("  - {name: seafloor", "\t- {name: seafloor")], status=USAGE, said=["tab", "blanks"]),
    Mistake("wrong indentation", [("  - {name: salt", " - {name: salt")], status=USAGE, said=["model.yaml:", "begin in the same column"]),
    Mistake("a key twice", [("output:", "name: again\noutput:")], status=USAGE, said=["model.yaml:13:", "name"]),
    Mistake("a name twice", [("name: top_chalk", "name: seafloor")], status=USAGE, said=["the name 'seafloor' is used already (line 5)"]),
    Mistake("names that differ by case", [("{name: W1", "{name: f1")], said=["tetrahedra"]),
    Mistake("Excel's CSV of Europe", files=seafloor("\ufeff" + csv(-300, row="%s;%s;%s", header="Rechtswert;Hochwert;Tiefe\n",
                                                                change=lambda p: tuple(("%.2f" % v).replace(".", ",") for v in (p[0], p[1], -p[2]))).replace("\n", "\r\n")),
            said=["all 4 units of the column have regions"], unsaid=["seafloor"]),
    Mistake("the same with a fourth column", files=seafloor("\ufeff" + csv(-300, row="A1;%s;%s;%s", header="Punkt;Ost;Nord;Teufe in m\n",
                                                                        change=lambda p: tuple(("%.2f" % v).replace(".", ",") for v in (p[0], p[1], -p[2])))),
            status=BAD_INPUT, said=["seafloor.csv:1:", "Punkt, Ost, Nord, Teufe in m", "columns: {x: 2, y: 3, z: 4}"]),
    Mistake("a fourth column that is named in the project", [("file: seafloor.csv", "file: seafloor.csv, columns: {x: Ost, y: 3, depth: Teufe in m}")],
            files=seafloor(csv(-300, row="A1;%s;%s;%s", header="Punkt;Ost;Nord;Teufe in m\n",
                               change=lambda p: tuple(("%.2f" % v).replace(".", ",") for v in (p[0], p[1], -p[2])))),
            said=["all 4 units of the column have regions"], unsaid=["seafloor"]),
    Mistake("thousands with separators", files=seafloor(csv(-300, row='"%s","%s","%s"', change=lambda p: tuple("{:,.2f}".format(v) for v in p))),
            said=["all 4 units of the column have regions"], unsaid=["seafloor"]),
    Mistake("a name in Latin-1", [("name: salt, kind: body, file: salt.ts", "name: salt, kind: body, file: salt.ts, object: " + LATIN)],
            files=[("salt.ts", (dome(name=LATIN, end="\r\n") + dome(name="other", end="\r\n")).encode("latin-1"))], said=["all 4 units of the column have regions"]),
    Mistake("no object of that name, of a file in Latin-1", [("name: salt, kind: body, file: salt.ts", "name: salt, kind: body, file: salt.ts, object: Nord")],
            files=[("salt.ts", dome(name=LATIN).encode("latin-1"))], status=BAD_INPUT, said=[LATIN, "none is called Nord"]),
    Mistake("1e30 under another null in ZMAP+", files=[("top_chalk.zmap", zmap(-1000, holes=HOLES))],
            said=["top_chalk: 6 nodes of 'top' have the height 1e+30", "the first near (432500, 5802000)", "left out", "no_data: none"]),
    Mistake("1e30 under another null in ESRI ASCII", files=[("base_chalk.asc", esri(-1500, "NODATA_value -9999\n", HOLES, "1e30"))],
            said=["base_chalk: 6 nodes of 'base_chalk' have the height 1e+30", "left out"]),
    Mistake("-99999 without its key", files=[("base_chalk.asc", esri(-1500, "", HOLES, "-99999"))],
            said=["base_chalk: 6 nodes of 'base_chalk' have the height -99999", "left out"]),
    Mistake("a slip of the decimal point in one node", files=[("base_chalk.asc", esri(-1500, "", [(6, 5)], "-149.2"))],
            said=["horizon base_chalk: 1 vertex stands far above or below all neighbours", "above them at (433000, 5802500, -149.2)", "a slip in the file", "warning"]),
    Mistake("two nodes with other slips", files=[("top_chalk.zmap", zmap(-1000, holes=[(3, 3), (8, 7)], hole="-1942.0"))],
            said=["horizon top_chalk: 2 vertices stand far above or below all neighbours", "below them at"]),
    Mistake("a fault as points", said=["tetrahedra", "regions"]),
    Mistake("a fault as sticks in one table",
            files=[("F1.csv", "x,y,z,stick\n" + "".join("%.1f,%.1f,%.1f,%d\n" % (431500 + 600 * i, 5799500 + 500 * j, 200 - 1000 * i, j) for j in range(13) for i in range(4)))],
            said=["all 4 units of the column have regions"], unsaid=["error"]),
    Mistake("traces of a fault on the map", [("file: F1.csv", "file: F1.pl")],
            files=[("F1.pl", "GOCAD PLine 1\nHEADER {\nname:F1\n}\nILINE\nVRTX 1 431500 5799000 0\nVRTX 2 431800 5806000 0\nSEG 1 2\nEND\n")], status=BAD_INPUT,
            said=["surface F1: the lines of F1.pl all lie at height 0", "traces on a map"]),
    Mistake("an archive", [("seafloor.csv", "seafloor.zip")], files=[("seafloor.zip", b"PK\x03\x04" + bytes(range(60)))], status=BAD_INPUT,
            said=["unpack it"], unsaid=["Excel"]),
    Mistake("a body as points", [("file: salt.ts", "file: salt.csv")], files=[("salt.csv", "x,y,z\n" + "".join("%d,%d,%d\n" % (433000 + 7 * i * i, 5801000 + 53 * i, -1000 - 20 * (i * i % 11)) for i in range(12)))],
            status=BAD_INPUT,
            said=["surface salt", "a body needs a closed triangulated surface"]),
    Mistake("five columns without a header", files=seafloor("".join("%d %.1f %.1f %.1f 7\n" % (k, *p) for k, p in enumerate(p for line in nodes(-300) for p in line))),
            status=BAD_INPUT, said=["seafloor.csv:1:", "no header names the 5 columns", "columns: {x: 2, y: 3, z: 4}"]),
    Mistake("a first line of counts", files=seafloor("%d %d 1\n" % (NX, NY) + csv(-300, row="%.1f %.1f %.1f", header="")),
            status=BAD_INPUT, said=["seafloor.csv:1:", "counts"]),
    Mistake("a box for depths", [("-2500]", "0]"), ("5805000, 0]", "5805000, 2500]")], status=BAD_INPUT,
            said=["no horizon of the column lies in the box", "counted the other way", "z: depth"], times=[("counted the other way", 1)]),
    Mistake("a deviation survey without its head", [("file: W1.pl", "file: W1.csv")], files=[("W1.csv", "MD,INCL,AZIM\n0,0,0\n500,0,0\n2000,30,90\n")],
            status=BAD_INPUT, said=["W1.csv", "head: [x, y, z]"]),
    Mistake("a deviation survey", [("file: W1.pl", "file: W1.csv, head: [431000, 5801000, 0]")], files=[("W1.csv", "MD,INCL,AZIM\n0,0,0\n500,0,0\n2000,30,90\n")],
            said=["all 4 units of the column have regions"]),
    Mistake("a well of places", [("file: W1.pl", "file: W1.txt")], files=[("W1.txt", "431000 5801000 0\n431100 5801000 -1000\n431300 5801000 -2000\n")],
            said=["all 4 units of the column have regions"]),
    Mistake("one horizon as depths", files=[("base_chalk.asc", esri(1500))],
            said=["base_chalk lies outside the box", "counted the other way", "'z: depth'"], unsaid=["is listed before", "never meets"],
            times=[("counted the other way", 1)]),
    Mistake("a well as depths", files=[("W1.pl", "GOCAD PLine 1\nHEADER {\nname:W1\n}\nILINE\nVRTX 1 431000 5801000 0\nVRTX 2 431200 5801100 2000\nSEG 1 2\nEND\n")],
            said=["W1 lies outside the box", "counted the other way", "'z: depth'"], unsaid=["a length of"]),
    Mistake("one file for two wells", [("  - {name: W1, file: W1.pl}", "  - {name: W1, file: W1.pl}\n  - {name: W2, file: W1.pl}")],
            said=["wells W1 and W2 have one and the same path", "1 warning"]),
    Mistake("a zone without its half", [("utm 32N", "utm 32")], status=USAGE, said=["32"]),
    Mistake("a unit in full", [("unit: m}", "unit: meter}")], status=USAGE, said=["'meter'"]),
    Mistake("EPSG with a blank", [("utm 32N", "EPSG 25832")], status=USAGE, said=["epsg:"]),
    Mistake("a path of Windows", [("file: seafloor.csv", 'file: "data\\seafloor.csv"')], status=USAGE, said=["write paths with /"]),
    Mistake("an Excel workbook", [("seafloor.csv", "seafloor.xlsx")], files=[("seafloor.xlsx", b"PK\x03\x04" + bytes(range(60)))], status=BAD_INPUT,
            said=["save the sheet", "CSV"]),
    Mistake("SEG-Y", [("seafloor.csv", "seafloor.sgy")], files=[("seafloor.sgy", b"\xc3\x40\xf1\x40" * 900)], status=BAD_INPUT, said=["SEG-Y holds seismic traces"]),
    Mistake("a box of six numbers", [("{min: [430000, 5800000, -2500], max: [436000, 5805000, 0]}", "[430000, 5800000, -2500, 436000, 5805000, 0]"),
                                     ("file: seafloor.csv", "file: seafloor.csv, extend: flat")], status=USAGE,
            said=["box: {min: [x, y, z], max: [x, y, z]}"], unsaid=["there is no box"]),
    Mistake("formats that are none", [("formats: [vtu]", "formats: [eclipse]")], status=USAGE, said=["'eclipse'"]),
    Mistake("formats without a list", [("formats: [vtu]", "formats: vtu")], status=None, said=["vtu"]),
    Mistake("a box with digits too many", [("max: [436000, 5805000, 0]", "max: [4360000, 5805000, 0]")],
            status=BAD_INPUT, said=["seafloor, top_chalk, base_chalk reach over 6000 m of the box's 3.93e+06 m in x", "digit too many"],
            times=[("digit too many", 1)]),
    Mistake("cells with digits too many", [("{min: [430000, 5800000, -2500], max: [436000, 5805000, 0]}", "{margin: 100, bottom: -2500, top: 0}")],
            files=[("base_chalk.asc", esri(-1500, step=1000 * STEP))], status=BAD_INPUT,
            said=["base_chalk reaches over 6e+06 m in x, the other 2 horizons together over 6000 m", "spacing or unit of base_chalk", "digit too many"],
            times=[("digit too many", 1)]),
    Mistake("a box in kilometres", [("{min: [430000, 5800000, -2500], max: [436000, 5805000, 0]}", "{min: [430, 5800, -2.5], max: [436, 5805, 0]}")],
            status=BAD_INPUT, said=["a thousandth of what the surfaces cover", "multiply those of the box by 1000"]),
    Mistake("a fault given as a horizon", [("kind: fault, file: F1.csv", "kind: horizon, file: F1.csv, gridding: {method: triangulate}")], status=None,
            said=["horizon F1 dips by", "kind: fault"]),
    Mistake("one file under two names", [("file: base_chalk.asc", "file: top_chalk.zmap")], status=None, said=["top_chalk and base_chalk are one and the same surface"]),
    Mistake("the zone before the eastings", files=seafloor(csv(-300, change=lambda p: (32e6 + p[0], p[1], p[2]))),
            said=["without 32 million in front of its eastings"], unsaid=["never meets"]),
]


class FirstHour(ProgramTest):
    timeout = 120

    def run_mistake(self, mistake):
        write_files(self)
        for name, text in mistake.files:
            self.write(name, text)
        text = project(*mistake.changes)
        printed = self.run_program(self.write("model.yaml", text), status=mistake.status)
        flat = re.sub(r"\s+", " ", printed)
        for words in mistake.said:
            self.assertIn(words, flat)
        for words in mistake.unsaid:
            self.assertNotIn(words, flat)
        for words, n in mistake.times:
            self.assertEqual(flat.count(words), n, flat)
        if mistake.status in (USAGE, BAD_INPUT):
            self.assert_nothing_written()

    def test_the_model_without_mistakes_says_nothing(self):
        write_files(self)
        printed = self.run_program(self.write("model.yaml", PROJECT))
        self.assertIn("all 4 units of the column have regions", printed)
        self.assertIn("in 2 parts", printed)  # the fault does that, so it is no warning
        self.assertNotIn("warning:", printed)

    def test_info_of_the_project_tells_the_doubts(self):
        write_files(self)
        self.write("seafloor.csv", csv(-300, change=lambda p: (p[1], p[0], p[2])))
        self.assertIn("with x and y exchanged", self.run_program("info", self.write("model.yaml", PROJECT)))

    def test_info_of_a_grid_tells_spikes_and_steps_are_none(self):
        self.assertIn("base: 1 vertex stands", self.run_program("info", self.write("base.asc", esri(-1500, "", [(6, 5)], "-149.2"))))
        lines = nodes(-1000)
        stepped = "".join("%.1f,%.1f,%.2f\n" % (x, y, z - 300 * (x > X0 + 6 * STEP)) for line in lines for x, y, z in line)
        self.assertNotIn("stands", self.run_program("info", self.write("step.csv", "x,y,z\n" + stepped)))

    def test_info_of_a_file_tells_no_data(self):
        printed = self.run_program("info", self.write("a.zmap", zmap(-1000, holes=HOLES)))
        self.assertIn("6 nodes of 'top' have the height 1e+30", printed)
        self.assertNotIn("to 1e+30", printed)


def add_test(number, mistake):
    def test(self):
        self.run_mistake(mistake)
    setattr(FirstHour, "test_%02d_%s" % (number, re.sub(r"\W+", "_", mistake.name)), test)


for number, mistake in enumerate(MISTAKES, 1):
    add_test(number, mistake)


if __name__ == "__main__":
    main()
