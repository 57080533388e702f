# test_checks.sh -- each check of tools/ passes a clean tree and catches what it is for.
. "$SOURCE/tests/tools/tools.sh"

# A tree that every check passes.
fresh() {
    rm -rf "${tree:?}"/*
    mkdir -p "$tree/include/taut" "$tree/src/core" "$tree/src/geometry" "$tree/src/certify" "$tree/src/cli" \
        "$tree/src/construct" "$tree/docs"
    printf '#include <stdio.h>\n#include "taut/status.h"\n#include "core/fail.h"\n%s\n%s\n' \
        'int say(const char *reason) { return say("lost"); }' 'int taut_y(void) { return taut_x(); }' > "$tree/src/core/fail.c"
    printf '#include "numeric/sum.h"\n/* [Known2001] */\n' > "$tree/src/certify/a.c"
    printf '#include "geometry/b.h"\n#include "basis/b.h"\n' > "$tree/src/geometry/b.c"
    printf '#include "taut/taut.h"\n#include "cli/c.h"\n#include "c.h"\n' > "$tree/src/cli/c.c"
    printf '/* status.h -- what happened. */\n#include "taut/export.h"\n%s\n' \
        '#define TAUT_REASON_LIST(X) X("lost", "a part is lost", "find it")' > "$tree/include/taut/status.h"
    printf '# Errors\n\n## Any call\n\n| `lost` | 3 | a part is lost | find it |\n' > "$tree/docs/errors.md"
    mkdir -p "$tree/tests/fault"
    printf '/* calls taut_known */\n' > "$tree/tests/fault/test_known.c"
    printf 'taut_exempt it takes none\n' > "$tree/tests/fault/no_memory.txt"
    printf '/* known.h -- functions. */\n/* Two. */\nTAUT_API taut_status taut_known(int n);\n%s\n' \
        'TAUT_API taut_status taut_exempt(int n);' > "$tree/include/taut/known.h"
    printf '@book{Known2001,\n  title = {Known}\n}\n' > "$tree/docs/references.bib"
}

# passes CHECK: on the tree as it is
passes() {
    if ! said=$("$SOURCE/tools/check_$1.sh" "$tree" 2>&1); then
        fail "check_$1 refuses a clean tree: $said"
    fi
}

# catches CHECK FILE EXPECTED CONTENT: with this file added, the check fails and its output names EXPECTED
catches() {
    fresh
    mkdir -p "$tree/$(dirname "$2")"
    printf '%b' "$4" > "$tree/$2"
    if said=$("$SOURCE/tools/check_$1.sh" "$tree" 2>&1); then
        fail "check_$1 lets through: $4"
    fi
    case $said in *"$3"*) ;; *) fail "check_$1 on \"$4\" says \"$said\", expected \"$3\"" ;; esac
}

fresh
for check in layers words citations docs reasons faults; do
    passes $check
done

catches layers src/core/x.c 'core may not include' '#include "geometry/b.h"\n'
catches layers src/construct/x.c 'construct may not include' '#include "certify/certify_ops.h"\n'
catches layers src/certify/x.c 'certify may not include' '#include "construct/construct_ops.h"\n'
catches layers src/certify/x.c 'certify may not include' '#include "numeric/banded.h"\n'
catches layers src/construct/x.c 'construct may not include' '#include "io/format.h"\n'
catches layers src/io/x.c 'io may not include' '#include "draw/figure.h"\n'
catches layers src/modules/cairo/x.c 'modules/cairo may not include' '#include "geometry/net.h"\n'
catches layers src/modules/other/x.c 'may not include' '#include <cairo.h>\n'
catches layers src/core/x.c 'x.c:2: `long`' '/* no long way */\nunsigned long x;\n'
catches layers src/core/x.c 'x.c:1: `0.5L`' 'double x = 0.5L;\n'
catches layers src/core/x.c 'x.c:1: `3L`' 'double x = 3L;\n'
catches layers include/taut/x.h 'x.h:1: `long`' 'long double x;\n'
catches layers src/cli/x.c 'cli may not include' '  # include "core/memory.h"\n'
catches layers src/cli/x.c 'cli may not include' '#include "platform/module.h"\n'
catches layers src/geometry/x.c 'geometry may not include' '#include <jansson.h>\n'
catches layers src/geometry/x.c 'without its layer' '#include "net.h"\n'
catches layers src/geometry/x.c 'name the layer' '#include "geometry/../cli/c.h"\n'
catches layers src/strange/x.c 'no row' 'int x;\n'
catches layers src/x.c 'in no layer' 'int x;\n'
catches layers src/core/x.c 'a circle of 2 files' \
    'int taut_x(void)\n{\n    return taut_y();\n}\n'
