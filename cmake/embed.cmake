# taut_embed(<output.c> <symbol> <files...>): a C file with `const taut_embedded <symbol>[]`, one row per file
# (name without folder, text, length), ended by a row of NULL. Declared in src/cli/embedded_files.h.
function(taut_embed output symbol)
  set(listed ${ARGN})
  list(SORT listed)
  string(REPLACE ";" "|" joined "${listed}")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DSYMBOL=${symbol} "-DFILES=${joined}"
            -P ${CMAKE_SOURCE_DIR}/cmake/embed_run.cmake
    DEPENDS ${listed} ${CMAKE_SOURCE_DIR}/cmake/embed_run.cmake
    VERBATIM)
endfunction()
