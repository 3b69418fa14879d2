"""A state as earlier migrations left it: it goes up, shows what it showed, and is scored on."""

import pytest
from sqlglot import exp

import engines
from gam_db.errors import StateError
from gam_db.stored.schema import migrations
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.tables import VIEWS, StateTables
from test_two_writers import NEW, Plant
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

#: The last migration before runs recorded what they were planned from.
BEFORE = 16

#: What columns of then are called now.
NOW = {"lo": "calibrated_lo", "hi": "calibrated_hi"}


def test_a_state_of_the_first_migrations_goes_up_and_is_scored_on(
    engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = engines.session(engine)
    plant = Plant(session)
    plant.begin()
    now = plant.monitor().state.tables
    plant.prefix = engines.fresh_name("before")
    before = StateTables(prefix=plant.prefix)
    with monkeypatch.context() as older:
        older.setattr(migrations, "files", lambda: files()[:BEFORE])
        made = migrations.migrate(session, before)
    for name in {one.name for one in made} - {"migration", *VIEWS}:
        columns = session.relations()[before.folded(name)]
        rows = exp.select(*(NOW.get(column, column) for column in columns)).from_(now.table(name))
        names = [exp.to_identifier(column) for column in columns]
        target = exp.Schema(this=before.table(name), expressions=names)
        session.execute(exp.Insert(this=target, expression=rows))
    mine = plant.monitor()
    shown = [visible(mine, BUCKETS), visible(mine, NOVEL)]
    assert all(shown)
    with pytest.raises(StateError, match=r"older gam-db: \d+ migrations are pending; run `gam migrate`"):
        mine.score()
    assert len(mine.migrate()) == len(files()) - BEFORE
    assert mine.migrate() == []
    assert [visible(mine, BUCKETS), visible(mine, NOVEL)] == shown
    for full in (False, True):
        plant.arrive(plant.grown(NEW, late=False))
        mine.score(full=full)
    plant.assert_as_one_full_run()
    assert mine.prune(keep=NEW).num_rows
    plant.assert_as_one_full_run(is_pruned=True)