catches layers include/taut/x.h 'may not include' '#include "core/memory.h"\n'
catches layers src/core/x.c 'belongs to one system' '#include <unistd.h>\n'
catches layers src/cli/x.c 'belongs to one system' '#include <windows.h>\n'
catches layers src/core/x.c 'which system this is' '#ifdef _WIN32\n#endif\n'
catches layers include/taut/x.h 'which system this is' '#if defined(__linux__)\n#endif\n'
catches layers plugins/host/x.py 'what the package taut offers' 'import subprocess\n'
catches layers plugins/host/x.py 'what the package taut offers' 'from taut._library import library\n'
fresh
mkdir -p "$tree/src/platform"
mkdir -p "$tree/plugins/host"
printf 'import json\nimport taut\nfrom taut import hosts\nfrom . import features\n' > "$tree/plugins/host/x.py"
printf '#if defined(__linux__)\n#include <unistd.h>\n#endif\n/* not __APPLE__ */\n' > "$tree/src/platform/x.c"
printf '/* __APPLE__ */\n' > "$tree/src/core/x.c"
passes layers

catches words src/core/x.c 'a // comment' 'int x; // why\n'
catches words src/core/x.c 'a // comment' '/* one */ char *s = "a \\" /*"; // two\n'
catches words src/core/x.c 'unfinished' '/* TO''DO: later */\n'
catches words docs/x.md 'one machine' 'see /wo''rk/tree/docs\n'
catches words docs/x.md 'nothing to a reader' 'as iss''ue #12 says\n'
fresh
printf '/* see https://example.org */\nchar *s = "//"; char c = %s;\n' "'\"'" > "$tree/src/core/x.c"
passes words

catches citations src/core/x.c 'Unknown1999' '/* [Unknown1999] section 3 */\n'
catches citations docs/x.md 'Unknown1999a' 'as [Unknown1999a] has it\n'
catches citations docs/references.bib 'more than once' '@a{Known2001,\n}\n@b{Known2001,\n}\n'

catches docs include/taut/x.h 'no comment says what this is' '/* x.h */\n\nTAUT_API int taut_x(void);\n'
catches docs include/taut/x.h 'no comment says what this is' '/* x.h */\n\ntypedef struct taut_x {\n    int a;\n} taut_x;\n'
catches docs include/taut/x.h 'does not begin' 'int x;\n'
catches docs src/problem/construct_list.h 'no section `x-y`' '    X(x_y, "x-y")\n'
catches docs src/basis/basis_list.h 'no row for the basis x' '    X(x, "x")\n'
catches docs src/cli/command_list.h 'no row for taut dig' '    X(dig)\n'
catches docs docs/x.md 'which is not there' 'see [there](gone.md)\n'
fresh
printf '/* x.h */\n\n/* one */\nTAUT_API int taut_x(void);\nTAUT_API int taut_y(void);\n\nTAUT_API int taut_z(int a,\n    int b); %s\n' \
    '/* a sum */' > "$tree/include/taut/x.h"
printf '# The part, here\n<a id="X_y"></a>\nsee [there](#the-part-here), [me](x.md#X_y) and `[no](link)`\n' > "$tree/docs/x.md"
passes docs

catches docs docs/x.md 'no such place' '# Here\n[there](#her)\n'
long=$(printf '%130s' '' | tr ' ' 'x')
catches docs docs/x.md 'a line of 130 characters' "$long\n"
fresh
printf '| %s |\n\n    %s\n' "$long" "$long" > "$tree/docs/x.md"
passes docs
catches docs docs/x.md '"at the most" is no plain word' 'ten at the most\n'
catches docs docs/x.md 'a cell of 163 characters' "| a | $long$(printf '%030d' 0)\\\\|b |\n"
fresh
printf '| %s | %s |\n' "$long" "$long" > "$tree/docs/x.md"
passes docs
catches docs docs/x.md 'no such place' '<a id="X_Y"></a>\n[there](x.md#x_y)\n'

# The reference: made of the headers, and noticed where it leads nowhere, lacks a header, or a symbol.
library() {
    fresh
    mkdir -p "$tree/tools" "$tree/examples/c"
    printf '## The library\n' > "$tree/README.md"
    printf '/* taut/taut.h -- all. */\n\n/* First */\n#include "taut/status.h"\n#include "taut/known.h"\n' > "$tree/include/taut/taut.h"
    printf 'taut_exempt\ntaut_known\n' > "$tree/tools/symbols.txt"
    "$SOURCE/tools/reference.sh" "$tree" || fail "reference.sh refuses a clean tree"
}
stale() { # stale EXPECTED: check_docs fails and says so
    said=$("$SOURCE/tools/check_docs.sh" "$tree" 2>&1) && fail "check_docs does not say: $1"
    case $said in *"$1"*) ;; *) fail "check_docs says \"$said\", expected \"$1\"" ;; esac
}
library
passes docs
grep -q '^Two\.$' "$tree/build/reference/known.md" || fail "the reference lacks the comment of a function"
sed -i 's|Two\.|Two: docs/gone.md.|' "$tree/include/taut/known.h"
stale 'lead to docs/gone.md, which is not there'
library
echo taut_new >> "$tree/tools/symbols.txt"
stale 'the headers know no taut_new'
library
printf '/* x.h -- more. */\n' > "$tree/include/taut/x.h"
stale 'taut.h does not include it'

