# What `cmake --install` puts where: headers, the shared libraries, taut.pc and taut-draw.pc, a CMake package, manual pages, completion for
# bash, examples; and the same as a Debian package.
include(CMakePackageConfigHelpers)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/taut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
target_include_directories(taut_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
set_target_properties(taut_shared PROPERTIES EXPORT_NAME taut)
set_target_properties(taut_draw_shared PROPERTIES EXPORT_NAME draw)
install(TARGETS taut_shared taut_draw_shared EXPORT taut-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_COMPONENT Development)
install(EXPORT taut-targets NAMESPACE taut:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/taut)

file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/taut-config.cmake @ONLY
  CONTENT "include(\"\${CMAKE_CURRENT_LIST_DIR}/taut-targets.cmake\")\n")
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/taut-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/taut-config.cmake ${CMAKE_BINARY_DIR}/generated/taut-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/taut)

# The prefix is found from where taut.pc lies, so that the whole can be moved.
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up "${up}")
function(taut_pkg_config name description rest)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/${name}.pc @ONLY CONTENT
"prefix=\${pcfiledir}/${up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: ${name}
Description: ${description}
Version: ${PROJECT_VERSION}
${rest}Libs: -L\${libdir} -l${name}
Libs.private: -lm
Cflags: -I\${includedir}
")
  install(FILES ${CMAKE_BINARY_DIR}/generated/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
taut_pkg_config(taut "${PROJECT_DESCRIPTION}" "")
taut_pkg_config(taut-draw "Figures and pages of the surfaces of taut" "Requires: taut = ${PROJECT_VERSION}\n")

# Pages and completion, made of what the program says of itself, of the headers and of the reference of the documents.
set(made ${CMAKE_BINARY_DIR}/generated)
function(taut_made file)
  cmake_parse_arguments(PARSE_ARGV 1 made "" "" "FROM;COMMAND")
  list(GET made_COMMAND 0 script)
  add_custom_command(OUTPUT ${made}/${file}
    COMMAND sh ${made_COMMAND} > ${made}/${file}.new
    COMMAND ${CMAKE_COMMAND} -E rename ${made}/${file}.new ${made}/${file}
    DEPENDS ${made_FROM} ${script} taut_program VERBATIM)
endfunction()
taut_made(taut.1 COMMAND ${CMAKE_SOURCE_DIR}/tools/manual.sh $<TARGET_FILE:taut_program>)
taut_made(taut.bash COMMAND ${CMAKE_SOURCE_DIR}/tools/completion.sh $<TARGET_FILE:taut_program>)
taut_made(taut.5 FROM ${CMAKE_SOURCE_DIR}/docs/format.md
  COMMAND ${CMAKE_SOURCE_DIR}/tools/manual_documents.sh ${PROJECT_VERSION} ${CMAKE_SOURCE_DIR}/docs/format.md)
file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/include/taut/*.h)
foreach(header IN LISTS headers) # taut.h is taut(3), any other taut_<header>(3)
  get_filename_component(short ${header} NAME_WE)
  set(page taut_${short}.3)
  if(short STREQUAL taut)
    set(page taut.3)
    set(short)
  endif()
  taut_made(${page} FROM ${headers} ${CMAKE_SOURCE_DIR}/tools/headers.awk
    COMMAND ${CMAKE_SOURCE_DIR}/tools/manual_library.sh ${PROJECT_VERSION} ${CMAKE_SOURCE_DIR}/include/taut/taut.h ${short})
  list(APPEND library_pages ${made}/${page})
endforeach()
add_custom_target(manual ALL DEPENDS ${made}/taut.1 ${library_pages} ${made}/taut.5 ${made}/taut.bash)
add_dependencies(product manual)
install(FILES ${made}/taut.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${library_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man3)
install(FILES ${made}/taut.5 DESTINATION ${CMAKE_INSTALL_MANDIR}/man5)
install(FILES ${made}/taut.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME taut)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples/c DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(FILES ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# A Debian package of all of it: `cpack -G DEB` in the build folder.
set(CPACK_PACKAGE_NAME taut)
# A packager's name and address, as Debian's own tools take them; without one an address that is none (RFC 2606).
if(DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(CPACK_PACKAGE_CONTACT "The authors of Taut <authors@taut.invalid>")
endif()
set(CPACK_PACKAGE_DESCRIPTION "Builds free-form surfaces from what bounds them, and proves what it built:
a library with headers, and the program taut.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_PACKAGE_DIRECTORY_OF_BUILD ${CMAKE_BINARY_DIR})
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/deb.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/deb_finish.cmake)
# Programs linked with these libraries need this package; the system's list of libraries is made anew when it comes and goes.
file(WRITE ${CMAKE_BINARY_DIR}/generated/deb/shlibs
  "libtaut 0 taut (>= ${PROJECT_VERSION})\nlibtaut-draw 0 taut (>= ${PROJECT_VERSION})\n")
file(WRITE ${CMAKE_BINARY_DIR}/generated/deb/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/generated/deb/shlibs ${CMAKE_BINARY_DIR}/generated/deb/triggers)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "pkg-config, cmake")
include(CPack)
