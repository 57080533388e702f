# Every tests/<kind>/**/test_*.c is one program and one ctest; every tests/cli/test_*.sh one ctest.
# A test that needs a library the product does not names it in a line `links: <package> ...` near its top. One that ends with 77
# says what it lacks and how to get it; it is reported as skipped. On Windows those are left out that link something, and those that
# say `needs: posix`, or a module, near their top; so are those that link something or need a module where the library is built alone
# (TAUT_ALONE, of a toolchain file).
file(GLOB support_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/support/*.c ${CMAKE_SOURCE_DIR}/tests/support/oracle/*.c)
if(WIN32)
  list(FILTER support_sources EXCLUDE REGEX "/(folder_add|fake_cad).c")
  list(APPEND support_sources ${CMAKE_SOURCE_DIR}/tests/support/windows/posix.c)
endif()
add_library(taut_test_support STATIC ${support_sources})
target_include_directories(taut_test_support PUBLIC ${CMAKE_SOURCE_DIR}/tests/support)
target_link_libraries(taut_test_support PUBLIC taut_draw_static taut_embedded_files)
foreach(part taut_module_exact taut_cad) # loaded or started by tests when they run
  if(TARGET ${part})
    add_dependencies(taut_test_support ${part})
  endif()
endforeach()
if(WIN32)
  target_compile_options(taut_test_support PUBLIC -include ${CMAKE_SOURCE_DIR}/tests/support/windows/posix.h)
endif()

if(NOT WIN32 AND NOT TAUT_ALONE)
  # What OpenCASCADE sees in a STEP file, where it is installed: for tests that link step-probe, and as a program.
  set(probe_libraries)
  foreach(toolkit TKXDESTEP TKXCAF TKLCAF TKCAF TKCDF)
    find_library(OCCT_${toolkit} ${toolkit})
    list(APPEND probe_libraries ${OCCT_${toolkit}})
  endforeach()
  if(TARGET taut_cad AND NOT probe_libraries MATCHES "NOTFOUND")
    add_library(step-probe STATIC ${CMAKE_SOURCE_DIR}/tests/support/cad/probe.cpp)
    target_include_directories(step-probe SYSTEM PRIVATE ${OCCT_INCLUDE})
    target_link_libraries(step-probe PRIVATE taut_flags ${probe_libraries} ${OCCT_LIBRARIES})
    if(TAUT_SANITIZE)
      set_source_files_properties(${CMAKE_SOURCE_DIR}/tests/support/cad/probe.cpp PROPERTIES
        COMPILE_OPTIONS "-fno-sanitize=vptr,function")
    endif()
  else()
    add_library(step-probe STATIC ${CMAKE_SOURCE_DIR}/tests/support/cad/absent.c)
    target_link_libraries(step-probe PRIVATE taut_flags)
  endif()
  target_include_directories(step-probe PUBLIC ${CMAKE_SOURCE_DIR}/tests/support/cad)
  add_executable(probe_step ${CMAKE_SOURCE_DIR}/tests/support/cad/main.c)
  target_link_libraries(probe_step PRIVATE step-probe taut_flags)
  set_target_properties(probe_step PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
endif()

# What the sanitizers are told: which leaks are not ours.
set(sanitizer_options "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0")

# Under wine: no message of its own, no window, and its folder in the build.
if(WIN32)
  set(wine_options ";WINEPREFIX=${CMAKE_BINARY_DIR}/wine;WINEDEBUG=-all;WINEDLLOVERRIDES=mscoree=\\;mshtml=\\;winemenubuilder.exe=")
endif()

function(taut_test file)
  file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR}/tests ${file})
  string(REGEX REPLACE "\\.c$" "" name ${name})
  string(REPLACE "/test_" "/" name ${name})
  string(REPLACE "/" "-" target ${name})
  file(STRINGS ${file} links REGEX "(^| )links: [a-z]" LIMIT_COUNT 1)
  string(REGEX REPLACE "^.*links: ([a-z0-9 -]*).*$" "\\1" links "${links}")
  separate_arguments(links)
  file(STRINGS ${file} needs REGEX "^ \\* needs: [a-z]" LIMIT_COUNT 1)
  if((WIN32 AND (links OR needs)) OR (TAUT_ALONE AND (links OR needs MATCHES "cairo|exact|loaded")))
    return()
  endif()
  add_executable(test-${target} ${file})
  target_link_libraries(test-${target} PRIVATE taut_test_support ${links} m)
  set_target_properties(test-${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  add_test(NAME ${name} COMMAND test-${target} WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  set(patience 600)
  if(CMAKE_CROSSCOMPILING_EMULATOR MATCHES "qemu") # fifty times slower
    set(patience 7200)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${patience} SKIP_RETURN_CODE 77
    ENVIRONMENT "OPENBLAS_NUM_THREADS=1;${sanitizer_options}${wine_options}")
  if(WIN32)
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED wine)
  endif()
endfunction()

file(GLOB_RECURSE test_files CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/tests/unit/test_*.c ${CMAKE_SOURCE_DIR}/tests/property/test_*.c
  ${CMAKE_SOURCE_DIR}/tests/paper/test_*.c ${CMAKE_SOURCE_DIR}/tests/thread/test_*.c)
foreach(file IN LISTS test_files)
  taut_test(${file})
endforeach()

# Fault tests put an allocator that fails on demand before the library's own.
file(GLOB fault_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/fault/test_*.c)
foreach(file IN LISTS fault_files)
  taut_test(${file})
  get_filename_component(short ${file} NAME_WE)
  string(REPLACE "test_" "" short ${short})
  if(NOT TARGET test-fault-${short})
    continue()
  endif()
  target_sources(test-fault-${short} PRIVATE
    ${CMAKE_SOURCE_DIR}/tests/fault/failing_memory.c ${CMAKE_SOURCE_DIR}/tests/fault/fault.c
    ${CMAKE_SOURCE_DIR}/tests/fault/calls.c)
endforeach()

if(WIN32)
  include(windows_tests) # the program, by a script that needs no shell
  return()
endif()

if(TAUT_ALONE)
  return() # tools/same_bytes.sh compares the program with another
endif()

file(GLOB cli_tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/cli/test_*.sh)
foreach(file IN LISTS cli_tests)
  get_filename_component(short ${file} NAME_WE)
  string(REPLACE "test_" "" short ${short})
  add_test(NAME cli/${short} COMMAND sh ${file})
  set_tests_properties(cli/${short} PROPERTIES TIMEOUT 300 SKIP_RETURN_CODE 77
    ENVIRONMENT "TAUT=${CMAKE_BINARY_DIR}/bin/taut;PROBE=${CMAKE_BINARY_DIR}/tests/probe_step;SOURCE=${CMAKE_SOURCE_DIR};SOURCE_DATE_EPOCH=0;${sanitizer_options}")
endforeach()

# Forgeries of made models and random problems, against the judge from outside; by the thousand here, by the million in
# tools/forge_night.sh. The seeds are fixed: what is run is always the same.
file(GLOB forge_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/forge/*.c)
add_executable(forge ${forge_sources})
target_link_libraries(forge PRIVATE taut_test_support m)
set_target_properties(forge PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
if(TAUT_SANITIZE) # ten times slower
  set(forgeries 30)
  set(forged_problems 9)
else()
  set(forgeries 300)
  set(forged_problems 60)
endif()
add_test(NAME forge/forgeries COMMAND forge --seed 1 --count ${forgeries} --table)
add_test(NAME forge/made COMMAND forge --seed 1 --count ${forged_problems} --mode made --table)
set_tests_properties(forge/forgeries forge/made PROPERTIES TIMEOUT 600 ENVIRONMENT "${sanitizer_options}")

# A binding without headers, by Python's ctypes; a library with sanitizers needs a program that has them.
if(NOT TAUT_SANITIZE)
  add_test(NAME bindings/python COMMAND sh ${CMAKE_SOURCE_DIR}/tests/bindings/test_bindings.sh)
  set_tests_properties(bindings/python PROPERTIES TIMEOUT 120 SKIP_RETURN_CODE 77
    ENVIRONMENT "TAUT_LIBRARY=$<TARGET_FILE:taut_shared>;SOURCE=${CMAKE_SOURCE_DIR}")
endif()

# The pages of `taut view` in a browser, where there is one.
add_test(NAME viewer/page COMMAND sh ${CMAKE_SOURCE_DIR}/tests/viewer/test_page.sh)
set_tests_properties(viewer/page PROPERTIES TIMEOUT 400 SKIP_RETURN_CODE 77
  ENVIRONMENT "TAUT=${CMAKE_BINARY_DIR}/bin/taut;SOURCE=${CMAKE_SOURCE_DIR};${sanitizer_options}")

# The site made of docs/, where mkdocs and a browser are.
if(NOT TAUT_SANITIZE) # nothing of the program's
  add_test(NAME site/pages COMMAND sh ${CMAKE_SOURCE_DIR}/tests/site/test_site.sh)
  set_tests_properties(site/pages PROPERTIES TIMEOUT 400 SKIP_RETURN_CODE 77 ENVIRONMENT "SOURCE=${CMAKE_SOURCE_DIR}")
endif()

# The page of `taut studio`, where the toolchain for WebAssembly is.
if(NOT TAUT_SANITIZE) # one page, the same bytes
  add_test(NAME studio/page COMMAND sh ${CMAKE_SOURCE_DIR}/tests/studio/test_studio.sh)
  set_tests_properties(studio/page PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 77
    ENVIRONMENT "TAUT=${CMAKE_BINARY_DIR}/bin/taut;STUDIO=${TAUT_MODULE_DIR}/taut-studio.so;SOURCE=${CMAKE_SOURCE_DIR}")
endif()

# The checks of tools/ are seen to catch what they are for.
file(GLOB tool_tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/tools/test_*.sh)
foreach(file IN LISTS tool_tests)
  get_filename_component(short ${file} NAME_WE)
  string(REPLACE "test_" "" short ${short})
  add_test(NAME tools/${short} COMMAND sh ${file})
  set_tests_properties(tools/${short} PROPERTIES TIMEOUT 300 ENVIRONMENT "SOURCE=${CMAKE_SOURCE_DIR}")
endforeach()

# Each public header compiles alone, as C17 and as C++17.
file(GLOB public_headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/include/taut/*.h)
foreach(header IN LISTS public_headers)
  get_filename_component(short ${header} NAME_WE)
  foreach(language c cpp)
    set(source ${CMAKE_BINARY_DIR}/generated/headers/${short}.${language})
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"taut/${short}.h\"\n#include \"taut/${short}.h\"\nextern int taut_header_test;\n")
    list(APPEND header_sources ${source})
  endforeach()
endforeach()
add_library(test-headers OBJECT ${header_sources})
target_include_directories(test-headers PRIVATE ${CMAKE_SOURCE_DIR}/include)
target_compile_options(test-headers PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>)
