# test_make.sh -- make, measure, eval, convert, certify, example, schema: what they take, say and leave behind.
. "$SOURCE/tests/cli/cli.sh"

cat > saddle.json <<'JSON'
{ "taut": 1, "construct": "dirichlet", "unit": "m",
  "u": { "type": "bezier", "degree": 2 }, "v": { "type": "bezier", "degree": 2 },
  "points": [[[-1,-1,0],[-1,0,1],[-1,1,0]], [[0,-1,1],null,[0,1,1]], [[1,-1,0],[1,0,1],[1,1,0]]] }
JSON

# Every output at once, and the report in both forms.
run 0 make saddle.json -o m.json -o m.obj -o m.svg -o m.pdf -o m.png --report r.json
for file in m.json m.obj m.svg m.pdf m.png r.json; do
    [ -s "$file" ] || complain "$file is missing or empty"
done
contains err.txt 'stationary +holds'
contains err.txt '4\.1997155355'
contains r.json '"holds": true'
contains m.json '"unit": "m"'
run 0 make saddle.json --quiet
[ ! -s err.txt ] || complain "--quiet said something"
cmp -s out.txt m.json || complain "standard output is not the same model"
run 0 make - --quiet < saddle.json
cmp -s out.txt m.json || complain "standard input gives another model"

# Saved models: proved again, measured, evaluated, converted.
run 0 certify m.json --json
contains out.txt '"construct": "dirichlet"'
run 0 certify m.json saddle.json
run 0 measure m.json --json
contains out.txt '"area": 4\.1997155355[0-9]{3,}'
run 0 measure m.json
contains out.txt '^area +4\.1997155355 m\^2$' # one digit more than it is good to
contains out.txt '^  max_abs +[0-9.e-]{4,8} 1/m$'
run 0 eval m.json --at 0.5,0.5 --at 0,0 --json
contains out.txt '"point"'
run 0 eval m.json --at 1.0000000000000002,0.5 --json
run 0 convert m.json -o again.json -o again.obj
cmp -s again.json m.json || complain "a model does not survive convert"
sed 's/-0\.[45][0-9]*\]/-0.6]/' m.json > bent.json
cmp -s bent.json m.json && complain "the model was not bent"
run 1 certify bent.json saddle.json
contains err.txt 'stationary +DOES NOT HOLD'
sed 's/\[1,1,0\]/[1,1,0.5]/' saddle.json > elsewhere.json
run 1 certify m.json elsewhere.json
contains err.txt 'known +DOES NOT HOLD'

# The command line is wrong: 2.
refused 2 'command'
refused 2 'command' mkae saddle.json
contains err.txt 'did you mean \\"make\\"'
refused 2 'option' make saddle.json --reprot r.json
contains err.txt 'did you mean --report'
refused 2 'option' make saddle.json --nonsense
contains err.txt 'no option --nonsense'
refused 2 'operand' make
contains err.txt 'needs more'
refused 2 'operand' make saddle.json more.json
contains err.txt 'does not know what to do with more\.json'
refused 2 'option' make saddle.json -o
contains err.txt '-o needs a value'
refused 2 'format model\.xyz' make saddle.json -o model.xyz
contains err.txt 'the ending of model\.xyz'
refused 2 'option a\.json' make saddle.json -o a.json -o a.json
contains err.txt 'a\.json is given twice'
refused 2 'value --tolerance 1,5 found null expected a number from 1e-14 to 1' make saddle.json --tolerance 1,5
refused 2 'value --tolerance nan' make saddle.json --tolerance nan
refused 2 'value --threads 0 found 0' make saddle.json --threads 0
refused 2 'range found 1\.5 expected 1' eval m.json --at 1.5,0
refused 2 'value --at 1 found 1 expected two numbers U,V' eval m.json --at 1
refused 2 'name' eval m.json --surface other --at 0,0
contains err.txt 'no surface other'
refused 2 'name' eval m.json --curve other --at 0
contains err.txt 'no curve other'
refused 2 'option' convert m.json
contains err.txt 'at least one -o'
refused 2 'name' measure m.json --surface other
contains err.txt '--surface other'
refused 2 'name' example nonsense
contains err.txt 'nonsense.*taut example. lists them'
refused 2 'name' example dirichlet-tnt
contains err.txt 'did you mean .*dirichlet-tent'
refused 2 'name' example film
contains err.txt 'did you mean ..film-[a-z]'
refused 2 'name' schema nonsense
contains err.txt 'there are: .*problem'
absent model.xyz a.json more.json

# Files that can't be read or written: 5, and nothing left behind.
refused 5 'read missing\.json' make missing.json
refused 5 'read \.' make .
refused 5 'read no\\u000a\\u001bfile\.json' make "$(printf 'no\n\033file.json')"
run 5 make "$(printf 'no\n\033file.json')" # one line, which cannot move the cursor
[ "$(wc -l < err.txt)" = 1 ] || complain "a name of two lines: $(cat err.txt)"
contains err.txt 'no\?\?file\.json: '
refused 5 'write' make saddle.json --quiet -o nowhere/m.json
contains err.txt 'nowhere/m\.json'
refused 5 'write' make saddle.json --quiet -o good.json -o nowhere/folder.obj
contains err.txt 'nowhere/folder\.obj'
mkdir folder.json
refused 5 'write' make saddle.json --quiet -o folder.json
contains err.txt 'folder\.json'
absent good.json nowhere
if [ -w /dev/full ]; then
    "$TAUT" make saddle.json --quiet > /dev/full 2> err.txt
    [ $? = 5 ] || complain "a full disk is not exit 5"
    [ "$(wc -l < err.txt)" = 1 ] || complain "a full disk: $(cat err.txt)"
    refused 5 'write' make saddle.json --quiet -o other.json --report /dev/full
    contains err.txt '/dev/full'
    absent other.json
    [ -c /dev/full ] || complain "/dev/full was replaced"
fi
"$TAUT" example dirichlet-tent 2> err.txt | head -c 1 > /dev/null

# A comma-decimal locale changes nothing.
for locale in de_DE.UTF-8 fr_FR.UTF-8; do
    LC_ALL=$locale "$TAUT" make saddle.json --quiet > locale.json
    cmp -s locale.json m.json || complain "locale $locale changes the model"
done

for name in $("$TAUT" schema); do
    run 0 schema "$name"
done
run 0 --version
contains out.txt '^taut [0-9]'
[ "$(wc -l < out.txt)" = 1 ] || [ -n "${TAUT_KERNEL:-}" ] || complain "--version says more: $(cat out.txt)"
TAUT_KERNEL=sse9 "$TAUT" --version > out.txt
contains out.txt '^TAUT_KERNEL=sse9 is passed over: '
TAUT_KERNEL=baseline "$TAUT" --version > out.txt
contains out.txt 'baseline kernels$'
[ "$(wc -l < out.txt)" = 1 ] || complain "the baseline is always there: $(cat out.txt)"
for command in make certify measure eval convert example schema; do
    run 0 "$command" --help
    contains out.txt "^taut $command"
    cp out.txt asked.txt
    run 0 help "$command"
    cmp -s out.txt asked.txt || complain "help $command says something else than $command --help"
done
run 0 --help
cp out.txt asked.txt
run 0 help
cmp -s out.txt asked.txt || complain "help says something else than --help"
run 2 help mkae
contains err.txt 'did you mean "make"'
run 2 help make make
finish
