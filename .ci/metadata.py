"""Metadata of a distribution that depend on where it is built: its addresses, and its description.

Nothing in the checkout says under which address it is published; its remote does. Built from a clone of
a forge, links and pictures of the README are absolute, as a package index needs them, and the URLs name
that forge. Built from anything else, both stay. A source distribution keeps what it was built with.
"""

import os
import re
import subprocess
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

_WEB = re.compile(r"(https?)://(?:[^/@]*@)?([^/@]+)/(.+?)(?:\.git)?/*")
_SSH = re.compile(r"(?:ssh://)?[\w.-]+@([\w-]+(?:\.[\w-]+)+)(?::\d+(?=/))?[:/]/*(.+?)(?:\.git)?/*")
_LINK = re.compile(r"(!?)(\[(?:[^][]|\[[^][]*\]\([^()\s]*\))*\]\()([^()\s#:]+)(#[^()\s]*)?\)")


class Addresses(MetadataHookInterface):
    """Fills in ``readme`` and ``urls``; what is in a source distribution already stays."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Complete the section [project] of pyproject.toml; see the module."""
        root, readme, urls = Path(self.root), "README.md", dict(self.config["urls"])
        forge = forge_of(_git(root, "remote", "get-url", "origin")) if _is_top(root) else None
        commit = _git(root, "rev-parse", "HEAD") if forge else ""
        if not forge or not commit:
            metadata.setdefault("readme", readme)
            metadata.setdefault("urls", urls)
            return
        at = _git(root, "describe", "--tags", "--exact-match") or commit
        pages = f"{forge}/-" if "gitlab" in forge.split("/")[2] else forge
        urls |= {
            "Source": forge,
            "Issues": f"{pages}/issues",
            "Documentation": f"{pages}/tree/{at}/docs",
        }
        text = absolute((root / readme).read_text(encoding="utf-8"), pages, at, root)
        metadata.setdefault("readme", {"content-type": "text/markdown", "text": text})
        metadata.setdefault("urls", urls)


def forge_of(remote: str) -> str | None:
    """Return where a remote is read in a browser, without user and password; None if nowhere."""
    if web := _WEB.fullmatch(remote):
        return "{}://{}/{}".format(*web.groups())
    if ssh := _SSH.fullmatch(remote):
        return "https://{}/{}".format(*ssh.groups())
    return None


def absolute(text: str, pages: str, at: str, root: Path) -> str:
    """Return Markdown whose links to files lead to the forge.

    Args:
        text: the Markdown.
        pages: what the addresses of its pages begin with.
        at: the commit, or its tag.
        root: the folder that the links start from.
    """

    def link(found: re.Match[str]) -> str:
        picture, words, path, place = found.groups()
        words = _LINK.sub(link, words)
        if not (root / path).exists():
            return f"{picture}{words}{path}{place or ''})"
        kind = "raw" if picture else "tree" if (root / path).is_dir() else "blob"
        return f"{picture}{words}{pages}/{kind}/{at}/{path}{place or ''})"

    return _LINK.sub(link, text)


def _is_top(root: Path) -> bool:
    """Tell whether a folder is a checkout of its own, and not a folder of another one."""
    top = _git(root, "rev-parse", "--show-toplevel")
    return bool(top) and os.path.samefile(top, root)


def _git(root: Path, *words: str) -> str:
    """Return what git says; nothing where it is not there, or knows no answer."""
    try:
        done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return done.stdout.strip()
