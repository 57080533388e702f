# Toolchain file: 64-bit ARM with Debian's cross compiler, run by qemu (tools/deps.sh nightly). Static, so that nothing of that
# processor need be installed; there are no modules and no C++.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(TAUT_ALONE ON)
