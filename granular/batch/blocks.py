"""Arguments of any shape, layout and type as contiguous blocks of float64, without a copy of the whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def is_view(argument: NDArray[Any], shape: tuple[int, ...]) -> bool:
    """Whether blocks of an argument can be read where they are.

    Parameters
    ----------
    argument : (...) array
        Real numbers of any type [any unit].
    shape : tuple of int
        Common shape of all arguments.

    Returns
    -------
    bool
        True for float64 of that shape in C order.

    Examples
    --------
    >>> import numpy as np
    >>> is_view(np.zeros((2, 3)), (2, 3)), is_view(np.zeros(3), (2, 3))
    (True, False)
    """
    import numpy as np

    return argument.dtype == np.float64 and argument.shape == shape and argument.flags.carray


def block_reader(argument: NDArray[Any], shape: tuple[int, ...], block: int) -> Callable[[int, int], Array]:
    """How to read one argument block by block.

    Parameters
    ----------
    argument : (...) array
        Real numbers of any type, broadcastable to ``shape`` [any unit].
    shape : tuple of int
        Common shape of all arguments.
    block : int
        Largest number of elements that will be asked for at once [-].

    Returns
    -------
    callable
        Takes start and stop in C order of ``shape`` and gives a contiguous float64 array, which is overwritten by the
        next call: a view where the argument has this form, a block filled once where it is a single value, and
        otherwise a converted copy of this block alone. Not for two threads at once.

    Notes
    -----
    Source: NumPy's buffered iteration.

    Examples
    --------
    >>> import numpy as np
    >>> block_reader(np.arange(3), (2, 3), 4)(1, 5).tolist()
    [1.0, 2.0, 0.0, 1.0]
    """
    import numpy as np

    if argument.size == 1:
        same: Array = np.full(block, argument.item(), dtype=np.float64)
        return lambda start, stop: same[:stop - start]
    if is_view(argument, shape):
        flat: Array = argument.reshape(-1)
        return lambda start, stop: flat[start:stop]
    scratch: Array = np.empty(block)
    pieces: Any = np.nditer([np.broadcast_to(argument, shape)], order="C", casting="unsafe", buffersize=block,
                       flags=["external_loop", "buffered", "ranged", "zerosize_ok"],
                       op_flags=[["readonly", "aligned", "nbo"]], op_dtypes=[np.float64])

    def read(start: int, stop: int) -> Array:
        pieces.iterrange = (start, stop)
        filled = 0
        for piece in pieces:
            scratch[filled:filled + piece.size] = piece
            filled += piece.size
        return scratch[:filled]

    return read
