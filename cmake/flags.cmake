# Flags of all of taut's own code. No stack frame is above 64 kB, as threads of musl and WebAssembly have little (sanitizers and
# debugging make larger ones).
add_library(taut_flags INTERFACE)
target_compile_options(taut_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wvla -fno-math-errno
  $<$<CONFIG:Release>:-Wframe-larger-than=65536>
  $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes;-Wmissing-prototypes>
  -ffp-contract=off -fvisibility=hidden $<$<NOT:$<PLATFORM_ID:Windows>>:-fPIC>)
target_compile_definitions(taut_flags INTERFACE _POSIX_C_SOURCE=200809L _XOPEN_SOURCE=700)
target_include_directories(taut_flags INTERFACE
  ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/src)
if(WIN32)
  # The stack there is aligned to 16 bytes, and gcc keeps vectors of 32 and 64 on it as if it were not: no move asks for more.
  target_compile_options(taut_flags INTERFACE -Wa,-muse-unaligned-vector-move
    -Wno-float-conversion) # MinGW's isfinite() and its like convert in branches that are not taken
  # Numbers are written and read by MinGW, not by the C library of the system.
  target_compile_definitions(taut_flags INTERFACE __USE_MINGW_ANSI_STDIO=1 _WIN32_WINNT=0x0601 UNICODE)
  target_link_options(taut_flags INTERFACE -static-libgcc)
endif()
if(TAUT_WERROR)
  target_compile_options(taut_flags INTERFACE -Werror)
endif()
if(TAUT_SANITIZE)
  target_compile_options(taut_flags INTERFACE
    -fsanitize=${TAUT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # A sanitizer finds the functions behind C++ exceptions, which OpenCASCADE throws, only where it begins.
  target_link_options(taut_flags INTERFACE -fsanitize=${TAUT_SANITIZE}
    -Wl,--push-state,--no-as-needed -lstdc++ -Wl,--pop-state)
endif()
# Edges are counted for the fuzzer. Tracing every comparison as well (-fsanitize=fuzzer-no-link) makes the tests, which
# share these objects, four times slower; dictionaries and a mutator that knows documents do its work.
if(TAUT_FUZZ)
  target_compile_options(taut_flags INTERFACE -fsanitize-coverage=inline-8bit-counters,pc-table)
endif()
