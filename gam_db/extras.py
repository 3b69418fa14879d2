"""Optional libraries, imported where they are needed, and what a process of our own goes without."""

import gc
import importlib
import sys
from typing import Any

from gam_db.errors import UserError

#: Libraries that use pandas, where it is installed, their own way.
_USERS_OF_PANDAS = ("chdb", "pyspark", "sklearn")


def needed(module: str, extra: str) -> Any:
    """Return a module that comes with an extra of this package, by its full name.

    Raises:
        UserError: it is not installed; the message says what to install.
    """
    if module.partition(".")[0] in _USERS_OF_PANDAS:
        give_pandas()
    try:
        return importlib.import_module(module)
    except ImportError as error:
        library = module.partition(".")[0].replace("sklearn", "scikit-learn")
        raise UserError(f'This needs {library}: pip install "gam-db[{extra}]".') from error


class _WithoutPandas:
    """Finds no pandas, for whoever asks."""

    @staticmethod
    def find_spec(name: str, *_: object) -> None:
        if name == "pandas":
            raise ModuleNotFoundError("No module named 'pandas'", name=name)


def begin_process() -> None:
    """Begin a process that is our own, ends soon and is given no frame, such as a command.

    Python looks for circles among its objects less often, which takes a tenth of such a process.
    """
    gc.set_threshold(100_000, 20, 100)
    hide_pandas()


def hide_pandas() -> None:
    """Let nobody load pandas.

    Arrow would, wherever it is installed, to learn whether a list is one of its frames, and that takes
    longer than most commands do.
    """
    sys.meta_path.insert(0, _WithoutPandas)


def give_pandas() -> None:
    """Let pandas be loaded again, for a library that may want it."""
    sys.meta_path[:] = [finder for finder in sys.meta_path if finder is not _WithoutPandas]
