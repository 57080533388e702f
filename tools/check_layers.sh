#!/bin/sh
# check_layers.sh [ROOT] -- who may include whom, and no circles between files. Prints what breaks that and fails.
set -eu
bad=0
tools=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$(dirname "$0")/..}"

# layer: what it may include besides itself, <standard headers> and "taut/...". "layer" is all of a layer,
# "layer/file.h" one file, <file.h> a library's header, <*.hxx> all of OpenCASCADE's. C++ may have C++'s own.
table='
platform:  core
core:      platform
numeric:   core platform
basis:     core numeric
geometry:  core platform numeric basis
problem:   core
measure:   core platform numeric basis geometry
pattern:   core numeric
trace:     core numeric basis geometry pattern
construct: core platform numeric basis geometry problem trace pattern
certify:   core platform/parallel.h numeric/kernel/name.h numeric/quadrature.h numeric/sum.h basis geometry measure problem
mesh:      core basis geometry measure
shell:     core numeric/bernstein.h numeric/quadrature.h numeric/strip.h basis geometry measure mesh
io:        core platform numeric/bernstein.h basis geometry problem measure mesh shell
draw:      core platform basis geometry measure mesh io
page:      core basis geometry measure mesh io draw
cli:       core/decimal.h core/elementary/elementary.h core/printf.h platform/system.h
web:       core io draw/flat_page.h measure/cloth/mounted.h measure/dual/density.h mesh/parts.h shell/thick/thick.h numeric/modes_lent.h certify/film/complex/complex.h certify/film/complex/told.h construct/film/complex/complex.h certify/common certify/certify_ops.h construct/construct_ops.h
modules/*: core draw
modules/exact: core <flint/fmpq.h>
modules/cairo: core draw <cairo.h> <cairo-svg.h> <cairo-pdf.h>
cad:       io/cad/wire.h <*.hxx>
include/taut:
'

# Standard C, what the compilers bring, and what all systems have of POSIX.
standard='assert complex ctype errno fenv float immintrin inttypes limits locale math setjmp signal stdalign stdarg stdatomic
stdbool stddef stdint stdio stdlib stdnoreturn string strings time'

# What belongs to one system: only in src/platform, and in the program that reads CAD files.
system='crt_externs dirent dlfcn fcntl io malloc ntsecapi poll process pthread shellapi spawn sys/mman sys/random sys/resource sys/stat sys/time sys/types sys/wait
termios threads unistd windows'
system_names='_WIN32|_WIN64|__MINGW32__|__linux__|__gnu_linux__|__APPLE__|__wasi__|__unix__|__GLIBC__|__CYGWIN__'
system_files='src/platform/[^/]*|cad/[^/]*|src/io/cad/cad\.c'

list=$(find src cad include/taut -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' 2>/dev/null | sort)
if [ -z "$list" ]; then
    echo "check_layers: no sources under $(pwd)" >&2
    exit 1
fi
# shellcheck disable=SC2086
TABLE="$table" STANDARD="$standard" SYSTEM="$system" NAMES="$system_names" FILES="$system_files" awk '
    BEGIN {
        rows = split(ENVIRON["TABLE"], row, "\n")
        for (r = 1; r <= rows; r++) {
            colon = index(row[r], ":")
            if (colon == 0) {
                continue
            }
            layer = substr(row[r], 1, colon - 1)
            known[layer] = 1
            n = split(substr(row[r], colon + 1), word, " ")
            for (i = 1; i <= n; i++) {
                allowed[layer, word[i]] = 1
            }
        }
        n = split(ENVIRON["STANDARD"], word, /[ \n]+/)
        for (i = 1; i <= n; i++) {
            standard["<" word[i] ".h>"] = 1
        }
        n = split(ENVIRON["SYSTEM"], word, /[ \n]+/)
        for (i = 1; i <= n; i++) {
            system_header["<" word[i] ".h>"] = 1
        }
        names = "(^|[^A-Za-z0-9_])(" ENVIRON["NAMES"] ")([^A-Za-z0-9_]|$)"
        files = "^(" ENVIRON["FILES"] ")$"
    }
    FNR == 1 {
        depth = split(FILENAME, part, "/")
        layer = part[1] == "include" ? "include/taut" : part[1] == "cad" ? "cad" : part[2]
        if (layer == "modules") {
            layer = ("modules/" part[3]) in known ? "modules/" part[3] : "modules/*"
            own = "modules/" part[3]
        } else {
            own = layer
        }
        if (part[1] == "src" && depth < 3) {
            complain("stands in no layer")
        } else if (!(layer in known)) {
            complain("layer " layer " has no row in tools/check_layers.sh")
        }
    }
    function complain(what) {
        printf "%s:%d: %s\n", FILENAME, FNR, what
        bad = 1
    }
    # How symbols leave a DLL has to be said in the one public header that says how symbols leave.
    /^[ \t]*#/ && $0 ~ names && FILENAME !~ files && FILENAME != "include/taut/export.h" {
        complain("asks which system this is: only src/platform does")
    }
    /^[ \t]*#[ \t]*include/ {
        what = $0
        sub(/^[ \t]*#[ \t]*include[ \t]*/, "", what)
        if (match(what, /^<[^>]*>/)) {
            header = substr(what, 1, RLENGTH)
            if (header ~ /\.hxx>$/) {
                header = "<*.hxx>"
            }
            if (header in system_header) {
                if (FILENAME !~ files) {
                    complain(header " belongs to one system: only src/platform includes it")
                }
            } else if (!(header in standard) && !((layer, header) in allowed) \
                && !(FILENAME ~ /\.[ch]pp$/ && header ~ /^<[a-z_]+>$/)) {
                complain(layer " may not include " header)
            }
        } else if (match(what, /^"[^"]*"/)) {
            header = substr(what, 2, RLENGTH - 2)
            slash = index(header, "/")
            from = slash > 0 ? substr(header, 1, slash - 1) : ""
            if (header ~ /\.\./) {
                complain("includes \"" header "\": name the layer instead")
            } else if (from == "") { # only in programs and modules
                if (own !~ /^(cad|cli|modules)/) {
                    complain("includes \"" header "\" without its layer")
                }
            } else if (from != "taut" && index(header, own "/") != 1 && !((layer, from) in allowed) \
                       && !((layer, header) in allowed)) {
                complain(layer " may not include \"" header "\"")
            }
        } else {
            complain("includes what no one can read: " what)
        }
    }
    END { exit bad }
