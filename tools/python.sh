#!/bin/sh
# python.sh test|pack|install FOLDER|wheel|windows|bench [ARGUMENT...] -- the Python package: its tests (pytest, types by mypy) against the
# library of build/release, its wheel (build/python/*.whl; `pack` packs alone, `install` puts it into a folder, `wheel` runs all tests on
# what is installed from it), the wheel around the library for Windows (build/python-windows/*.whl, of build/mingw), whose layouts and functions alone
# are looked at, its figures. By $PYTHON, or the first python3 that has all they need.
set -eu
cd "$(dirname "$0")/.."
export TAUT_BUILD=${TAUT_BUILD:-$PWD/build/release} PYTHONDONTWRITEBYTECODE=1
wheels=build/python

has() { # has PYTHON MODULE...
    python=$1
    shift
    for module in "$@"; do
        "$python" -c "import $module" 2>/dev/null || return 1
    done
}
if [ -z "${PYTHON:-}" ]; then
    for PYTHON in python3 /usr/bin/python3; do # as tools/deps.sh finds it
        if has "$PYTHON" numpy pytest hypothesis mypy wheel setuptools pip jsonschema; then break; fi
    done
fi
if ! has "$PYTHON" numpy pytest; then
    echo "python.sh: no python3 with numpy and pytest: tools/deps.sh test" >&2
    exit 1
fi

make_wheel() {
    rm -rf "$wheels/src" "$wheels"/*.whl # what `wheel` has installed stays
    mkdir -p "$wheels/src"
    cp -R python/taut python/setup.py python/pyproject.toml python/README.md "$wheels/src"
    "$PYTHON" -m pip --quiet wheel --no-build-isolation --no-deps -w "$wheels" "$wheels/src"
    ls "$wheels"/*.whl
}

check_types() {
    if has "$PYTHON" mypy; then
        (cd python && "$PYTHON" -m mypy --strict --cache-dir "../$wheels/mypy" taut tests/typed_use.py)
    else
        echo "left out: types are not checked (Debian: mypy)"
    fi
}

case ${1:-} in
test)
    shift
    "$PYTHON" -m pytest -q -p no:cacheprovider python/tests "$@"
    check_types
    ;;
pack) make_wheel ;;
install)
    make_wheel
    "$PYTHON" -m pip --quiet install --no-deps --no-index --upgrade --target "${2:?install needs a folder}" "$wheels"/*.whl
    ;;
wheel)
    shift
    make_wheel
    rm -rf "$wheels/installed"
    "$PYTHON" -m pip --quiet install --no-deps --no-index --target "$wheels/installed" "$wheels"/*.whl
    unset TAUT_LIBRARY # it is the wheel's own
    TAUT_WHEEL=1 PYTHONPATH=$PWD/$wheels/installed "$PYTHON" -m pytest -q -p no:cacheprovider python/tests "$@"
    check_types
    ;;
windows)
    TAUT_BUILD=${TAUT_MINGW:-$PWD/build/mingw}
    wheels=build/python-windows
    make_wheel
    "$PYTHON" tests/windows/check_wheel.py "$wheels"/*.whl
    ;;
bench)
    shift
    TAUT_LIBRARY=${TAUT_LIBRARY:-$TAUT_BUILD/libtaut.so.0} PYTHONPATH=$PWD/python "$PYTHON" bench/python/bench.py "$@"
    ;;
*)
    sed -n 's/^# \{0,1\}//p' "$0" | sed -n 2,5p >&2
    exit 2
    ;;
esac
