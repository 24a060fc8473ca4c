# commands.py PAGE: prints the commands of a page, which stand in blocks of ```sh.
import sys

inside = False
for line in open(sys.argv[1]):
    if line.startswith("```"):
        inside = line.strip() == "```sh"
    elif inside:
        print(line, end="")