' $list || bad=1
# The judge from outside shares nothing with what it judges: public headers, and its own.
for file in tests/support/oracle/*.[ch]; do
    if [ -e "$file" ] && grep -nE '^[ \t]*#[ \t]*include[ \t]*"' "$file" | grep -vE '"(taut|oracle)/[a-z_]+\.h"'; then
        echo "$file: the oracle may include taut/ and oracle/ only" >&2
        bad=1
    fi
done
# Plug-ins stand on the package alone, and on their hosts.
hosts='FreeCAD|FreeCADGui|Part|PySide2|bpy|bpy_extras|bmesh|gpu|gpu_extras|mathutils|paraview|vtkmodules|Rhino|Grasshopper|scriptcontext|System|compas|numpy|taut'
plain='__future__|collections|contextlib|inspect|json|math|os|pathlib|sys|tempfile|traceback'
plugins=$(find plugins -name '*.py' 2>/dev/null || true)
if [ -n "$plugins" ]; then
    # shellcheck disable=SC2086
    if grep -nE '^[ \t]*(import|from) +[A-Za-z_]' $plugins /dev/null | grep -vE ":[ \t]*(import|from) +($hosts|$plain)([. ,]|\$)" ||
        grep -nE 'taut\._|from taut import .*\b_|import +ctypes' $plugins /dev/null; then
        echo "check_layers: plug-ins use what the package taut offers, their host, numpy and little else" >&2
        bad=1
    fi
fi
python3 "$tools/check_circles.py" . || bad=1
python3 "$tools/check_types.py" . || bad=1
exit $bad
