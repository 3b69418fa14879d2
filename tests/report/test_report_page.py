"""The page in a real browser: what is drawn is what the views say, and nothing of the data runs."""

import dataclasses
import datetime as dt
import functools
import json
import random
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

import pyarrow as pa
import pytest

import browser
import gam_db
import gam_db.report as report_module
from gam_db.engines.duckdb.session import DuckSession
from gam_db.report import Wishes

pytestmark = pytest.mark.thorough

START = dt.datetime(2026, 3, 22, tzinfo=dt.UTC)
STEP, COUNT = dt.timedelta(minutes=10), 1400
ZONE = "Europe/Berlin"
TITLE = "</title><script>window.HACKED=1</script>"
PARAMETERS = gam_db.Parameters(m=3, tau=1, bins=8, window=40, stride=10, max_gap="30 min")
CALIBRATION = gam_db.Calibration(duration="3 d")
MADE = dt.datetime(2026, 4, 1, tzinfo=dt.UTC)

#: Readings from the end at which one lies where none was: 1, 2 and 3 novel vectors are in the last window.
EDGES = (8, 9, 10)

#: Names that would do harm as markup, as a path, as a key or as a pattern.
HOSTILE = (
    *("</script><script>window.HACKED=1</script>", '<img src=x onerror="window.HACKED=1">', "a'b\"c"),
    *(
        "${window.HACKED=1}",
        "__proto__",
        "\u202eabc\u202d",
        "line\u2028end",
        "x" * 200,
        "",
        "Twin",
        "twin",
    ),
    *("a/b#c?d%20e", "&lt;b&gt;", "{{script}}", "{{data}}"),
)


@dataclass(frozen=True)
class Plant:
    """A page, and what the views say of the same tables."""

    file: Path
    fleet: list[dict[str, Any]]
    health: dict[tuple[str, str], list[dict[str, Any]]]
    machines: dict[str, dict[str, Any]]
    healthy: dict[tuple[str, str], set[int]]
    new: dict[tuple[str, str], set[int]]
    ladder: dict[int, float]
    alarms: list[dict[str, Any]]


def once(when: int, i: int) -> float:
    """What one reading adds that is where none was."""
    return 9.0 if i == when else 0.0


def telemetry() -> pa.Table:
    """Machines of all kinds: calm, left long ago, left lately (after the clocks change), back, paused, silent."""
    kinds: dict[str, Callable[[int], float]] = {
        "calm": lambda i: 0.0,
        "left": lambda i: 9.0 if i > 800 else 0.0,
        "lately": lambda i: 9.0 if i > 1320 else 0.0,
        "back": lambda i: 9.0 if 700 < i < 900 else 0.0,
        "some": lambda i: 9.0 if i > 1000 and i % 37 == 0 else 0.0,
        "night": lambda i: 9.0 if i > 1060 else 0.0,  # hours after the clocks were put forward
        **{f"edge {last}": functools.partial(once, COUNT - last) for last in EDGES},
    }
    rows: list[tuple[str, str, dt.datetime, float | None]] = []
    names = [("m1", kind) for kind in kinds] + [("m2", "left"), ("m2", "paused"), ("m3", "silent")]
    names += [("m3", "constant"), ("m3", "short"), ("m4", "empty"), ("m6", "recalibrated")]
    names += [(name, "calm") for name in HOSTILE] + [("m5", name) for name in HOSTILE]
    for asset, channel in names:
        chance = random.Random(f"{asset} {channel}")
        for i in range(COUNT):
            if (channel == "paused" and 600 < i < 760) or (channel == "silent" and i > 1200):
                continue
            if channel == "short" and i < 1180:
                continue
            value: float | None = i % 5 + kinds.get(channel, kinds["calm"])(i) * (1 + chance.random())
            if channel == "constant" and i < 500:
                value = 1.0
            if channel == "empty":
                value = None
            rows.append((asset, channel, START + i * STEP, value))
    columns = list(zip(*rows, strict=True))
    return pa.table(
        {
            "asset": pa.array(columns[0]),
            "channel": pa.array(columns[1]),
            "time": pa.array(columns[2], pa.timestamp("us", "UTC")),
            "value": pa.array(columns[3], pa.float64()),
        }
    )


