#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a page: its text, and what a browser without a window makes of it at the width of a desk and of a phone."""
import glob
import html.parser
import json
import os
import re
import struct
import unittest
import zlib

from geomesh_program import SOURCE, ProgramTest, level, main
from headless_browser import BROWSER, Browser

DESK, PHONE = (1400, 1000), (390, 844)


def axe_core():
    """The script of axe-core (npm install axe-core), or nothing: GEOMESH_AXE_CORE names the file."""
    named = os.environ.get("GEOMESH_AXE_CORE")
    places = [named] if named else []
    for folder in (SOURCE, os.path.expanduser("~"), "/usr/local/lib", "/usr/lib", "/usr/share/nodejs"):
        places += glob.glob(os.path.join(folder, "node_modules", "axe-core", "axe.min.js")) + glob.glob(os.path.join(folder, "axe-core", "axe.min.js"))
    return next((p for p in places if os.path.exists(p)), None)


class Elements(html.parser.HTMLParser):
    """Tags with their attributes, and the text of labels."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.text = [], [], {}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes), list(self.open)))
        if tag not in ("input", "meta", "br", "img", "path", "rect", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        while tag in self.open and self.open.pop() != tag:
            pass

    def handle_data(self, data):
        for tag in self.open:
            self.text[tag] = self.text.get(tag, "") + data


def rows_of_png(data):
    """Rows of pixels, each a list of (red, green, blue)."""
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and colour in (2, 6)
            each = 3 if colour == 2 else 4
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, stride, last, out = zlib.decompress(packed), each * width, bytes(each * width), []
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - each] if i >= each else 0), last[i], (last[i - each] if i >= each else 0)
            if kind == 1:
                row[i] = (row[i] + left) & 255
            elif kind == 2:
                row[i] = (row[i] + up) & 255
            elif kind == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif kind == 4:
                guess = left + up - corner
                row[i] = (row[i] + min((left, up, corner), key=lambda v: abs(guess - v))) & 255
        last = bytes(row)
        out.append([tuple(row[each * x:each * x + 3]) for x in range(width)])
    return out


def is_shade_of(pixel, colour):
    """The colour, darker by the light that falls on it; pale neighbours of the pixel row are not it."""
    shares = [p / max(c, 1) for p, c in zip(pixel, colour)]
    return max(shares) - min(shares) < 0.06 and 0.45 < max(shares) < 1.04


def share_of(rows, colour):
    n = sum(is_shade_of(pixel, colour) for row in rows for pixel in row)
    return n / (len(rows) * len(rows[0]))


def rgb(text):
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


class PageTest(ProgramTest):
    def sample_as_page(self, name):
        """The project of a sample, with the page among its formats."""
        with open(self.sample(name)) as file:
            text = file.read()
        text = re.sub(r"(?m)^output:.*\n?", "", text).replace("file: ", "file: " + os.path.dirname(self.sample(name)) + "/")
        return self.write(name.replace("-", "_") + ".yaml", text + "\noutput: {directory: out, formats: [html]}\n")


class Text(PageTest):
    def page(self, more=""):
        self.write("upper.ts", level("upper", 5))
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "column: [top, upper, bottom]\nmesh: {size: 3}\noutput: {directory: ., formats: [vtu, html]}\n" + more)
        self.run_program("project.yaml")
        with open(self.path("model.html")) as file:
            return file.read()

    def test_everything_that_can_be_worked_has_a_name(self):
        text = self.page()
        found = Elements(text)
        self.assertIn('<html lang="en">', text)
        self.assertEqual(sum(tag == "main" for tag, _, _ in found.tags), 1)
        for tag, attributes, inside in found.tags:
            if tag in ("input", "select"):
                self.assertIn("label", inside, attributes)
            if tag == "svg":
                self.assertEqual(attributes.get("role"), "img")
                self.assertGreater(len(attributes.get("aria-label", "")), 5)
            if tag == "canvas" and attributes.get("aria-hidden") != "true":
                self.assertTrue(attributes.get("aria-label") and attributes.get("tabindex") == "0", attributes)
            if tag == "img":
                self.assertIn("corner cut away", attributes["alt"])
        self.assertIn("prefers-color-scheme: dark", text)
        self.assertIn("SPDX-License-Identifier: MIT", text)
        self.assertIsNone(re.search(r"https?:", text))  # nothing is asked of a network

    def test_the_head_says_what_was_made_when_and_by_what(self):
        os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
        self.addCleanup(os.environ.pop, "SOURCE_DATE_EPOCH")
        text = self.page()
        facts = dict(re.findall(r"<dt>(.*?)</dt><dd>(.*?)</dd>", text))
        self.assertEqual(facts["Project"], "project.yaml")
        self.assertEqual(facts["Made"], "14 November 2023, 22:13 UTC")
        self.assertRegex(facts["By"], r"^geomesh \d+\.\d+")
        self.assertEqual(facts["Box"], "x 0 to 10, y 0 to 10, z 0 to 10 (10 x 10 x 10 m)")
        self.assertRegex(facts["Size"], r"^requested: 3 m; edges are [\d.]+ m long in the mean, [\d.]+ m at least")
        self.assertRegex(facts["Elements"], "^elements are fit for solvers")
        self.assertEqual(facts["Model"], "all 2 units of the column have regions; no warnings about the model")

    def test_the_heading_counts_units_and_not_their_parts(self):
        """It said "12 regions" of four units."""
        for sample, words in (("faulted-layers", "4 units in 12 regions"), ("unconformity", "4 units")):
            project = self.sample_as_page(sample)
            printed = self.run_program(project, "-o", self.path("out"))
            self.assertIn(" points, " + words + ":", printed)
            with open(self.path("out", sample.replace("-", "_") + ".html")) as file:
                lead = re.search(r'<p class="lead">(.*?)</p>', file.read()).group(1)
            self.assertTrue(lead.endswith(" points, " + words), lead)

    def test_colours_of_the_project_are_those_of_the_page_and_of_the_report(self):
        text = self.page('colours: {top: "#102030", upper: [255, 0, 0]}\n')
        data = json.loads(re.search(r'id="model">(.*?)</script>', text, re.S).group(1).replace("<\\/", "</"))
        self.assertEqual({r["name"]: r["colour"] for r in data["regions"]}["top"], "#102030")
        self.assertEqual({s["name"]: s["colour"] for s in data["surfaces"]}["upper"], "#ff0000")
        self.assertEqual(self.report(self.path("model.report.json"))["input"]["colours"], {"top": "#102030", "upper": "#ff0000"})

    def test_the_date_of_the_page_is_in_no_mesh_file(self):
        files = []
        for epoch in ("1700000000", "1800000000"):
            os.environ["SOURCE_DATE_EPOCH"] = epoch
            self.addCleanup(os.environ.pop, "SOURCE_DATE_EPOCH", None)
            self.page()
            with open(self.path("model.vtu"), "rb") as file:
                files.append(file.read())
        self.assertEqual(files[0], files[1])


@unittest.skipUnless(BROWSER, "skipped: chromium is not installed")
class InBrowser(PageTest):
    bare = False

    def salt_dome(self):
        """A sample with a body that the closed box hides."""
        self.run_program(self.sample("salt-dome"), "-o", self.path("out"), "--quiet")
        return self.path("out", "salt_dome.html")

    def browse(self, page, size, **more):
        browser = Browser(self.path("profile"), **more)
        self.addCleanup(browser.close)
        browser.open(page, *size)
        if more.get("webgl", True) and browser.evaluate("document.querySelector('.says').textContent").startswith("This browser has no WebGL 2"):
            self.skipTest("skipped: this browser draws no WebGL 2 here")
        return browser

    def stage_box(self, browser):
        return browser.evaluate("(() => { const b = document.querySelector('#viewer .stage').getBoundingClientRect();"
                                " return [b.x + scrollX, b.y + scrollY, b.width, b.height].map(Math.round); })()")

    def stage(self, browser, scale=0.25):
        """The picture's pixels, some of them: decoding them takes long."""
        return rows_of_png(browser.screenshot(self.stage_box(browser), scale))

    def colours(self, browser):
        return {name: rgb(colour) for name, colour in browser.evaluate("JSON.parse(document.getElementById('model').textContent).regions.map(r => [r.name, r.colour])")}

    def use(self, browser, **values):
        """Sets controls as a person would."""
        for name, value in values.items():
            browser.evaluate("(() => { const c = document.querySelector('#viewer [name=%s]'); c.value = '%s'; c.dispatchEvent(new Event('input')); c.dispatchEvent(new Event('change')); })()" % (name, value))
        browser.settle()

    def text(self, browser, selector):
        return browser.evaluate("document.querySelector('%s').innerText" % selector)

    def test_the_first_view_shows_what_is_inside_and_every_control_does_something(self):
        browser = self.browse(self.salt_dome(), DESK)
        colours = self.colours(browser)
        first = self.stage(browser)
        for name, colour in colours.items():
            self.assertGreater(share_of(first, colour), 0.01, name + " is to be seen in the first view")
        self.assertEqual(self.text(browser, ".says"), "Cut at x = 5000 m and at y = 4000 m.")
        with self.subTest("light falls from above"):
            lightest = max(sum(p) for row in first for p in row if is_shade_of(p, colours["tertiary"]))
            self.assertGreater(lightest, 0.95 * sum(colours["tertiary"]))
        with self.subTest("the worst elements are not drawn until they are asked for"):
            self.assertLess(share_of(first, (220, 0, 120)), 1e-5)
        with self.subTest("a cut keeps the side away from the camera"):
            for axis in "xyz":
                self.use(browser, cut=axis)
                if axis != "z":
                    self.assertGreater(share_of(self.stage(browser), colours["salt"]), 0.02, axis)
            self.use(browser, cut="")
            self.assertLess(share_of(self.stage(browser), colours["salt"]), 0.001)
            self.assertEqual(self.text(browser, ".says"), "Nothing is cut away.")
            self.use(browser, cut="line", strike=45)
            self.assertGreater(share_of(self.stage(browser), colours["salt"]), 0.02)
        with self.subTest("colours, heights, units apart, one unit alone"):
            seen = [first]
            self.use(browser, cut="corner")
            for change in ({"colours": "0"}, {"colours": "1"}, {"colours": "unit", "apart": 1}, {"apart": 0, "stretch": 3}):
                self.use(browser, **change)
                seen.append(self.stage(browser))
            self.assertEqual(len({str(rows) for rows in seen}), len(seen))
            self.use(browser, stretch=1)
            browser.evaluate("[...document.querySelectorAll('#viewer .item')].find(e => e.textContent.startsWith('salt')).querySelector('.only').click()")
            browser.settle()
            alone = self.stage(browser)
            self.assertLess(share_of(alone, colours["bunter"]), 0.001)
        self.assertEqual(browser.errors(), [])
        self.assertEqual(browser.requests(), [])

    def test_a_click_names_the_unit_and_its_place(self):
        browser = self.browse(self.salt_dome(), DESK)
        colour = self.colours(browser)["salt"]
        rows = self.stage(browser)
        places = [(x, y) for y, row in enumerate(rows) for x, pixel in enumerate(row) if is_shade_of(pixel, colour)]
        x, y = places[len(places) // 2]
        box = self.stage_box(browser)
        browser.click(box[0] + 4 * x + 2, box[1] + 4 * y + 2)
        card = self.text(browser, ".card")
        self.assertTrue(card.startswith("salt"), card)
        for part in ("volume", "km3", "tetrahedra", "place", "Opacity", "Only this"):
            self.assertIn(part, card)
        at = [float(v) for v in re.search(r"place\s*([-\d.]+), ([-\d.]+), ([-\d.]+) m", card).groups()]
        self.assertTrue(abs(at[0] - 5000) < 1500 and abs(at[1] - 4000) < 1500 and -5000 < at[2] < 0, at)
        before = share_of(rows, colour)
        browser.evaluate("(() => { const s = document.querySelector('.card input'); s.value = 0; s.dispatchEvent(new Event('input')); })()")
        browser.settle()
        self.assertLess(share_of(self.stage(browser), colour), 0.3 * before)
        browser.drag(box[0] + 300, box[1] + 300, 120, -60)
        self.assertEqual(browser.errors(), [])

    def test_the_page_fits_a_phone(self):
        browser = self.browse(self.salt_dome(), PHONE)
        self.assertGreater(browser.evaluate("document.querySelector('canvas.model').clientWidth"), 0.85 * PHONE[0])
        self.assertGreater(share_of(self.stage(browser), self.colours(browser)["salt"]), 0.01)
        self.run_program(self.sample_as_page("faulted-layers"), "-o", self.path("out"), "--quiet")
        for page in ("salt_dome", "faulted_layers"):
            browser.open(self.path("out", page + ".html"), *PHONE)
            self.assertLessEqual(browser.evaluate("document.documentElement.scrollWidth"), PHONE[0], page)

    def test_without_webgl_there_is_a_picture_of_the_inside(self):
        browser = self.browse(self.salt_dome(), DESK, webgl=False)
        self.assertIn("no WebGL 2", self.text(browser, ".says"))
        self.assertTrue(browser.evaluate("document.querySelector('.bar').hidden"))
        rows = self.stage(browser)
        for name, colour in self.colours(browser).items():
            self.assertGreater(share_of(rows, colour), 0.01, name)
        self.assertEqual(browser.errors(), [])

    def test_axe_core_finds_nothing_serious(self):
        script = axe_core()
        if not script:
            self.skipTest("skipped: axe-core is not installed (npm install axe-core, or GEOMESH_AXE_CORE=.../axe.min.js)")
        page = self.salt_dome()
        with open(script, encoding="utf-8") as file:
            text = file.read()
        browser = self.browse(page, DESK)
        for size, dark in ((DESK, False), (DESK, True), (PHONE, False)):
            browser.open(page, *size, dark=dark)
            browser.evaluate(text + "; 1")
            found = browser.evaluate("axe.run().then(r => r.violations.filter(v => ['serious', 'critical'].includes(v.impact))"
                                     ".map(v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 120)).join(' | ')))")
            self.assertEqual(found, [], (size, "dark" if dark else "light"))


if __name__ == "__main__":
    main()
