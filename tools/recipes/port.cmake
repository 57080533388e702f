# port.cmake -- vcpkg's words, as far as packaging/vcpkg says them: installs into PACKAGES what the port at PORT says.
set(CURRENT_PORT_DIR ${PORT})
set(CURRENT_PACKAGES_DIR ${PACKAGES})
set(build ${PORT}/../../build/vcpkg)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

function(need path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "the port names ${path}, which is not there")
  endif()
endfunction()

function(vcpkg_check_linkage linkage)
  if(NOT linkage STREQUAL "ONLY_DYNAMIC_LIBRARY")
    message(FATAL_ERROR "linkage ${linkage}")
  endif()
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 asked "" "SOURCE_PATH" "OPTIONS")
  run(cmake -S ${asked_SOURCE_PATH} -B ${build} -G Ninja ${asked_OPTIONS} -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON
    -DCMAKE_INSTALL_PREFIX=${PACKAGES} -DCMAKE_INSTALL_LIBDIR=lib)
endfunction()

function(vcpkg_cmake_install)
  run(cmake --build ${build} --target install)
endfunction()

# Where CMake looks in a tree of vcpkg's; the configuration still finds what it names.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 asked "" "PACKAGE_NAME;CONFIG_PATH" "")
  need(${PACKAGES}/${asked_CONFIG_PATH})
  file(GLOB files ${PACKAGES}/${asked_CONFIG_PATH}/*-config.cmake ${PACKAGES}/${asked_CONFIG_PATH}/*Config.cmake)
  if(NOT files)
    message(FATAL_ERROR "no configuration of ${asked_PACKAGE_NAME} at ${asked_CONFIG_PATH}")
  endif()
endfunction()

function(vcpkg_fixup_pkgconfig)
  need(${PACKAGES}/lib/pkgconfig/taut.pc)
endfunction()

function(vcpkg_copy_tools)
  cmake_parse_arguments(PARSE_ARGV 0 asked "AUTO_CLEAN" "" "TOOL_NAMES")
  foreach(tool IN LISTS asked_TOOL_NAMES)
    need(${PACKAGES}/bin/${tool})
    file(COPY ${PACKAGES}/bin/${tool} DESTINATION ${PACKAGES}/tools/taut)
  endforeach()
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 asked "" "" "FILE_LIST")
  foreach(path IN LISTS asked_FILE_LIST)
    need(${path})
  endforeach()
endfunction()

include(${PORT}/portfile.cmake)
