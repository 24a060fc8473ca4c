"""The C library, loaded once: its structures, the types of its functions, and its errors as exceptions."""
import ctypes
import ctypes.util
import operator
import os
import pathlib
from ctypes import POINTER, c_char_p, c_double, c_float, c_int, c_int32, c_size_t, c_uint, c_uint32, c_uint64, c_void_p

from ._errors import Error, error_of
from ._interrupts import Interrupts
from ._progress import report_of

ABI_VERSION = 0


REPORT = ctypes.CFUNCTYPE(c_int, c_void_p, c_char_p, c_double, c_uint64)
VOXEL = ctypes.CFUNCTYPE(c_uint32, c_void_p, c_int32, c_int32, c_int32)
EDITED_VOXEL = ctypes.CFUNCTYPE(c_uint32, c_void_p, c_int32, c_int32, c_int32, c_uint32)
SENTENCE = ctypes.CFUNCTYPE(None, c_void_p, c_char_p)
IS_EMPTY = ctypes.CFUNCTYPE(c_int, c_void_p, c_int32, c_int32, c_int32, c_int32)


class Progress(ctypes.Structure):
    _fields_ = [("report", REPORT), ("user", c_void_p)]


class LoadOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("trusted", c_int), ("threads", c_uint), ("most_cubes", c_uint64),
                ("progress", POINTER(Progress)), ("frame", c_int32)]


class DeviceInfo(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char * 256), ("kind", ctypes.c_char * 32), ("uuid", ctypes.c_char * 40),
                ("memory_bytes", c_uint64), ("usable", c_int)]


class Snapshot(ctypes.Structure):
    _fields_ = [("root", c_uint64), ("voxels", c_uint64)]


class TracerOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("device", c_char_p), ("threads", c_uint), ("query", c_char_p),
                ("outputs", c_char_p), ("precision", c_char_p), ("passes", c_char_p), ("bounds", c_int)]


class BuildOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("threads", c_uint), ("memory_bytes", c_uint64), ("path", c_char_p),
                ("compress", c_int), ("provenance", c_char_p), ("progress", POINTER(Progress))]


class Source(ctypes.Structure):
    _fields_ = [("extent", c_int32 * 3), ("voxel", VOXEL), ("is_empty", IS_EMPTY), ("user", c_void_p)]


class InputReport(ctypes.Structure):
    _fields_ = [("warning", SENTENCE), ("note", SENTENCE), ("user", c_void_p)]


class InputOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("resolution", c_int32), ("coverage", c_char_p), ("z_up", c_int),
                ("threshold", POINTER(c_double)), ("colour_map", c_char_p), ("colour", c_char_p), ("voxel_size", c_char_p),
                ("unit", c_char_p), ("align", POINTER(c_double)), ("bounds", POINTER(c_double)), ("window", POINTER(c_double)),
                ("volume", c_int32), ("grid", c_char_p), ("interior", c_char_p), ("fill_colour", c_char_p), ("crop", c_int),
                ("report", POINTER(InputReport))]


class ChoiceOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("objective", c_char_p), ("max_bytes", c_uint64), ("device", c_char_p),
                ("precision", c_char_p), ("formats", POINTER(c_char_p)), ("format_count", c_size_t), ("rays", c_void_p),
                ("ray_count", c_uint64), ("editable", c_int), ("seconds", c_double), ("threads", c_uint),
                ("memory_bytes", c_uint64), ("progress", POINTER(Progress))]


class FormatRow(ctypes.Structure):
    _fields_ = [("format", c_char_p), ("passes", c_char_p), ("bytes", c_uint64), ("exact", c_int), ("frontier", c_int),
                ("chosen", c_int), ("failure", c_char_p)]


class FormatSpeed(ctypes.Structure):
    _fields_ = [("predicted", c_double), ("measured", c_double), ("slowest", c_double), ("fastest", c_double),
                ("checked_rays", c_uint64), ("wrong_rays", c_uint64), ("max_ulp", c_double)]


class PictureOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("width", c_int32), ("height", c_int32), ("style", c_char_p),
                ("view", c_char_p), ("eye", POINTER(c_double)), ("look", POINTER(c_double)),
                ("vertical_fov", c_double), ("samples", c_uint), ("progress", POINTER(Progress)),
                ("orthographic", c_int), ("view_height", c_double), ("clip_box", POINTER(c_double)),
                ("clip_planes", POINTER(c_double)), ("clip_plane_count", c_size_t)]


# Name: result, arguments. What can fail returns a pointer to an error.
FUNCTIONS = {
    "voxc_abi_version": (c_uint32, []),
    "voxc_version": (c_char_p, []),
    "voxc_error_get_kind": (c_int, [c_void_p]),
    "voxc_error_message": (c_char_p, [c_void_p]),
    "voxc_error_free": (None, [c_void_p]),
    "voxc_free": (None, [c_void_p]),
    "voxc_volume_load": (c_void_p, [c_char_p, POINTER(LoadOptions), POINTER(c_void_p)]),
    "voxc_volume_free": (None, [c_void_p]),
    "voxc_volume_save": (c_void_p, [c_void_p, c_char_p, c_int]),
    "voxc_volume_digest": (c_uint64, [c_void_p]),
    "voxc_volume_format": (c_char_p, [c_void_p]),
    "voxc_volume_ir": (c_char_p, [c_void_p]),
    "voxc_volume_provenance": (c_char_p, [c_void_p]),
    "voxc_volume_extent": (None, [c_void_p, POINTER(c_int32)]),
    "voxc_volume_voxels": (c_uint64, [c_void_p]),
    "voxc_volume_frames": (c_uint64, [c_void_p]),
    "voxc_volume_bytes": (c_uint64, [c_void_p]),
    "voxc_volume_attribute": (c_void_p, [c_void_p, c_char_p, POINTER(c_uint32)]),
    "voxc_volume_with_attribute": (c_void_p, [c_void_p, c_char_p, c_uint32, c_void_p, POINTER(c_void_p)]),
    "voxc_volume_words": (POINTER(c_uint32), [c_void_p, POINTER(c_uint64)]),
    "voxc_volume_to_model": (None, [c_void_p, POINTER(c_double)]),
    "voxc_volume_read": (c_void_p, [c_void_p, POINTER(c_int32), POINTER(c_int32), c_void_p]),
    "voxc_volume_list": (c_void_p, [c_void_p, c_void_p, c_void_p]),
    "voxc_devices": (c_size_t, [POINTER(DeviceInfo), c_size_t]),
    "voxc_tracer_free": (None, [c_void_p]),
    "voxc_tracer_device": (c_char_p, [c_void_p]),
    "voxc_tracer_trace": (c_void_p, [c_void_p, c_void_p, c_uint64, c_void_p]),
    "voxc_tracer_trace_bounded": (c_void_p, [c_void_p, c_void_p, c_uint64, c_void_p]),
    "voxc_tracer_update": (c_void_p, [c_void_p, c_void_p, POINTER(c_uint64)]),
    "voxc_format_parse": (c_void_p, [c_char_p, c_char_p, POINTER(c_void_p)]),
    "voxc_format_free": (None, [c_void_p]),
    "voxc_format_text": (c_char_p, [c_void_p]),
    "voxc_format_ir": (c_char_p, [c_void_p]),
    "voxc_format_extent": (None, [c_void_p, POINTER(c_int32)]),
    "voxc_emit_header": (c_void_p, [c_void_p, c_char_p, POINTER(c_void_p)]),
    "voxc_emit_header_in": (c_void_p, [c_void_p, c_char_p, c_char_p, POINTER(c_void_p)]),
    "voxc_emit_glsl": (c_void_p, [c_void_p, POINTER(c_void_p)]),
    "voxc_build_grid": (c_void_p, [c_void_p, c_void_p, POINTER(c_int32), POINTER(BuildOptions), POINTER(c_void_p)]),
    "voxc_build_voxels": (c_void_p, [c_void_p, c_void_p, c_void_p, c_uint64, POINTER(c_int32), POINTER(BuildOptions),
                                     POINTER(c_void_p)]),
    "voxc_build_source": (c_void_p, [c_void_p, POINTER(Source), POINTER(BuildOptions), POINTER(c_void_p)]),
    "voxc_build_input": (c_void_p, [c_void_p, c_char_p, POINTER(InputOptions), POINTER(BuildOptions),
                                    POINTER(c_void_p)]),
    "voxc_suggest": (c_void_p, [c_char_p, POINTER(InputOptions), POINTER(ChoiceOptions), POINTER(c_void_p)]),
    "voxc_search": (c_void_p, [c_char_p, POINTER(InputOptions), POINTER(ChoiceOptions), POINTER(c_void_p)]),
    "voxc_format_table_free": (None, [c_void_p]),
    "voxc_format_table_rows": (c_size_t, [c_void_p]),
    "voxc_format_table_voxels": (c_uint64, [c_void_p]),
    "voxc_format_table_sets": (c_size_t, [c_void_p]),
    "voxc_format_table_set": (c_char_p, [c_void_p, c_size_t]),
    "voxc_format_table_row": (None, [c_void_p, c_size_t, POINTER(FormatRow)]),
    "voxc_format_table_speed": (None, [c_void_p, c_size_t, c_size_t, POINTER(FormatSpeed)]),
    "voxc_editable_create": (c_void_p, [c_void_p, POINTER(c_void_p)]),
    "voxc_editable_free": (None, [c_void_p]),
    "voxc_editable_set_box": (c_void_p, [c_void_p, POINTER(c_int32), POINTER(c_int32), c_uint32]),
    "voxc_editable_set_sphere": (c_void_p, [c_void_p, POINTER(c_int32), c_int32, c_uint32]),
    "voxc_editable_set_voxels": (c_void_p, [c_void_p, c_void_p, c_void_p, c_uint64]),
    "voxc_editable_paste": (c_void_p, [c_void_p, c_void_p, POINTER(c_int32)]),
    "voxc_editable_apply": (c_void_p, [c_void_p, POINTER(c_int32), POINTER(c_int32), EDITED_VOXEL, c_void_p]),
    "voxc_editable_snapshot": (Snapshot, [c_void_p]),
    "voxc_editable_restore": (None, [c_void_p, Snapshot]),
    "voxc_editable_view": (c_void_p, [c_void_p, Snapshot, POINTER(c_void_p)]),
    "voxc_editable_frames": (c_uint64, [c_void_p, POINTER(Snapshot), c_uint64]),
    "voxc_editable_framed": (c_void_p, [c_void_p, POINTER(Snapshot), c_uint64, POINTER(c_void_p)]),
    "voxc_editable_voxels": (c_uint64, [c_void_p]),
    "voxc_editable_words": (c_uint64, [c_void_p]),
    "voxc_editable_wants_compaction": (c_int, [c_void_p]),
    "voxc_editable_compact": (c_void_p, [c_void_p, POINTER(BuildOptions), POINTER(c_void_p)]),
    "voxc_tracer_follow": (c_void_p, [c_void_p, c_void_p, POINTER(c_uint64)]),
    "voxc_tracer_create": (c_void_p, [c_void_p, POINTER(TracerOptions), POINTER(c_void_p)]),
    "voxc_render": (c_void_p, [c_void_p, POINTER(PictureOptions), c_void_p]),
}


