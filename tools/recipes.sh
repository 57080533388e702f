#!/bin/bash
# recipes.sh [conda] [homebrew] [vcpkg] -- does what the recipes of packaging/ say, without their tools: installs this commit by each
# into an empty folder below build/recipes, and runs what each names as its test. In the place of the tools stand their words, in
# tools/recipes: what a recipe asks of a tool, that tool itself may still refuse.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD work=$PWD/build/recipes
version=$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ $# -gt 0 ] || set -- conda homebrew vcpkg

in_tree() { # in_tree NAME: a copy of the commit, to build in
    rm -rf "${work:?}/$1"
    mkdir -p "$work/$1/tree" "$work/$1/prefix" "$work/$1/test"
    git archive HEAD | tar -x -C "$work/$1/tree"
    cd "$work/$1/tree"
}

check_version() { # check_version PROGRAM LIBRARIES
    [ "$(LD_LIBRARY_PATH=$2 "$1" --version | head -n 1 | grep -oE '[0-9.]+' | head -n 1)" = "$version" ] || {
        echo "recipes: $1 is not version $version" >&2
        return 1
    }
}

do_conda() {
    export PREFIX=$work/conda/prefix
    bash packaging/conda/build.sh
    check_version "$PREFIX/bin/taut" "$PREFIX/lib"
    sed '/^{%/d; s/{{[^}]*}}/filled/' packaging/conda/meta.yaml |
        /usr/bin/python3 -c 'import sys, yaml; print("\n".join(yaml.safe_load(sys.stdin)["test"]["commands"]))' > "$work/conda/commands"
    (cd "$work/conda/test" && PATH=$PREFIX/bin:$PATH LD_LIBRARY_PATH=$PREFIX/lib bash -ex "$work/conda/commands")
}

do_homebrew() {
    ruby "$root/tools/recipes/formula.rb" packaging/homebrew/taut.rb "$work/homebrew/prefix" "$work/homebrew/test"
    check_version "$work/homebrew/prefix/bin/taut" "$work/homebrew/prefix/lib"
}

do_vcpkg() {
    cmake -DPACKAGES="$work/vcpkg/prefix" -DPORT="$PWD/packaging/vcpkg" -P "$root/tools/recipes/port.cmake"
    check_version "$work/vcpkg/prefix/tools/taut/taut" "$work/vcpkg/prefix/lib"
}

for recipe; do
    (in_tree "$recipe" && "do_$recipe") || {
        echo "recipes: $recipe FAILED" >&2
        exit 1
    }
    echo "$recipe: installed, and its tests passed"
done
rm -rf "$work"
