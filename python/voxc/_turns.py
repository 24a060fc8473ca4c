"""Objects that the library takes from one thread at a time, while ctypes lets other threads run: they wait."""
from __future__ import annotations

import functools
from typing import Any, Callable, TypeVar, cast

Method = TypeVar("Method", bound=Callable[..., Any])


def in_turn(method: Method) -> Method:
    """A method that begins when no other thread is within one of the same object, by its `_lock`."""

    @functools.wraps(method)
    def waiting(self: Any, *arguments: Any, **options: Any) -> Any:
        with self._lock:
            return method(self, *arguments, **options)

    return cast(Method, waiting)
