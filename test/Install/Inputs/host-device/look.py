# Looks at the engine's frame: the sponge is in the middle, yellow above and red below, the ring is around it, blue in front, and
# the sky is in the corners.
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
from pictures import Picture

picture = Picture(sys.argv[1])
assert (picture.width, picture.height) == (160, 90)
picture.expect("sky", (0, 0, 20, 10), lambda r, g, b: b > g > r)
picture.expect("sponge above", (65, 23, 95, 31), lambda r, g, b: r > 1.5 * b and g > 1.3 * b)
picture.expect("sponge below", (70, 64, 95, 70), lambda r, g, b: r > 1.3 * g)
picture.expect("ring in front", (76, 48, 85, 56), lambda r, g, b: b > 1.5 * r)
picture.expect("ring, white", (63, 48, 70, 56), lambda r, g, b: abs(r - b) < 30 and r > 100)
