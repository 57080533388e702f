# libtaut: every source of every layer but the program's, the modules' and those of libtaut-draw.
add_custom_target(product) # all that is installed, without tests and benchmarks

if(WIN32)
  set(system_libraries advapi32 shell32) # chance, and the words of the command line
  set(other_systems "/platform/(posix|posix_helper|unix|wasi).c|/io/cad/(answer|cad|helper|wire).c")
else()
  find_package(PkgConfig REQUIRED)
  find_package(Threads REQUIRED)
  set(system_libraries Threads::Threads m dl)
  set(other_systems "/platform/(windows|wasi).c|/io/cad/absent.c")
endif()

file(GLOB_RECURSE library_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*.c)
list(FILTER library_sources EXCLUDE REGEX "/src/(cli|draw|modules|page|web)/|${other_systems}")

# The page of `taut view`: our scripts and the part of three.js they need (src/page/viewer/three/bundle.sh makes it).
file(GLOB viewer_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/page/viewer/page.* ${CMAKE_SOURCE_DIR}/src/page/viewer/script/*.js)
taut_embed(${CMAKE_BINARY_DIR}/generated/viewer.c taut_viewer_files page/viewer_files.h taut_viewer_file
  ${viewer_files} ${CMAKE_SOURCE_DIR}/src/page/viewer/three/three.min.js)

add_library(taut_objects OBJECT ${library_sources})
target_link_libraries(taut_objects PUBLIC taut_flags ${system_libraries})

add_library(taut_static STATIC $<TARGET_OBJECTS:taut_objects>)
set_target_properties(taut_static PROPERTIES OUTPUT_NAME taut)
target_link_libraries(taut_static PUBLIC taut_flags ${system_libraries})

add_library(taut_shared SHARED $<TARGET_OBJECTS:taut_objects>)
set_target_properties(taut_shared PROPERTIES OUTPUT_NAME taut VERSION ${PROJECT_VERSION} SOVERSION 0)
target_link_libraries(taut_shared PRIVATE taut_flags ${system_libraries})
if(WIN32)
  # The objects are those of programs too, so a list says what leaves the DLL.
  file(STRINGS ${CMAKE_SOURCE_DIR}/tools/symbols.txt symbols REGEX "^taut_")
  list(JOIN symbols "\n" symbols)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/taut.def CONTENT "EXPORTS\n${symbols}\n" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tools/symbols.txt)
  target_sources(taut_shared PRIVATE ${CMAKE_BINARY_DIR}/generated/taut.def)
  target_compile_definitions(taut_objects PRIVATE TAUT_STATIC)
  target_compile_definitions(taut_static INTERFACE TAUT_STATIC)
  set_target_properties(taut_shared PROPERTIES RUNTIME_OUTPUT_NAME taut-0) # libtaut-0.dll; its import library is libtaut.dll.a
endif()
add_dependencies(product taut_shared)

# libtaut-draw: figures and pages. It stands on what libtaut keeps to itself, too: the shared library has that of it from the
# archive, hidden, and all that is public from libtaut.so, which stands before the archive.
file(GLOB_RECURSE draw_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/draw/*.c ${CMAKE_SOURCE_DIR}/src/page/*.c)
add_library(taut_draw_objects OBJECT ${draw_sources} ${CMAKE_BINARY_DIR}/generated/viewer.c)
target_link_libraries(taut_draw_objects PUBLIC taut_flags)

add_library(taut_draw_static STATIC $<TARGET_OBJECTS:taut_draw_objects>)
set_target_properties(taut_draw_static PROPERTIES OUTPUT_NAME taut-draw)
target_link_libraries(taut_draw_static PUBLIC taut_static)

add_library(taut_draw_shared SHARED $<TARGET_OBJECTS:taut_draw_objects>)
set_target_properties(taut_draw_shared PROPERTIES OUTPUT_NAME taut-draw VERSION ${PROJECT_VERSION} SOVERSION 0)
if(WIN32)
  # An import library defines what the archive does: here the DLL has all it needs from the archive, and shares no code.
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/taut_draw.def CONTENT "EXPORTS\ntaut_draw_formats\n" @ONLY)
  target_sources(taut_draw_shared PRIVATE ${CMAKE_BINARY_DIR}/generated/taut_draw.def)
  target_link_libraries(taut_draw_shared PRIVATE taut_static)
  target_compile_definitions(taut_draw_objects PRIVATE TAUT_STATIC)
  set_target_properties(taut_draw_shared PROPERTIES RUNTIME_OUTPUT_NAME taut-draw-0)
else()
  target_link_libraries(taut_draw_shared PUBLIC taut_shared PRIVATE taut_flags $<TARGET_FILE:taut_static> ${system_libraries})
  if(NOT APPLE) # whose linker has no such thing; hidden symbols stay hidden there
    target_link_options(taut_draw_shared PRIVATE -Wl,--exclude-libs,$<TARGET_FILE_NAME:taut_static>)
  endif()
  add_dependencies(taut_draw_shared taut_static)
endif()
add_dependencies(product taut_draw_shared)

# Kernels for one instruction set each, chosen at run time. None may fuse a product with a sum: all give the same bytes.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  file(GLOB_RECURSE avx2_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*avx2.c)
  file(GLOB_RECURSE avx512_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*avx512.c)
  list(FILTER avx2_sources EXCLUDE REGEX "/numeric/kernel/") # these name their instruction set themselves
  list(FILTER avx512_sources EXCLUDE REGEX "/numeric/kernel/")
  set_source_files_properties(${avx2_sources} PROPERTIES COMPILE_OPTIONS "-mavx2")
  set_source_files_properties(${avx512_sources} PROPERTIES COMPILE_OPTIONS "-mavx512f;-mavx2")
endif()
