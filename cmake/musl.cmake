# Toolchain file: this processor with musl for a C library, by Debian's wrapper of gcc (tools/deps.sh nightly). Static, so that the
# program runs beside glibc; there are no modules and no C++.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER musl-gcc)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(TAUT_ALONE ON)
