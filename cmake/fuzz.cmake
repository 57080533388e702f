# Every tests/fuzz/fuzz_*.c defines LLVMFuzzerTestOneInput. It becomes, with clang and TAUT_FUZZ, the libFuzzer
# program fuzz-<name>, and in every build a ctest fuzz/<name> that runs all inputs of tests/fuzz/corpus/<name>/ once
# (found inputs are added there, so that they stay tested). What targets share is in outcome.c; mutate_<name>.c, where it
# is there, is that target's own mutator.
file(GLOB fuzz_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/fuzz/fuzz_*.c)
foreach(file IN LISTS fuzz_files)
  get_filename_component(short ${file} NAME_WE)
  string(REPLACE "fuzz_" "" short ${short})
  if(TAUT_FUZZ)
    file(GLOB mutator ${CMAKE_SOURCE_DIR}/tests/fuzz/mutate_${short}.c)
    add_executable(fuzz-${short} ${file} ${mutator} ${CMAKE_SOURCE_DIR}/tests/fuzz/outcome.c)
    target_link_libraries(fuzz-${short} PRIVATE taut_static taut_embedded_files)
    target_link_options(fuzz-${short} PRIVATE -fsanitize=fuzzer)
    set_target_properties(fuzz-${short} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz)
  endif()
  if(BUILD_TESTING)
    add_executable(test-fuzz-${short} ${file} ${CMAKE_SOURCE_DIR}/tests/fuzz/outcome.c
      ${CMAKE_SOURCE_DIR}/tests/fuzz/replay.c)
    target_link_libraries(test-fuzz-${short} PRIVATE taut_static taut_embedded_files)
    set_target_properties(test-fuzz-${short} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    add_test(NAME fuzz/${short} COMMAND test-fuzz-${short} ${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/${short})
    set_tests_properties(fuzz/${short} PROPERTIES TIMEOUT 300 ENVIRONMENT "${wine_options}")
    if(WIN32)
      set_tests_properties(fuzz/${short} PROPERTIES FIXTURES_REQUIRED wine)
    endif()
  endif()
endforeach()
