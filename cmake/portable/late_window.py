"""late_window.py ASSEMBLY NM PROCESSOR ARCHIVE...: functions of GLFW and Vulkan that the archives call, as jumps through a table that is filled when a
window is first asked for (LateWindow.c). So nothing but that needs either library, and no program loads them but for it."""
import pathlib
import re
import subprocess
import sys

OWN = {"glfwInit", "glfwGetError"}  # LateWindow.c has them.
# The member of ImGui's archive for other ways to windows are not linked.
MEMBERS = re.compile(r"imgui_impl_(?!glfw|vulkan)")
# A jump to where a slot says, without a register that holds an argument.
JUMPS = {"x86_64": "jmp *{slot}(%rip)", "aarch64": "adrp x16, {slot}; ldr x16, [x16, :lo12:{slot}]; br x16"}


def called(nm, archive):
    table = subprocess.run([nm, "--undefined-only", archive], capture_output=True, text=True, check=True).stdout
    names, taken = set(), True
    for line in table.splitlines():
        if line.endswith(":"):
            taken = not MEMBERS.match(line)
        elif taken:
            names |= set(re.findall(r" U ((?:glfw|vk)[A-Z]\w*)$", line))
    return names


def main():
    assembly, nm, processor, *archives = sys.argv[1:]
    names = sorted(set().union(*(called(nm, archive) for archive in archives)) - OWN)
    text = [".text"]
    for name in names:
        text += [f".globl {name}", f".hidden {name}", f".type {name},@function", f"{name}: {JUMPS[processor].format(slot=f'slot_{name}')}"]
    text += [".bss", ".balign 8", *(f"slot_{name}: .skip 8" for name in names), ".section .rodata", *(f'text_{name}: .asciz "{name}"' for name in names),
             '.section .data.rel.ro,"aw"', ".balign 8", ".globl voxcWindowFunctions", ".hidden voxcWindowFunctions", "voxcWindowFunctions:",
             *(f".quad text_{name}, slot_{name}" for name in names), ".quad 0, 0", '.section .note.GNU-stack,"",@progbits']
    pathlib.Path(assembly).write_text("\n".join(text) + "\n")


main()
