"""How a result looks in a notebook: as a page, and as a table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from motes.drawing.markup import Html, join, table, tag
from motes.errors import MissingExtraError

# Of more rows than these a notebook shows the first ones.
MOST_ROWS = 40


def notebook(title: str, rows: Sequence[Mapping[str, str]], facts: Iterable[tuple[str, str]]) -> Html:
    """A title, a table of the rows of `Result.table`, and facts below it; all text is escaped."""
    shown = rows[:MOST_ROWS]
    head = [name for name in (shown[0] if shown else {}) if name != "meaning"]
    more = [tag("p", f"... and {len(rows) - len(shown)} more rows: to_dataframe() has all of them")]
    return tag(
        "div",
        tag("p", tag("b", title)),
        table(head, [[row[name].partition(":")[0] for name in head] for row in shown]),
        *(more if len(rows) > len(shown) else []),
        tag("ul", *(tag("li", join(tag("i", name), ": ", text)) for name, text in facts)),
    )


def data_frame(records: Sequence[Mapping[str, Any]]) -> Any:
    """Records as a data frame of pandas, which the extra xarray brings.

    Raises
    ------
    MissingExtraError
        Where pandas is not installed.
    """
    try:
        import pandas
    except ImportError:
        raise MissingExtraError("pandas", "xarray", "A data frame") from None
    return pandas.DataFrame.from_records(records)
