"""A page taken apart: page.py PAGE V.hvx [SMALL.hvx | --scene]

Its words must be those of the volume, and nothing in it may lead elsewhere. Prints how many checks it holds, and whether it has more
than 1.4 times the bytes of SMALL.hvx, the same volume compressed; or what is cut away, how high an orthographic picture is, and whether
the kernel takes bounds.
"""
import json
import re
import struct
import sys
import zlib
from pathlib import Path

UNFIT = (0, 13, 60)

page = Path(sys.argv[1]).read_bytes().decode()
packed = re.search(r'<script id="packed" type="text/plain">([^<]*)</script>', page).group(1)
assert "\r" not in packed and "\0" not in packed
poster = re.search(r'<img alt=""(?: class="inside")? src="(data:image/jpeg;base64,[A-Za-z0-9+/=]+)">', page)
assert len(poster.group(1)) <= 12000
text = page.replace(packed, "").replace(poster.group(0), "").replace("//# sourceURL", "")
assert not re.search(r"https?:|//[a-z]|\bsrc=|\bhref=|@import|url\(", text)

held, bits, data = 0, 0, bytearray()
for character in packed:
    code = ord(character)
    for seven in [code] if code < 128 else [UNFIT[(code - 256) >> 7], code & 127]:
        held = (held << 7 | seven) & 0x7fff
        bits += 7
        if bits >= 8:
            bits -= 8
            data.append(held >> bits & 255)
number = lambda pattern: int(re.search(pattern, page).group(1))
size, script, words = number(r"bytes\.subarray\(0, (\d+)\)"), number(r"whole\.subarray\(0, (\d+)\)"), number(r"new Uint32Array\((\d+)\)")
whole = zlib.decompress(bytes(data[:size]), -15)

volume = Path(sys.argv[2]).read_bytes()
(count,) = struct.unpack_from("<Q", volume, 168 + 40)
(offset,) = struct.unpack_from("<Q", volume, 168 + 48)
assert count == words
block, at = number(r"block = (\d+)"), script
for first in range(0, words, block):
    length = min(block, words - first)
    planes = whole[at:at + 4 * length]
    mine = bytearray(4 * length)
    for rank in range(4):
        mine[rank::4] = planes[rank * length:(rank + 1) * length]
    assert mine == volume[offset + 4 * first:offset + 4 * (first + length)]
    at += 4 * length
print(len(whole) - at, "checks")
if sys.argv[3:] == ["--scene"]:
    told = json.loads(re.search(rb"^const scene = (.*);$", whole[:script], re.MULTILINE).group(1))
    cuts = [",".join(str(number + 0.0) for number in plane) + ";" for plane in told["cuts"]]
    print("cuts:", *cuts, "end")
    print("height", told["camera"]["height"])
    print("bounded" if b"voxc_scene_closest" in whole[:script] else "without bounds")
elif len(sys.argv) > 3:
    small = Path(sys.argv[3]).stat().st_size
    print("more" if Path(sys.argv[1]).stat().st_size > 1.4 * small else "no more", "than 1.4 times")
