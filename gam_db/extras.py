"""Optional libraries: imported where they are needed, never by ``import gam_db``."""

import importlib
from typing import Any

from gam_db.errors import UserError


def needed(module: str, extra: str) -> Any:
    """Return a module that comes with an extra of this package.

    Args:
        module: its full name, such as ``sklearn.mixture``.
        extra: the extra that installs it.

    Raises:
        UserError: it is not installed; the message says what to install.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        library = module.partition(".")[0].replace("sklearn", "scikit-learn")
        raise UserError(f'This needs {library}: pip install "gam-db[{extra}]".') from error
