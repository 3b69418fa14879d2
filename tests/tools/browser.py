"""A real browser for the tests of the page: Chromium, headless, driven by Playwright."""

import atexit
import contextlib
import functools
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

#: Where the sources of the page, and what npm installs, lie.
ROOM = Path(__file__).parents[2] / "gam_db" / "report" / "page"

QUIET = (
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update"),
)
SOFTWARE_3D = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")


def chromium() -> str:
    """Return the browser's path, or skip with a sentence."""
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if found is None:
        pytest.skip("there is no Chromium here: apt-get install chromium; .ci/run does")
    return found


def node() -> Path:
    """Return where npm installed what builds the page, or skip with a sentence."""
    if not (ROOM / "node_modules" / ".bin" / "esbuild").exists():
        pytest.skip("npm ci was not run in gam_db/report/page; .ci/run does")
    return ROOM / "node_modules"


@contextlib.contextmanager
def browser(*more: str) -> Iterator[Any]:
    """Open Chromium with options besides the quiet ones."""
    opened = _driver().chromium.launch(
        executable_path=chromium(), headless=True, args=[*QUIET, *(more or SOFTWARE_3D)]
    )
    try:
        yield opened
    finally:
        opened.close()


@functools.cache
def _driver() -> Any:
    """Start Playwright once in a process: it takes only one."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="there is no Playwright here: pip install playwright; .ci/run does"
    )
    driver = playwright.sync_playwright().start()
    atexit.register(driver.stop)
    return driver


class Seen:
    """One page, and what went wrong on it: errors, warnings, dialogs, requests."""

    def __init__(self, opened: Any, file: Path, at: str = "", script: str = "", **options: Any) -> None:
        self.file = file
        self.context = opened.new_context(
            **{"viewport": {"width": 1280, "height": 900}, "reduced_motion": "reduce", **options}
        )
        self.page = self.context.new_page()
        self.wrong: list[str] = []
        self.page.on("console", self._heard)
        self.page.on("pageerror", lambda error: self.wrong.append(f"error: {error}"))
        self.page.on("dialog", self._asked)
        self.page.on("request", self._requested)
        if script:
            self.page.add_init_script(script)
        self.go(at)

    def __enter__(self) -> "Seen":
        return self

    def __exit__(self, *_: object) -> None:
        self.context.close()

    def _heard(self, message: Any) -> None:
        # What the tests themselves cause: they read pixels back.
        is_ours = "GL Driver Message" in message.text or "Canvas2D: Multiple readback" in message.text
        if message.type in ("error", "warning") and not is_ours:
            self.wrong.append(f"{message.type}: {message.text}")

    def _asked(self, dialog: Any) -> None:
        self.wrong.append(f"dialog: {dialog.message}")
        dialog.dismiss()

    def _requested(self, request: Any) -> None:
        if not request.url.startswith(("file:", "blob:", "data:")):
            self.wrong.append(f"request: {request.url}")

    def go(self, at: str) -> None:
        """Open the page at an address within it, and wait until it is drawn."""
        self.page.goto(f"{self.file.as_uri()}{at}")
        self.wait()

    def wait(self, kind: str = "") -> None:
        """Wait until a page is drawn: fleet or signal, or whichever it is."""
        chosen = f'[data-ready="{kind}"]' if kind else '[data-ready]:not([data-ready=""])'
        self.page.wait_for_selector(f"html{chosen}", timeout=30_000)

    def ask(self, script: str, given: Any = None) -> Any:
        """Return the value of an expression in the page."""
        return self.page.evaluate(script, given)


@functools.cache
def bundled(*changes: tuple[str, str, str]) -> str:
    """Return the script, built anew, with changes of its sources: file, text, other text."""
    node()
    with tempfile.TemporaryDirectory() as folder:
        room = Path(folder)
        shutil.copytree(ROOM / "src", room / "src")
        shutil.copy(ROOM / "package.json", room)
        (room / "node_modules").symlink_to(ROOM / "node_modules")
        for file, before, after in changes:
            path = room / "src" / file
            text = path.read_text(encoding="utf-8")
            assert text.count(before) >= 1, f"{file} has no {before}"
            path.write_text(text.replace(before, after), encoding="utf-8")
        subprocess.run(["npm", "run", "-s", "build"], cwd=room, check=True, capture_output=True)
        return (room / "page.js").read_text(encoding="utf-8")
