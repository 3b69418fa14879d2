"""What was made lately is not made again: trees and texts, by all that they are made of."""

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

T = TypeVar("T")


class Lately(Generic[T]):
    """Keeps what was asked for last, for all sessions; of too many the oldest quarter goes."""

    def __init__(self, most: int) -> None:
        self.most = most
        self._kept: dict[Hashable, T] = {}

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """Return what was made of a key, or make it; another thread may make it, too."""
        found = self._kept.pop(key, None)
        if found is None:
            found = make()
            if len(self._kept) >= self.most:
                for oldest in list(self._kept)[: self.most // 4]:
                    self._kept.pop(oldest, None)
        self._kept[key] = found  # the newest again
        return found