def installed(*names):
    """The first of these files in the folder of this module, as a wheel has them, or one above, as an installation has; None if none is there."""
    for folder in list(pathlib.Path(__file__).resolve().parents)[:6]:
        for name in names:
            if (folder / name).exists():
                return str(folder / name)
    return None


def load():
    """The library that VOXC_LIBRARY names, or that of the installation that this module is a part of, or that of the system."""
    name = f"libvoxc.so.{ABI_VERSION}"
    library = ctypes.CDLL(os.environ.get("VOXC_LIBRARY") or installed(name, f"lib/{name}") or name)
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    if library.voxc_abi_version() != ABI_VERSION:
        raise ImportError(f"the C library has interface {library.voxc_abi_version()}, but this module is for {ABI_VERSION}")
    return library


lib = load()


def check(error):
    """Raises what a function of the library returned, if that is an error."""
    if error:
        kind, message = lib.voxc_error_get_kind(error), lib.voxc_error_message(error).decode()
        lib.voxc_error_free(error)
        raise KeyboardInterrupt if kind == 130 else error_of(message, kind)


def make(function, *arguments):
    """Calls what hands an object over through its last argument."""
    made = c_void_p()
    check(function(*arguments, ctypes.byref(made)))
    return made


def text(value):
    """A str or path as the library takes it; None stays None."""
    encoded = None if value is None else os.fsencode(value)
    if encoded and 0 in encoded:  # Where C takes it to end.
        raise ValueError("embedded null byte")
    return encoded