def made(folder: Path, source: pa.Table, **wished: Any) -> Plant:
    """The page of telemetry, and the views' rows."""
    session = DuckSession()
    monitor = gam_db.Monitor(session, gam_db.Source(source), PARAMETERS, CALIBRATION)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    later = dataclasses.replace(PARAMETERS, overrides=[gam_db.Override("m6", bins=5)])
    again = gam_db.Monitor(session, gam_db.Source(source), later, CALIBRATION)
    again.calibrate()
    again.score()
    session.connection.execute(
        "INSERT INTO gam_label SELECT monitor_id, 1, episode_id, 'm1', 0, 1, 'false_alarm', ?, NULL, 0 "
        "FROM gam_state_episode WHERE seq = 1",
        [HOSTILE[1]],
    )
    file = folder / "the 'page' <b>.html"
    monitor.report(file, Wishes(title=TITLE, time_zone=ZONE, details=16, made=MADE, **wished))

    def rows(query: str) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = session.connection.sql(query).to_arrow_table().to_pylist()
        return found

    health = defaultdict(list)
    for row in rows("SELECT * FROM gam_health ORDER BY bucket"):
        health[row["asset"], row["channel"]].append(row)
    healthy, new = defaultdict(set), defaultdict(set)
    known = "FROM gam_state_support JOIN gam_state_version USING (support_id) JOIN gam_state_channel USING (channel_id)"
    for row in rows(f"SELECT asset, channel, cell_key {known}"):
        healthy[row["asset"], row["channel"]].add(row["cell_key"])
    for row in rows("SELECT asset, channel, cell_key FROM gam_quarantine"):
        new[row["asset"], row["channel"]].add(row["cell_key"])
    machines = {row["asset"]: row for row in rows("SELECT * FROM gam_machine")}
    ladder = f"SELECT gam_ladder.bins, gam_ladder.floor {known.replace('gam_state_support', 'gam_ladder', 1)} WHERE asset = 'm1' AND channel = 'left'"
    floors = {row["bins"]: row["floor"] for row in rows(ladder)}
    alarms = rows("SELECT * FROM gam_alarm WHERE status <> 'merged'")
    return Plant(file, rows("SELECT * FROM gam_fleet"), health, machines, healthy, new, floors, alarms)


@pytest.fixture(scope="module")
def plant(tmp_path_factory: pytest.TempPathFactory) -> Plant:
    browser.chromium()
    return made(tmp_path_factory.mktemp("page"), telemetry())


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    with browser.browser() as opened:
        yield opened


def half_up(value: float, digits: int) -> str:
    """A number as the page rounds it, without zeros at its end."""
    text = str(Decimal(value).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP).normalize())
    return f"{Decimal(text):f}"


def share(value: float | None) -> str:
    """A share as the page writes it."""
    if value is None:
        return "–"
    if 0 < value < 0.001:
        return "< 0.001"
    return half_up(value, 3 if value < 0.1 else 2)


def clock(tick: int) -> str:
    """An instant as the list writes it, in the plant's time zone."""
    there = dt.datetime.fromtimestamp(tick / 1e6, ZoneInfo(ZONE))
    return f"{there.day} {there:%b} {there:%H:%M}"


#: All rows of the list, scrolled through: name of machine, of signal, value, words.
ROWS = """async () => {
  const box = document.getElementById('list'), found = new Map();
  for (let y = 0; ; y += 200) {
    box.scrollTop = y; box.dispatchEvent(new Event('scroll'));
    if (document.querySelectorAll('.row').length > 60) return 'too many rows';
    for (const row of document.querySelectorAll('.row')) found.set(+row.dataset.place, [row.classList.contains('machine'),
      row.querySelector('.name').textContent, row.querySelector('.value').textContent, row.querySelector('.words').textContent]);
    if (y > box.scrollHeight) break;
  }
  return [...found].sort((a, b) => a[0] - b[0]).map(one => one[1]);
}"""


def listed(seen: browser.Seen) -> dict[tuple[str, str], tuple[str, str]]:
    """Every signal of the list, with its value and its words; all machines opened by a count or search."""
    rows = seen.ask(ROWS)
    assert rows != "too many rows"
    found, machine = {}, ""
    for is_machine, name, value, words in rows:
        name = "" if name == "(no name)" else name
        if is_machine:
            machine = name
        else:
            found[machine, name] = (value, words)
    return found


