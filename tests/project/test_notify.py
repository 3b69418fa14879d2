"""The script of docs/notify.md sends every message at least once, and says when it could not."""

import email
import json
import os
import re
import subprocess
import sys
import threading
from collections.abc import Iterator
from email import policy
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "notify.md").read_text(encoding="utf-8")

CHANGES = [
    {
        "seq": 1,
        "episode_id": 1,
        "what": "opened",
        "channel": "j2",
        "signals_together": 2,
        "is_message": 1,
    },
    {
        "seq": 2,
        "episode_id": 2,
        "what": "opened",
        "channel": "j3",
        "signals_together": 2,
        "is_message": 0,
    },
    {
        "seq": 3,
        "episode_id": 1,
        "what": "ended",
        "channel": "j2\nBcc: x",
        "signals_together": 1,
        "is_message": 1,
    },
    {
        "seq": 4,
        "episode_id": 2,
        "what": "ended",
        "channel": "j3",
        "signals_together": 1,
        "is_message": 0,
    },
]

#: Stands for gam: prints what is new after a number, as gam alarms does.
GAM = f"""#!{sys.executable}
import json, sys
after = int(sys.argv[sys.argv.index("--after") + 1])
assert sys.argv[1:3] == ["alarms", "--new"] and "--json" in sys.argv
changes = [row for row in {[{"asset": "R2", **row} for row in CHANGES]!r} if row["seq"] > after]
seq = max((row["seq"] for row in changes), default=after)
messages = [row for row in changes if row["is_message"]]
print(json.dumps({{"monitor": "plant", "seq": seq, "messages": messages, "changes": changes}}))
"""

#: Stands for sendmail: keeps each letter as a file.
SENDMAIL = f"""#!{sys.executable}
import pathlib, sys
assert sys.argv[1:] == ["-t", "-oi"]
letters = pathlib.Path("letters")
letters.mkdir(exist_ok=True)
(letters / str(len(list(letters.iterdir())))).write_bytes(sys.stdin.buffer.read())
"""


class Receiver(HTTPServer):
    """A web server that keeps what it is sent and answers as it is told."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.bodies: list[dict[str, object]] = []
        self.answers: list[int] = []


class Handler(BaseHTTPRequestHandler):
    """Answers each POST with the next of the server's answers, else with 202 as Teams does."""

    server: Receiver

    def do_POST(self) -> None:
        assert self.headers["Content-Type"] == "application/json"
        body = self.rfile.read(int(self.headers["Content-Length"]))
        answer = self.server.answers.pop(0) if self.server.answers else 202
        if answer < 400:
            self.server.bodies.append(json.loads(body))
        self.send_response(answer)
        self.end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    with Receiver() as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


@pytest.fixture
def place(tmp_path: Path) -> Path:
    (script,) = re.findall(r"```python\n(#!.*?)```", PAGE, re.DOTALL)
    (tmp_path / "notify.py").write_text(script, encoding="utf-8")
    for name, text in (("gam", GAM), ("sendmail", SENDMAIL)):
        (tmp_path / name).write_text(text, encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    return tmp_path


def notify(place: Path, *words: str) -> subprocess.CompletedProcess[str]:
    environment = {"PATH": f"{place}:{os.environ['PATH']}", "SENDMAIL": str(place / "sendmail")}
    command = [sys.executable, "notify.py", *words]
    return subprocess.run(command, cwd=place, env=environment, capture_output=True, text=True)


def test_a_webhook_gets_each_message_until_it_takes_it(place: Path, receiver: Receiver) -> None:
    url = f"http://127.0.0.1:{receiver.server_port}/"
    receiver.answers = [200, 500]
    done = notify(place, "webhook", url)
    assert (done.returncode, "500" in done.stderr) == (1, True)
    assert (place / "alarms.seen").read_text() == "1\n"
    for _ in range(2):
        done = notify(place, "webhook", url)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert [body["id"] for body in receiver.bodies] == ["plant-1", "plant-3"]
    assert receiver.bodies[0]["text"] == "R2 j2 and 1 more of this machine: episode 1 opened"
    assert (place / "alarms.seen").read_text() == "4\n"


def test_a_message_is_sent_again_where_its_number_was_not_kept(place: Path, receiver: Receiver) -> None:
    """As after a computer that stopped between the two steps."""
    url = f"http://127.0.0.1:{receiver.server_port}/"
    assert notify(place, "webhook", url).returncode == 0
    (place / "alarms.seen").write_text("1\n")
    assert notify(place, "webhook", url).returncode == 0
    assert [body["seq"] for body in receiver.bodies] == [1, 3, 3]


def test_teams_gets_a_card(place: Path, receiver: Receiver) -> None:
    assert notify(place, "teams", f"http://127.0.0.1:{receiver.server_port}/").returncode == 0
    assert len(receiver.bodies) == 2
    body = json.dumps(receiver.bodies[0])
    assert json.loads(body)["type"] == "message"
    assert '"contentType": "application/vnd.microsoft.card.adaptive"' in body
    assert "R2 j2 and 1 more of this machine: episode 1 opened" in body


def test_a_letter_names_its_message_and_no_name_adds_a_header(place: Path) -> None:
    assert notify(place, "mail", "team@example.org").returncode == 0
    letters = [
        email.message_from_bytes(file.read_bytes(), policy=policy.default)
        for file in sorted((place / "letters").iterdir())
    ]
    assert [letter["Message-ID"] for letter in letters] == [
        "<plant-1@gam-db.invalid>",
        "<plant-3@gam-db.invalid>",
    ]
    assert letters[1]["Subject"] == "R2 j2 Bcc: x: episode 1 ended"
    assert [(letter["To"], letter["Bcc"]) for letter in letters] == [("team@example.org", None)] * 2
    assert "gam alarm 1" in letters[0].get_content()


def test_a_letter_that_is_not_taken_is_an_error(place: Path) -> None:
    (place / "sendmail").write_text("#!/bin/sh\nexit 75\n")
    assert notify(place, "mail", "team@example.org").returncode == 1
    assert not (place / "alarms.seen").exists()


def test_an_error_of_gam_is_an_error(place: Path, receiver: Receiver) -> None:
    (place / "gam").write_text("#!/bin/sh\nexit 75\n")
    assert notify(place, "webhook", f"http://127.0.0.1:{receiver.server_port}/").returncode == 1
    assert receiver.bodies == []


def test_the_script_reads_what_gam_prints() -> None:
    rows = (ROOT / "sql" / "stored" / "alarms" / "event_rows.sql").read_text(encoding="utf-8")
    columns = set(re.findall(r"^  (\w+),?$", rows, re.MULTILINE))
    read = set(re.findall(r"message\[['\"](\w+)['\"]\]", PAGE))
    assert {"seq", "asset", "what"} <= read <= columns
    assert read <= {"asset", *CHANGES[0]}
