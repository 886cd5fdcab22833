"""Tables as pandas frames."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

from ._sbeh import OutputError

if TYPE_CHECKING:
    import pandas


def read_table(path: Path | io.StringIO) -> pandas.DataFrame:
    """A table of sbeh: numbers to the bit, empty fields of numbers as nan. Raises OutputError."""
    import pandas  # takes longer to load than all the rest

    try:
        return pandas.read_csv(path, float_precision="round_trip", keep_default_na=False, na_values=["", "nan"])
    except FileNotFoundError:
        raise OutputError(f"{path}: is not there") from None
    except (pandas.errors.ParserError, pandas.errors.EmptyDataError, UnicodeDecodeError) as error:
        raise OutputError(f"{path}: is no table: {error}") from None


def read_series(path: str | Path) -> pandas.DataFrame:
    """The history of an evolution, one row per time, of a folder or of its series.csv.

    Columns: studies/docs/series.md; `time`, `energy` and its parts, `dissipation_...`, `area`, `order_mean`, ...
    """
    path = Path(path)
    return read_table(path / "series.csv" if path.is_dir() else path)
