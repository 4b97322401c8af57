"""A headless Chromium for tests of pages, driven through the W3C's WebDriver protocol: JSON over HTTP to chromedriver,
with Python's own modules. And the pixels of its screenshots."""
import base64
import json
import os
import re
import shutil
import struct
import subprocess
import urllib.request
import zlib

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key of an element's id, fixed by the standard


def missing():
    """The first program that is not installed, or nothing."""
    return next((each for each in ("chromium", "chromedriver") if not shutil.which(each)), None)


class Browser:
    def __init__(self, width=1200, height=900):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        for line in self.driver.stdout:
            if found := re.search(r"started successfully on port (\d+)", line):
                self.root = f"http://127.0.0.1:{found[1]}"
                break
        else:
            raise RuntimeError("chromedriver does not start")
        arguments = ["--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--force-color-profile=srgb",
                     f"--window-size={width},{height}"]
        if os.geteuid() == 0:
            arguments.append("--no-sandbox")  # which root cannot have
        self.session = ""
        made = self.call("POST", "/session", {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": {"binary": shutil.which("chromium"), "args": arguments},
            "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.session = "/session/" + made["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.session:
            self.call("DELETE", "")
        self.driver.terminate()
        self.driver.wait()

    def call(self, method, path, body=None):
        data = None if method != "POST" else json.dumps(body or {}).encode()
        request = urllib.request.Request(self.root + self.session + path, data, {"Content-Type": "application/json"},
                                         method=method)
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["value"]

    def open(self, url):
        self.call("POST", "/url", {"url": url})

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def find(self, selector):
        return self.call("POST", "/element", {"using": "css selector", "value": selector})

    def click(self, element):
        self.call("POST", f"/element/{element[ELEMENT]}/click")

    def drag(self, element, begin, end):
        """Presses the mouse in an element and moves it; from its middle, in pixels of the page."""
        moves = [{"type": "pointerMove", "duration": 0, "origin": element, "x": x, "y": 0} for x in (begin, end)]
        self.call("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
            "actions": [moves[0], {"type": "pointerDown", "button": 0}, moves[1], {"type": "pointerUp", "button": 0}]}]})

    def errors(self):
        return [each["message"] for each in self.call("POST", "/se/log", {"type": "browser"})]

    def picture(self, element):
        return Picture(base64.b64decode(self.call("GET", f"/element/{element[ELEMENT]}/screenshot")))


class Picture:
    """A PNG of 8 bits that is not interlaced, as browsers write it."""

    def __init__(self, png):
        assert png[:8] == b"\x89PNG\r\n\x1a\n"
        at, data = 8, b""
        while at < len(png):
            length, kind = struct.unpack(">I4s", png[at:at + 8])
            body = png[at + 8:at + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, bits, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
                assert bits == 8 and not interlaced and color in (2, 6)
                self.channels = 3 if color == 2 else 4
            elif kind == b"IDAT":
                data += body
            at += 12 + length
        self.rows = []
        raw, size, above = zlib.decompress(data), self.width * self.channels, bytes(self.width * self.channels)
        for y in range(self.height):
            begin = y * (size + 1)
            above = self.unfiltered(raw[begin], bytearray(raw[begin + 1:begin + 1 + size]), above)
            self.rows.append(above)

    def unfiltered(self, kind, row, above):
        for i in range(len(row)):
            left = row[i - self.channels] if i >= self.channels else 0
            corner = above[i - self.channels] if i >= self.channels else 0
            guess = left + above[i] - corner
            paeth = min((left, above[i], corner), key=lambda each: abs(guess - each))
            row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
        return row

    def at(self, x, y):
        """The colour at a share of its width and of its height."""
        column = int(x * self.width) * self.channels
        return tuple(self.rows[int(y * self.height)][column:column + 3])
