"""Functions for WebGL of formats with every kind of level, traversal and payload through glslang: check.py VOXC FOLDER"""
import re
import subprocess
import sys
from pathlib import Path

VOXC, FOLDER = sys.argv[1], Path(sys.argv[2])
FORMATS = """
R(2^3) G(3) --whole-level-dedup
R(2^3) G(3) --precision fast
G(5) --restart-sv --inline-leaves
G(6, 2) --unroll-sv
S(5)
S(2) S(3) --flat-traversal
D(3^3,6) R(2^3) --direct-traversal
D(2^3,15) G(3) --df-packing
D(3^3,15) M(2^3) --octant-distances --df-packing --share-grids --values-apart
H(3^3) M(2^3) --share-grids --short-pointers
M(1^3) M(2^3) M(2^3) --palette --share-grids --values-apart
R(1^3) G(4) --values-apart --palette=4
R(2^3) G(0) G(3) --granules
G(5) --rgb565
G(5) --material
G(5) --occupancy
G(5) --constant-colour --precision fast
""".strip().splitlines()

SHADER = """#version 300 es
uniform highp usampler2D words;
#define VOXC_VOLUME int
#define VOXC_LOAD(volume, index) texelFetch(words, ivec2(int((index) & 4095u), int((index) >> 12)), 0).x
{functions}
out uvec4 answer;
void main() {{
  voxc_v_Hit hit;
  bool found = voxc_v_closest(0, vec3(gl_FragCoord.xy, -1.0), vec3(0.0, 0.5, 1.0), 0.0, 1000.0, hit);
  while (found && hit.colour == 0u)
    found = voxc_v_next(0, vec3(gl_FragCoord.xy, -1.0), vec3(0.0, 0.5, 1.0), 1000.0, hit);
  vec3 point = voxc_v_outside(vec3(gl_FragCoord.xy, -1.0), vec3(0.0, 0.5, 1.0), hit);
  bool is_lit = found && !voxc_v_any(0, point, voxc_v_normal(hit), 0.0, 1000.0);
  answer = uvec4(uvec3(hit.voxel), uint(is_lit));
}}
"""

for number, line in enumerate(FORMATS):
    text, _, passes = line.partition(" --")
    options = ("--" + passes).split() if passes else []
    functions = subprocess.run([VOXC, "compile", text, *options, "--emit=webgl", "--name", "v", "-o", "-"], check=True,
                               capture_output=True, text=True).stdout
    # What WebGL refuses beyond the language: a choice by ?: between structures.
    structures = re.findall(r"^VOXC_\w+ voxc_v_[A-Z]\w* (voxc_v_\w+)\(", functions, re.M)
    for choice in re.findall(r"\? (voxc_v_\w+)\(", functions):
        if choice in structures:
            sys.exit(f"{line}\n{choice} gives a structure, and stands behind a ?")
    shader = FOLDER / f"{number}.frag"
    shader.write_text(SHADER.format(functions=functions))
    told = subprocess.run(["glslangValidator", "-S", "frag", shader], capture_output=True, text=True)
    if told.returncode != 0:
        sys.exit(f"{line}\n{told.stdout}")
    print("took", line)
