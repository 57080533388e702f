# What `cmake --install` puts where: headers, the shared library, taut.pc, a CMake package, the manual page.
include(CMakePackageConfigHelpers)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/taut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
target_include_directories(taut_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
set_target_properties(taut_shared PROPERTIES EXPORT_NAME taut)
install(TARGETS taut_shared EXPORT taut-targets
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
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/taut.pc @ONLY CONTENT
"prefix=\${pcfiledir}/${up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: taut
Description: ${PROJECT_DESCRIPTION}
Version: ${PROJECT_VERSION}
Libs: -L\${libdir} -ltaut
Libs.private: -lm
Cflags: -I\${includedir}
")
install(FILES ${CMAKE_BINARY_DIR}/generated/taut.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(manual_page ${CMAKE_BINARY_DIR}/generated/taut.1)
add_custom_command(OUTPUT ${manual_page}
  COMMAND sh ${CMAKE_SOURCE_DIR}/tools/manual.sh $<TARGET_FILE:taut_program> > ${manual_page}.new
  COMMAND ${CMAKE_COMMAND} -E rename ${manual_page}.new ${manual_page}
  DEPENDS taut_program ${CMAKE_SOURCE_DIR}/tools/manual.sh VERBATIM)
add_custom_target(manual ALL DEPENDS ${manual_page})
add_dependencies(product manual)
install(FILES ${manual_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
