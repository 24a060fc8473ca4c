"""Damages the length of the first record of a volume's journal in all ways, and counts those that voxc refuses: lengths.py VOXC VOLUME"""
import subprocess
import sys

voxc, volume = sys.argv[1:]
LENGTH = 32 + 8  # Behind the head of the journal, and kind and room of the record's.

with open(volume + ".journal", "rb") as file:
    whole = file.read()
refused, lengths = 0, [0, 1, 39, 41, 47, 48, 88, 128, 200, 1 << 16, 1 << 31, 1 << 40, 1 << 63, (1 << 64) - 1]
for length in lengths:
    with open(volume + ".journal", "wb") as file:
        file.write(whole[:LENGTH] + length.to_bytes(8, "little") + whole[LENGTH + 8:])
    run = subprocess.run([voxc, "info", volume], capture_output=True, text=True)
    refused += run.returncode == 1 and "is damaged at its edit 1, behind which there are others" in run.stderr
print(refused, "of", len(lengths), "damaged lengths refused")