def open_all(seen: browser.Seen) -> dict[tuple[str, str], tuple[str, str]]:
    """All signals: those that are judged and calm, above, rising, or not judged, by the counts."""
    found: dict[tuple[str, str], tuple[str, str]] = {}
    for name in ("above", "rising", "calm", "unjudged"):
        seen.page.click(f'.tile[data-count="{name}"]')
        found |= listed(seen)
        seen.page.click(f'.tile[data-count="{name}"]')
    return found


def compare_list(seen: browser.Seen, plant: Plant) -> None:
    """Every figure of the list and every count equals that of gam_fleet."""
    found = open_all(seen)
    assert set(found) == {(row["asset"], row["channel"]) for row in plant.fleet}
    newest = max(row["data_tick"] or 0 for row in plant.fleet)
    for row in plant.fleet:
        value, words = found[row["asset"], row["channel"]]
        assert value == share(row["hi"])
        is_new = row["is_above"] == 1 and row["since_tick"] > newest - 86_400_000_000
        assert words.startswith("new") == is_new
        assert ("silent for" in words) == (row["silent_for"] is not None)
        if row["is_above"] == 1:
            assert f"since {clock(row['since_tick'])}, " in words
        elif row["status"] == "labelled":
            assert words.startswith(f"episode {row['episode_id']}, ")
            assert f"labelled {row['label'].replace('_', ' ')}" in words
        elif row["is_above"] == 0 and row["hi"] > row["hi_limit"]:
            far = "far " * row["is_far_above"]
            assert words.startswith(f"indicator {far}above its limit, no episode so far")
        elif row["is_above"] == 0:
            assert words.startswith(("as in calibration", "below its limit, and rising"))
        else:
            assert words.startswith("not judged: ")
    told = seen.ask(
        "Object.fromEntries([...document.querySelectorAll('.tile')].map(t => [t.dataset.count, t.querySelector('b').textContent]))"
    )
    above = [row["is_above"] for row in plant.fleet]
    assert int(told["above"]) == above.count(1)
    assert int(told["rising"]) + int(told["calm"]) == above.count(0)
    assert int(told["unjudged"]) == above.count(None)
    assert int(told["silent"]) == sum(row["silent_for"] is not None for row in plant.fleet)
    assert int(told["fresh"]) == sum(words.startswith("new") for _, words in found.values()) > 0
    said = seen.ask("document.querySelector('h1').textContent")
    hot = sum(row["above"] > 0 for row in plant.machines.values())
    assert said.startswith(
        f"{hot} of {len(plant.machines)} machines are in states that they never visited"
    )


def lightness(pixel: list[int]) -> str:
    """What a pixel of the heat map stands for."""
    red, green, blue = pixel[:3]
    if (red, green, blue) == (255, 255, 255):
        return "nothing"
    if (red, green, blue) == (226, 239, 228):
        return "calibration"
    if (red, green, blue) == (246, 247, 249):
        return "pause"
    return "above" if red - blue > 40 else "below"


def expected_columns(plant: Plant, asset: str, columns: int) -> list[set[str]]:
    """What each column of a machine's row may be, from gam_health bucket by bucket."""
    first = min(
        int(START.timestamp() * 1e6) + 2 * 600_000_000, 2**62
    )  # the first vector, of three readings
    last = max(row["data_tick"] or 0 for row in plant.fleet)

    def column(tick: int) -> int:
        return min(columns - 1, max(0, int((tick - first) / (last - first) * columns)))

    found: list[set[str]] = [set() for _ in range(columns)]
    for (owner, _), rows in plant.health.items():
        for row in rows:
            if owner != asset or row["hi"] is None or row["hi_limit"] is None:
                continue
            kind = "above" if row["hi"] > row["hi_limit"] else "below"
            long = row["last_tick"] - row["first_tick"] > 5 * 9 * 600_000_000
            ends = {column(row["first_tick"]), column(row["last_tick"])}
            for at in ends if long else range(min(ends), max(ends) + 1):
                found[at].add(kind)
    return found


