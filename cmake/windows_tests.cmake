# What the program for Windows does against what the native one does; what is asked of the system; and a program of the DLL.
set(TAUT_NATIVE ${CMAKE_SOURCE_DIR}/build/release/bin/taut CACHE FILEPATH "The native program that the one for Windows is compared with")
# By its path: an executable target would be run by wine, for which every program that is not for Windows ends with 0, and
# whose own server is then there before the one that is to stay. `windows/failure` sees that what fails is seen.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

if(CMAKE_CROSSCOMPILING_EMULATOR)
  add_test(NAME windows/wine COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/windows/start_wine.py ${CMAKE_CROSSCOMPILING_EMULATOR})
  set_tests_properties(windows/wine PROPERTIES FIXTURES_SETUP wine TIMEOUT 240 ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1${wine_options}")
endif()
add_test(NAME windows/compare COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/windows/compare.py
  ${TAUT_NATIVE} ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:taut_program>)
set_tests_properties(windows/compare PROPERTIES PROCESSORS 2)
add_test(NAME windows/failure COMMAND ${Python3_EXECUTABLE} -c "raise SystemExit(1)")
set_tests_properties(windows/failure PROPERTIES WILL_FAIL TRUE)
add_test(NAME windows/imports COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/windows/imports.py
  ${CMAKE_OBJDUMP} $<TARGET_FILE:taut_program> $<TARGET_FILE:taut_shared>)

add_executable(windows-interrupt ${CMAKE_SOURCE_DIR}/tests/windows/interrupt.c)
target_link_libraries(windows-interrupt PRIVATE taut_static)
add_test(NAME windows/interrupt COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/windows/interrupt.py
  ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:windows-interrupt>)

file(GLOB example_programs CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/examples/c/*.c)
set(windows_tests windows/compare windows/failure windows/imports windows/interrupt)
foreach(file IN LISTS example_programs)
  get_filename_component(short ${file} NAME_WE)
  add_executable(example-${short} ${file})
  target_link_libraries(example-${short} PRIVATE taut_draw_shared taut_shared)
  target_include_directories(example-${short} PRIVATE ${CMAKE_SOURCE_DIR}/include)
  set(words)
  if(short STREQUAL build)
    set(words ${CMAKE_SOURCE_DIR}/examples/harmonic-rows.json ${CMAKE_BINARY_DIR}/tests/rows.obj ${CMAKE_BINARY_DIR}/tests/rows.svg)
  endif()
  add_test(NAME windows/dll-${short} COMMAND example-${short} ${words} WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  list(APPEND windows_tests windows/dll-${short})
endforeach()
set_tests_properties(${windows_tests} PROPERTIES TIMEOUT 600 FIXTURES_REQUIRED wine ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1${wine_options}")
