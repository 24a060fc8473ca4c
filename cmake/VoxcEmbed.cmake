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
  target_sources(${target} PRIVATE "${output}")
endfunction()