catches reasons src/core/x.c '"gone" stands in no list' 'int x(int a) { return say(a ? "lost" : "gone"); }\n'
catches reasons src/core/x.c '"gone" stands in no list' 'struct error x = {.reason = "gone", .place = "here"};\n'
catches reasons src/core/fail.c 'words that nothing gives: lost' '/* say("lost") */\nint say(const char *reason);\n'
catches reasons docs/errors.md 'no row for lost' '## Any call\n\n## More\n| `lost` | 3 |\n'
catches reasons docs/errors.md 'no reason is called gone' '## Any call\n| `lost` | 3 |\n| `gone` | 3 |\n'
catches reasons include/taut/read.h 'both have lost' '#define TAUT_DOCUMENT_REASON_LIST(X) X("lost", "it is", "seek it")\n'
catches reasons include/taut/read.h 'cannot be read' '#define TAUT_DOCUMENT_REASON_LIST(X) X("left")\n'

catches faults include/taut/x.h 'taut_x: no test' '/* x.h */\nTAUT_API taut_status\ntaut_x(int n);\n'
catches faults include/taut/x.h 'taut_x: no test' '/* x.h */\nTAUT_API void taut_x(taut_record *record);\n'
catches faults tests/fault/no_memory.txt 'is no public function' 'taut_exempt it takes none\ntaut_gone too\n'
catches faults tests/fault/no_memory.txt 'the reason is missing' 'taut_exempt \n'

# The table of layouts, where a header gains a member, a constant, or what no table can hold.
layout() { # layout MEMBERS CONSTANTS: a header, and the table as it stands
    printf '/* x.h */\ntypedef struct taut_x {\n%b\n} taut_x;\ntypedef enum taut_y { %s } taut_y;\n' "$1" "$2" > "$tree/include/taut/x.h"
}
fresh
layout 'int a; /* int b; */ double c[2];\nunion { int d; const double *e, *f; };' 'TAUT_Y_A = 0, TAUT_Y_B'
said=$("$SOURCE/tools/check_abi.sh" "$tree" 2>&1) && fail "check_abi does not miss the table"
"$SOURCE/tools/abi.py" --update "$tree" || fail "abi.py cannot read a header"
passes abi
for row in 'X(taut_x, a, "int")' 'X(taut_x, c, "double[2]")' 'X(taut_x, d, "int")' 'X(taut_x, f, "const double *")' 'X(TAUT_Y_B, "b")'; do
    grep -qF "$row" "$tree/src/core/abi_list.h" || fail "the table lacks $row"
done
layout 'int a, b; double c[2];\nunion { int d; const double *e, *f; };' 'TAUT_Y_A = 0, TAUT_Y_B'
said=$("$SOURCE/tools/check_abi.sh" "$tree" 2>&1) && fail "check_abi lets a new member through"
case $said in *'is not what include/taut declares'*) ;; *) fail "check_abi says \"$said\" of a new member" ;; esac
layout 'int a : 3;' 'TAUT_Y_A = 0, TAUT_Y_B'
said=$("$SOURCE/tools/check_abi.sh" "$tree" 2>&1) && fail "check_abi lets a bit-field through"
case $said in *'cannot read include/taut: taut_x: int a : 3'*) ;; *) fail "check_abi says \"$said\" of a bit-field" ;; esac

# A library that exports what it should not, and lacks what it should have.
if command -v cc > /dev/null && command -v nm > /dev/null; then
    fresh
    printf '%s\n' '#include <math.h>' 'int stray(void); int stray(void) { return 0; }' \
        'double taut_wave(double x); double taut_wave(double x) { return sin(floor(x)); }' |
        cc -shared -fPIC -fno-builtin -x c - -lm -o "$tree/libtaut.so"
    said=$("$SOURCE/tools/check_symbols.sh" "$tree/libtaut.so" 2>&1) && fail "check_symbols passes a stray library"
    case $said in *'stray: exported, but not named taut_'*) ;; *) fail "stray symbol not named: $said" ;; esac
    case $said in *'sin: called, but every C library rounds it'*) ;; *) fail "libm's sine not named: $said" ;; esac
    case $said in *'floor: called'*) fail "floor is exact: $said" ;; esac
    case $said in *'taut_version: was exported before and is gone'*) ;; *) fail "lost symbol not named: $said" ;; esac
fi

# The tables of the elementary functions are what their definitions give.
if command -v python3 > /dev/null; then
    "$SOURCE/tools/elementary_tables.py" --check || fail "src/core/elementary/tables.c is stale"
fi

finish
