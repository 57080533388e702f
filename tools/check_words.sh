#!/bin/sh
# check_words.sh [ROOT] -- what has no place in the sources: // comments in C, marks of unfinished work, and words about
# where the work was done instead of what it is.
set -eu
cd "${1:-$(dirname "$0")/..}"
bad=0

# All text under version control, or all there is where there is none.
files() {
    if [ -e .git ]; then
        git ls-files --cached --others --exclude-standard
    else
        find . -type f | sed 's|^\./||'
    fi | sort -u | grep -vE '(^|/)(corpus|node_modules|build|out)/|package-lock\.json$|\.(png|pdf|jpg|step|stl)$' |
        while read -r file; do [ -f "$file" ] && echo "$file"; done
}

complain() { # complain WHAT: the lines of standard input are findings
    if found=$(grep .); then
        echo "$found" | sed "s|\$|    <- $1|"
        bad=1
    fi
}

list=$(files)
sources=$(echo "$list" | grep -E '\.(c|h)$' || true)

# A // outside of strings, character constants and block comments.
if [ -n "$sources" ]; then
    # shellcheck disable=SC2086
    complain 'a // comment' <<END
$(awk '
    FNR == 1 { inside = 0 }
    {
        line = $0
        while (line != "") {
            if (inside) {
                end = index(line, "*/")
                if (end == 0) {
                    break
                }
                line = substr(line, end + 2)
                inside = 0
            } else if (match(line, /"|\047|\/\*|\/\//)) {
                mark = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                if (mark == "//") {
                    printf "%s:%d: %s\n", FILENAME, FNR, $0
                    break
                }
                if (mark == "/*") {
                    inside = 1
                } else { # a string or a character: to its end
                    while (line != "" && substr(line, 1, 1) != mark) {
                        line = substr(line, substr(line, 1, 1) == "\\" ? 3 : 2)
                    }
                    line = substr(line, 2)
                }
            } else {
                break
            }
        }
    }' $sources)
END
fi

# The brackets keep this file from finding itself.
search() { # search PATTERN WHAT
    # shellcheck disable=SC2086
    complain "$2" <<END
$(echo "$list" | tr '\n' '\0' | xargs -0 grep -nHIE "$1" 2>/dev/null || true)
END
}
search '(^|[^A-Za-z_])(TO[D]O|FIX[M]E|XX[X]|HAC[K])([^A-Za-z_]|$)' 'a mark of unfinished work'
search '(^|[^A-Za-z._])/wor[k]/|\.\./share[d]' 'a path of one machine'
search '(^|[^A-Za-z])[Ii]ssue [#][0-9]|(^|[^A-Za-z])[#][0-9]+ \(issue\)' 'a number that means nothing to a reader'
exit $bad
