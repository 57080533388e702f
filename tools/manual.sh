#!/bin/sh
# manual.sh TAUT -- the manual page, made of what the program says of itself, so that the two agree.
set -eu
taut=$1

# Text as it stands: backslashes, and lines that begin with a dot or a quote, would mean something to troff.
verbatim() {
    printf '.nf\n'
    sed 's/\\/\\e/g; s/-/\\-/g; s/^\([.'"'"']\)/\\\&\1/'
    printf '.fi\n'
}

version=$("$taut" --version | sed 's/^taut *//; s/,.*//; 1q')
printf '.TH TAUT 1 "" "taut %s" "User commands"\n' "$version"
printf '.SH NAME\ntaut \\- build surfaces from what bounds them, and prove what was built\n'
printf '.SH SYNOPSIS\n.B taut\n.I COMMAND\n[\n.I ARGUMENT\n]...\n'
printf '.SH DESCRIPTION\n'
"$taut" --help | verbatim
printf '.SH COMMANDS\n'
for command in $("$taut" --help | sed -n 's/^  taut \([a-z]*\)  .*/\1/p'); do
    printf '.SS %s\n' "$command"
    "$taut" "$command" --help | verbatim
done
printf '.SH SEE ALSO\n.BR taut (3),\n.BR taut (5).\nThe formats of problems, models and reports are described in docs/format.md of the sources;\n'
printf '.B taut schema\nprints them as JSON Schema.\n'
