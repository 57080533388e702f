# The program `taut`: one file per command, public headers only; examples and paper tables are built in.
file(GLOB_RECURSE program_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/cli/*.c)
file(GLOB example_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/examples/*.json)
file(GLOB paper_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/data/papers/*.json)
file(GLOB schema_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/schema/*.json)
taut_embed(${CMAKE_BINARY_DIR}/generated/examples.c taut_examples cli/embedded_files.h taut_embedded ${example_files})
taut_embed(${CMAKE_BINARY_DIR}/generated/papers.c taut_papers cli/embedded_files.h taut_embedded ${paper_files})
taut_embed(${CMAKE_BINARY_DIR}/generated/schemas.c taut_schemas cli/embedded_files.h taut_embedded ${schema_files})
taut_embed(${CMAKE_BINARY_DIR}/generated/titles.c taut_titles cli/embedded_files.h taut_embedded ${CMAKE_SOURCE_DIR}/examples/titles.txt)
taut_embed(${CMAKE_BINARY_DIR}/generated/pages.c taut_pages cli/embedded_files.h taut_embedded
  ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/docs/architecture.md ${CMAKE_SOURCE_DIR}/docs/certificate.md
  ${CMAKE_SOURCE_DIR}/docs/format.md)
add_library(taut_embedded_files STATIC
  ${CMAKE_BINARY_DIR}/generated/examples.c ${CMAKE_BINARY_DIR}/generated/papers.c
  ${CMAKE_BINARY_DIR}/generated/schemas.c ${CMAKE_BINARY_DIR}/generated/titles.c
  ${CMAKE_BINARY_DIR}/generated/pages.c)
target_link_libraries(taut_embedded_files PUBLIC taut_flags)
if(program_sources)
  add_executable(taut_program ${program_sources})
  set_target_properties(taut_program PROPERTIES OUTPUT_NAME taut)
  target_link_libraries(taut_program PRIVATE taut_draw_static taut_embedded_files)
  if(WIN32)
    target_link_options(taut_program PRIVATE -Wl,--stack,8388608)
    # CMake has every program's linker write a list of what it exports: not in the place of the library's
    set_target_properties(taut_program PROPERTIES ARCHIVE_OUTPUT_NAME taut-program)
  endif()
  add_dependencies(product taut_program)
  install(TARGETS taut_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
