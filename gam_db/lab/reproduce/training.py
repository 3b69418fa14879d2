"""How long networks are trained, which the paper does not say: what the order of methods owes to it."""

from collections.abc import Sequence
from dataclasses import dataclass

from gam_db.lab.reproduce.methods import METHODS, Task, check_libraries
from gam_db.lab.reproduce.paper import TABLE2
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.lab.reproduce.table2 import agreement, figures_of

EPOCHS, QUICK_EPOCHS = (1, 5, 20, 100), (1, 3)
NETWORKS = ("ae", "mlp")


@dataclass(frozen=True)
class Trained:
    """Some networks after so many epochs, among the methods without networks.

    Attributes:
        epochs: how often calibration was gone through.
        figures: of each network, see :func:`gam_db.lab.reproduce.table2.figures_of`.
        order: all methods, best Global first.
        agreement: Spearman's correlation of that order with the paper's.
    """

    epochs: int
    figures: dict[str, Figures]
    order: list[str]
    agreement: float


@dataclass(frozen=True)
class Study:
    """What the study of training lengths gave.

    Attributes:
        lengths: one for each number of epochs, ascending.
        without: Global of the methods without networks.
        quick: whether everything was shortened.
    """

    lengths: list[Trained]
    without: dict[str, float]
    quick: bool


def training(names: Sequence[str], quick: bool, results: Results, show: Show) -> Study:
    """Run what has no result yet on the Langevin system of seed 0, and return the study.

    Args:
        names: networks, out of METHODS.
        quick: a short series and few epochs: to see that it works, no evidence.
        results: where results are kept.
        show: told what is at work.

    Raises:
        UserError: see its subclasses.
    """
    others = [name for name, method in METHODS.items() if method.library != "torch"]
    check_libraries([*names, *others])
    without = {name: figures_of(name, Task(0, quick), results, show)["global_score"] for name in others}
    lengths = []
    for epochs in QUICK_EPOCHS if quick else EPOCHS:
        figures = {
            name: figures_of(name, Task(0, quick, epochs=epochs), results, show) for name in names
        }
        scores = without | {name: run["global_score"] for name, run in figures.items()}
        order = sorted(scores, key=lambda name: -scores[name])
        lengths.append(Trained(epochs, figures, order, agreement(order, list(TABLE2)) or 0.0))
    return Study(lengths, without, quick)
