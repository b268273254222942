# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of a run: the caller's own function, a bar of tqdm, or lines."""
from __future__ import annotations

import sys
from typing import Any, Callable, Optional, Union

Progress = Callable[[str, int, int], None]

#: Stages of a run in their order. Refinement and the stages after it may occur several times.
STAGES = ("read", "build", "intersect", "delaunay", "recover", "classify", "estimate", "refine", "improve", "verify", "write")


class OneBar:
    """One bar for the whole run: it never moves back, and shows the name of the stage. A stage counts as one step."""

    def __init__(self, tqdm: Any) -> None:
        self._bar = tqdm(total=len(STAGES), bar_format="{desc:<10}{percentage:3.0f}%|{bar}| {elapsed}")

    def __call__(self, stage: str, done: int, total: int) -> None:
        if stage in STAGES:
            share = min(done / total, 1.0) if total else 0.0
            self._bar.n = max(self._bar.n, STAGES.index(stage) + share)
        self._bar.set_description_str(stage, refresh=True)

    def end(self, finished: bool) -> None:
        if finished:
            self._bar.n = self._bar.total
            self._bar.set_description_str("done", refresh=True)
        self._bar.close()


class Lines:
    """Prints a line for each stage to standard error, if tqdm is not installed."""

    def __init__(self) -> None:
        self._stage: Optional[str] = None

    def __call__(self, stage: str, done: int, total: int) -> None:
        if stage != self._stage:
            self._stage = stage
            print(stage, "...", file=sys.stderr)

    def end(self, finished: bool) -> None:
        pass


def progress_of(progress: Union[bool, Progress, None]) -> Optional[Progress]:
    """Returns the progress function of a run: the argument itself; for True a bar, or lines if tqdm is not installed."""
    if progress is not True:
        return progress or None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return Lines()
    return OneBar(tqdm)


def end_progress(progress: Optional[Progress], finished: bool) -> None:
    end = getattr(progress, "end", None)
    if isinstance(progress, (OneBar, Lines)) and end is not None:
        end(finished)
