# Read by cpack when it packs: what the Debian package needs of other packages, as dpkg-shlibdeps finds it in what was built. What is
# loaded or started when first wanted, and heavy, is recommended and not needed: OpenCASCADE behind taut-cad, FLINT.
cmake_policy(VERSION 3.25)
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
find_program(TAUT_SHLIBDEPS dpkg-shlibdeps REQUIRED)
set(build ${CPACK_PACKAGE_DIRECTORY_OF_BUILD})
set(room ${build}/generated/deb)
file(WRITE ${room}/debian/control "Source: taut\n\nPackage: taut\nArchitecture: any\n")

# dependencies(<variable> <files...>): those that were built
function(dependencies variable)
  set(found)
  foreach(file IN LISTS ARGN)
    if(EXISTS ${build}/${file})
      list(APPEND found -e${build}/${file})
    endif()
  endforeach()
  if(NOT found)
    return()
  endif()
  execute_process(COMMAND ${TAUT_SHLIBDEPS} -O -l${build} --ignore-missing-info ${found} WORKING_DIRECTORY ${room}
    OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE code OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT code EQUAL 0 OR NOT said MATCHES "^shlibs:Depends=(.*)$")
    message(FATAL_ERROR "dpkg-shlibdeps: ${said} ${complaint}")
  endif()
  set(${variable} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

dependencies(CPACK_DEBIAN_PACKAGE_DEPENDS bin/taut libtaut.so libtaut-draw.so modules/taut-cairo.so)
dependencies(CPACK_DEBIAN_PACKAGE_RECOMMENDS libexec/taut-cad modules/taut-exact.so)
