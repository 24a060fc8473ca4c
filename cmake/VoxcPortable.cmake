# Binaries for systems older than this one, and without its packages (scripts/wheel.sh and tarball.sh): `voxc-portable`, one shared
# library with the C interface and the whole driver, and `voxc-portable-program`, a program of a few kilobytes that begins it. They
# are linked of the objects that are there already, with the archives of all libraries within, and hidden; and against a C library as
# it was in the version below, of which nothing newer is asked.
set(VOXC_PORTABLE_GLIBC 2.28)

# What -lNAME is to find before the system's folders: archives, where those there are shared libraries too.
set(portable "${PROJECT_BINARY_DIR}/portable")
set(compiler "${CMAKE_C_COMPILER}")
if(CMAKE_SYSROOT)
  list(APPEND compiler "--sysroot=${CMAKE_SYSROOT}")
endif()
set(VOXC_PORTABLE_COMPILER "${compiler}" CACHE INTERNAL "What scripts/portable.sh compiles with")
add_custom_command(
  OUTPUT "${portable}/libc.so"
  COMMAND python3 -B "${CMAKE_CURRENT_LIST_DIR}/portable/old_glibc.py" "${portable}" ${VOXC_PORTABLE_GLIBC} ${compiler}
  COMMAND python3 -B "${CMAKE_CURRENT_LIST_DIR}/portable/archives.py" "${portable}" "${portable}/made" ${compiler}
  DEPENDS "${CMAKE_CURRENT_LIST_DIR}/portable/old_glibc.py" "${CMAKE_CURRENT_LIST_DIR}/portable/archives.py"
  VERBATIM)
add_custom_target(voxc-portable-libraries DEPENDS "${portable}/libc.so")

# voxc_portable(TARGET): how one of them is linked.
function(voxc_portable target)
  set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON LINK_DEPENDS "${portable}/libc.so;${PROJECT_SOURCE_DIR}/lib/C/exports.map")
  add_dependencies(${target} voxc-portable-libraries)
  target_link_directories(${target} BEFORE PRIVATE "${portable}")
  target_link_options(${target} PRIVATE -static-libgcc -static-libstdc++ -Wl,-z,defs -Wl,--gc-sections -Wl,--strip-all
                                        -Wl,-z,relro -Wl,-z,now)
endfunction()

add_library(voxc-portable SHARED "${CMAKE_CURRENT_LIST_DIR}/portable/NewerNames.c" "${CMAKE_CURRENT_LIST_DIR}/portable/NoJbig.c"
                                 "${PROJECT_SOURCE_DIR}/tools/voxc/main.cpp" $<TARGET_OBJECTS:voxc-c>)
voxc_portable(voxc-portable)
target_include_directories(voxc-portable PRIVATE "${PROJECT_SOURCE_DIR}/tools/voxc")
if(VOXC_VIEW)
  # The window within, and what it needs of a system loaded when it opens.
  add_custom_command(
    OUTPUT "${portable}/window.s"
    COMMAND python3 -B "${CMAKE_CURRENT_LIST_DIR}/portable/late_window.py" "${portable}/window.s" "${CMAKE_NM}" ${CMAKE_SYSTEM_PROCESSOR}
            $<TARGET_FILE:voxc-window> "${VOXC_IMGUI_LIBRARY}"
    DEPENDS voxc-window "${CMAKE_CURRENT_LIST_DIR}/portable/late_window.py"
    VERBATIM)
  enable_language(ASM)
  target_sources(voxc-portable PRIVATE "${portable}/window.s" "${CMAKE_CURRENT_LIST_DIR}/portable/LateWindow.c")
  target_link_libraries(voxc-portable PRIVATE $<TARGET_FILE:voxc-window> "${VOXC_IMGUI_LIBRARY}" stb)
else()
  target_link_libraries(voxc-portable PRIVATE voxc-no-window)
endif()
# Its name here is not that of the C library, which is a target too; scripts/portable.sh gives it that.
set_target_properties(voxc-portable PROPERTIES NO_SONAME ON VOXC_HAS_LLVM_WITHIN ${VOXC_LLVM_WITHIN}
                                               LIBRARY_OUTPUT_DIRECTORY "${portable}" INSTALL_RPATH "$ORIGIN"
                                               BUILD_WITH_INSTALL_RPATH ON)
target_link_options(voxc-portable PRIVATE -Wl,-soname,libvoxc.so.0 -Wl,--defsym=voxc_main=main "-Wl,--version-script=${PROJECT_SOURCE_DIR}/lib/C/exports.map" -lpthread -ldl -lrt
                                          "-Wl,--dependency-file=${portable}/linked.d")
target_link_libraries(voxc-portable PRIVATE voxc-driver voxc-applications voxc-components voxc-compiler voxc-flags)

add_executable(voxc-portable-program "${CMAKE_CURRENT_LIST_DIR}/portable/Start.c")
voxc_portable(voxc-portable-program)
target_compile_options(voxc-portable-program PRIVATE -fno-stack-protector)
target_link_options(voxc-portable-program PRIVATE -pie -nostartfiles)
set_target_properties(voxc-portable-program PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${portable}"
                                                       INSTALL_RPATH "$ORIGIN/../lib" BUILD_WITH_INSTALL_RPATH ON)
target_link_libraries(voxc-portable-program PRIVATE voxc-portable)
