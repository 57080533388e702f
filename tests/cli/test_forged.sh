#!/bin/sh
# test_forged.sh -- models that no construction made, each of which passed a claim that it does not meet: by a point of little
# weight, by a derivative that the degree does not have, by a surface so large that a gap beside it seems small, by a film
# whose measured area is worth nothing, by coordinates so far away that rounding is all there is, by one frame of several that
# rounding hides, beside a cable so strong that the film's own derivatives are nothing, along a cable so faint that its force is
# 0, by waves that vanish wherever a pipe is looked at, by a bump on a straight edge, by a hook too small for doubles,
# by bends so small that all their products vanish, which once were halved for ever.
. "$(dirname "$0")/cli.sh"
# model: claim that must not hold
while read -r name claim; do
    "$TAUT" certify "$SOURCE/tests/cli/forged/$name.model.json" "$SOURCE/tests/cli/forged/$name.problem.json" \
        > out.txt 2> err.txt
    if grep -Eq "^  $claim +holds" out.txt err.txt; then
        complain "$name: \"$claim\" holds"
    fi
    grep -Eq "^  $claim +(DOES NOT HOLD|undecided)" out.txt err.txt || complain "$name: nothing is said of \"$claim\""
done <<'LIST'
dirichlet-light-point stationary
harmonic-degree-1 harmonic
biharmonic-cubic biharmonic
harmonic-extension-lifted continuity
dirichlet-far stationary
bonnet-flattened algebraic
plateau-light-point least
plateau-light-point stationary
film-strong-cable stationary
film-faint-cable stationary
pipe-elliptic-waves tube
asymptotic-bumped osculating
pipe-hook embedded
pipe-vanishing embedded
LIST
finish
