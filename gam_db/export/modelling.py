"""Modelling: the steps of a package as models in files, each short enough to be read at a glance.

This module owns which step is a model of its own and in which folder, and how its file is written.
"""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sqlglot import exp

from gam_db.composing.brief import shortened
from gam_db.composing.layout import commented, laid_out
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.selects import selects_of
from gam_db.composing.tidy import tidied
from gam_db.engines.base import Engine
from gam_db.export import jinja
from gam_db.export.models import (
    CHECKS,
    EARLIER,
    VIEWS,
    Modelled,
    left_out,
    package_steps,
)
from gam_db.export.printing import PAGES, SENTENCE, composed, inline_single, owners_of, spelled_out

#: Lines of a file at most, as far as steps can be parted.
LONGEST = 120

#: Steps that are models wherever they are, for whoever reads the formulas of the method.
_FORMULAS = ("codes", "vectors", "novelty", "cohort", "assessed", EARLIER)

#: The steps that have a row per channel.
_KEYS = dict.fromkeys(("channel", "channel_channels", "cohort"), "channel_id")

#: Steps that read the source, with any prefix.
_STAGING = ("readings", "identified", "samples", "names", "channel", "calibration")


#: What a title says of the form that a file is for.
FORM = re.compile(r"( rows)?(, (dbt|stored) form)?(?=:)")


@dataclass(frozen=True)
class Model:
    """One model, or one test that is a query."""

    name: str  # without the prefix; it is that of a state table where there is one
    folder: str
    comment: str  # what it holds
    text: str  # of the file
    columns: Sequence[str]
    keys: tuple[str, ...] = ()  # columns that no two rows share
    values: Mapping[str, Sequence[str]] = field(default_factory=dict)  # column -> those that there are

    @property
    def is_described(self) -> bool:
        """Whether its columns are described: it is a table, or a view for whoever reads on."""
        return bool(self.keys)


def models(of: Modelled) -> list[Model]:
    """Return the models and tests of a package, each after those that it reads."""
    package = package_steps(of)
    keys = {**of.calibrated, "bucket": ("channel_id", "bucket_no"), **VIEWS}
    checks = [name for name in CHECKS if name in package.steps]
    results = [*keys, *checks]
    queries = {name: step.query.copy() for name, step in package.steps.items()}
    absent = left_out(of)
    for name in keys:
        queries[name].set("order", None)
        for select in selects_of(queries[name])[-1:]:
            held = [part for part in select.expressions if part.alias_or_name not in absent]
            select.set("expressions", held)
    tidy_steps = tidied(queries, results, by_name=False, keys=_KEYS)
    objects = owners_of(
        tidy_steps, lambda name, owners: name in results or name in _FORMULAS or owners > 1
    )
    inline_single(tidy_steps, objects)
    columns = dict(tidy_steps)
    brief = of.engine.brief
    tidy_steps = {
        name: shortened(query, brief, columns, filled=False) for name, query in tidy_steps.items()
    }
    files = _Files(of, package, tidy_steps, objects, results)
    return [files.model(name, keys.get(name, ())) for name in files.parted()]