def compare_heat(seen: browser.Seen, plant: Plant) -> None:
    """Each pixel of the heat map is above, below or neither, as the buckets in its column are."""
    order, columns, pixels = seen.ask(
        """() => { const canvas = document.querySelector('canvas.heat'), names = [...document.querySelectorAll('.names div')].map(n => n.title);
        const high = canvas.height / names.length, context = canvas.getContext('2d');
        return [names, canvas.width, names.map((_, row) => { const data = context.getImageData(0, row * high + 1, canvas.width, 1).data; return Array.from({length: canvas.width}, (_, x) => [...data.slice(4 * x, 4 * x + 3)]); })]; }"""
    )
    assert sorted(order) == sorted(plant.machines)
    seen_kinds = set()
    for asset, row in zip(order, pixels, strict=True):
        for at, (allowed, pixel) in enumerate(
            zip(expected_columns(plant, asset, columns), row, strict=True)
        ):
            kind = lightness(pixel)
            seen_kinds.add(kind)
            if "above" in allowed:
                assert kind == "above", (asset, at)
            elif allowed:
                assert kind == "below", (asset, at)
            else:
                assert kind not in ("above",), (asset, at)
    assert {"above", "below", "calibration", "nothing"} <= seen_kinds


#: Colour of the middle of each cell of a flat picture, by its two codes.
FLAT = """codes => { const canvas = document.querySelector('figure canvas'), size = canvas.width / codes, context = canvas.getContext('2d'), found = [];
  for (let x = 0; x < codes; x++) for (let y = 0; y < codes; y++) { const d = context.getImageData(Math.floor((x + .45) * size), Math.floor((codes - 1 - y + .45) * size), 1, 1).data; if (d[3]) found.push([x, y, d[0], d[2]]); }
  return found; }"""


