"""What goes wrong in the library or the program, as exceptions by kind."""
from __future__ import annotations


class Error(Exception):
    """What went wrong, in one sentence; `kind` is "input", "usage", "environment" or "interrupted". It is raised as the one of
    InputError, UsageError and MachineError that its kind is."""

    __module__ = "voxc"
    KINDS = {1: "input", 2: "usage", 3: "environment", 130: "interrupted"}

    def __init__(self, message: str, kind: int = 1) -> None:
        super().__init__(message, kind)
        self.kind: str = self.KINDS.get(kind, "input")

    def __str__(self) -> str:
        return str(self.args[0])


class InputError(Error):
    """A file or a format is wrong, or a check failed."""

    __module__ = "voxc"


class UsageError(Error):
    """The call itself is wrong: an option that there is none of, or that does nothing for this input."""

    __module__ = "voxc"


class MachineError(Error):
    """The machine lacks something: a device, memory, room on a disk, a permission, the program voxc."""

    __module__ = "voxc"


OF_KINDS = {2: UsageError, 3: MachineError}


def error_of(message: str, kind: int) -> Error:
    """The exception of a kind, as the library and the exit codes of the tools number them."""
    return OF_KINDS.get(kind, InputError)(message, kind)
