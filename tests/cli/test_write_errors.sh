# test_write_errors.sh -- full disks, closed pipes, limits, folders that take nothing, and being killed half way: the exit code
# that was promised, one line on standard error, and no file, whole or in part, that was not there before.
. "$SOURCE/tests/cli/cli.sh"
"$TAUT" example dirichlet-tent > problem.json
endings='json obj stl ply glb svg'

# A device that is full, under any ending; what was to appear beside it does not.
if [ -w /dev/full ]; then
    for ending in $endings; do
        ln -s /dev/full "full.$ending"
        refused 5 'write' make problem.json --quiet -o beside.json -o "full.$ending"
        contains err.txt "full\.$ending: [Nn]o space"
        [ -L "full.$ending" ] || complain "full.$ending was replaced"
        rm "full.$ending"
    done
    absent beside.json
    [ -c /dev/full ] || complain "/dev/full was replaced"
    for command in 'example dirichlet-tent' 'measure model.json --json' 'reproduce harmonic' 'schema model' '--help'; do
        "$TAUT" make problem.json --quiet -o model.json
        # shellcheck disable=SC2086
        "$TAUT" $command > /dev/full 2> err.txt
        code=$?
        [ $code = 5 ] || complain "$command to a full disk: exit $code"
        [ "$(wc -l < err.txt)" = 1 ] || complain "$command to a full disk: $(cat err.txt)"
    done
fi

# A file that may not grow so far.
for ending in obj glb svg; do
    (ulimit -f 1 && "$TAUT" make problem.json --quiet -o "limited.$ending" 2> err.txt)
    code=$?
    [ $code = 5 ] || complain "a file limit, .$ending: exit $code"
    [ "$(wc -l < err.txt)" = 1 ] || complain "a file limit: $(cat err.txt)"
    absent "limited.$ending"
done

# A pipe that nobody reads any more.
mkfifo gone
true < gone &
exec 3> gone # waits for the reader, who leaves
wait $!
"$TAUT" make problem.json --quiet >&3 2> err.txt
code=$?
exec 3>&-
[ $code = 5 ] || complain "a closed pipe: exit $code"
[ "$(wc -l < err.txt)" = 1 ] || complain "a closed pipe: $(cat err.txt)"

# Folders that take nothing, for root either.
refused 5 'write' make problem.json --quiet -o beside.obj -o /proc/taut-model.json
contains err.txt '/proc/taut-model\.json'
absent beside.obj
if [ "$(id -u)" != 0 ]; then
    mkdir closed
    chmod a-w closed
    refused 5 'write' make problem.json --quiet -o beside.obj -o closed/model.json
    contains err.txt 'closed'
    absent beside.obj
fi
mkdir old
echo old > old/model.json
refused 5 'write' make problem.json --quiet -o old/model.json -o nowhere/model.obj
contains err.txt 'nowhere/model\.obj'
[ "$(cat old/model.json)" = old ] || complain "a file was replaced although another could not be written"

# Stopped half way: one output is written but not yet in place, the next waits for a reader who never comes.
stop() { # stop SIGNAL EXPECTED-EXIT SECOND-OUTPUT
    mkfifo slow.ply
    "$TAUT" make problem.json --quiet -o first.json -o "$3" -o slow.ply 2> err.txt &
    pid=$!
    tries=0
    # both outputs are being written when it holds two files without a name, or two with a hidden one
    while [ "$(ls -l "/proc/$pid/fd" 2> /dev/null | grep -c '(deleted)')" -lt 2 ] &&
        [ "$(find . -name '.taut-*' | wc -l)" -lt 2 ]; do
        sleep 0.05
        tries=$((tries + 1))
        [ $tries -lt 400 ] || { complain "nothing is written after 20 s"; break; }
    done
    kill "-$1" $pid
    wait $pid 2> /dev/null
    code=$?
    [ $code = "$2" ] || complain "SIG$1: exit $code, expected $2"
    rm -f slow.ply
    absent first.json "$3"
}
stop INT 130 second.obj
stop TERM 143 second.obj
stop HUP 129 second.obj

# Even where no handler can run nothing is left, if the system has files without a name.
if ! python_with os; then
    missing python3 'tools/deps.sh test'
elif "$PYTHON" -c 'import os; os.open(".", os.O_TMPFILE | os.O_WRONLY)' 2> /dev/null; then
    stop KILL 137 second.obj
    "$TAUT" make problem.json --quiet -o whole.step 2> /dev/null && stop KILL 137 second.step # another library writes it
fi
finish
