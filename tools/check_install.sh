#!/bin/sh
# check_install.sh [BUILD] -- installs a build into an empty folder and uses it as a stranger would: the C program of the
# README and those of examples/c by pkg-config, C++ by the CMake package, the program `taut` from where it was put, its
# pages and its completion. Then the same files as a Debian package.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
build=$(cd "$build" && pwd)
source=$PWD
work=$(mktemp -d)
cleanup() {
    for part in modules libexec; do
        if [ -d "$work/$part" ]; then
            mv "$work/$part" "$build/$part"
        fi
    done
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
awk '/^```json$/ { on = 1; next } /^```/ { if (on) exit } on' README.md > "$work/tent.json"
grep -q 'int main' "$work/example.c" || { echo "check_install: no program in README.md"; exit 1; }
cd "$work"
# shellcheck disable=SC2046
gcc -std=c17 -Wall -Wextra -Wpedantic -Werror example.c $(pkg-config --cflags --libs taut) -o example
LD_LIBRARY_PATH=$lib ./example | tee said
grep -q 'height -0\.5$' said || { echo "check_install: the README's program says something else than the README"; exit 1; }


fail() {
    echo "check_install: $*"
    exit 1
}

# Programs are linked with the name that only changes when old ones would break.
readelf -d "$lib/libtaut.so" | grep -q 'SONAME.*\[libtaut\.so\.0\]' || fail "the soname is not libtaut.so.0"
readelf -d example | grep -q 'NEEDED.*\[libtaut\.so\.0\]' || fail "a program does not ask for libtaut.so.0"
readelf -d "$lib/libtaut-draw.so" | grep -q 'NEEDED.*\[libtaut\.so\.0\]' || fail "libtaut-draw.so does not ask for libtaut.so.0"
readelf -d "$lib/libtaut-draw.so" | grep -q 'SONAME.*\[libtaut-draw\.so\.0\]' || fail "the soname is not libtaut-draw.so.0"

# The three programs of examples/c, each by the line in its head.
for program in "$source"/examples/c/*.c; do
    cp "$program" .
    line=$(sed -n 's/^ \* *\(cc .* -o .*\)$/\1/p' "$program")
    [ -n "$line" ] || fail "$program does not say how it is compiled"
    sh -c "$line -Wall -Wextra -Werror" || fail "$program: $line"
done
export LD_LIBRARY_PATH="$lib"
./saddle > said && grep -q 'agrees with the formula to 14 digits' said || fail "saddle says $(cat said)"
./film > said && [ "$(grep -c ' holds$' said)" = 4 ] && [ -s film.obj ] || fail "film says $(cat said)"
"$prefix/bin/taut" example harmonic-rows > rows.json
./build rows.json rows.obj rows.svg > said && grep -q 'harmonic: .* holds$' said && [ -s rows.obj ] && [ -s rows.svg ] ||
    fail "build says $(cat said)"
unset LD_LIBRARY_PATH

mkdir cmake
cat > cmake/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(stranger CXX)
find_package(taut 0.2 REQUIRED)
add_executable(stranger stranger.cpp)
target_link_libraries(stranger PRIVATE taut::draw)
END
printf '%s\n' '#include <taut/taut.h>' '#include <cstdio>' \
    'int main() { std::puts(taut_version()); return taut_construct_count() > 0 && taut_formats_ending(taut_draw_formats(), "a.svg", NULL) != NULL ? 0 : 1; }' > cmake/stranger.cpp
if ! { cmake -S cmake -B cmake/build -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" && cmake --build cmake/build; } > log 2>&1
then
    cat log
    exit 1
fi
version=$(LD_LIBRARY_PATH=$lib cmake/build/stranger)

# The installed program draws with the modules that were installed, and reads CAD files with the taut-cad that was; those of the
# build are put out of its sight.
mv "$build/modules" "$work/modules"
if [ -d "$build/libexec" ]; then
    mv "$build/libexec" "$work/libexec"
fi
found=$(pkg-config --modversion taut)
[ "$version" = "$found" ] || { echo "check_install: the library is $version, taut.pc says $found"; exit 1; }
case $("$prefix/bin/taut" --version) in *"$version"*) ;; *) echo "check_install: taut --version differs"; exit 1 ;; esac
"$prefix/bin/taut" example dirichlet-tent > problem.json
"$prefix/bin/taut" make --quiet problem.json -o picture.png
test -s picture.png
if [ -x "$prefix/libexec/taut/taut-cad" ]; then
    "$prefix/bin/taut" make --quiet problem.json -o part.step -o part.igs
    "$prefix/bin/taut" convert part.step -o part.json
    (cd / && PATH=$prefix/bin:$PATH && taut convert "$work/part.igs" -o "$work/again.json") || fail "taut-cad is not found"
    test -s part.json
    test -s again.json
fi

# Each command, construction and basis has its place in the pages; bash completes commands, options and names.
for command in $("$prefix/bin/taut" --help | sed -n 's/^  taut \([a-z]*\)  .*/\1/p'); do
    grep -q "^\.SS $command\$" "$prefix/share/man/man1/taut.1" || fail "taut(1) has no section $command"
done
for construct in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z-]*\)".*/\1/p' "$source/src/problem/construct_list.h"); do
    name=$(echo "$construct" | sed 's/-/\\\\-/g')
    grep -q "^\.SS .*$name" "$prefix/share/man/man5/taut.5" || fail "taut(5) has no section $construct"
