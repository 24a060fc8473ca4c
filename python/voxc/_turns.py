"""Objects that the library takes from one thread at a time, while ctypes lets other threads run: they wait."""
from __future__ import annotations

import contextlib
import functools
import time
from typing import Any, Callable, Iterator, TypeVar, cast

Method = TypeVar("Method", bound=Callable[..., Any])


def in_turn(method: Method) -> Method:
    """A method that begins when no other thread is within one of the same object, by its `_lock`."""

    @functools.wraps(method)
    def waiting(self: Any, *arguments: Any, **options: Any) -> Any:
        with self._lock:
            return method(self, *arguments, **options)

    return cast(Method, waiting)


@contextlib.contextmanager
def both_in_turn(first: Any, second: Any) -> Iterator[None]:
    """Holds the locks of two objects, and waits for neither while it has the other, which a callback of whoever has that one
    may want."""
    while True:
        with first._lock:
            if second._lock.acquire(blocking=False):
                try:
                    yield
                finally:
                    second._lock.release()
                return
        time.sleep(0.001)
