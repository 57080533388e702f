# Run by cpack over the files of a Debian package before it packs them: pages and the list of changes are compressed there, as Debian
# wants them; `cmake --install` leaves them as they are.
cmake_policy(VERSION 3.25)
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
find_program(TAUT_GZIP gzip REQUIRED)
set(root ${CPACK_TEMPORARY_DIRECTORY}/usr/share)
file(GLOB pages ${root}/man/man*/*.[0-9])
set(changes ${root}/doc/taut/changelog)
# SOURCE_DATE_EPOCH, where it is set, is the time of a package that is made again byte for byte.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${changes} "taut (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * What moved is in CHANGELOG.md beside this file.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND ${TAUT_GZIP} -9n ${pages} ${changes} COMMAND_ERROR_IS_FATAL ANY)