@dataclass
class _Files:
    """The files of a package.

    Attributes:
        of: the package.
        package: its steps, for their comments.
        queries: of the steps, tidied.
        objects: the steps that are models or tests; the others stand in the WITH list of one of them.
        results: those that are tables, views or tests; the other models are ephemeral.
    """

    of: Modelled
    package: Pipeline
    queries: Mapping[str, exp.Query]
    objects: list[str]
    results: Collection[str]

    def parted(self) -> list[str]:
        """Make models of more steps until no file is too long, and return all models in order."""
        pending = list(self.objects)
        while pending:
            name = pending.pop()
            while (step := self._to_part(name)) is not None:
                before = set(self.objects)
                self.objects = self._with(step)
                pending += [of for of in self.objects if of not in before]
        return [name for name in self.queries if name in self.objects]

    def _with(self, step: str) -> list[str]:
        """Return the models if a step is one, too: with it all steps that several would spell out."""
        held = {*self.objects, step}
        return owners_of(self.queries, lambda name, owners: name in held or owners > 1)

    def _to_part(self, name: str) -> str | None:
        """Return the step of a WITH list that ends the first half of a file that is too long."""
        if self._body(name).count("\n") < LONGEST - 12:
            return None
        ordered = spelled_out(name, self.queries, self.objects)
        lengths = [self._text(self.queries[step].copy()).count("\n") + 3 for step in ordered]
        half = self._body(name).count("\n") / 2
        for place, step in enumerate(ordered):
            if sum(lengths[: place + 1]) >= half or place == len(ordered) - 1:
                return step
        return None

    def model(self, name: str, keys: tuple[str, ...]) -> Model:
        """Return the model of a step."""
        of = self.of
        comment = self.package.steps[name].definition.comment
        stem = name.rpartition("_")[2]
        folder = "intermediate"
        if name in CHECKS:
            folder = "tests"
        elif name in VIEWS or name == "bounds":
            folder = "mart"
        elif stem in _STAGING and name not in _FORMULAS:
            folder = "staging"
        first, *_ = SENTENCE.split(FORM.sub("", comment, 1), 1)
        about = "\n".join(commented(PAGES.sub("", first)))
        body = self._body(name)
        head = []
        if name in CHECKS:
            head.append(jinja.config({"severity": "warn"}))
            if before := of.adapter.get("before", ""):
                head.append(jinja.run(before))
        else:
            head.append(jinja.config(self._config(name)))
        if name in of.calibrated:
            body = jinja.built_once(body)
        elif name == EARLIER:
            body = jinja.if_there(f"{of.prefix}bucket", body, self._text(self._nothing(name)))
        text = "\n\n".join([*head, f"{about}\n{body}"]) + "\n"
        place = "tests" if folder == "tests" else f"models/{folder}"
        columns = self.queries[name].named_selects
        return Model(CHECKS.get(name, name), place, comment, text, columns, keys, self._values(name))

    def _config(self, name: str) -> dict[str, Any]:
        of, adapter = self.of, self.of.adapter
        if name in VIEWS:
            hook = {"pre_hook": adapter["before"]} if "before" in adapter else {}
            return {"materialized": "view", **hook}
        if name not in self.results:
            return {"materialized": "ephemeral"}
        config: dict[str, Any] = {"materialized": "incremental", "incremental_strategy": "append"}
        if name == "bucket":
            config["incremental_strategy"] = adapter.get("strategy", "delete+insert")
            config["unique_key"] = ["channel_id", "bucket_no"]
            ended = exp.delete(jinja.THIS.copy(), where=exp.column("last_time").is_(exp.null()))
            config["post_hook"] = of.engine.text(ended)
        config |= adapter.get("config", {})
        return config

    def _values(self, name: str) -> dict[str, list[str]]:
        """Return the values that columns have at most."""
        if name == "channel":
            query = self.package.steps[name].query
            hashes = {part.alias: part.unalias().name for part in query.expressions}
            return {key: [hashes[key]] for key in ("settings_hash", "method_hash")}
        verdicts = ["ready", "too_fine", "needs_data", "constant", "no_data"]
        if "probe" in self.of.parts:
            verdicts.insert(1, "blind")
        return {"verdict": verdicts} if name == "bounds" else {}

    def _nothing(self, name: str) -> exp.Query:
        """Return no row of a step of whole numbers."""
        columns = [
            exp.alias_(exp.cast(exp.null(), "BIGINT"), of) for of in self.queries[name].named_selects
        ]
        channels = self.of.reference("channel")
        return exp.select(*columns).from_(channels).where(exp.Literal.number(1).eq(0))

    def _body(self, name: str) -> str:
        tables = {step: self.of.reference(CHECKS.get(step, step)) for step in self.objects}
        if name == EARLIER:
            tables["stored_bucket"] = exp.Table(this=exp.var("{{ before }}"))
        query = composed(name, self.queries, tables)
        return self._text(query)

    def _text(self, query: exp.Query) -> str:
        jinja.check_is_free(query)
        engine: Engine = self.of.engine
        return laid_out(engine.text(query), engine.dialect)
