"""A browser without a window that opens pages from files, for the tests of the pages."""

import shutil
import sys
import tempfile

ARGUMENTS = [
    "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
    "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-dev-shm-usage", "--hide-scrollbars", "--force-prefers-reduced-motion"]
CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")


def skip_if_absent():
    """Ends the test program as skipped, naming the Debian packages, where there is no browser to test with."""
    try:
        import selenium  # noqa: F401
    except ImportError:
        missing = "python3-selenium"
    else:
        missing = None if CHROMIUM and DRIVER else "chromium chromium-driver"
    if missing:
        print(f"skipped: the tests of the pages need the Debian packages {missing}", file=sys.stderr)
        sys.exit(77)


class Browser:
    def __init__(self):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
        self.profile = tempfile.TemporaryDirectory(prefix="isopatch-browser-", ignore_cleanup_errors=True)
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for argument in [*ARGUMENTS, f"--user-data-dir={self.profile.name}"]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_script_timeout(30)
        self.resize(1280, 800)

    def close(self):
        self.driver.quit()
        self.profile.cleanup()

    def resize(self, width, height, is_phone=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": is_phone})

    def open(self, path):
        """Opens the page and waits for its first picture; what the console says is thrown away before."""
        self.driver.get_log("browser")
        self.driver.get(path.as_uri())
        self.settle()

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def settle(self):
        """Waits until what was asked for is drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)));")

    def messages(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def change(self, **state):
        self.run("isopatch.viewer.change(arguments[0])", state)
        self.settle()

    def picture(self):
        """The pixels of the canvas as a PNG."""
        return self.run("return isopatch.viewer.canvas.toDataURL()")

    def pixels(self):
        """The canvas' width, height, number of colours, and the part of pixels that differ from the first one."""
        return self.run("""
            const canvas = isopatch.viewer.canvas;
            const gl = canvas.getContext("webgl2") || canvas.getContext("webgl");
            const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
            const bytes = new Uint8Array(4 * width * height);
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            const all = new Uint32Array(bytes.buffer);
            let drawn = 0;
            for (const pixel of all) if (pixel !== all[0]) drawn += 1;
            return {width, height, colours: new Set(all).size, drawn: drawn / all.length, first: [...bytes.slice(0, 3)]};""")

    def click(self, x, y):
        """A click with the mouse at a pixel of the canvas."""
        left, top = self.run("""
            isopatch.viewer.canvas.scrollIntoView({block: "center"});
            const box = isopatch.viewer.canvas.getBoundingClientRect(); return [box.left, box.top];""")
        for kind in ("mousePressed", "mouseReleased"):
            self.driver.execute_cdp_cmd("Input.dispatchMouseEvent", {
                "type": kind, "x": left + x, "y": top + y, "button": "left", "clickCount": 1})
        self.settle()

    def press(self, key, modifiers=0):
        """A key on the canvas; modifiers: 8 is shift."""
        self.run("isopatch.viewer.canvas.focus()")
        for kind in ("keyDown", "keyUp"):
            self.driver.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": kind, "key": key, "modifiers": modifiers})
        self.settle()

    def values(self):
        """What the page shows for the last click: title, how and the rows."""
        return self.run("""
            const host = document.getElementById("picked");
            const rows = [...host.querySelectorAll("dl div")].map((row) => [...row.children].map((cell) => cell.textContent));
            const text = (name) => (host.querySelector(name) || {textContent: ""}).textContent;
            return {title: text("h3"), how: text(".how"), rows: Object.fromEntries(rows)};""")
