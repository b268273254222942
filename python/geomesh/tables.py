# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of named rows that print as tables, in a terminal and in a notebook."""
from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any, Generic, Iterable, List, Sequence, Tuple, TypeVar, Union, overload

if TYPE_CHECKING:
    from typing_extensions import SupportsIndex

Row = TypeVar("Row", bound=Tuple[Any, ...])


def _text(value: Any) -> str:
    if isinstance(value, float):
        return "%.6g" % value
    if isinstance(value, (list, tuple)):
        return ", ".join(str(v) for v in value)
    return str(value)


class Table(List[Row], Generic[Row]):
    """A list of named tuples. ``pandas.DataFrame(table)`` has one column for each field.

    A row is found by its index or by its name:

    >>> import geomesh
    >>> regions = geomesh.Table([geomesh.Region(1, "upper", "upper", [], 12, 350.0)])
    >>> regions
    id  name   unit   inside  n_tetrahedra  volume
     1  upper  upper                    12     350
    >>> regions["upper"].volume
    350.0
    >>> regions[0].id
    1
    """

    def __init__(self, rows: Iterable[Row] = (), fields: Sequence[str] = ()) -> None:
        super().__init__(rows)
        self._fields = tuple(fields) or (tuple(self[0]._fields) if self else ())

    @overload
    def __getitem__(self, key: "Union[str, SupportsIndex]") -> Row: ...

    @overload
    def __getitem__(self, key: slice) -> List[Row]: ...

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            for row in self:
                if row.name == key:
                    return row
            raise KeyError("%r; there are %s" % (key, ", ".join(row.name for row in self)))
        return super().__getitem__(key)

    def _cells(self) -> List[List[str]]:
        return [list(self._fields)] + [[_text(value) for value in row] for row in self]

    def _is_number(self, column: int) -> bool:
        return all(isinstance(row[column], (int, float)) for row in self)

    def __repr__(self) -> str:
        cells = self._cells()
        widths = [max(len(row[c]) for row in cells) for c in range(len(self._fields))]
        lines = []
        for row in cells:
            words = [word.rjust(width) if self and self._is_number(c) else word.ljust(width)
                     for c, (word, width) in enumerate(zip(row, widths))]
            lines.append("  ".join(words).rstrip())
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head, *rows = self._cells()
        parts = ["<table><tr>"] + ["<th>%s</th>" % html.escape(word) for word in head] + ["</tr>"]
        for row in rows:
            parts.append("<tr>" + "".join("<td>%s</td>" % html.escape(word) for word in row) + "</tr>")
        return "".join(parts) + "</table>"
