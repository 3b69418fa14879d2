"""The architectures: layers and losses as the paper gives them, from its section on baselines.

The paper gives the widths of the perceptrons (256, 128, 64, 32 and the latent size, decoders
symmetric), a latent size of 2, two stacked recurrent layers of 64 units, the mean squared error and
Adam at 1e-4. It does not give the activation (here ReLU, none at the output), how the divergence is
weighted in the variational loss (here 1, per vector, beside the sum of the squared errors), or what the
recurrent models read (here the m delayed samples, oldest first).

A net takes rows of normalised values. For a reconstruction a row is a vector, newest sample first; for a
forecast it is the sample to be forecast and after it the vector one sample earlier.
"""

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from gam_db.extras import needed

WIDTHS = (256, 128, 64, 32)
LATENT = 2
UNITS = 64
LAYERS = 2

Tensor = Any
"""A tensor of PyTorch, which is not imported to say so."""


@dataclass(frozen=True)
class Net:
    """An architecture with fresh weights.

    Attributes:
        modules: all that is trained.
        loss: mean loss of a batch of rows.
        scores: by name, the anomaly score of each row: the higher, the less healthy.
    """

    modules: Any
    loss: Callable[[Tensor], Tensor]
    scores: Mapping[str, Callable[[Tensor], Tensor]]


def torch() -> Any:
    """Return PyTorch.

    Raises:
        UserError: it is not installed.
    """
    return needed("torch", "benchmark")


def autoencoder(m: int) -> Net:
    """Return the autoencoder; its score is the squared reconstruction error."""
    encoder, decoder = _perceptron(m, *WIDTHS, LATENT), _perceptron(LATENT, *WIDTHS[::-1], m)
    whole = torch().nn.Sequential(*encoder, *decoder)
    return _of_errors(whole, lambda rows: (whole(rows) - rows) ** 2)


def variational(m: int) -> Net:
    """Return the variational autoencoder (Kingma and Welling 2014).

    Its scores are the squared error of the reconstruction from the latent mean, and the divergence of
    the latent distribution from a standard normal one.
    """
    library = torch()
    encoder = library.nn.Sequential(*_perceptron(m, *WIDTHS, 2 * LATENT))
    decoder = library.nn.Sequential(*_perceptron(LATENT, *WIDTHS[::-1], m))

    def encoded(rows: Tensor) -> Tensor:
        return encoder(rows).chunk(2, dim=1)

    def divergence(rows: Tensor) -> Tensor:
        mean, log_variance = encoded(rows)
        return 0.5 * (mean**2 + log_variance.exp() - 1 - log_variance).sum(dim=1)

    def loss(rows: Tensor) -> Tensor:
        mean, log_variance = encoded(rows)
        drawn = mean + (0.5 * log_variance).exp() * library.randn_like(mean)
        return (((decoder(drawn) - rows) ** 2).sum(dim=1) + divergence(rows)).mean()

    def error(rows: Tensor) -> Tensor:
        return ((decoder(encoded(rows)[0]) - rows) ** 2).mean(dim=1)

    modules = library.nn.ModuleList([encoder, decoder])
    return Net(modules, loss, {"reconstruction": error, "latent": divergence})


def recurrent_autoencoder(m: int) -> Net:
    """Return the recurrent autoencoder; the decoder is fed the encoder's last state at every step."""
    library = torch()
    encoder = library.nn.LSTM(1, UNITS, LAYERS, batch_first=True)
    decoder = library.nn.LSTM(UNITS, UNITS, LAYERS, batch_first=True)
    head = library.nn.Linear(UNITS, 1)

    def error(rows: Tensor) -> Tensor:
        in_time = rows.flip(1).unsqueeze(2)
        last = encoder(in_time)[0][:, -1:]
        return (head(decoder(last.expand(-1, m, -1))[0]) - in_time).squeeze(2) ** 2

    return _of_errors(library.nn.ModuleList([encoder, decoder, head]), error)


def recurrent_forecast(m: int) -> Net:
    """Return the recurrent forecast of the next sample; its score is the squared error."""
    library = torch()
    cells = library.nn.LSTM(1, UNITS, LAYERS, batch_first=True)
    head = library.nn.Linear(UNITS, 1)

    def error(rows: Tensor) -> Tensor:
        return (head(cells(rows[:, 1:].flip(1).unsqueeze(2))[0][:, -1]) - rows[:, :1]) ** 2

    return _of_errors(library.nn.ModuleList([cells, head]), error)


def forecast(m: int) -> Net:
    """Return the feed-forward forecast of the next sample; its score is the squared error."""
    whole = torch().nn.Sequential(*_perceptron(m, *WIDTHS, 1))
    return _of_errors(whole, lambda rows: (whole(rows[:, 1:]) - rows[:, :1]) ** 2)


def _of_errors(modules: Any, errors: Callable[[Tensor], Tensor]) -> Net:
    """Return a net that is trained on, and scores by, its mean squared error."""
    return Net(
        modules,
        loss=lambda rows: errors(rows).mean(),
        scores={"error": lambda rows: errors(rows).mean(dim=1)},
    )


def _perceptron(*widths: int) -> list[Any]:
    library = torch()
    layers: list[Any] = []
    for incoming, outgoing in itertools.pairwise(widths):
        layers += [library.nn.Linear(incoming, outgoing), library.nn.ReLU()]
    return layers[:-1]
