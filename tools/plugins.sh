#!/bin/sh
# plugins.sh zip|test [ARGUMENT...] -- the plug-ins of other programs: packed, each with the package taut in it, into
# build/plugins/*.zip, as the managers of their hosts install them; or tested in the hosts that are here (pytest).
set -eu
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
out=build/plugins

python=${PYTHON:-/usr/bin/python3}
pack() { # pack HOST FOLDER VENDOR: FOLDER of plugins/HOST becomes the zip's, the package taut goes into VENDOR of it
    work=$out/work/$1
    mkdir -p "$work"
    cp -R "plugins/$1/." "$work"
    find "$work" -name __pycache__ -prune -exec rm -r {} +
    cp LICENSE "$work/${2:-.}"
    if [ -n "$3" ]; then
        mkdir -p "$work/$3"
        cp -R "$out/work/wheel/taut" "$work/$3"
    fi
    (cd "$work" && "$python" -m zipfile -c "../../taut-$1.zip" ./*)
    echo "$out/taut-$1.zip"
}

case ${1:-} in
zip)
    tools/python.sh pack >/dev/null
    rm -rf "$out"
    mkdir -p "$out/work/wheel"
    "$python" -m zipfile -e build/python/taut-*.whl "$out/work/wheel"
    [ ! -d plugins/freecad ] || pack freecad '' freecad/taut_workbench/vendor
    [ ! -d plugins/blender ] || pack blender taut_surfaces taut_surfaces/vendor
    [ ! -d plugins/paraview ] || pack paraview '' vendor
    [ ! -d plugins/grasshopper ] || pack grasshopper '' ''
    rm -r "$out/work"
    ;;
test)
    shift
    for host in freecadcmd blender pvpython xvfb-run; do
        command -v $host >/dev/null || echo "left out: there is no $host (tools/deps.sh hosts)"
    done
    "$python" -m pytest -q -p no:cacheprovider tests/plugins "$@"
    ;;
*)
    sed -n 's/^# \{0,1\}//p' "$0" | sed -n 2,3p >&2
    exit 2
    ;;
esac
