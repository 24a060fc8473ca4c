"""Formats: what a volume is made of."""
from __future__ import annotations

import ctypes
from typing import Any, Iterable, Optional, Tuple, Union

from ._library import check, lib, make, needed, text


def list_of(names: Union[str, Iterable[str], None]) -> Optional[bytes]:
    """Names with commas between, from a list or from such a text."""
    return None if names is None else text(names if isinstance(names, str) else ",".join(names))


class Format:
    """A hybrid format, parsed from a string such as "R(4, 4, 4) G(5)" or from IR text; passes are named as in the tools,
    "whole-level-dedup", and run in their order."""

    def __init__(self, written: str, passes: Union[str, Iterable[str], None] = None) -> None:
        self._handle = make(lib.voxc_format_parse, needed(written, "a format"), list_of(passes))

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            lib.voxc_format_free(self._handle)

    @property
    def text(self) -> str:
        """The format in short, without its passes: "R(4, 4, 4) G(5)"."""
        return lib.voxc_format_text(self._handle).decode()

    @property
    def ir(self) -> str:
        """The format as IR text, with all that passes decided."""
        return lib.voxc_format_ir(self._handle).decode()

    @property
    def extent(self) -> Tuple[int, ...]:
        """The voxels that it holds, (x, y, z)."""
        extent = (ctypes.c_int32 * 3)()
        lib.voxc_format_extent(self._handle, extent)
        return tuple(extent)

    def header(self, name: Optional[str] = None, language: str = "shared") -> str:
        """The traversal as functions, as `voxc compile --emit=header` writes it: by default one text of GLSL and C++; else the `language`
        is "glsl", "essl", "cpp", "cuda", "hlsl" or "wgsl". That of CUDA includes no other file, so that it may stand at the top of the text
        of a kernel that CuPy or torch compiles, as C++20. `name` is put into the names that it declares."""
        return self._emit(lib.voxc_emit_header_in, text(language), text(name))

    def glsl(self) -> str:
        """The intersection kernel in GLSL."""
        return self._emit(lib.voxc_emit_glsl)

    def _emit(self, function: Any, *arguments: Any) -> str:
        made = ctypes.c_void_p()
        check(function(self._handle, *arguments, ctypes.byref(made)))
        try:
            return ctypes.string_at(made).decode()
        finally:
            lib.voxc_free(made)

    def __repr__(self) -> str:
        return self.ir.strip()

    def __str__(self) -> str:
        return self.text
