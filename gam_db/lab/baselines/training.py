"""Training a net on calibration, and scoring by it; seeded, on one thread of the processor."""

import contextlib
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from gam_db.lab.baselines.nets import Net, torch

LEARNING_RATE = 1e-4
BATCH = 256
_NUMBERS_AT_ONCE = 500_000

Rows = NDArray[np.float64]
OnEpoch = Callable[[int, float], None]


def trained(
    build: Callable[[int], Net],
    m: int,
    rows: Rows,
    epochs: int,
    seed: int,
    on_epoch: OnEpoch = lambda epoch, loss: None,
    batch: int = BATCH,
) -> Net:
    """Return a net that was trained on rows by Adam, in shuffled batches.

    The same seed gives the same net on the same machine; PyTorch's own random state stays as it was.

    Args:
        build: makes the net from m.
        m: embedding dimension.
        rows: of calibration, shape (vectors, columns).
        epochs: how often all rows are gone through.
        seed: of weights, batches and draws.
        on_epoch: called with the epochs done and the mean loss of the last one.
        batch: rows of a batch.
    """
    library = torch()
    with _seeded(seed):
        net = build(m)
        data = library.tensor(rows, dtype=library.float32)
        optimizer = library.optim.Adam(net.modules.parameters(), lr=LEARNING_RATE)
        for epoch in range(1, epochs + 1):
            total = 0.0
            for drawn in library.randperm(len(data)).split(batch):
                optimizer.zero_grad()
                loss = net.loss(data[drawn])
                loss.backward()
                optimizer.step()
                total += loss.item() * len(drawn)
            on_epoch(epoch, total / len(data))
    return net


def scored(net: Net, score: str, rows: Rows) -> NDArray[np.float64]:
    """Return one of a net's scores of each row."""
    at_once = max(1, _NUMBERS_AT_ONCE // rows.shape[1])
    library = torch()
    with _seeded(0), library.no_grad():
        data = library.tensor(rows, dtype=library.float32)
        parts = [net.scores[score](part) for part in data.split(at_once)]
        return np.asarray(library.cat(parts).double().numpy())


@contextlib.contextmanager
def _seeded(seed: int) -> Iterator[None]:
    """Seed PyTorch and keep it to one thread, whose sums do not depend on how many there are."""
    library = torch()
    threads = library.get_num_threads()
    with library.random.fork_rng(devices=[]):
        library.manual_seed(seed)
        library.set_num_threads(1)
        try:
            yield
        finally:
            library.set_num_threads(threads)
