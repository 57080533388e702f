# Parts that need a heavy library, loaded when first wanted (src/core/module.h): one shared object each.
# taut_module(<name> <pkg-config package>): sources in src/modules/<name>/.
set(TAUT_MODULE_DIR ${CMAKE_BINARY_DIR}/modules)
set(TAUT_MODULE_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/taut)
function(taut_module name package)
  pkg_check_modules(${name}_dependency IMPORTED_TARGET ${package})
  if(NOT ${name}_dependency_FOUND)
    message(STATUS "Module ${name} is left out: ${package} is not installed")
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/modules/${name}/*.c)
  if(NOT sources)
    return()
  endif()
  add_library(taut_module_${name} MODULE ${sources})
  set_target_properties(taut_module_${name} PROPERTIES
    OUTPUT_NAME taut-${name} PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${TAUT_MODULE_DIR})
  target_link_libraries(taut_module_${name} PRIVATE taut_flags PkgConfig::${name}_dependency m)
  add_dependencies(product taut_module_${name})
  install(TARGETS taut_module_${name} LIBRARY DESTINATION ${TAUT_MODULE_INSTALL_DIR})
endfunction()

taut_module(cairo cairo)
set_source_files_properties(${CMAKE_SOURCE_DIR}/src/core/module.c PROPERTIES COMPILE_DEFINITIONS
  "TAUT_MODULE_BUILD_DIR=\"${TAUT_MODULE_DIR}\";TAUT_MODULE_INSTALL_DIR=\"${CMAKE_INSTALL_PREFIX}/${TAUT_MODULE_INSTALL_DIR}\"")
