# test_packaging.sh -- the recipes of packaging/ can be read by a reader of their language, and name the version that this is. What
# they do is not tried: their tools are not here.
. "$SOURCE/tests/tools/tools.sh"
cd "$SOURCE/packaging" || exit 1
version=$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' ../CMakeLists.txt)
[ -n "$version" ] || fail "CMakeLists.txt says no version"

said=$(python3 -c 'import json; d = json.load(open("vcpkg/vcpkg.json")); print(d["name"], d["version"])') || fail "vcpkg.json is no JSON"
[ "$said" = "taut $version" ] || fail "vcpkg.json is of \"$said\", expected taut $version"

# A recipe of conda's is YAML once its braces are filled.
grep -q "^{% set version = \"$version\" %}" conda/meta.yaml || fail "meta.yaml is of another version than $version"
if python3 -c 'import yaml' 2> /dev/null; then
    sed '/^{%/d; s/{{[^}]*}}/filled/' conda/meta.yaml > "$tree/meta.yaml"
    python3 -c 'import sys, yaml; d = yaml.safe_load(open(sys.argv[1])); sys.exit(d["package"]["name"] != "taut" or "host" not in d["requirements"])' \
        "$tree/meta.yaml" || fail "meta.yaml is not read"
else
    echo "left out: PyYAML is not here: python3-yaml"
fi
bash -n conda/build.sh || fail "build.sh"

grep -q "version \"$version\"" homebrew/taut.rb || fail "taut.rb is of another version than $version"
if command -v ruby > /dev/null; then
    ruby -c homebrew/taut.rb > /dev/null || fail "taut.rb"
else
    echo "left out: ruby is not here"
fi

# CMake reads the port's file with what vcpkg has put out of the way.
printf 'foreach(name check_linkage cmake_configure cmake_install cmake_config_fixup fixup_pkgconfig copy_tools install_copyright)\n
    cmake_language(EVAL CODE "function(vcpkg_${name})\\nendfunction()")\nendforeach()\nset(CURRENT_PORT_DIR /nowhere/a/b)\nset(CURRENT_PACKAGES_DIR /nowhere)\ninclude(%s)\n' \
    "$PWD/vcpkg/portfile.cmake" > "$tree/port.cmake"
cmake -P "$tree/port.cmake" || fail "portfile.cmake is not read"
for recipe in README.md vcpkg/vcpkg.json vcpkg/portfile.cmake conda/meta.yaml conda/build.sh homebrew/taut.rb; do
    grep -qi 'untested' $recipe || fail "$recipe does not say that it is untested"
done
finish