def needed(value, what):
    """The same of what has to be given."""
    if value is None:
        raise TypeError(f"{what} is a str or a path, and not None")
    return text(value)


def handle_of(value, kind, what):
    """What the library knows an object by that has to be of a class of ours."""
    if not isinstance(value, kind):
        raise TypeError(f"{what} is a voxc.{kind.__name__}, and not {type(value).__name__}")
    return value._handle


def memory_of(owner, address, count):
    """Bytes of an object of the library, which keep it: whatever NumPy makes of them."""
    memory = (ctypes.c_uint8 * count).from_address(address)
    memory.owner = owner
    return memory


def options(kind, **members):
    """A structure of options; members of None keep their default value."""
    made = kind(struct_size=ctypes.sizeof(kind))
    for name, value in members.items():
        if value is not None:
            setattr(made, name, value)
            taken = getattr(made, name)
            if isinstance(taken, int) and taken != value:  # ctypes takes the low bits of what is too large.
                raise ValueError(f"{name} cannot be {value}")
    return made


def int3(values, what):
    """Three whole numbers, along x, y and z, as the library takes them."""
    try:
        numbers = [operator.index(value) for value in values]
    except TypeError:
        numbers = []
    if len(numbers) != 3 or any(not -2**31 <= number < 2**31 for number in numbers):
        raise ValueError(f"{what} is three whole numbers of 32 bits, along x, y and z, and not {values}")
    return (c_int32 * 3)(*numbers)


class Reporter:
    """A function (stage, fraction, done), or a bar of tqdm's kind, as the library's progress. What it raises ends the work and is raised again, and so does
    Control-C: nothing is raised within a callback."""

    def __init__(self, function):
        self.failure = None
        self.function = report_of(function)
        self.callback = REPORT(self.report)
        self.progress = Progress(self.callback, None)
        self.interrupts = Interrupts()

    def guard(self, function):
        """A function as a callback that returns 0 from its first exception on, which ends the work and is raised again."""
        def guarded(*arguments):
            try:
                return 0 if self.failure or self.interrupts.came else function(*arguments)
            except BaseException as failure:
                self.failure = failure
                return 0
        return guarded

    def report(self, _, stage, fraction, done):
        try:
            if self.failure or self.interrupts.asked():
                return 1
            if self.function:
                self.function(stage.decode(), fraction, done)
            return 0
        except BaseException as failure:
            self.failure = failure
            return 1

    def call(self, function, *arguments):
        """Calls a function of the library that reports to this, and raises what it returned or what a callback raised."""
        with self.interrupts:
            error = function(*arguments)
        if self.interrupts.came and not self.failure:
            self.failure = KeyboardInterrupt()
        if self.failure:
            lib.voxc_error_free(error)
            raise self.failure
        check(error)

    @property
    def pointer(self):
        return ctypes.pointer(self.progress)
