# Tests of the tools: each file says in its RUN lines what is run and what must come out.
import os
import platform
import shutil
import subprocess
import sys

import lit.formats

config.name = "voxc"
config.test_format = lit.formats.ShTest(execute_external=False)
config.suffixes = [".test", ".vir"]
config.test_source_root = os.path.dirname(__file__)
config.test_exec_root = os.path.join(config.voxc_binary_dir, "test")
config.excludes = ["Inputs"]

bin_dir = os.path.join(config.voxc_binary_dir, "bin")
shared_dir = os.environ.get("VOXC_SHARED", os.path.join(config.voxc_source_dir, "..", "shared"))
if "VOXC_SEED" in os.environ:
    config.environment["VOXC_SEED"] = os.environ["VOXC_SEED"]
config.environment["PATH"] = os.pathsep.join([config.llvm_tools_dir, config.environment["PATH"]])

# Longer names first: lit replaces them in this order, and %voxc begins the others.
for tool in ["voxc-cliffs", "voxc-edit-costs", "voxc-gpu-day", "voxc-hard-rays", "voxc-opt", "voxc-trace", "voxc"]:
    config.substitutions.append(("%" + tool + r"\b", os.path.join(bin_dir, tool)))
config.substitutions += [
    ("%shared", os.path.normpath(shared_dir)),
    ("%source", config.voxc_source_dir),
    ("%build", config.voxc_binary_dir),
    ("%cmake", config.cmake),
    ("%cxx", config.cxx),
    ("%cc", config.cc),
    ("%exits", f"{sys.executable} {os.path.join(config.test_source_root, 'exits.py')}"),
    ("%python", sys.executable),
]

if os.path.isdir(shared_dir):
    config.available_features.add("shared")
# As random tests are longer then.
if int(os.environ.get("VOXC_TEST_FACTOR", 1)) > 1:
    config.available_features.add("thorough")
if config.sanitized:
    config.available_features.add("sanitized")
    config.environment["ASAN_OPTIONS"] = "detect_leaks=0"

# The viewer needs a build with windows; to be used, a display of its own and hands for it.
if config.has_window:
    config.available_features.add("window")
    if shutil.which("Xvfb") and shutil.which("xdotool"):
        config.available_features.add("display")

# Tests leave nothing beside their sources.
config.environment["PYTHONDONTWRITEBYTECODE"] = "1"

# What a search keeps of devices is not the user's.
config.environment["XDG_CACHE_HOME"] = os.path.join(config.test_exec_root, "cache")

# Kernels run on lavapipe, whatever else this machine has, under the validation layer, whose messages go to stdout.
lavapipe = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json"
config.environment["MESA_SHADER_CACHE_DISABLE"] = "true"
config.environment["VK_ICD_FILENAMES"] = lavapipe
config.environment["VK_INSTANCE_LAYERS"] = "VK_LAYER_KHRONOS_validation"
if os.path.exists(lavapipe):
    config.available_features.add("vulkan")
if platform.machine() == "x86_64":
    config.available_features.add("x86-64")
# The Python that has a module need not be the one that runs lit.
for module, feature, name in [("numpy", "numpy", "%numpython"), ("matplotlib, PIL", "matplotlib", "%plotpython"),
                              ("pyopenvdb", "pyopenvdb", "%vdbpython")]:
    for python in [sys.executable, "/usr/bin/python3"]:
        if subprocess.run([python, "-c", "import " + module], capture_output=True).returncode == 0:
            config.available_features.add(feature)
            config.substitutions.insert(0, (name, python))
            break
# Blender looks for its Python, which is the system's, beside whatever python3 it finds first.
config.substitutions.append(("%blender", "env PATH=/usr/bin:/bin blender"))
# Programs that some tests need, and that a machine may lack.
for program in ["readelf", "zsh", "fish", "mypy", "blender"]:
    if shutil.which(program):
        config.available_features.add(program)
if shutil.which("mksquashfs") and os.path.exists("/usr/include/squashfuse/squashfuse.h"):
    config.available_features.add("squashfuse")
config.available_features.update(name for name, is_built in config.components.items() if is_built)
if config.has_spirv_cross:
    config.available_features.add("spirv-cross")
