#!/bin/sh
# manual_library.sh VERSION taut.h [HEADER] -- manual pages made of the comments of the headers that taut.h includes: of a
# header's name, such as `dirichlet`, its page taut_dirichlet(3); without one taut(3), which leads to all of them.
set -eu
export LC_ALL=C
said=$(mktemp)
trap 'rm -f "$said"' EXIT
awk -f "$(dirname "$0")/headers.awk" "$2" > "$said"

# Read twice: first for the names, then to write.
awk -F '\t' -v version="$1" -v wanted="${3:-}" '
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
    function head(title, name, purpose, include,    package) {
        package = include == "taut/draw.h" ? "taut\\-draw" : "taut"
        sub(/\.$/, "", purpose)
        printf ".TH %s 3 \"\" \"taut %s\" \"C library\"\n.SH NAME\n%s \\- %s\n", toupper(title), version, name, purpose
        printf ".SH SYNOPSIS\n.B #include <%s>\n.PP\n", include
        print ".B cc program.c $(pkg\\-config \\-\\-cflags \\-\\-libs " package ")\n.SH DESCRIPTION"
    }
    function body() { # what a comment says, and what it is about
        if ($1 == "para") {
            turn("para")
            print inline($2)
        } else if ($1 == "code" || $1 == "decl") {
            turn($1)
            print verbatim($2)
        } else if ($1 == "item") {
            turn("item")
            print ".TP\n.I " $2 "\n" inline($3)
        }
    }
    $1 == "header" { at = $2; gsub(/^taut\/|\.h$/, "", at); entries = 0 }
    FNR == NR {
        if ($1 == "name") {
            split($2, word, " ")
            page[word[2]] = at
            if (word[1] == "function" && at == wanted && word[2] != "taut_" at) {
                functions = functions ", " word[2]
            }
        }
        next
    }
    $1 == "entry" { entries++ }

    wanted == "" && FNR == 1 {
        head("taut", "taut", "the C library libtaut: build surfaces from what bounds them, and prove what was built", "taut/taut.h")
        print "The header includes all others, each of which has its own page."
    }
    wanted == "" && $1 == "section" { print ".SS " verbatim($2) }
    wanted == "" && $1 == "purpose" { print ".TP\n.BR taut_" at " (3)\n" inline(capital($2)) }
    wanted == "" && at == "status" && entries == 0 && $1 ~ /^(para|code|item)$/ { kept[++keeps] = $0 }

    at != wanted || wanted == "" { next }
    $1 == "purpose" { head("taut_" at, "taut_" at functions, $2, "taut/" at ".h"); print inline(capital($2)) }
    $1 == "entry" { turn(""); print (entries == 1 ? ".SH API\n" : "") ".SS " verbatim($2) }
    { body() }
    END {
        if (wanted == "") {
            print ".SH WHAT HOLDS OF EVERY CALL"
            for (k = 1; k <= keeps; k++) {
                $0 = kept[k]
                body()
            }
            turn("")
            print ".SH NAMES\n.nf"
            fflush()
            for (name in page) {
                printf "%-44s taut_%s(3)\n", name, page[name] | "sort"
            }
            close("sort")
            print ".fi"
        }
        turn("")
        print ".SH SEE ALSO\n.BR taut (1),\n.BR taut (3),\n.BR taut (5).\nWhat is cited by a key such as [WuWang2011]: docs/references.bib of the sources."
    }
' "$said" "$said"
