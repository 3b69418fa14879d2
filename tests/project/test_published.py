"""A distribution names the forge that it was built from, and its description links to that."""

import importlib.util
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from email.message import Message
from email.parser import Parser
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]
PAPER = "Paper's code, https://github.com/mart1bb/geometric-attractor-monitoring"

REMOTES = {
    "https://forge.example/plant/gam-db": "https://forge.example/plant/gam-db",
    "https://forge.example/plant/gam-db.git": "https://forge.example/plant/gam-db",
    "https://user:secret@forge.example:8443/plant/gam-db.git/": "https://forge.example:8443/plant/gam-db",
    "http://forge/plant/gam-db": "http://forge/plant/gam-db",
    "git@forge.example:plant/gam-db.git": "https://forge.example/plant/gam-db",
    "git@forge.example:group/plant/gam-db": "https://forge.example/group/plant/gam-db",
    "ssh://git@forge.example/plant/gam-db.git": "https://forge.example/plant/gam-db",
    "ssh://git@forge.example:2222/plant/gam-db.git": "https://forge.example/plant/gam-db",
    "git@work:plant/gam-db.git": None,  # a name that one ssh configuration knows
    "/srv/git/gam-db.git": None,
    "../gam-db": None,
    "file:///srv/git/gam-db": None,
    "": None,
}


def hook() -> ModuleType:
    spec = importlib.util.spec_from_file_location("metadata_hook", ROOT / ".ci" / "metadata.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("remote", REMOTES)
def test_a_remote_is_an_address_where_it_leads_to_a_forge(remote: str) -> None:
    assert hook().forge_of(remote) == REMOTES[remote]


def test_links_and_pictures_lead_to_the_forge(tmp_path: Path) -> None:
    (tmp_path / "docs").mkdir()
    for name in ("a.md", "b.png"):
        (tmp_path / "docs" / name).touch()
    said = {
        "[one](docs/a.md)": "[one](F/blob/v1/docs/a.md)",
        "[part](docs/a.md#part)": "[part](F/blob/v1/docs/a.md#part)",
        "[`all`](docs)": "[`all`](F/tree/v1/docs)",
        "![of it](docs/b.png)": "![of it](F/raw/v1/docs/b.png)",
        "[![of it](docs/b.png)](docs/a.md)": "[![of it](F/raw/v1/docs/b.png)](F/blob/v1/docs/a.md)",
        "[here](#here)": "[here](#here)",
        "[there](https://there.example/docs/a.md)": "[there](https://there.example/docs/a.md)",
        "rows[0](x)": "rows[0](x)",
    }
    for text, expected in said.items():
        assert hook().absolute(text, "F", "v1", tmp_path) == expected


def checkout(folder: Path, remote: str, tag: str = "") -> str:
    """A repository of the files that are here now; returns its commit."""

    def git(*words: str) -> str:
        who = ["-c", "user.name=x", "-c", "user.email=x@example.com", "-c", "commit.gpgsign=false"]
        done = subprocess.run(
            ["git", *who, *words], cwd=folder, check=True, capture_output=True, text=True
        )
        return done.stdout.strip()

    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    )
    for name in listed.stdout.splitlines():
        if (ROOT / name).is_file() and not name.startswith("tests/"):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    git("init", "--quiet")
    git("add", "--all")
    git("commit", "--quiet", "--message=all")
    if remote:
        git("remote", "add", "origin", remote)
    if tag:
        git("tag", tag)
    return git("rev-parse", "HEAD")


def built(folder: Path, out: Path) -> list[Message]:
    """The metadata of the source distribution, and of the wheel that is built from that."""
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(out), str(folder)]
    subprocess.run(command, check=True, capture_output=True)
    (wheel,), (source,) = out.glob("*.whl"), out.glob("*.tar.gz")
    with zipfile.ZipFile(wheel) as packed:
        (name,) = (name for name in packed.namelist() if name.endswith(".dist-info/METADATA"))
        texts = [packed.read(name).decode()]
    with tarfile.open(source) as packed_source:
        member = packed_source.extractfile(f"{source.name.removesuffix('.tar.gz')}/PKG-INFO")
        assert member is not None
        texts.append(member.read().decode())
    return [Parser().parsestr(text) for text in texts]


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("remote", "tag"),
    [
        ("https://forge.example/plant/gam-db.git", ""),
        ("git@forge.example:plant/gam-db.git", "v0.0.1"),
        ("", ""),
    ],
)
def test_a_distribution_says_where_it_comes_from(remote: str, tag: str, tmp_path: Path) -> None:
    folder = tmp_path / "gam-db"
    folder.mkdir()
    commit = checkout(folder, remote, tag)
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    forge, at = "https://forge.example/plant/gam-db", tag or commit
    for metadata in built(folder, tmp_path / "dist"):
        assert metadata["Description-Content-Type"] == "text/markdown"
        text, urls = metadata.get_payload(), metadata.get_all("Project-URL")
        assert isinstance(text, str)
        if not remote:
            assert (text.strip(), urls) == (readme.strip(), [PAPER])
            continue
        assert urls == [
            PAPER,
            f"Source, {forge}",
            f"Issues, {forge}/issues",
            f"Documentation, {forge}/tree/{at}/docs",
        ]
        links = re.findall(r"(!?)\[[^]]*\]\(([^)#]+)", text)
        assert len(links) == len(re.findall(r"\]\([^)#]", readme)) > 20
        assert [link for _, link in links if not link.startswith("https://")] == []
        own = [(picture, link.removeprefix(f"{forge}/")) for picture, link in links if forge in link]
        assert {link.split("/")[0] for picture, link in own if picture} == {"raw"}
        assert {link.split("/")[0] for picture, link in own if not picture} == {"blob"}
        assert {link.split("/")[1] for _, link in own} == {at}


@pytest.mark.thorough
def test_a_folder_of_another_repository_is_not_that_one(tmp_path: Path) -> None:
    folder = tmp_path / "theirs" / "gam-db"
    folder.mkdir(parents=True)
    checkout(folder, "")
    shutil.rmtree(folder / ".git")
    subprocess.run(["git", "init", "--quiet"], cwd=folder.parent, check=True)
    remote = ["git", "remote", "add", "origin", "https://forge.example/their/plant"]
    subprocess.run(remote, cwd=folder.parent, check=True)
    for metadata in built(folder, tmp_path / "dist"):
        assert metadata.get_all("Project-URL") == [PAPER]
