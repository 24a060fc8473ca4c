"""voxc in Python: volumes of voxels in hybrid formats, built from arrays or files, traced, and made pictures of.

    import voxc
    volume = voxc.build("R(4, 4, 4) G(4)", "bunny.ply")
    hits = volume.tracer().trace(origins, directions)
    voxc.save_picture("bunny.png", volume.render())

Arrays are NumPy's. A grid of voxels is indexed [z, y, x]; its uint32 words are R in the low byte, then G, B and A, and 0
is empty. Places are (x, y, z), in voxels. What cannot be done raises voxc.Error with the sentence that the tools would print: an
InputError, a UsageError or a MachineError.
"""
from __future__ import annotations

from ._errors import Error, InputError, MachineError, UsageError
from ._library import lib as _lib
from .building import build
from .choosing import search, suggest
from .editable import Editable
from .format import Format
from .page import Page
from .picture import Picture, save_picture
from .points import Points, load_npz
from .told import InputWarning
from .tracer import BOUNDED_RAY, HIT, RAY, Tracer, devices, normals
from .volume import Volume

__version__: str = _lib.voxc_version().decode()
__all__ = ["BOUNDED_RAY", "Editable", "Error", "Format", "HIT", "InputError", "InputWarning", "MachineError", "Page", "Picture",
           "Points", "RAY", "Tracer", "UsageError", "Volume", "build", "devices", "load_npz", "normals", "save_picture", "search",
           "suggest"]