done
# So has each header, and each function of the library; and troff has nothing to say about the pages.
for header in "$source"/include/taut/*.h; do
    page=$(basename "$header" .h | sed 's/^taut$//; s/^./_&/')
    [ -s "$prefix/share/man/man3/taut$page.3" ] || fail "there is no page taut$page(3)"
done
while read -r symbol; do
    page=$(sed -n "s/^$symbol  *\(taut_[a-z]*\)(3)\$/\1/p" "$prefix/share/man/man3/taut.3")
    grep -q "[ *]$symbol(" "$prefix/share/man/man3/$page.3" || fail "taut(3) does not lead to $symbol"
done <<END
$(cat "$source/tools/symbols.txt" "$source/tools/symbols_draw.txt")
END
if command -v man > /dev/null; then
    for page in "$prefix"/share/man/man?/taut*; do
        LC_ALL=C.UTF-8 man --warnings -l "$page" 2>&1 > /dev/null | grep . && fail "man does not like $page"
    done
fi
cat > complete.bash <<'END'
. "$1/share/bash-completion/completions/taut"
ask() { # ask WORD...: what the last word may become
    COMP_WORDS=("$PREFIX/bin/taut" "$@") COMP_CWORD=$#
    _taut
    echo "${COMPREPLY[*]}"
}
PREFIX=$1
ask me
ask make --rep
ask example dirichlet-te
ask make --threads ''
ask panels --kind ''
ask join nothing-here u
END
bash complete.bash "$prefix" > said
printf '%s\n' measure --report dirichlet-tent '' 'conical circular' 'u0 u1' | cmp -s - said || fail "completion offers $(cat said)"
mv "$work/modules" "$build/modules"
if [ -d "$work/libexec" ]; then
    mv "$work/libexec" "$build/libexec"
fi

(cd "$build" && cpack -G DEB -B "$work/deb") > log 2>&1 || { cat log; fail "no Debian package"; }
package=$(echo "$work"/deb/taut_*.deb)
dpkg-deb -x "$package" "$work/root"
(cd "$prefix" && find . ! -type d | sort) > installed
# Pages are compressed there, and there is a list of changes as Debian's packages have it.
(cd "$work/root/usr" && find . ! -type d | sed '/man/s/\.gz$//; /doc\/taut\/changelog\.gz$/d' | sort) > packaged
cmp -s installed packaged || fail "the package holds other files than the installation: $(diff installed packaged)"
dpkg-deb -f "$package" Depends | grep -q libc6 || fail "the package does not say what it depends on"
dpkg-deb -f "$package" Depends | grep -qE 'libocct|libflint' && fail "the package needs what is loaded when first wanted"
if [ -x "$prefix/libexec/taut/taut-cad" ]; then
    dpkg-deb -f "$package" Recommends | grep -q 'libocct-data-exchange' || fail "the package does not recommend OpenCASCADE"
fi
if command -v lintian > /dev/null; then
    lintian --fail-on error "$package" > log 2>&1 || { grep '^E' log; fail "lintian finds errors in the package"; }
fi
"$work/root/usr/bin/taut" --version > /dev/null || fail "the packaged program does not run"
echo "version $version, installed and used; $(basename "$package") of $(stat -c %s "$package") bytes"
