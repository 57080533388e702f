#!/bin/sh
# deps.sh GROUP... -- installs what is missing, and says what and why. Groups: build test browser site check files bench wasm windows nightly hosts.
#
# A need is met when its command runs, its pkg-config file is found or its header compiles, however it came to the
# machine; only unmet needs become packages. With nothing missing no network is touched.
set -eu

# group, how to tell that it is there, Debian 12 package, why
needs() {
    cat <<'LIST'
build cmd:gcc                        gcc                    compiles the library
build cmd:g++                        g++                    compiles the public headers as C++ too
build header:stdlib.h                libc6-dev              the C library's headers
build cmd:cmake                      cmake                  says what is built from what
build cmd:ninja                      ninja-build            runs the build
build cmd:pkg-config                 pkg-config             finds libraries
build pc:cairo                       libcairo2-dev          draws figures (SVG, PDF, PNG)
build header:flint/fmpq_mat.h        libflint-dev           rational arithmetic: --exact
test  cmd:git                        git                    makes the copy of the tree that is broken on purpose
test  cmd:python3                    python3                breaks it, and reads our files with a reader of its own
test  pc:jansson                     libjansson-dev         another JSON parser, which ours is compared with
test  header:gmp.h                   libgmp-dev             exact numbers the results are checked against
test  header:mpfr.h                  libmpfr-dev            numbers of any precision: the elementary functions
test  header:flint/fmpq_mat.h        libflint-dev           exact rational algebra, likewise
test  header:arb.h                   libflint-arb-dev       intervals of any precision, likewise
test  header:lapacke.h               liblapacke-dev         a second solver that shares no code with ours
test  cmd:pdfinfo                    poppler-utils          reads the PDF figures back
test  cmd:rsvg-convert               librsvg2-bin           reads the SVG figures back
test  header:opencascade/STEPControl_Writer.hxx libocct-data-exchange-dev reads STEP and IGES, writes IGES
test  cmd:python3                    python3                changes documents, one member at a time
test  py:jsonschema                  python3-jsonschema     reads the schemas
test  py:numpy                       python3-numpy          what the Python package gives and takes
test  py:pytest                      python3-pytest         runs its tests
test  py:hypothesis                  python3-hypothesis     draws their inputs
test  py:mypy                        mypy                   checks its types
test  py:wheel                       python3-wheel          packs it
test  py:setuptools                  python3-setuptools     packs it
test  py:pip                         python3-pip            packs and installs it
site  cmd:mkdocs                     mkdocs                 makes a site of docs/
browser cmd:node                     nodejs                 drives the browser that looks at the pages of `taut view`
browser cmd:chromium                 chromium               that browser
check cmd:ccache                     ccache                 compiles once what several trees have in common
check cmd:clang                      clang                  a second compiler, the sanitizers, the fuzzer
check cmd:clang-format               clang-format           the formatting
check clang:fsanitize=fuzzer,address libclang-rt-14-dev     what sanitizers and fuzzer link with
check cmd:llvm-symbolizer-14         llvm-14                names in the sanitizers' reports
check cmd:nm                         binutils               lists the library's symbols
check cmd:dpkg-shlibdeps             dpkg-dev               what the Debian package depends on
check cmd:lintian                     lintian                the Debian package
check cmd:gmsh                       gmsh                   reads STEP and IGES back
check file:/usr/lib/x86_64-linux-gnu/lib3MF.so.1 lib3mf1     the 3MF Consortium's reader
check py:ezdxf                       python3-ezdxf          reads DXF back
check cmd:evolver                evolver                Surface Evolver, which finds the same sails
check file:/usr/share/doc/evolver/examples/cat.fe evolver-doc its sample files
check cmd:node                       nodejs                 runs the Khronos validator of glTF
check cmd:npm                        npm                    fetches it
check cmd:tsc                        node-typescript        checks the types of scripts
check py:matplotlib                  python3-matplotlib     draws by `surface.plot`
check py:meshio                 python3-meshio         takes meshes by `taut.neighbours`
check py:nbclient                    python3-nbclient       runs the notebooks as Jupyter does
check py:ipykernel                   python3-ipykernel      with this
check py:distributed                 python3-distributed    Dask, which spreads sweeps
check py:vtkmodules                  python3-vtk9           VTK, which reads the VTU files back
files file:/usr/share/doc/netgen/examples/frame.step netgen-doc STEP files that others made, tests/cli/test_other_files.sh
files file:/usr/share/doc/gmsh-doc/doc/gmsh/tutorial/t20_data.step.gz gmsh-doc more of them
files file:/usr/share/opencascade/data/step/linkrods.step occt-misc more of them, and IGES
wasm  cmd:clang                      clang                  compiles for WebAssembly
wasm  cmd:wasm-ld                    lld                    links it
wasm  file:/usr/include/wasm32-wasi/stdlib.h wasi-libc      the C library of WebAssembly
wasm  file:/usr/lib/llvm-14/lib/clang/14.0.6/lib/wasi/libclang_rt.builtins-wasm32.a libclang-rt-14-dev-wasm32 what the compiler calls there
wasm  cmd:wasm-opt                   binaryen               makes the module smaller and faster
wasm  cmd:esbuild                    esbuild                makes one script of the studio's
wasm  cmd:node                       nodejs                 runs its tests
windows cmd:x86_64-w64-mingw32-gcc-win32 gcc-mingw-w64-x86-64-win32 compiles for Windows
windows cmd:python3                  python3                runs the tests of the program for Windows
windows file:/usr/lib/wine/wine64    wine64                 is the Windows they run on
nightly cmd:musl-gcc                 musl-tools             compiles for another C library
nightly cmd:aarch64-linux-gnu-gcc    gcc-aarch64-linux-gnu  compiles for another processor
nightly file:/usr/aarch64-linux-gnu/lib/libc.a libc6-dev-arm64-cross its C library
nightly cmd:qemu-aarch64             qemu-user              is that processor
nightly cmd:ruby                     ruby                   reads the recipe for Homebrew
nightly file:/usr/lib/python3/dist-packages/yaml/__init__.py python3-yaml reads the one for conda
hosts cmd:freecadcmd                 freecad                runs the tests of plugins/freecad
hosts cmd:blender                    blender                those of plugins/blender
hosts cmd:admesh                     admesh                 looks for what STL files need mended
hosts cmd:pvpython                   python3-paraview       those of plugins/paraview
hosts cmd:xvfb-run                   xvfb                   the windows of these
hosts cmd:xauth                      xauth                  likewise
bench header:suitesparse/cholmod.h   libsuitesparse-dev     CHOLMOD, a peer of the Dirichlet solver
bench header:sisl.h                  libsisl-dev            SISL, a peer in evaluation
bench header:opencascade/STEPControl_Writer.hxx libocct-data-exchange-dev OpenCASCADE, a peer in evaluation
bench pc:openblas                    libopenblas-dev        what CHOLMOD runs on
bench header:lapacke.h               liblapacke-dev         fast diagonalisation by LAPACK, the fair peer of the Dirichlet solver
bench header:tbb/tbb.h               libtbb-dev             what OpenCASCADE's CMake files name
bench cmd:evolver               evolver                Surface Evolver, a peer of the least area
LIST
}

