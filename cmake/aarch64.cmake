# For 64-bit Arm processors under Linux, by Debian's cross compiler; VOXC_SYSROOT is the folder that scripts/sysroot.sh has made. What is
# built runs here by qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES VOXC_SYSROOT)
set(CMAKE_SYSROOT "${VOXC_SYSROOT}")
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L "${VOXC_SYSROOT}")

set(CMAKE_FIND_ROOT_PATH "${VOXC_SYSROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${VOXC_SYSROOT}")
set(ENV{PKG_CONFIG_LIBDIR} "${VOXC_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${VOXC_SYSROOT}/usr/share/pkgconfig")
