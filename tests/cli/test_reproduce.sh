# test_reproduce.sh -- the rows of one paper; the JSON is whole; an unknown paper is named. All papers: test_reproduction.sh.
. "$SOURCE/tests/cli/cli.sh"
run 0 reproduce dirichlet
contains out.txt 'rows, 0 that should agree and do not'
grep -q 'differs' out.txt && complain "$(grep differs out.txt)"
run 0 reproduce dirichlet --json
contains out.txt '"verdict": "agrees"'
contains out.txt '"verdict": "erratum"'
refused 2 'name' reproduce nonsense
contains err.txt 'there are: .*dirichlet'
finish
