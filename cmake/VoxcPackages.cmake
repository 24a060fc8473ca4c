# Debian packages: `cpack -G DEB` in the build folder makes one of each component.
set(CPACK_PACKAGE_CONTACT "the founding engineers of voxc <voxc@localhost>")
set(CPACK_PACKAGE_VENDOR "voxc")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_COMPONENTS_ALL runtime tools dev python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
# Without it, files would belong to whoever made the package's folders with his own umask.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "libvoxc0")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "C libraries: libvoxc.so.0 builds and traces volumes; libvoxc-rt.so.0 traces them, and needs no compiler.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION "libs")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "libvulkan1") # Opened at run time.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME "voxc")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "Tools: voxc builds, traces and measures volumes of voxels in formats that are composed of levels.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION "graphics")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libvulkan1")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "bash-completion, man-db")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME "libvoxc-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Development: headers, archives for C++, documentation and examples.")
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION "libdevel")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libvoxc0 (= ${PROJECT_VERSION}), libglm-dev, libzstd-dev, libvulkan-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "llvm-19-dev, clang-19, libclang-19-dev, libclang-cpp19-dev, glslang-dev, glslang-tools, spirv-tools, libboost-dev, zlib1g-dev, libturbojpeg0-dev, libpng-dev, libstb-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME "python3-voxc")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module: volumes from NumPy arrays, hits and pictures as arrays.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION "python")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE "all")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libvoxc0 (>= ${PROJECT_VERSION}), python3, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "voxc")

include(CPack)