def compare_states(seen: browser.Seen, plant: Plant, name: tuple[str, str]) -> None:
    """Each cell of the first flat picture is healthy or new as gam_state_support and gam_quarantine say."""
    codes = PARAMETERS.grid + 3
    flat: dict[tuple[int, int], str] = {}
    for keys, kind in ((plant.new[name], "new"), (plant.healthy[name], "healthy")):
        flat |= {(key % codes, key // codes % codes): kind for key in keys}
    drawn = {
        (x, y): "new" if red > blue + 30 else "healthy" for x, y, red, blue in seen.ask(FLAT, codes)
    }
    assert drawn == flat
    assert set(flat.values()) == {"new", "healthy"}


def compare_all(seen: browser.Seen, plant: Plant) -> None:
    """All comparisons that a wrong script must fail."""
    compare_list(seen, plant)
    compare_heat(seen, plant)
    seen.go("#/m1/left")
    seen.page.reload()
    seen.wait("signal")
    compare_states(seen, plant, ("m1", "left"))


def test_every_figure_is_that_of_the_views(chrome: Any, plant: Plant) -> None:
    with browser.Seen(chrome, plant.file, timezone_id="America/New_York") as seen:
        compare_all(seen, plant)
        fleet = {(row["asset"], row["channel"]): row for row in plant.fleet}
        # Just below the limit, at it, and just above: the limit is 2 of 40 vectors.
        edges = {row["hi"]: row for name, row in fleet.items() if name[1].startswith("edge")}
        told = [edges[n / 40]["hi"] > edges[n / 40]["hi_limit"] for n in (1, 2, 3)]
        assert told == [False, False, True]
        assert edges[2 / 40]["hi"] == edges[2 / 40]["hi_limit"]
        ends = {row["hi"] for row in fleet.values()}
        assert {0.0, 1.0, None} <= ends
        assert fleet["m6", "recalibrated"]["version_no"] == 2
        night = dt.datetime.fromtimestamp(fleet["m1", "night"]["since_tick"] / 1e6, ZoneInfo(ZONE))
        assert (night.date(), night.utcoffset()) == (dt.date(2026, 3, 29), dt.timedelta(hours=2))
        assert {row["version_no"] for name, row in fleet.items() if name[0] != "m6"} == {1}
        row = fleet["m1", "left"]
        chip = seen.ask("(({hi, limit}) => [hi, limit])(document.querySelector('.chip').dataset)")
        assert [float(one) for one in chip] == [row["hi"], row["hi_limit"]]
        facts = seen.ask("[...document.querySelectorAll('.facts b')].map(b => b.textContent)")
        assert facts[:3] == [share(row["hi"]), share(row["hi_limit"]), share(row["floor"])]
        assert facts[3] == ("–" if row["sees"] is None else f"{row['sees']} %")
        assert facts[6] == f"{row['cells']:,}"
        ladder = seen.ask("document.querySelector('[data-ladder]').dataset.ladder")
        assert dict(json.loads(ladder)) == plant.ladder
        said = seen.ask("document.querySelector('.state').textContent")
        assert clock(row["since_tick"])[-5:] in said
        assert seen.ask("document.querySelector('.cube').dataset.drawn") == "1"
        assert seen.wrong == []


@pytest.mark.parametrize(
    "change",
    [
        (
            "colour.js",
            "signal.place * D.columns + column",
            "signal.place * D.columns + Math.max(0, column - 3)",
        ),
        ("words.js", "Number(time) / 1000", "(Number(time) + 36e8) / 1000"),
        ("states.js", "add(healthy, 0); add(fresh, 1);", "add(healthy, 1); add(fresh, 0);"),
    ],
    ids=["buckets moved", "an hour off", "new and healthy swapped"],
)
def test_a_wrong_script_is_found(
    chrome: Any, plant: Plant, tmp_path: Path, change: tuple[str, str, str]
) -> None:
    text = plant.file.read_text(encoding="utf-8")
    data = json.loads(text.partition('type="application/json">')[2].partition("</script>")[0])
    wrong = report_module.page(data, TITLE, browser.bundled(change))
    (tmp_path / "wrong.html").write_text(wrong, encoding="utf-8")
    with browser.Seen(chrome, tmp_path / "wrong.html") as seen, pytest.raises(AssertionError):
        compare_all(seen, plant)


def test_the_bundle_is_that_of_its_sources() -> None:
    assert browser.bundled() == (browser.ROOM / "page.js").read_text(encoding="utf-8")


def test_sources_write_no_markup() -> None:
    forbidden = (
        "innerHTML",
        "outerHTML",
        "insertAdjacentHTML",
        "document.write",
        "eval(",
        "new Function",
    )
    for path in (browser.ROOM / "src").glob("*.js"):
        text = path.read_text(encoding="utf-8")
        assert [word for word in forbidden if word in text] == [], path.name


def test_hostile_names_are_shown_and_run_nothing(chrome: Any, plant: Plant) -> None:
    with browser.Seen(chrome, plant.file) as seen:
        assert seen.page.title() == TITLE
        names = {name for name, _ in open_all(seen)}
        assert set(HOSTILE) <= names
        for name in filter(None, HOSTILE):
            seen.page.fill("input[type=search]", name)
            assert any(asset == name or channel == name for asset, channel in listed(seen))
        seen.page.fill("input[type=search]", "m5")
        hrefs = seen.ask("[...document.querySelectorAll('a.row')].map(row => row.getAttribute('href'))")
        assert len(hrefs) == len(HOSTILE)
        for href in hrefs:
            seen.ask("hash => { location.hash = hash; }", href)
            seen.page.wait_for_selector("nav.crumb")
            seen.wait("signal")
            shown = seen.ask("[...document.querySelectorAll('h1 bdi')].map(b => b.textContent)")
            assert shown[0] == "m5"
            assert ("" if shown[1] == "(no name)" else shown[1]) in HOSTILE
        assert seen.ask("[window.HACKED, document.querySelectorAll('img, script').length]") == [None, 2]
        assert seen.wrong == []


def test_keys_links_search_and_the_way_back(chrome: Any, plant: Plant) -> None:
    with browser.Seen(chrome, plant.file) as seen:
        page = seen.page
        page.keyboard.press("Tab")
        assert seen.ask("document.activeElement.className") == "skip"
        page.keyboard.press("Enter")
        assert seen.ask("document.activeElement.id") == "main"
        page.fill("input[type=search]", "left")
        page.focus(".row.machine")
        page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        seen.wait("signal")
        assert seen.ask("document.querySelector('h1').textContent").endswith("left")
        page.go_back()
        seen.wait("fleet")
        assert seen.ask("document.activeElement.classList.contains('signal')"), "focus is where it was"
        assert seen.ask("document.querySelector('input').value") == "left"
        page.fill("input[type=search]", "there is no such thing")
        assert seen.ask("document.querySelectorAll('.row').length") == 0
        page.fill("input[type=search]", "")
        page.click("canvas.heat", position={"x": 300, "y": 4})
        assert seen.ask("document.activeElement.getAttribute('aria-expanded')") == "true"
        page.click(".seg button:nth-child(2)")
        seen.wait("fleet")
        assert (
            seen.ask("document.querySelector('.seg button:nth-child(2)').getAttribute('aria-pressed')")
            == "true"
        )
        assert seen.wrong == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_is_accessible_and_fits(chrome: Any, plant: Plant, scheme: str) -> None:
    axe = (browser.node() / "axe-core" / "axe.min.js").read_text(encoding="utf-8")
    with browser.Seen(chrome, plant.file, color_scheme=scheme, bypass_csp=True) as seen:
        for at in ("", "#/m1/left", "#/m3/constant"):
            seen.ask("hash => { location.hash = hash || '#/'; }", at)
            seen.wait("signal" if at else "fleet")
            seen.page.add_script_tag(content=axe)
            found = seen.ask(
                "axe.run().then(r => r.violations.map(v => [v.id, v.nodes.slice(0, 3).map(n => n.html)]))"
            )
            assert found == []
            for wide in (1280, 640, 390):
                seen.page.set_viewport_size({"width": wide, "height": 800})
                assert seen.ask("document.documentElement.scrollWidth <= innerWidth"), (at, wide)
            seen.page.set_viewport_size({"width": 1280, "height": 900})
        assert seen.wrong == []


def test_a_browser_that_cannot_says_so(plant: Plant, chrome: Any) -> None:
    with (
        browser.browser("--disable-3d-apis") as flat,
        browser.Seen(flat, plant.file, "#/m1/left") as seen,
    ):
        assert "WebGL is off" in seen.ask("document.querySelector('.cube').textContent")
        assert seen.ask("document.querySelectorAll('figure canvas').length") == 2
        assert [one for one in seen.wrong if "WebGL" not in one] == []
    context = chrome.new_context()
    page = context.new_page()
    page.add_init_script("delete window.DecompressionStream")
    page.goto(plant.file.as_uri())
    assert "too old" in page.inner_text("h1")
    context.close()


def test_a_channel_recalibrated_is_that_of_its_new_version(chrome: Any, plant: Plant) -> None:
    with browser.Seen(chrome, plant.file, "#/m6/recalibrated") as seen:
        row = next(row for row in plant.fleet if row["asset"] == "m6")
        facts = seen.ask("document.querySelector('.facts').textContent")
        assert "calibration 2" in facts
        chip = seen.ask("(({hi, limit}) => [hi, limit])(document.querySelector('.chip').dataset)")
        assert [float(one) for one in chip] == [row["hi"], row["hi_limit"]]
        assert row["bins"] == 5
        assert seen.wrong == []


#: Rows of the list of episodes: number and status, when it began, what was said of it.
ALARMS = """() => [...document.querySelectorAll('.alarms tbody tr')].map(row => [+row.dataset.alarm, ...[...row.cells].map(cell => cell.textContent)])"""

#: Which columns of the tall strip of a signal are marked at its lower edge.
MARKED = """() => { const canvas = document.querySelector('.strip canvas'), data = canvas.getContext('2d').getImageData(0, canvas.height - 1, canvas.width, 1).data;
  return Array.from({length: canvas.width}, (_, x) => data[4 * x] < 60 && data[4 * x + 1] < 60 && data[4 * x + 2] < 60); }"""


def test_episodes_are_listed_and_marked_as_the_view_says(chrome: Any, plant: Plant) -> None:
    alarms = {row["episode_id"]: row for row in plant.alarms}
    assert len(alarms) > 2
    assert [row["label"] for row in alarms.values()].count("false_alarm") == 1
    with browser.Seen(chrome, plant.file, color_scheme="light") as seen:
        listed = {row[0]: row[1:] for row in seen.ask(ALARMS)}
        assert set(listed) == set(alarms)
        order = [alarms[number] for number in listed]
        assert order == sorted(
            order, key=lambda row: (row["status"] != "open", -row["since_tick"], row["episode_id"])
        )
        for number, (signal, said, since, _, evidence, label) in listed.items():
            row = alarms[number]
            assert signal == f"{row['asset']} · {row['channel'] or '(no name)'}"
            assert (said, since) == (f"{number}, {row['status']}", clock(row["since_tick"]))
            by_evidence = f"{row['evidence'] / row['height']:.1f} times the threshold"
            assert evidence == (by_evidence if row["height"] > 1 else "by its indicator")
            if row["label"]:
                assert label == f"{row['label'].replace('_', ' ')}: {row['note']}"
            else:
                assert row["is_proving"] == ("first windows" in label)
        assert seen.ask("[window.HACKED, document.querySelectorAll('img').length]") == [None, 0]
        first = next(row for row in order if row["status"] == "open")
        seen.page.click(f'tr[data-alarm="{first["episode_id"]}"] a')
        seen.wait("signal")
        own = [number for number, row in alarms.items() if row["channel_id"] == first["channel_id"]]
        assert [row[0] for row in seen.ask(ALARMS)] == sorted(
            own, key=lambda number: list(listed).index(number)
        )
        assert seen.wrong == []


def test_a_raised_signal_begins_with_what_is_found_and_what_to_do(chrome: Any, plant: Plant) -> None:
    text = plant.file.read_text(encoding="utf-8")
    data = json.loads(text.partition('type="application/json">')[2].partition("<")[0])
    alarms = [
        dict(zip(data["alarms"], row, strict=True)) for row in zip(*data["alarms"].values(), strict=True)
    ]
    raised = sum(row["status"] not in ("merged", "withdrawn") for row in plant.alarms)
    one = next(row for row in alarms if row["status"] == "open")
    assert one["finding"].endswith(".")
    assert one["advice"].endswith(".")
    with browser.Seen(chrome, plant.file, viewport={"width": 1300, "height": 900}) as seen:
        told = seen.ask("document.querySelector('.promise').textContent")
        assert told == data["promise"]
        assert f"of these {raised} in this time" in told or "No rate can be stated." in told
        wide = (
            "[...document.querySelectorAll('.table')].every(one => one.scrollWidth <= one.clientWidth)"
        )
        assert seen.ask(wide)
        seen.page.click(f'tr[data-alarm="{one["id"]}"] a')
        seen.wait("signal")
        said = seen.ask("document.querySelector('.advice').textContent")
        assert said == f"{one['finding']} {one['advice']}"
        assert seen.wrong == []


def test_a_strip_marks_its_episodes(chrome: Any, plant: Plant, tmp_path: Path) -> None:
    """Each mark goes from the column of the onset to that of the last open judgement."""
    data = json.loads(
        plant.file.read_text(encoding="utf-8").partition('type="application/json">')[2].partition("<")[0]
    )
    data["details"] = {}  # so that the page of a signal shows its strip
    (tmp_path / "page.html").write_text(report_module.page(data, "x"), encoding="utf-8")
    first, span = data["first"], data["last"] - data["first"]
    row = next(row for row in plant.alarms if (row["asset"], row["channel"]) == ("m1", "left"))
    ends = [round((row[of] - first) / span * data["columns"]) for of in ("since_tick", "last_tick")]
    assert ends[1] > ends[0] + 3
    with browser.Seen(chrome, tmp_path / "page.html", "#/m1/left", color_scheme="light") as seen:
        marked = seen.ask(MARKED)
        assert [x for x, is_marked in enumerate(marked) if is_marked] == list(range(*ends))
        seen.ask("() => { location.hash = '#/m1/calm'; }")
        seen.wait("signal")
        assert not any(seen.ask(MARKED))


def test_a_source_that_counts_has_no_clock(chrome: Any, tmp_path: Path) -> None:
    rows = [("A", name, t, t % 5 + 9.0 * (t > left)) for name, left in COUNTED for t in range(3000)]
    columns = list(zip(*rows, strict=True))
    source = pa.table(dict(zip(("asset", "channel", "time", "value"), columns, strict=True)))
    parameters = gam_db.Parameters(m=2, bins=6, window=40, stride=10)
    session = DuckSession()
    monitor = gam_db.Monitor(
        session, gam_db.Source(source), parameters, gam_db.Calibration(intervals=[(0, 299)])
    )
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    monitor.report(tmp_path / "page.html", Wishes(made=MADE, time_zone=ZONE))
    fleet = {row["channel"]: row for row in monitor.status().to_pylist()}
    since = dict(session.connection.execute("SELECT channel, since_tick FROM gam_fleet").fetchall())
    with browser.Seen(chrome, tmp_path / "page.html") as seen:
        found = open_all(seen)
        for name, row in fleet.items():
            value, words = found["A", name]
            assert value == share(row["hi"])
            assert (row["onset"] is not None) == (f"since {since[name] or 0:,}," in words)
            assert words.startswith("new") == (name == "last")
        assert "the last windows" in seen.ask("document.querySelector('h1').parentElement.textContent")
        assert ZONE not in seen.ask("document.body.innerText")
        seen.ask("() => { location.hash = '#/A/left'; }")
        seen.wait("signal")
        assert f"since {since['left']:,}" in seen.ask("document.querySelector('.state').textContent")
        assert seen.wrong == []


#: Signals of a source that counts, and the instant at which each leaves.
COUNTED = (("calm", 9999), ("left", 1500), ("last", 2975))


def test_it_prints_on_a4(chrome: Any, plant: Plant, tmp_path: Path) -> None:
    wide = 703  # 186 mm, which the margins leave of A4, at 96 to the inch
    with browser.Seen(chrome, plant.file) as seen:
        seen.page.click('.tile[data-count="calm"]')
        many = int(seen.ask("document.querySelector('.tile[data-count=calm] b').textContent"))
        assert seen.ask("document.querySelectorAll('a.row').length") < many, "the list scrolls"
        pages = seen.page.pdf(prefer_css_page_size=True)
        assert pages.startswith(b"%PDF")
        assert b"/MediaBox [0 0 59" in pages, "A4: 595 by 842 points"
        seen.page.emulate_media(media="print")
        seen.page.set_viewport_size({"width": wide, "height": 1000})
        seen.ask("dispatchEvent(new Event('beforeprint'))")
        assert seen.ask("document.documentElement.scrollWidth <= innerWidth")
        assert seen.ask("document.querySelectorAll('a.row').length") == many, "paper has all rows"
        over = """() => { const rows = [...document.querySelectorAll('.row')].map(row => row.getBoundingClientRect()).sort((a, b) => a.top - b.top);
            return rows.filter((row, i) => i && row.top < rows[i - 1].bottom - 1).length; }"""
        assert seen.ask(over) == 0, "none lies over another"
        seen.ask("dispatchEvent(new Event('afterprint'))")
        assert seen.ask("document.querySelectorAll('.row').length") <= 60
        seen.go("#/m1/left")
        seen.page.reload()
        seen.wait("signal")
        assert seen.ask("document.documentElement.scrollWidth <= innerWidth")
        seen.page.set_viewport_size({"width": 1280, "height": 1000})
        widths = "() => [...document.querySelectorAll('.u-wrap')].map(one => one.clientWidth)"
        before = seen.ask(widths)
        while max(before) < 800:  # charts follow the window a moment later
            seen.page.wait_for_timeout(50)
            before = seen.ask(widths)
        seen.ask("dispatchEvent(new Event('beforeprint'))")
        assert max(seen.ask(widths)) <= 688
        seen.ask("dispatchEvent(new Event('afterprint'))")
        assert seen.ask(widths) == before
        assert len(seen.page.pdf(prefer_css_page_size=True)) > 20_000
        assert seen.wrong == []


def test_boxes_of_both_sorts_are_drawn(chrome: Any, plant: Plant) -> None:
    with browser.Seen(chrome, plant.file, "#/m1/left", color_scheme="light") as seen:
        count = """() => { const gl = document.querySelector('.cube canvas'), flat = document.createElement('canvas'); flat.width = gl.width; flat.height = gl.height;
          const context = flat.getContext('2d'); context.drawImage(gl, 0, 0); const d = context.getImageData(0, 0, gl.width, gl.height).data; let hot = 0, cool = 0;
          for (let i = 0; i < d.length; i += 4) if (d[i + 3] > 200) { if (d[i] > d[i + 2] + 60) hot++; else if (d[i + 2] > d[i] + 20) cool++; } return [hot, cool]; }"""
        hot, cool = seen.ask(count)
        assert hot > 300
        assert cool > 300
        seen.page.click(".modes button:nth-child(3)")
        assert seen.ask(count)[1] < cool / 10
        seen.page.click(".modes button:nth-child(4)")
        assert seen.ask(count)[0] == 0
        assert seen.wrong == []
