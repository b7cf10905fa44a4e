"""Pages in a real browser: what all tests of them need."""

import pathlib
import re
import tempfile
import unittest

import browser
import fixture


class Pages(unittest.TestCase):
    """One browser for all tests of a class."""
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="isopatch-pages-")
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.temporary.cleanup()

    def open(self, name):
        path = self.folder / f"{name}.html"
        if not path.exists():
            fixture.write_page(name, self.folder)
        self.browser.open(path)
        return path

    def expect_drawn(self):
        found = self.browser.pixels()
        self.assertGreater(found["colours"], 50, found)
        self.assertGreater(found["drawn"], 0.04, found)

    def expect_sound(self):
        """No message of the browser, nothing loaded from elsewhere, no control without a name."""
        self.assertEqual(self.browser.messages(), [])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map((x) => x.name)"), [])
        unnamed = self.browser.run("""
            return [...document.querySelectorAll("input, select, button")].filter((control) => !(
              control.getAttribute("aria-label") || (control.labels && control.labels.length) ||
              (control.tagName === "BUTTON" && control.textContent.trim()))).map((control) => control.outerHTML);""")
        self.assertEqual(unnamed, [])


def contrast(*colours):
    """Of two colours "rgb(1, 2, 3)", from 1 to 21: WCAG 2.1, relative luminance."""
    def luminance(colour):
        parts = [int(x) / 255 for x in re.findall(r"\d+", colour)[:3]]
        red, green, blue = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue
    low, high = sorted(map(luminance, colours))
    return (high + 0.05) / (low + 0.05)


def four_digits(value, unit):
    """What the program prints: four digits with the prefix that leaves at least 1 before the point."""
    factor, symbol = next(((f, s) for f, s in [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "u")]
                           if abs(value) >= f and not (unit == "m" and f >= 1)), (1e-9, "n"))
    return f"{value / factor:.4g} {symbol}{unit}"
