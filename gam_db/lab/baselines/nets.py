"""The architectures: layers and losses as the paper gives them, from its section on baselines.

The paper gives the widths of the perceptrons (256, 128, 64, 32 and the latent size, decoders
symmetric), a latent size of 2, two stacked recurrent layers of 64 units, the mean squared error and
Adam at 1e-4. It does not give the activation (here ReLU, none at the output), how the divergence is
weighted in the variational loss (here 1, per vector, beside the sum of the squared errors), or what the
recurrent models read (here the m delayed samples, oldest first).

A net takes rows of normalised values. For a reconstruction a row is a vector, newest sample first; for a
forecast it is the sample to be forecast and after it the vector one sample earlier. A context is such a
row of consecutive samples, as long as it may be.

For contexts the paper names two more architectures and says no size. Here the convolutional autoencoder
has three layers of 16, 32 and 64 channels (kernel 8, stride 4) before the latent size, and the mirror of
them after it; the Transformer reads pieces of 50 samples as words of 64 numbers with learnt places, two
layers of 4 heads and 128 units, their mean as the latent values, and two such layers after them.
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
LONG_LATENT = 20
"""Latent size for contexts."""

CHANNELS = (16, 32, 64)
KERNEL, STRIDE = 8, 4
PIECE = 50
WORD, HEADS = 64, 4

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


def autoencoder(m: int, latent: int = LATENT) -> Net:
    """Return the autoencoder; its score is the squared reconstruction error."""
    encoder, decoder = _perceptron(m, *WIDTHS, latent), _perceptron(latent, *WIDTHS[::-1], m)
    whole = torch().nn.Sequential(*encoder, *decoder)
    return _of_errors(whole, lambda rows: (whole(rows) - rows) ** 2)


def variational(m: int, latent: int = LATENT) -> Net:
    """Return the variational autoencoder (Kingma and Welling 2014).

    Its scores are the squared error of the reconstruction from the latent mean, and the divergence of
    the latent distribution from a standard normal one.
    """
    library = torch()
    encoder = library.nn.Sequential(*_perceptron(m, *WIDTHS, 2 * latent))
    decoder = library.nn.Sequential(*_perceptron(latent, *WIDTHS[::-1], m))

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


def convolutional(m: int, latent: int = LONG_LATENT) -> Net:
    """Return the convolutional autoencoder of a context; its score is the squared error.

    The context is lengthened with zeros to a multiple of 64 samples.
    """
    library = torch()
    step = STRIDE ** len(CHANNELS)
    length = -(-m // step) * step
    width = CHANNELS[-1] * (length // step)
    layers: list[Any] = [library.nn.Unflatten(1, (1, length))]
    for incoming, outgoing in itertools.pairwise((1, *CHANNELS)):
        layers += [library.nn.Conv1d(incoming, outgoing, KERNEL, STRIDE, padding=2), library.nn.ReLU()]
    layers += [library.nn.Flatten(), library.nn.Linear(width, latent), library.nn.Linear(latent, width)]
    layers += [library.nn.ReLU(), library.nn.Unflatten(1, (CHANNELS[-1], length // step))]
    for incoming, outgoing in itertools.pairwise((*CHANNELS[::-1], 1)):
        layers += [
            library.nn.ConvTranspose1d(incoming, outgoing, KERNEL, STRIDE, padding=2),
            library.nn.ReLU(),
        ]
    whole = library.nn.Sequential(*layers[:-1], library.nn.Flatten())

    def error(rows: Tensor) -> Tensor:
        return (whole(library.nn.functional.pad(rows, (0, length - m)))[:, :m] - rows) ** 2

    return _of_errors(whole, error)


def transformer(m: int, latent: int = LONG_LATENT) -> Net:
    """Return the Transformer that reconstructs a context; its score is the squared error.

    The context is lengthened with zeros to a multiple of 50 samples.
    """
    library = torch()
    pieces = -(-m // PIECE)

    def layers() -> Any:
        return library.nn.Sequential(
            *(
                library.nn.TransformerEncoderLayer(WORD, HEADS, 2 * WORD, 0.0, batch_first=True)
                for _ in range(LAYERS)
            )
        )

    parts = library.nn.ModuleDict(
        {
            "reads": library.nn.Linear(PIECE, WORD),
            "encoder": layers(),
            "narrows": library.nn.Linear(WORD, latent),
            "widens": library.nn.Linear(latent, WORD),
            "decoder": layers(),
            "writes": library.nn.Linear(WORD, PIECE),
        }
    )
    places = library.nn.ParameterList([0.02 * library.randn(1, pieces, WORD) for _ in range(2)])

    def error(rows: Tensor) -> Tensor:
        cut = library.nn.functional.pad(rows, (0, pieces * PIECE - m)).unflatten(1, (pieces, PIECE))
        encoded = parts["encoder"](parts["reads"](cut) + places[0]).mean(dim=1, keepdim=True)
        repeated = parts["widens"](parts["narrows"](encoded)) + places[1]
        return (parts["writes"](parts["decoder"](repeated)).flatten(1)[:, :m] - rows) ** 2

    return _of_errors(library.nn.ModuleList([parts, places]), error)


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
