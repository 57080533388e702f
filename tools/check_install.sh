#!/bin/sh
# check_install.sh [BUILD] -- installs a build into an empty folder and uses it as a stranger would: the C program of the
# README by pkg-config, the same as C++ by the CMake package, the program `taut` from where it was put.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
build=$(cd "$build" && pwd)
work=$(mktemp -d)
cleanup() {
    if [ -d "$work/modules" ]; then
        mv "$work/modules" "$build/modules"
    fi
    rm -rf "$work"
}
trap cleanup EXIT
prefix=$work/prefix

cmake --install "$build" --prefix "$prefix" > "$work/log" || { cat "$work/log"; exit 1; }
pc=$(find "$prefix" -name taut.pc)
lib=$(dirname "$(dirname "$pc")")
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH

# The first block of C in the README is a whole program.
awk '/^```c$/ { on = 1; next } /^```/ { if (on) exit } on' README.md > "$work/example.c"
grep -q 'int main' "$work/example.c" || { echo "check_install: no program in README.md"; exit 1; }
cd "$work"
# shellcheck disable=SC2046
gcc -std=c17 -Wall -Wextra -Wpedantic -Werror example.c $(pkg-config --cflags --libs taut) -o example
LD_LIBRARY_PATH=$lib ./example | tee said
grep -q 'height -0\.5$' said || { echo "check_install: the README's program says something else than the README"; exit 1; }

mkdir cmake
cat > cmake/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(stranger CXX)
find_package(taut 0.1 REQUIRED)
add_executable(stranger stranger.cpp)
target_link_libraries(stranger PRIVATE taut::taut)
END
printf '%s\n' '#include <taut/taut.h>' '#include <cstdio>' \
    'int main() { std::puts(taut_version()); return taut_construct_count() > 0 ? 0 : 1; }' > cmake/stranger.cpp
if ! { cmake -S cmake -B cmake/build -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" && cmake --build cmake/build; } > log 2>&1
then
    cat log
    exit 1
fi
version=$(LD_LIBRARY_PATH=$lib cmake/build/stranger)

# The installed program draws with the modules that were installed; those of the build are put out of its sight.
mv "$build/modules" "$work/modules"
found=$(pkg-config --modversion taut)
[ "$version" = "$found" ] || { echo "check_install: the library is $version, taut.pc says $found"; exit 1; }
case $("$prefix/bin/taut" --version) in *"$version"*) ;; *) echo "check_install: taut --version differs"; exit 1 ;; esac
"$prefix/bin/taut" example dirichlet-tent > problem.json
"$prefix/bin/taut" make --quiet problem.json -o picture.png
test -s picture.png
grep -q '^\.SS make$' "$prefix/share/man/man1/taut.1" || { echo "check_install: no manual page"; exit 1; }
echo "version $version, installed and used"
