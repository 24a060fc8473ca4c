# Looks at a picture of the hall: the sky is blue, the sponge is gold with a bright lamp in it, and the red wall is red.
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
from pictures import Picture

picture = Picture(sys.argv[1])
assert (picture.width, picture.height) == (64, 36)
picture.expect("sky", (40, 2, 44, 3), lambda r, g, b: b > r and b > 100)
picture.expect("sponge", (22, 8, 39, 27), lambda r, g, b: r > g > b and r > 1.3 * b)
picture.expect("lamp", (28, 15, 31, 18), lambda r, g, b: r > 200)
picture.expect("wall", (52, 10, 55, 18), lambda r, g, b: r > 2 * g and r > 2 * b)
