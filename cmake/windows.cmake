# What `make windows` leaves: one zip with the program, the library, what one builds against it, and how to.
install(TARGETS taut_shared RUNTIME DESTINATION bin ARCHIVE DESTINATION lib)
install(TARGETS taut_static ARCHIVE DESTINATION lib)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/taut DESTINATION include)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/CHANGELOG.md
  ${CMAKE_SOURCE_DIR}/docs/windows.md DESTINATION .)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples/c DESTINATION examples)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # the zip needs no tests
set(CPACK_GENERATOR ZIP)
set(CPACK_PACKAGE_FILE_NAME taut-${PROJECT_VERSION}-windows-x86_64)
set(CPACK_STRIP_FILES ON)
include(CPack)
