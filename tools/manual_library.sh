#!/bin/sh
# manual_library.sh VERSION taut.h -- the manual page taut(3), made of the comments of the headers that taut.h includes.
set -eu
export LC_ALL=C
awk -f "$(dirname "$0")/headers.awk" "$2" | awk -F '\t' -v version="$1" '
    function verbatim(s) {
        gsub(/\\/, "\\e", s)
        gsub(/-/, "\\-", s)
        gsub(/\^/, "\\(ha", s)
        sub(/^[.\047]/, "\\\\\\&&", s)
        return s
    }
    function inline(s,    out, word) { # names and `code` bold
        while (match(s, /`[^`]+`|(taut|TAUT)_[A-Za-z0-9_]+|taut\/[a-z]+\.h|\*[a-z]+[a-z_]*/)) {
            word = substr(s, RSTART, RLENGTH)
            gsub(/`/, "", word)
            out = out verbatim(substr(s, 1, RSTART - 1)) "\\fB" verbatim(word) "\\fR"
            s = substr(s, RSTART + RLENGTH)
        }
        return out (out == "" ? verbatim(s) : substr(verbatim("x" s), 2))
    }
    function turn(to) { # from one kind of block to another
        if (to == block && to != "para") {
            return
        }
        if (block == "code" || block == "decl") {
            print ".fi\n.RE"
        }
        if (to == "code" || to == "decl") {
            print ".PP\n.RS 4\n.nf"
        } else if (to == "para") {
            print ".PP"
        }
        block = to
    }
    function capital(s) {
        return toupper(substr(s, 1, 1)) substr(s, 2)
    }
    BEGIN {
        printf ".TH TAUT 3 \"\" \"taut %s\" \"C library\"\n", version
        print ".SH NAME\ntaut \\- the C library libtaut: build surfaces from what bounds them, and prove what was built"
        print ".SH SYNOPSIS\n.B #include <taut/taut.h>\n.PP\n.B cc program.c $(pkg\\-config \\-\\-cflags \\-\\-libs taut)"
        print ".SH DESCRIPTION\nEach section is one header, in the order of the work; what holds of every call is said under"
        print ".BR taut/status.h ."
    }
    $1 == "header" { turn(""); print ".SH " $2 }
    $1 == "purpose" { turn("para"); print inline(capital($2)) }
    $1 == "entry" { turn(""); print ".SS " verbatim($2) }
    $1 == "para" { turn("para"); print inline($2) }
    $1 == "code" || $1 == "decl" { turn($1); print verbatim($2) }
    $1 == "item" { turn("item"); print ".TP\n.I " $2 "\n" inline($3) }
    END {
        turn("")
        print ".SH SEE ALSO\n.BR taut (1),\n.BR taut (5).\nWhat is cited by a key such as [WuWang2011]: docs/references.bib of the sources."
    }
'
