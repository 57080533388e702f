# Parts that need a heavy library, loaded when first wanted (src/platform/module.h): one shared object each.
# taut_module(<name> <pkg-config package>): sources in src/modules/<name>/.
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

# Debian's FLINT comes without a pkg-config file.
find_path(FLINT_INCLUDE flint/fmpq.h)
find_library(FLINT_LIBRARY flint)
if(FLINT_INCLUDE AND FLINT_LIBRARY)
  file(GLOB exact_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/modules/exact/*.c)
  add_library(taut_module_exact MODULE ${exact_sources})
  set_target_properties(taut_module_exact PROPERTIES
    OUTPUT_NAME taut-exact PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${TAUT_MODULE_DIR})
  target_include_directories(taut_module_exact SYSTEM PRIVATE ${FLINT_INCLUDE})
  target_link_libraries(taut_module_exact PRIVATE taut_flags ${FLINT_LIBRARY} m)
  add_dependencies(product taut_module_exact)
  install(TARGETS taut_module_exact LIBRARY DESTINATION ${TAUT_MODULE_INSTALL_DIR})
else()
  message(STATUS "Module exact is left out: libflint-dev is not installed")
endif()

# taut-cad, the program that reads STEP and IGES and writes IGES (src/io/cad/wire.h), started when first wanted.
# OpenCASCADE's own CMake package breaks where libtbb-dev is absent, so its libraries are taken by name.
find_path(OCCT_INCLUDE STEPControl_Writer.hxx PATH_SUFFIXES opencascade occt)
set(OCCT_LIBRARIES)
foreach(toolkit TKSTEP TKSTEPAttr TKSTEP209 TKSTEPBase TKIGES TKXSBase TKShHealing TKTopAlgo TKGeomAlgo TKBRep
    TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OCCT_${toolkit} ${toolkit})
  list(APPEND OCCT_LIBRARIES ${OCCT_${toolkit}})
endforeach()
if(OCCT_INCLUDE AND NOT OCCT_LIBRARIES MATCHES "NOTFOUND")
  file(GLOB occt_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/cad/*.cpp)
  add_executable(taut_cad ${occt_sources} ${CMAKE_SOURCE_DIR}/src/io/cad/wire.c)
  set_target_properties(taut_cad PROPERTIES OUTPUT_NAME taut-cad RUNTIME_OUTPUT_DIRECTORY ${TAUT_HELPER_DIR})
  target_include_directories(taut_cad SYSTEM PRIVATE ${OCCT_INCLUDE})
  target_link_libraries(taut_cad PRIVATE taut_flags ${OCCT_LIBRARIES})
  if(TAUT_SANITIZE)
    # Checks of virtual tables and function types need what OpenCASCADE was not built with.
    set_source_files_properties(${occt_sources} PROPERTIES COMPILE_OPTIONS "-fno-sanitize=vptr,function")
  endif()
  add_dependencies(product taut_cad)
  install(TARGETS taut_cad RUNTIME DESTINATION ${TAUT_HELPER_INSTALL_DIR})
else()
  message(STATUS "taut-cad is left out: libocct-data-exchange-dev is not installed")
endif()
