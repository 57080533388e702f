#!/bin/sh
# test_claim_mutants.sh -- tools/claim_mutants.py counts what breaks the code of a claim, at any distance and no other, and fails where
# the page says more.
. "${SOURCE:?the source tree}/tests/tools/tools.sh"

# Two claims: one by a function of its own that has a constant, one by what both call.
mkdir -p "$tree/tools" "$tree/docs" "$tree/src/certify/pipe" "$tree/tests/mutants"
cp "$SOURCE/tools/claim_mutants.py" "$SOURCE/tools/mutant_table.py" "$tree/tools"
cat > "$tree/src/certify/pipe/two.c" <<'END'
static const double most = 9;

static double common(double x)
{
    return x + 1;
}

static double only(double x)
{
    return x > most ? common(x) : 0;
}

static int add_caps(double x)
{
    return add("caps", only(x));
}

static int add_ends(double x)
{
    return add("ends", common(x));
}
END
row() { # row NAME OLD NEW
    printf '    {"name": "%s", "what": "it", "file": "src/certify/pipe/two.c", "old": "%s", "new": "%s", "caught_by": "^x$"}' "$@"
}
{
    echo '['
    row both 'return x + 1;' 'return x;'
    echo ,
    row constant 'most = 9' 'most = 8'
    echo ,
    row one 'x > most' 'x < most'
    echo
    echo ']'
} > "$tree/tests/mutants/certify.json"

page() { # page CAPS ENDS
    printf '| pipe | `caps` | bound | 3 | 0 |  | %s |\n| pipe | `ends` | exact | 3 | 0 |  | %s |\n' "$@" > "$tree/docs/certificate.md"
}
page 3 1
said=$("$tree/tools/claim_mutants.py" --check 2>&1) || fail "the page is right: $said"
page 3 2
said=$("$tree/tools/claim_mutants.py" --check 2>&1) && fail "the page says one more: $said"
case $said in *'pipe ends: 1 mutants, docs/certificate.md says 2'*) ;; *) fail "it does not say which claim: $said" ;; esac
said=$("$tree/tools/claim_mutants.py" pipe caps | tr '\n' ' ')
test "$said" = 'both constant one ' || fail "rows of caps: $said"
said=$("$tree/tools/claim_mutants.py" pipe ends)
test "$said" = both || fail "rows of ends: $said"
: > "$tree/docs/certificate.md"
said=$("$tree/tools/claim_mutants.py" --check 2>&1) && fail "there is no table: $said"
finish
