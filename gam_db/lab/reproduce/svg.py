"""Drawings in one style, as SVG: black, greys and dashes on white, so that no colour is needed."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

from gam_db.errors import ConfigurationError

BLACK, DARK, GREY, LIGHT = "#000000", "#555555", "#999999", "#dddddd"
DASHES = ("", "6 3", "2 2", "8 3 2 3")

Point = tuple[float, float]


class Drawing:
    """A drawing of a given size, in pixels, with the origin at its upper left corner.

    Args:
        width, height: its size.
        title: what it shows, for those who cannot see it.
    """

    def __init__(self, width: int, height: int, title: str) -> None:
        self._root = Xml.Element(
            "svg",
            {
                "xmlns": "http://www.w3.org/2000/svg",
                "viewBox": f"0 0 {width} {height}",
                "width": str(width),
                "height": str(height),
                "font-family": "Helvetica, Arial, sans-serif",
                "font-size": "12",
            },
        )
        self._add("title", {}).text = title
        self.box(0, 0, width, height, "#ffffff")

    def text(
        self,
        x: float,
        y: float,
        words: str,
        anchor: str = "start",
        fill: str = BLACK,
        size: int = 12,
        turned: bool = False,
    ) -> None:
        """Write words whose baseline begins, ends or is centred at a point; turned: upwards."""
        at = {
            "x": _short(x),
            "y": _short(y),
            "text-anchor": anchor,
            "fill": fill,
            "font-size": str(size),
        }
        if turned:
            at["transform"] = f"rotate(-90 {_short(x)} {_short(y)})"
        self._add("text", at).text = words

    def line(
        self, points: Iterable[Point], stroke: str = BLACK, width: float = 1, dash: str = ""
    ) -> None:
        """Draw a line through points."""
        path = "L".join(f"{_short(x)} {_short(y)}" for x, y in points)
        at = {"d": f"M{path}", "fill": "none", "stroke": stroke, "stroke-width": str(width)}
        self._add("path", at | ({"stroke-dasharray": dash} if dash else {}))

    def dots(self, points: Iterable[Point], fill: str, size: float) -> None:
        """Draw round dots, each place once."""
        places = sorted({(_short(x), _short(y)) for x, y in points})
        path = "".join(f"M{x} {y}h0" for x, y in places)
        at = {"d": path, "stroke": fill, "stroke-width": str(size), "stroke-linecap": "round"}
        self._add("path", at)

    def box(self, x: float, y: float, width: float, height: float, fill: str, edge: str = "") -> None:
        """Draw a box."""
        at = {"x": _short(x), "y": _short(y), "width": _short(width), "height": _short(height)}
        self._add("rect", at | {"fill": fill} | ({"stroke": edge} if edge else {}))

    def write(self, path: Path) -> None:
        """Write the file.

        Raises:
            ConfigurationError: it cannot be written.
        """
        Xml.indent(self._root, " ")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(Xml.tostring(self._root, "unicode") + "\n", encoding="utf-8")
        except OSError as error:
            raise ConfigurationError(f"{path} cannot be written; give another --out.") from error

    def _add(self, tag: str, attributes: dict[str, str]) -> Xml.Element:
        return Xml.SubElement(self._root, tag, attributes)


class Plot:
    """A frame in a drawing, with its scales.

    Args:
        drawing: where it lies.
        corner: its upper left corner.
        size: its width and height.
        across, up: lowest and highest value of each scale.
    """

    def __init__(self, drawing: Drawing, corner: Point, size: Point, across: Point, up: Point) -> None:
        self._drawing, self._corner, self._size = drawing, corner, size
        self._across, self._up = across, up

    def at(self, x: float, y: float) -> Point:
        """Return where two values lie in the drawing."""
        (left, top), (width, height) = self._corner, self._size
        share_x = (x - self._across[0]) / (self._across[1] - self._across[0])
        share_y = (y - self._up[0]) / (self._up[1] - self._up[0])
        return left + width * share_x, top + height * (1 - share_y)

    def frame(
        self,
        ticks_x: Sequence[float],
        ticks_y: Sequence[float],
        title_x: str = "",
        title_y: str = "",
        title: str = "",
    ) -> None:
        """Draw the frame, ticks with their values, and titles."""
        drawing, (left, top), (width, height) = self._drawing, self._corner, self._size
        drawing.box(left, top, width, height, "none", GREY)
        for value in ticks_x:
            x, _ = self.at(value, 0)
            drawing.line([(x, top + height), (x, top + height + 4)], GREY)
            drawing.text(x, top + height + 16, f"{value:g}", "middle", DARK, 10)
        for value in ticks_y:
            _, y = self.at(0, value)
            drawing.line([(left - 4, y), (left, y)], GREY)
            drawing.text(left - 6, y + 3.5, f"{value:g}", "end", DARK, 10)
        if title_x:
            drawing.text(left + width / 2, top + height + 32, title_x, "middle", DARK, 11)
        if title_y:
            drawing.text(left - 34, top + height / 2, title_y, "middle", DARK, 11, turned=True)
        if title:
            drawing.text(left, top - 6, title)

    def line(
        self,
        points: Iterable[Point],
        stroke: str = BLACK,
        width: float = 1.2,
        dash: str = "",
    ) -> None:
        """Draw a line through values."""
        self._drawing.line((self.at(x, y) for x, y in points), stroke, width, dash)


def _short(number: float) -> str:
    return f"{number:.1f}".removesuffix(".0")
