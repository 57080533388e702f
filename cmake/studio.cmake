# The module of `taut studio`: its page as a table of one file. Built where the toolchain for WebAssembly is found (tools/deps.sh wasm),
# apart from `product`, since compiling the library a second time takes a minute.
if(TAUT_SANITIZE OR TAUT_BENCH)
  return() # one page, the same bytes
endif()
set(TAUT_STUDIO_MISSING)
foreach(tool clang wasm-ld wasm-opt esbuild gzip base64)
  find_program(TAUT_STUDIO_${tool} ${tool})
  if(NOT TAUT_STUDIO_${tool})
    list(APPEND TAUT_STUDIO_MISSING ${tool})
  endif()
endforeach()
file(GLOB wasm_builtins /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a)
if(NOT EXISTS /usr/include/wasm32-wasi/stdlib.h OR NOT wasm_builtins)
  list(APPEND TAUT_STUDIO_MISSING wasi-libc)
endif()
if(TAUT_STUDIO_MISSING)
  list(JOIN TAUT_STUDIO_MISSING ", " missing)
  message(STATUS "Module studio is left out: ${missing} not installed (tools/deps.sh wasm)")
  add_custom_target(studio COMMENT "The studio is left out: ${missing} not installed (tools/deps.sh wasm)")
  return()
endif()

set(studio_wasm ${CMAKE_BINARY_DIR}/wasm/bin/taut.wasm)
set(studio_page ${CMAKE_BINARY_DIR}/generated/studio.html)
file(GLOB_RECURSE studio_library CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*.[ch] ${CMAKE_SOURCE_DIR}/include/*.h)
list(FILTER studio_library EXCLUDE REGEX "/src/(cli|modules|page)/")
add_custom_command(OUTPUT ${studio_wasm}
  COMMAND ${CMAKE_COMMAND} --preset wasm -DTAUT_WEB_NETS=ON -B ${CMAKE_BINARY_DIR}/wasm --log-level=WARNING
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/wasm
  COMMAND ${CMAKE_COMMAND} -E touch ${studio_wasm}
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} COMMENT "The library as WebAssembly, for the studio" VERBATIM
  DEPENDS ${studio_library} ${CMAKE_SOURCE_DIR}/cmake/web.cmake ${CMAKE_SOURCE_DIR}/cmake/wasi.cmake)
file(GLOB studio_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/studio/*)
add_custom_command(OUTPUT ${studio_page}
  COMMAND sh ${CMAKE_SOURCE_DIR}/studio/bundle.sh ${studio_wasm} ${PROJECT_VERSION} ${studio_page}
  COMMENT "The page of the studio" VERBATIM
  DEPENDS ${studio_wasm} ${studio_files} ${example_files} ${CMAKE_SOURCE_DIR}/web/taut.mjs ${CMAKE_SOURCE_DIR}/docs/schema/problem.json
          ${CMAKE_SOURCE_DIR}/src/page/viewer/three/three.min.js)
taut_embed(${CMAKE_BINARY_DIR}/generated/studio.c taut_module_table cli/embedded_files.h taut_embedded ${studio_page})
add_library(taut_module_studio MODULE ${CMAKE_BINARY_DIR}/generated/studio.c)
set_target_properties(taut_module_studio PROPERTIES
  OUTPUT_NAME taut-studio PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${TAUT_MODULE_DIR})
target_include_directories(taut_module_studio PRIVATE ${CMAKE_SOURCE_DIR}/src) # a table alone: seen from outside, no flags of code
add_custom_target(studio DEPENDS taut_module_studio)
install(TARGETS taut_module_studio LIBRARY DESTINATION ${TAUT_MODULE_INSTALL_DIR} OPTIONAL)
