#!/bin/sh
# manual_documents.sh VERSION docs/format.md -- the manual page taut(5), made of the reference of the documents: headings,
# paragraphs, lists, tables and blocks of Markdown as troff with the man macros.
set -eu
awk -v version="$1" '
    # Text for troff: `code` bold, **strong** bold, links without their target.
    function inline(s,    out, part, n, i) {
        gsub(/\\\|/, "|", s)
        gsub(/\\/, "\\e", s)
        while (match(s, /\[[^][]*\]\([^)]*\)/)) {
            part = substr(s, RSTART + 1, RLENGTH - 1)
            sub(/\].*/, "", part)
            s = substr(s, 1, RSTART - 1) part substr(s, RSTART + RLENGTH)
        }
        gsub(/-/, "\\-", s)
        gsub(/\*\*/, "`", s)
        n = split(s, piece, "`")
        out = piece[1]
        for (i = 2; i <= n; i++) {
            out = out (i % 2 == 0 ? "\\fB" : "\\fR") piece[i]
        }
        sub(/^[.\047]/, "\\\\\\&&", out)
        return out
    }
    function verbatim(s) {
        gsub(/\\/, "\\e", s)
        gsub(/-/, "\\-", s)
        sub(/^[.\047]/, "\\\\\\&&", s)
        return s
    }
    function leave() { # the block that was open
        if (mode == "code") {
            print ".fi\n.RE"
        }
        mode = ""
    }
    BEGIN {
        printf ".TH TAUT 5 \"\" \"taut %s\" \"File formats\"\n", version
        print ".SH NAME\ntaut \\- documents of taut: problems, models, reports"
        print ".SH DESCRIPTION"
    }
    fenced && !/^```/ { print verbatim($0); next }
    /^```/ {
        fenced = !fenced
        if (fenced) {
            leave()
            print ".PP\n.RS 4\n.nf"
        } else {
            print ".fi\n.RE"
        }
        next
    }
    /^# / { next }
    /^## / { leave(); print ".SH " toupper(inline(substr($0, 4))); next }
    /^### / { leave(); print ".SS " inline(substr($0, 5)); next }
    /^    / && mode != "item" {
        if (mode != "code") {
            leave()
            print ".PP\n.RS 4\n.nf"
            mode = "code"
        }
        print verbatim(substr($0, 5))
        next
    }
    /^\|/ {
        if (mode != "table") {
            leave()
            mode = "table"
            rows = 0
        }
        line = $0
        gsub(/\\\|/, "\001", line)
        n = split(line, cell, "|")
        for (i = 1; i <= n; i++) {
            gsub(/^ +| +$/, "", cell[i])
            gsub(/\001/, "|", cell[i])
            if (rows == 0) {
                heading[i] = cell[i] != "" ? cell[i] ": " : ""
            }
        }
        rows++
        if (rows <= 2) { # the heading, and the rule below it
            next
        }
        print ".TP\n" inline(cell[2])
        text = cell[3]
        for (i = 4; i < n; i++) {
            text = text (cell[i] != "" ? "; " heading[i] cell[i] : "")
        }
        print text != "" ? inline(text) : "\\&"
        next
    }
    /^- / { leave(); mode = "item"; print ".IP \\(bu 2\n" inline(substr($0, 3)); next }
    /^$/ {
        if (mode == "code") {
            held = 1
        } else {
            leave()
        }
        next
    }
    {
        if (mode == "item") {
            sub(/^ +/, "")
        } else if (mode != "text") {
            leave()
            print ".PP"
            mode = "text"
        }
        print inline($0)
    }
    END {
        leave()
        print ".SH SEE ALSO\n.BR taut (1),\n.BR taut (3);\n.B taut schema\nprints the same as JSON Schema."
    }
' "$2"
