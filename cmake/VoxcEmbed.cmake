# voxc_embed(TARGET NAME FILES...): compiles files into TARGET as text, found by path with
# `voxc::NAME(path)`; see include/voxc/Support/EmbeddedFile.h. Editing a file rebuilds what embeds it.
set(VOXC_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/EmbedFiles.cmake")

function(voxc_embed target name root)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  set(paths ${ARGN})
  list(TRANSFORM paths PREPEND "${root}/" OUTPUT_VARIABLE inputs)
  string(REPLACE ";" "|" joined "${paths}")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DNAME=${name}" "-DROOT=${root}" "-DPATHS=${joined}"
            -P "${VOXC_EMBED_SCRIPT}"
    DEPENDS ${inputs} "${VOXC_EMBED_SCRIPT}"
    VERBATIM)
  # The command is known in this folder alone and the target stands in another: a target of its own joins them.
  add_custom_target(${target}-${name} DEPENDS "${output}")
  add_dependencies(${target} ${target}-${name})
  # A custom command serves targets of its own folder alone; the object library carries its result to `target`.
  add_library(${name} OBJECT "${output}")
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/include")
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${name}>)
endfunction()
