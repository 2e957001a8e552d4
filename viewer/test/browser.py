# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium, driven over two pipes by its DevTools protocol (version 1.3).

https://chromedevtools.github.io/devtools-protocol/
"""

import base64
import fcntl
import json
import os
import pathlib
import select
import signal
import tempfile
import time

LIMIT = 120  # s; drawing in software on a busy machine is slow


class Browser:
    def __init__(self, program, *options):
        self.folder = tempfile.TemporaryDirectory(prefix="replay-", ignore_cleanup_errors=True)
        theirs, self.to = (self._high(fd) for fd in os.pipe())
        self.from_, ours = (self._high(fd) for fd in os.pipe())
        log = os.open(os.path.join(self.folder.name, "log"), os.O_CREAT | os.O_WRONLY)
        arguments = [program, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--remote-debugging-pipe", "--no-first-run",
                     "--disable-extensions", "--disable-background-networking",
                     f"--user-data-dir={self.folder.name}/profile", *options, "about:blank"]
        dup = os.POSIX_SPAWN_DUP2
        self.process = os.posix_spawn(program, arguments, os.environ, file_actions=[
            (dup, log, 2), (dup, log, 1), (dup, theirs, 3), (dup, ours, 4)])
        for fd in (theirs, ours, log):
            os.close(fd)
        self.rest, self.number, self.faults, self.events = b"", 0, [], []
        pages = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in pages if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"],
                                 flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=self.folder.name)

    @staticmethod
    def _high(fd):
        """Out of the way of 3 and 4, where Chromium expects its ends."""
        high = fcntl.fcntl(fd, fcntl.F_DUPFD_CLOEXEC, 10)
        os.close(fd)
        return high

    session = None

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session and not method.startswith(("Browser.", "Target.")):
            message["sessionId"] = self.session
        left = json.dumps(message).encode() + b"\0"
        while left:
            left = left[os.write(self.to, left):]
        until = time.monotonic() + LIMIT
        while True:
            answer = self._receive(until)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self._note(answer)

    def _receive(self, until):
        while b"\0" not in self.rest:
            if not select.select([self.from_], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError(f"Chromium did not answer within {LIMIT} s")
            piece = os.read(self.from_, 1 << 20)
            if not piece:
                raise RuntimeError("Chromium has ended; its last words: " + self.last_words())
            self.rest += piece
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def last_words(self):
        with open(os.path.join(self.folder.name, "log"), errors="replace") as log:
            return log.read()[-500:]

    def _note(self, event):
        """Keeps errors and exceptions of the page."""
        what, said = event.get("method"), event.get("params", {})
        if what == "Runtime.exceptionThrown":
            details = said["exceptionDetails"]
            self.faults.append(details.get("exception", {}).get("description", details["text"]))
        elif what == "Runtime.consoleAPICalled" and said["type"] in ("error", "assert"):
            self.faults.append(" ".join(str(a.get("value", a.get("description")))
                                        for a in said["args"]))
        elif what == "Log.entryAdded" and said["entry"]["level"] == "error":
            self.faults.append(said["entry"]["text"])

    def ask(self, script):
        """Value of a script on the page; promises are awaited."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"]["description"])
        return answer["result"].get("value")

    def wait_for(self, script, limit=LIMIT):
        until = time.monotonic() + limit
        while time.monotonic() < until:
            if self.ask(script):
                return True
            time.sleep(0.05)
        return False

    def open(self, path):
        self.faults.clear()
        self.call("Page.navigate", url=f"file://{path}")
        # The blank page before says "complete", too.
        self.wait_for(f"location.href.endsWith({json.dumps(os.path.basename(path))}) && "
                      "document.readyState === 'complete'")

    def size(self, width, height, ratio=1):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=ratio, mobile=False)

    def media(self, **features):
        """media(prefers_color_scheme="dark")"""
        listed = [{"name": name.replace("_", "-"), "value": value}
                  for name, value in features.items()]
        self.call("Emulation.setEmulatedMedia", features=listed)

    def key(self, name, **more):
        """Presses and lets go of one key, as from a keyboard."""
        text = {"text": name} if len(name) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=name, **text, **more)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=name, **more)

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def picture(self, selector=None):
        """PNG of the page as bytes, or of the first element that matches."""
        clip = {}
        if selector:
            box = self.ask(f"(r => [r.x + scrollX, r.y + scrollY, r.width, r.height])"
                           f"(document.querySelector('{selector}').getBoundingClientRect())")
            clip = {"clip": dict(zip(("x", "y", "width", "height"), box), scale=1)}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png",
                                          captureBeyondViewport=True, **clip)["data"])

    def downloaded(self, ending, limit=LIMIT):
        """Bytes of the first file with this ending that arrives, which is then forgotten, or None."""
        until = time.monotonic() + limit
        while time.monotonic() < until:
            for name in os.listdir(self.folder.name):
                if name.endswith(ending):
                    file = pathlib.Path(self.folder.name, name)
                    content = file.read_bytes()
                    file.unlink()
                    return content
            time.sleep(0.1)
        return None

    def close(self):
        try:
            self.call("Browser.close")
        except (OSError, RuntimeError, TimeoutError):
            os.kill(self.process, signal.SIGTERM)
        os.waitpid(self.process, 0)
        os.close(self.to)
        os.close(self.from_)
        self.folder.cleanup()
