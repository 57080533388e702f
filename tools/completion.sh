#!/bin/sh
# completion.sh TAUT -- completion for bash, made of what the program says of itself, so that the two agree: commands, options,
# their values and papers now, names of examples and schemas when the user asks for them.
set -eu
taut=$1
commands=$("$taut" --help | sed -n 's/^  taut \([a-z]*\)  .*/\1/p' | tr '\n' ' ')
papers=$("$taut" reproduce '?' 2>&1 | sed -n 's/.*there are: //; s/,//gp' || true)

printf '# Completion of taut for bash, made by tools/completion.sh.\n'
printf '_taut_options()\n{\n    case $1 in\n'
for command in $commands; do
    flags=$("$taut" "$command" --help | sed -n 's/^  \(-[-a-z]*\) .*/\1/p' | tr '\n' ' ')
    printf '    %s) echo "%s--help" ;;\n' "$command" "$flags"
done
printf '    esac\n}\n\n'

# After an option whose value is no file none is offered.
printf '_taut_takes_word()\n{\n    case $1 in\n    '
for command in $commands; do
    "$taut" "$command" --help | sed -n 's/^  \(-[-a-z]*\) \([^ ][^ ]*\)  .*/\1 \2/p'
done | sort -u | awk '$2 !~ /^FILE/ { printf "%s%s", n++ ? " | " : "", $1 }'
printf ') return 0 ;;\n    *) return 1 ;;\n    esac\n}\n\n'

# Where the value is one of a few words, they are offered.
printf '_taut_values()\n{\n    case $1 in\n'
for command in $commands; do
    "$taut" "$command" --help | grep -o -e '--[a-z-]* [A-Za-z][A-Za-z]*|[A-Za-z|]*' || true
done | sort -u | while read -r option values; do
    printf '    %s) echo "%s" ;;\n' "$option" "$(echo "$values" | tr '|' ' ')"
done
printf '    esac\n}\n\n'

cat <<'END'
_taut()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
END
printf '        words="%shelp --help --version"\n' "$commands"
cat <<'END'
    elif _taut_takes_word "$before"; then
        words=$(_taut_values "$before")
    elif [ "${word#-}" != "$word" ]; then
        words=$(_taut_options "$command")
    else
        case $command in
        example | schema) words=$("${COMP_WORDS[0]}" "$command" 2> /dev/null) ;;
END
printf '        help) words="%s" ;;\n        reproduce) words="%s" ;;\n' "$commands" "$papers"
cat <<'END'
        join)
            COMPREPLY=($(compgen -W "u0 u1 v0 v1" -- "$word") $(compgen -f -- "$word"))
            return
            ;;
        *) COMPREPLY=($(compgen -f -- "$word")) && return ;;
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o filenames -F _taut taut
END
