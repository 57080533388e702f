# headers.awk -- what the public headers say, one thing a line: kind, tab, text. `awk -f tools/headers.awk taut.h` follows the
# includes of taut.h in their order; tools/reference.sh and tools/manual_library.sh make pages of it.
#
#     section  a comment of taut.h                   entry  a comment and what it is about; a title for it
#     header   taut/x.h                              name   function, type, constant or macro, blank, a public name of the entry
#     purpose  what the header is for                decl   a line of the declarations
#     para     a paragraph of a comment              code   a line of a formula or a table in a comment
#     item     a parameter, tab, what it must be
#
# A group is what stands between blank lines; a comment in it that is not at the end of a line begins an entry. In comments,
# lines indented by 4 are formulas, and a line that begins with a word and two blanks is about a parameter.

function say(kind, text) {
    printf "%s\t%s\n", kind, text
}

function said() { # the paragraph or parameter that was being read is whole
    if (held != "") {
        say(item ? "item" : purpose ? "purpose" : "para", held)
    }
    held = ""
    item = purpose = 0
}

function prose(    i, s) { # the comment that was kept
    for (i = 1; i <= remarks; i++) {
        s = remark[i]
        if (s == "") {
            said()
        } else if (s ~ /^    / && !item) {
            said()
            say("code", substr(s, 5))
        } else if (match(s, /^[a-z]+(, [a-z]+)*  +/)) {
            said()
            item = 1
            held = substr(s, RSTART + RLENGTH)
            s = substr(s, 1, RLENGTH)
            sub(/ +$/, "", s)
            held = s "\t" held
        } else {
            if (s !~ /^ / && (item || (held ~ /[.:]$/ && s ~ /^(Cost|Sources?|Accuracy|Returns)[: ]/))) {
                said()
            }
            sub(/^ +/, "", s)
            held = held (held == "" ? "" : " ") s
        }
    }
    said()
    remarks = 0
}

function public(what, s,    i) { # a name; once, where a macro has two forms
    for (i = 1; i <= names; i++) {
        if (name[i] == s) {
            return
        }
    }
    kind[++names] = what
    name[names] = s
}

# The names of a declaration, comments left out of it.
function declared(s,    i, n, part) {
    if (s ~ /^#define/) {
        sub(/^#define /, "", s)
        match(s, /^[A-Za-z0-9_]+/)
        public("macro", substr(s, 1, RLENGTH))
        while (match(s, /X\(TAUT_[A-Z0-9_]+/)) { # a list of names
            public("constant", substr(s, RSTART + 2, RLENGTH - 2))
            s = substr(s, RSTART + RLENGTH)
        }
        return
    }
    if (s ~ /^TAUT_API/) {
        match(s, /taut_[a-z0-9_]+\(/)
        public("function", substr(s, RSTART, RLENGTH - 1))
        return
    }
    if (s ~ /^typedef/ && match(s, /taut_[a-z0-9_]+;/)) {
        public("type", substr(s, RSTART, RLENGTH - 1))
    }
    if (s ~ /^(typedef )?enum/) {
        sub(/^[^{]*[{]/, "", s)
        sub(/[}][^}]*$/, "", s)
        n = split(s, part, ",")
        for (i = 1; i <= n; i++) {
            if (match(part[i], /^ *TAUT_[A-Z0-9_]+ *(=|$)/)) {
                gsub(/ |=.*/, "", part[i])
                public("constant", part[i])
            }
        }
    }
}

# The names of an entry in a line: constants only where there is nothing else, and what all begin with only once.
function title(    i, n, head, stem, all) {
    for (i = 1; i <= names; i++) {
        if (kind[i] != "constant" || kind[1] == "constant") {
            head[++n] = name[i]
        }
    }
    stem = head[1]
    for (i = 2; i <= n; i++) {
        while (index(head[i] "_", stem "_") != 1 && sub(/_[^_]*$/, "", stem)) { }
    }
    all = head[1]
    for (i = 2; i <= n; i++) {
        all = all ", " (n > 2 && stem ~ /_/ && head[i] != stem ? substr(head[i], length(stem) + 1) : head[i])
    }
    return all
}

function close_entry(    i) {
    if (!lines) {
        return # a comment alone belongs to what follows
    }
    say("entry", title())
    for (i = 1; i <= names; i++) {
        say("name", kind[i] " " name[i])
    }
    prose()
    for (i = 1; i <= lines; i++) {
        say("decl", line[i])
    }
    lines = names = 0
}

FNR == 1 {
    close_entry()
    all = FILENAME ~ /taut\/taut\.h$/
    folder = FILENAME
    sub(/taut\/[^\/]*$/, "", folder)
    head = 1
}
all {
    if (/^\/\* [^-]*\*\/$/) {
        gsub(/^\/\* | \*\/$/, "")
        section = $0
    } else if (/^#include/) {
        gsub(/^#include "|"$/, "")
        ARGV[ARGC++] = folder $0
        under[folder $0] = section
    }
    next
}
FNR == 1 {
    if (under[FILENAME] != last) {
        say("section", last = under[FILENAME])
    }
    say("header", substr(FILENAME, length(folder) + 1))
    sub(/^\/\* taut\/[a-z]+\.h -- /, "/* ")
    purpose = 1
}

# What only the compiler reads.
/^#ifdef __cplusplus/ { skip = 1 }
skip { skip = !/^#endif/; next }
/^#include|^#(ifndef|define) [A-Z_]*_H$|_H \*\/$/ { next }

/^\/\*/ && !inside && !open && !more {
    close_entry()
    inside = 1
    sub(/^\/\* ?/, "")
    $0 = " * " $0
}
inside {
    inside = !/\*\/$/
    sub(/ *\*\/$/, "")
    sub(/^ \*? ?/, "")
    if (inside || $0 != "") {
        remark[++remarks] = $0
    }
    if (!inside && head) {
        prose()
        head = 0
    }
    next
}

/^$/ && !open && !more { close_entry(); next }
{
    if (!open && !more) {
        whole = ""
        shift = /^TAUT_API / ? 9 : 0
    }
    text = $0
    if (shift && text ~ /^(         |TAUT_API )/) {
        text = substr(text, 10)
    }
    line[++lines] = text

    code = $0 # without comments
    if (remarking) {
        remarking = code !~ /\*\//
        code = remarking ? "" : substr(code, index(code, "*/") + 2)
    }
    while (match(code, /\/\*([^*]|\*[^\/])*\*\//)) {
        code = substr(code, 1, RSTART - 1) substr(code, RSTART + RLENGTH)
    }
    if ((at = index(code, "/*")) > 0) {
        code = substr(code, 1, at - 1)
        remarking = 1
    }
    macro = whole ~ /^#/ || (whole == "" && code ~ /^#/)
    whole = whole (whole == "" || macro ? "" : " ") code
    sub(/ +$/, "", whole)
    if (!macro) {
        open += gsub(/[{]/, "{", code) - gsub(/[}]/, "}", code)
    }
    more = remarking || (macro ? whole ~ /\\$/ : whole !~ /;$/)
    if (!open && !more) {
        declared(whole)
    }
}
END { close_entry() }
