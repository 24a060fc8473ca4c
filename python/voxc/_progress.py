"""Progress bars as functions that the library may call."""
from __future__ import annotations

from typing import Any, Callable, Optional

Report = Callable[[str, float, int], Any]


def report_of(progress: Any) -> Optional[Report]:
    """A function (stage, fraction, done), of one, or of a bar as tqdm has them: with `update`, `reset` and `set_description`. A bar begins
    anew with each stage, and is full at the end of it."""
    if progress is None or not hasattr(progress, "update"):
        return progress
    bar = progress
    stage_now = None

    def report(stage: str, fraction: float, done: int) -> None:
        nonlocal stage_now
        if stage != stage_now:
            stage_now = stage
            bar.reset(total=1)
            bar.set_description(stage)
        bar.update(max(fraction - bar.n, 0))

    return report