compiles() { # compiles LANGUAGE HEADER
    echo "#include <$2>" | gcc -x "$1" -fsyntax-only - 2>/dev/null
}

has_modules() { # has_modules PYTHON MODULE...
    interpreter=$1
    shift
    for module in "$@"; do
        "$interpreter" -c "import $module" 2>/dev/null || return 1
    done
}

# Modules are of use in one interpreter only: the first that has all of them, else Debian's, which packages go to.
find_python() { # find_python MODULE...
    for python in ${PYTHON:-} python3; do
        if has_modules "$python" "$@"; then return; fi
    done
    python=/usr/bin/python3
}

is_there() {
    case $1 in
    cmd:*) command -v "${1#cmd:}" >/dev/null 2>&1 ;;
    pc:*) pkg-config --exists "${1#pc:}" 2>/dev/null ;;
    header:*.hxx) test -e "/usr/include/${1#header:}" ;;
    file:*) test -e "${1#file:}" ;;
    py:*) has_modules "$python" "${1#py:}" ;;
    header:*) compiles c "${1#header:}" ;;
    clang:*) echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d == 0 && n > 0; }' |
        clang "-${1#clang:}" -x c - -o /dev/null 2>/dev/null ;;
    esac
}

packages=
seen=' '
modules=
for group in "$@"; do
    modules="$modules $(needs | sed -n "s/^$group *py:\([a-z0-9]*\).*/\1/p" | tr '\n' ' ')"
done
# shellcheck disable=SC2086
find_python $modules
for group in "$@"; do
    case $group in build | test | browser | site | check | files | bench | wasm | windows | nightly | hosts) ;; *)
        echo "deps.sh: no group \"$group\"; there are build, test, browser, site, check, files, bench, wasm, windows, nightly and hosts" >&2
        exit 2
        ;;
    esac
    list=$(needs | sed -n "s/^$group *//p")
    while read -r test package why; do
        case $seen in *" $package "*) continue ;; esac
        if ! is_there "$test"; then
            [ -n "$packages" ] || echo "Missing on this machine, to be installed with apt-get:"
            printf '  %-28s %s\n' "$package" "$why"
            packages="$packages $package"
            seen="$seen$package "
        fi
    done <<END
$list
END
done
[ -n "$packages" ] || exit 0

if ! command -v apt-get >/dev/null 2>&1; then
    echo "deps.sh: there is no apt-get here: please install the above by hand" >&2
    exit 1
fi
sudo=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "deps.sh: installing needs root or sudo; as root: apt-get install$packages" >&2
        exit 1
    fi
    sudo=sudo
fi
install() { # install PACKAGE...
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# The package lists may be absent or old: refresh them when installing from what is there fails.
# shellcheck disable=SC2086
if ! install $packages >"$log" 2>&1; then
    if ! { $sudo apt-get update && install $packages; } >"$log" 2>&1; then
        cat "$log" >&2
        exit 1
    fi
fi
echo "Installed:$packages"
