# damage.py cut|flip PATTERN: cuts the file of this pattern in half, or changes one bit in its middle.
import glob
import sys

(path,) = glob.glob(sys.argv[2])
with open(path, "r+b") as file:
    content = file.read()
    middle = len(content) // 2
    if sys.argv[1] == "cut":
        file.truncate(middle)
    else:
        file.seek(middle)
        file.write(bytes([content[middle] ^ 4]))
