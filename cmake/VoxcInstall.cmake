# What `cmake --install` puts where, and the package that `find_package(voxc)` finds: voxc::runtime needs nothing more,
# voxc::compiler also the compiler's libraries, which are looked for only if that component is asked for.
include(CMakePackageConfigHelpers)
set(packageDirectory "${CMAKE_INSTALL_LIBDIR}/cmake/voxc")

foreach(component runtime compiler)
  set_target_properties(voxc-${component} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS voxc-${component} EXPORT voxc-${component} ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT voxc-${component} FILE voxc-${component}.cmake NAMESPACE voxc:: DESTINATION "${packageDirectory}")
endforeach()

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/voxc" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS voxc voxc-opt voxc-trace RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/voxc-config.cmake.in" "${PROJECT_BINARY_DIR}/voxc-config.cmake"
                              INSTALL_DESTINATION "${packageDirectory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/voxc-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/voxc-config.cmake" "${PROJECT_BINARY_DIR}/voxc-config-version.cmake"
        DESTINATION "${packageDirectory}")
