"""Parquet files of contacts, read by the batch, so that no row group is in memory as a whole."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.tables import ROWS
from granular.errors import ContactFileUnusable

if TYPE_CHECKING:
    import numpy as np
    import pyarrow.parquet
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

MAGIC = b"PAR1"
"""How a Parquet file begins and ends."""

_BUFFER = 1 << 18
"""Bytes of a column that are read from the file at a time."""


class ParquetTable:
    """A Parquet file with one row a contact.

    Parameters
    ----------
    path : Path
        The file.
    name : str
        Its name for messages.

    Raises
    ------
    ContactFileUnusable
        The file is damaged or cut off, or pyarrow is not installed.
    """

    def __init__(self, path: Path, name: str) -> None:
        """Read the schema, which stands at the end of the file."""
        self._path, self._name = path, name
        self._file = self._opened()
        self.columns: tuple[str, ...] = tuple(self._file.schema_arrow.names)

    def chunks(self, wanted: Sequence[str]) -> Iterator[Array]:
        """Read the columns some rows at a time; see ``ContactTable``."""
        import numpy as np
        import pyarrow
        from pyarrow import compute

        schema = self._file.schema_arrow
        for column in wanted:
            kind = schema.field(column).type
            if not (pyarrow.types.is_floating(kind) or pyarrow.types.is_integer(kind)):
                raise ContactFileUnusable(f"{self._name}: {column} holds {kind}", allowed="allowed numbers",
                                          remedy="Say which column is which with --column.")
        try:
            for batch in self._opened().iter_batches(batch_size=ROWS, columns=list(wanted), use_threads=False):
                rows = np.empty((len(wanted), batch.num_rows))
                for row, column in enumerate(wanted):
                    # not by to_numpy, which loads pandas where it is installed
                    numbers = compute.cast(batch.column(column), pyarrow.float64(), safe=False)
                    rows[row] = np.from_dlpack(compute.fill_null(numbers, math.nan) if numbers.null_count else numbers)
                yield rows
        except (pyarrow.ArrowException, OSError) as error:
            raise self._damaged(error) from None

    def place_of(self, contact: int) -> str:
        """Tell its row; see ``ContactTable``."""
        return f"row {contact}"

    def _opened(self) -> pyarrow.parquet.ParquetFile:
        try:
            import pyarrow
            from pyarrow import parquet
        except ImportError:
            raise ContactFileUnusable(f"{self._name} is a Parquet file, and pyarrow is not installed",
                                allowed="needed: pyarrow, for Parquet files",
                                remedy="pip install granular[tables], or save the list as CSV.") from None
        try:
            # with pre_buffer the whole file would be loaded ahead, without buffer_size a row group of each column
            return parquet.ParquetFile(self._path, pre_buffer=False, memory_map=False, buffer_size=_BUFFER)
        except (pyarrow.ArrowException, OSError) as error:
            raise self._damaged(error) from None

    def _damaged(self, error: Exception) -> ContactFileUnusable:
        reason = " ".join(str(error).split())[:100]
        return ContactFileUnusable(f"{self._name} is a Parquet file that cannot be read ({reason})",
                                   allowed="needed: a whole file", remedy="Copy or export it again.")
