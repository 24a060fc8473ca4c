# What `cmake --install` puts where, in five components that are Debian packages of their own (VoxcPackages.cmake): `runtime`, the
# shared C libraries; `tools`, with their manual and completion; `viewer`, its window; `dev`, all to compile and link programs; `python`.
include(CMakePackageConfigHelpers)
set(packageDirectory "${CMAKE_INSTALL_LIBDIR}/cmake/voxc")

# What a component needs to be built, looked for before anything is installed: `./demo` builds a part of it.
function(voxc_needs component)
  install(CODE "foreach(file IN ITEMS ${ARGN})
  if(NOT EXISTS \"\${file}\")
    message(FATAL_ERROR \"only a part of voxc is built: \${file} is missing; build the rest by 'cmake --build ${PROJECT_BINARY_DIR}'\")
  endif()
endforeach()" COMPONENT ${component})
endfunction()
voxc_needs(tools "$<TARGET_FILE:voxc>" "$<TARGET_FILE:voxc-opt>" "$<TARGET_FILE:voxc-trace>" "${PROJECT_BINARY_DIR}/manual/voxc")
voxc_needs(runtime "$<TARGET_FILE:voxc-c>" "$<TARGET_FILE:voxc-c-runtime>")
voxc_needs(dev "$<TARGET_FILE:voxc-runtime>" "$<TARGET_FILE:voxc-compiler>" "$<TARGET_FILE:voxc-image>" "$<TARGET_FILE:voxc-components>")
if(TARGET voxc-viewer)
  voxc_needs(viewer "$<TARGET_FILE:voxc-viewer>")
endif()

# The libraries for C++, whose interface changes with the version: archives. Optional components go with the compiler.
foreach(component runtime compiler)
  set_target_properties(voxc-${component} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS voxc-${component} EXPORT voxc-${component} ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
endforeach()
foreach(component image components openvdb assimp)
  if(TARGET voxc-${component})
    set_target_properties(voxc-${component} PROPERTIES EXPORT_NAME ${component})
    install(TARGETS voxc-${component} EXPORT voxc-compiler ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
  endif()
endforeach()
# Those for C.
foreach(library c c-runtime)
  install(TARGETS voxc-${library} EXPORT voxc-c
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT dev
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
  set_target_properties(voxc-${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
foreach(export runtime compiler c)
  install(EXPORT voxc-${export} FILE voxc-${export}.cmake NAMESPACE voxc:: DESTINATION "${packageDirectory}" COMPONENT dev)
endforeach()

# Headers, but for what only this repository uses and what this build lacks. docs/headers.md lists what is promised, what lies
# beneath that, and what is of this tree, which programs elsewhere do not get to see.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/headers.md")
file(READ "${PROJECT_SOURCE_DIR}/docs/headers.md" internalHeaderPage)
string(REGEX REPLACE "^.*## Of this tree" "" internalHeaderPage "${internalHeaderPage}")
string(REGEX MATCHALL "voxc/[A-Za-z]+/[A-Za-z0-9]+[.]h" internalHeaderNames "${internalHeaderPage}")
set(internalHeaders)
foreach(header IN LISTS internalHeaderNames)
  list(APPEND internalHeaders PATTERN "${header}" EXCLUDE)
  get_filename_component(folder "${header}" DIRECTORY)
  file(GLOB others RELATIVE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/include/${folder}/*.h")
  list(REMOVE_ITEM others ${internalHeaderNames})
  if(NOT others)
    list(APPEND internalHeaders PATTERN "${folder}" EXCLUDE) # An empty folder would stay when all is uninstalled.
  endif()
endforeach()
if(NOT VOXC_OPENVDB)
  list(APPEND internalHeaders PATTERN "OpenVdb" EXCLUDE)
endif()
if(NOT VOXC_ASSIMP)
  list(APPEND internalHeaders PATTERN "Assimp" EXCLUDE)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/voxc" "${PROJECT_SOURCE_DIR}/include/voxc-c"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev ${internalHeaders})

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/voxc-config.cmake.in" "${PROJECT_BINARY_DIR}/voxc-config.cmake"
                              INSTALL_DESTINATION "${packageDirectory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/voxc-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/voxc-config.cmake" "${PROJECT_BINARY_DIR}/voxc-config-version.cmake"
        DESTINATION "${packageDirectory}" COMPONENT dev)
# The prefix is found from where the file lies, so that an installation may be moved, or made for another prefix than the configured one.
file(RELATIVE_PATH VOXC_PREFIX_FROM_PC "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file("${CMAKE_CURRENT_LIST_DIR}/voxc.pc.in" "${PROJECT_BINARY_DIR}/voxc.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/voxc.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)

# The tools, with a page of the manual for each command and completion for shells, both from the tables of their help.
install(TARGETS voxc voxc-opt voxc-trace RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tools)
if(TARGET voxc-viewer)
  install(TARGETS voxc-viewer RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/voxc" COMPONENT viewer)
endif()
set(manual "${PROJECT_BINARY_DIR}/manual")
# The program voxc-trace and the command `voxc trace` have one page, as they have one name there.
add_custom_command(OUTPUT "${manual}/voxc" "${manual}/man1/voxc.1"
                   COMMAND voxc manual -o "${manual}/man1"
                   COMMAND voxc-opt --manual > "${manual}/man1/voxc-opt.1"
                   COMMAND voxc-trace --manual > "${manual}/program.1"
                   COMMAND "${CMAKE_COMMAND}" -E cat "${manual}/program.1" "${manual}/man1/voxc-trace.1" > "${manual}/both.1"
                   COMMAND "${CMAKE_COMMAND}" -E rename "${manual}/both.1" "${manual}/man1/voxc-trace.1"
                   COMMAND voxc completion bash > "${manual}/voxc"
                   COMMAND voxc completion zsh > "${manual}/_voxc"
                   COMMAND voxc completion fish > "${manual}/voxc.fish"
                   DEPENDS voxc voxc-opt voxc-trace VERBATIM)
add_custom_target(manual ALL DEPENDS "${manual}/voxc")
install(DIRECTORY "${manual}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT tools)
install(FILES "${manual}/voxc" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT tools)
install(FILES "${manual}/_voxc" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT tools)
install(FILES "${manual}/voxc.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT tools)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT tools)
# What draws the report of voxc bench: text, which needs Python and Matplotlib where it is used.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/tools/report/" DESTINATION "${CMAKE_INSTALL_DATADIR}/voxc/report" COMPONENT tools
        FILES_MATCHING PATTERN "*.py" PATTERN "*.html" PATTERN "*.css" PATTERN "*.js" PATTERN "__pycache__" EXCLUDE)

# What explains the libraries: docs without records of measurements, and the examples.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT dev PATTERN "evaluation" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT dev)

# The module for Python is text, and finds the C library of the system.
set(VOXC_PYTHON_DIRECTORY "lib/python3/dist-packages" CACHE STRING "Where Python looks for modules, below the prefix")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/python/voxc" DESTINATION "${VOXC_PYTHON_DIRECTORY}" COMPONENT python
        FILES_MATCHING PATTERN "*.py" PATTERN "py.typed")

# `cmake --build BUILD --target uninstall` removes what was installed.
add_custom_target(uninstall COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" -P "${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake" VERBATIM)

include(VoxcPackages)
