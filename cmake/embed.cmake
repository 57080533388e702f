# taut_embed(<output.c> <symbol> <header> <type> <files...>): a C file with `const <type> <symbol>[]`, one row per file
# (name without folder, text, length), ended by a row of NULL. Declared in src/<header>.
function(taut_embed output symbol header type)
  set(listed ${ARGN})
  list(SORT listed)
  string(REPLACE ";" "|" joined "${listed}")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DSYMBOL=${symbol} -DHEADER=${header} -DTYPE=${type} "-DFILES=${joined}"
            -P ${CMAKE_SOURCE_DIR}/cmake/embed_run.cmake
    DEPENDS ${listed} ${CMAKE_SOURCE_DIR}/cmake/embed_run.cmake
    VERBATIM)
endfunction()
