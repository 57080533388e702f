# test_help.sh -- help of commands, each with an example that the program takes; help of every reason; titles of examples.
. "$SOURCE/tests/cli/cli.sh"

commands=$("$TAUT" --help | sed -n 's/^  taut \([a-z]*\)  .*/\1/p')
[ "$(echo "$commands" | wc -l)" -ge 16 ] || complain "few commands: $commands"
for command in $commands; do
    run 0 "$command" --help
    cp out.txt said.txt
    run 0 help "$command"
    cmp -s out.txt said.txt || complain "taut help $command differs from taut $command --help"
    sed '/^Example:$/,$d' said.txt | awk 'length > 100' > wide.txt
    [ ! -s wide.txt ] || complain "taut $command --help is too wide for a terminal: $(cat wide.txt)"
    sed -n '/^Example:$/,$p' said.txt | grep -q "^  taut $command " || complain "taut $command --help shows no example"
done

# Every reason of every list, in the headers and here, and none is the name of a command.
python_with json || skip Python 'tools/deps.sh test'
"$PYTHON" - "$SOURCE" > reasons.txt <<'PY'
import glob, re, sys
for path in sorted(glob.glob(sys.argv[1] + "/include/taut/*.h")) + [sys.argv[1] + "/src/cli/cli.h"]:
    text = open(path, encoding="utf-8").read()
    for body in re.findall(r"REASON_LIST\(X\)((?:.*\\\n)*.*)", text):
        for word in re.findall(r'X\(\s*"([a-z0-9-]+)"', body):
            print(word)
PY
[ "$(sort -u reasons.txt | wc -l)" -gt 120 ] || complain "few reasons: $(wc -l < reasons.txt)"
for word in $(sort -u reasons.txt); do
    run 0 help "$word"
    [ "$(grep -c "^$word, a reason of errors" out.txt)" = "$(grep -cx -- "$word" reasons.txt)" ] ||
        complain "taut help $word: told $(cat out.txt)"
    [ "$(grep -c '^  What to do: ' out.txt)" = "$(grep -cx -- "$word" reasons.txt)" ] || complain "taut help $word: no remedy"
    for page in $(sed -n 's/^  More: *//p' out.txt); do
        [ -e "$SOURCE/$page" ] || complain "taut help $word leads to $page, which is not there"
    done
    [ -z "$(awk 'length > 100' out.txt)" ] || complain "taut help $word is too wide for a terminal: $(cat out.txt)"
    if echo "$commands" | grep -qx -- "$word"; then complain "$word is a command and a reason"; fi
done
# Constructions, claims and words of the report: rows of tables of the pages. Every claim of the examples has one.
for word in asymptotic biharmonic bonnet dirichlet film harmonic harmonic-extension pattern pipe plateau trace; do
    run 0 help "$word"
    contains out.txt '^  It (needs|may have): +[a-z]'
    contains out.txt "^$word, a construction$"
    contains out.txt "^  Documents: +taut example --construct $word$"
    contains out.txt "^  Example: +taut example $word[a-z0-9-]* \| taut make - -o model.json -o model.png$"
    page=$(sed -n 's/^  More: *//p' out.txt | head -n 1)
    [ -s "$SOURCE/$page" ] || complain "taut help $word leads to $page"
done
# Members of documents: every one that a schema of a problem has, with the construction that it is of.
"$PYTHON" - "$SOURCE" > members.txt <<'PY'
import json, sys
problem = json.load(open(sys.argv[1] + "/docs/schema/problem.json", encoding="utf-8"))
for name, schema in sorted(problem["$defs"].items()):
    if "construct" in schema.get("properties", {}):
        for construct in [schema["properties"]["construct"].get("const")]:
            for member in schema["properties"]:
                if construct is not None and member not in ("taut", "construct", "unit", construct):
                    print(construct, member)
PY
[ "$(sort -u members.txt | wc -l)" -gt 100 ] || complain "few members of documents: $(wc -l < members.txt)"
for member in $(sed 's/.* //' members.txt | sort -u); do
    "$TAUT" help "$member" > "member-$member.txt" 2> /dev/null || complain "taut help $member says nothing"
done
sort -u members.txt > unique.txt
while read -r construct member; do
    contains "member-$member.txt" "^$member, a member of problems \(\`$construct\`\)$"
done < unique.txt
run 0 help unit
contains out.txt '^unit, a member of every problem$'
run 0 help c-bezier
contains out.txt '^  Members: +`alpha`'
run 0 help CURVE
contains out.txt '^  Written: +\{ "name": "rim", "t": BASIS|^  Written: +`\{ "name": "rim", "t": BASIS'
for word in force cable LAW; do
    run 0 help "$word"
    contains out.txt '^  Written: +`\{ "force": T \}`'
