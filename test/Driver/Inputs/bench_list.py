# bench_list.py: a list of formats with a label, a comment, one that is too large, and a bare one.
print("# formats of 64 voxels an axis\n1\tR(2^3) G(4)\nlarge\tS(6)\n\nG(6)")
