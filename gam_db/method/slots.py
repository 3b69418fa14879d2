"""What follows from parameters, by the names of the slots in ``sql/`` that take it."""

from collections.abc import Callable, Collection, Mapping

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.composing import template
from gam_db.settings.parameters import Parameters


def following(
    setting: Parameters, names: Collection[str], columns: Collection[str] = ()
) -> dict[str, template.Slot]:
    """Return those of some slots that follow from the parameters, or read them as ``columns``."""
    reading = _READS if "bins" in columns else {}
    follows = {**_FOLLOWS, **reading, **(_DIFFERING if "buckets" in columns else {})}
    return {name: follows[name](setting) for name in names if name in follows}


def code_in(
    bins: int | exp.Expr, place: exp.Expr | None = None, value: exp.Column | None = None
) -> exp.Expr:
    """Return support/code.sql for so many bins.

    Args:
        bins: a number or a column.
        place: the column that holds the place, if there is one.
        value: the column that holds the sample, where it is not called so.
    """
    code = template.fill("support/code", {"bins": bins, "place": place or place_in(bins)})
    if value is not None:
        for column in list(code.find_all(exp.Column)):
            if column.name == "value":
                column.replace(value.copy())
    return code


def place_in(bins: int | exp.Expr) -> exp.Expr:
    """Return support/place.sql for so many bins."""
    return template.fill("support/place", {"bins": bins})


def code_of(setting: Parameters, bins: exp.Expr | None = None) -> exp.Expr:
    """Return the code of a sample cast to the narrowest integer: it is what a window has to sort."""
    largest = setting.grid + 2
    narrow = "SMALLINT" if largest < 2**15 else "INT" if largest < 2**31 else "BIGINT"
    return exp.cast(code_in(bins or setting.grid), narrow)


def block_no(setting: Parameters, vectors: exp.Expr | None = None) -> exp.Expr:
    """Return which block of calibration the vector of a place is in, of a column's or so many."""
    slots: dict[str, template.Slot] = {"place": exp.column("place"), "window": setting.window}
    return template.fill("certificate/block_no", {**slots, "vectors": vectors or exp.column("vectors")})


def coordinates(setting: Parameters) -> list[exp.Expr]:
    """Return the columns of a vector's codes, the newest first."""
    return [exp.column(f"code_{k}") for k in range(setting.m)]


def outside(setting: Parameters, above: exp.Expr | None = None) -> exp.Expr:
    """Return the condition that one of these codes lies outside the calibrated range."""
    return exp.or_(
        *(
            template.fill("embedding/outside", {"code": code, "above": above or setting.grid + 2})
            for code in coordinates(setting)
        )
    )


def all_present(setting: Parameters) -> exp.Expr:
    """Return the condition that every coordinate is there."""
    return exp.and_(
        *(template.fill("embedding/present", {"code": code}) for code in coordinates(setting))
    )


def cell_key(
    setting: Parameters, term: str = "embedding/cell_term", radix: exp.Expr | None = None
) -> exp.Expr:
    """Return the key of a vector's cell: a term for each coordinate, of that file of ``sql/``."""
    return template.added(
        [
            template.fill(term, {"code": code, "weight": weight_at(setting, k, radix)})
            for k, code in enumerate(coordinates(setting))
        ]
    )


def weight_at(setting: Parameters, power: int, radix: exp.Expr | None = None) -> template.Slot:
    """Return the radix to a power: a number, or a product of a column."""
    if radix is None or power == 0:
        weight: int = setting.radix**power
        return weight
    product: exp.Expr = exp.cast(radix.copy(), "BIGINT")
    for _ in range(power - 1):
        product = exp.Mul(this=product, expression=exp.cast(radix.copy(), "BIGINT"))
    return product


def novel_before(setting: Parameters, delayed: str) -> exp.Expr:
    """Return how many vectors were novel up to the one a window before, by a file that looks back."""
    return template.fill(delayed, {"column": exp.column("novel_so_far"), "delay": setting.window})


#: What reads the bins as a column, where channels differ in them.
_READS: Mapping[str, Callable[[Parameters], template.Slot]] = {
    "code": lambda setting: code_of(setting, exp.column("bins")),
    "cell_key": lambda setting: cell_key(setting, radix=exp.column("radix")),
    "outside": lambda setting: outside(setting, exp.column("radix") - 1),
}

#: Likewise the buckets of a window.
_DIFFERING: Mapping[str, Callable[[Parameters], template.Slot]] = {
    "buckets": lambda _: exp.column("buckets"),
    "window": lambda _: exp.cast(exp.null(), "BIGINT"),
}

_FOLLOWS: Mapping[str, Callable[[Parameters], template.Slot]] = {
    "bins": lambda setting: setting.grid,
    "window": lambda setting: setting.window,
    "novel_before": lambda setting: novel_before(setting, "embedding/delayed"),
    "stride": lambda setting: setting.bucket_length,
    "buckets": lambda setting: setting.window // setting.bucket_length,
    "span": lambda setting: setting.span,
    "target_floor": lambda setting: float(setting.target_floor),
    "least_vectors": lambda setting: setting.least_vectors,
    "long_ago": lambda _: LONG_AGO,
    "code": code_of,
    "coordinates": coordinates,
    "is_present": all_present,
    "cell_key": cell_key,
    "block_no": block_no,
    "outside": outside,
}