done
run 0 help pipe
contains out.txt '^  It needs: +radius, from, to \(or others in their place\)$'
run 0 help bonnet
contains out.txt '^  It needs: +lambda, sign, alpha, beta$'
# a member has a row of its own
run 0 help updates
contains out.txt '^  Default: +0\.$'
run 0 help count
contains out.txt '^  Default: +12\.$'
for word in EDGE CORNER PLANE LINE IMAGE; do
    run 0 help "$word"
    contains out.txt "^$word, a part of documents\$"
done

claims=$(sed -n '/^<!-- claims: made by/,$s/^| [a-z-]* | `\([a-z0-9_-]*\)` |.*/\1/p' "$SOURCE/docs/certificate.md" | sort -u)
[ "$(echo "$claims" | wc -l)" -gt 40 ] || complain "few claims: $claims"
for claim in $claims; do
    run 0 help "$claim"
    echo "$commands" | grep -qx -- "$claim" || contains out.txt "^$claim, a claim of certificates"
done
for kind in exact bound check; do
    run 0 help "$kind"
    contains out.txt "^$kind, a kind of claims$"
done
# what the report of a sail calls its numbers
"$TAUT" example film-sail | "$TAUT" make - > /dev/null 2> report.txt
sed -n 's/^  \([a-z][a-z ]*[a-z]\)   *.*/\1/p' report.txt > words.txt
echo 'does not hold' >> words.txt
[ "$(wc -l < words.txt)" -gt 25 ] || complain "few words in the report of a sail: $(cat words.txt)"
while read -r word; do
    run 0 help "$word"
    grep -q -e ', a word of the report$' -e ', a claim of ' out.txt || complain "taut help $word: $(cat out.txt)"
done < words.txt
for asks in 'help help' 'help --help' 'help -h' help -h; do
    run 0 $asks
    contains out.txt '^  taut make  .*'
done
run 0 help lowest eigenvalue
contains out.txt '^lowest_eigenvalue, a word of the report$'
if grep -q -e '\*\*' -e '](' out.txt; then complain "marks of Markdown: $(cat out.txt)"; fi
run 2 help laest
contains err.txt 'did you mean "least"'
run 2 help cabel-too-weak
contains err.txt 'did you mean "cable-too-weak"'

# A message names where to read on; with --json the one line is as it was.
echo '{ "taut": 1, "construct": "dirichlet" }' > bad.json
run 3 make bad.json
contains err.txt '^taut: bad\.json: .* \(see: taut help missing\)$'
[ "$(wc -l < err.txt)" = 1 ] || complain "a message of several lines: $(cat err.txt)"
refused 3 'missing' make bad.json
if grep -q 'taut help' err.txt; then complain "--json has what is for people: $(cat err.txt)"; fi
# a member that is like no other one: all that a pipe has
echo '{ "taut": 1, "construct": "pipe", "waypoints": [] }' > bad.json
run 3 make bad.json
contains err.txt '/waypoints: there is no such member here, expected "taut", .*"polygon", "from", "to", "axes", .* or "wall"'
run 2 make --nonsense
if grep -q 'see: taut help' err.txt; then complain "a wrong option leads away from its --help"; fi

# Each word on the left of the report of any example is explained.
"$TAUT" example > examples.txt
while read -r example; do
    "$TAUT" example "$example" > problem.json
    "$TAUT" make problem.json -o model.json < /dev/null 2>&1 || [ $? = 1 ] || complain "$example fails"
done < examples.txt > reports.txt
sed -n 's/^  \([a-z][a-z0-9 -]*[a-z0-9]\)  .*/\1/p' reports.txt | sort -u > labels.txt
[ "$(wc -l < labels.txt)" -ge 150 ] || complain "few labels: $(cat labels.txt)"
while read -r label; do
    "$TAUT" help "$label" > /dev/null 2>&1 || complain "taut help $label: not explained"
done < labels.txt

# A pipe gets bare names, a terminal a title beside each.
run 0 example
cp out.txt names.txt
if grep -q ' ' names.txt; then complain "a pipe gets more than names: $(grep -m 1 ' ' names.txt)"; fi
run 0 example --construct pipe
grep '^pipe-' names.txt > pipes.txt
cmp -s out.txt pipes.txt || complain "example --construct pipe: $(diff out.txt pipes.txt)"
refused 2 'value --construct pip' example --construct pip
if command -v script > /dev/null; then
    script -qc "'$TAUT' example --construct film" /dev/null > told.txt < /dev/null
    contains told.txt '^film-sail +a sail between four cables of given force'
    [ "$(wc -l < told.txt)" = "$(grep -c '^film-' names.txt)" ] || complain "a title a line: $(cat told.txt)"
fi
finish
