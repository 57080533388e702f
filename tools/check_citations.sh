#!/bin/sh
# check_citations.sh [ROOT] -- every citation such as [PieglTiller1997] has its entry in docs/references.bib.
set -eu
cd "${1:-$(dirname "$0")/..}"
bib=docs/references.bib
if [ ! -f $bib ]; then
    echo "check_citations: $bib is missing" >&2
    exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sed -n 's/^@[A-Za-z]*{ *\([A-Za-z0-9:-]*\) *,.*/\1/p' $bib | sort > "$work/listed"
bad=0
if twice=$(uniq -d "$work/listed" | grep .); then
    echo "$bib: more than once: $(echo "$twice" | tr '\n' ' ')"
    bad=1
fi

# Author names, a year, perhaps a letter; and the one reference that has no year.
pattern='\[([A-Z][A-Za-z]+[12][0-9][0-9][0-9][a-z]?|DLMF)\]'
places=
for place in README.md CONTRIBUTING.md CHANGELOG.md src include tests bench docs examples; do
    [ -e "$place" ] && places="$places $place"
done
# shellcheck disable=SC2086
grep -rnoIE "$pattern" $places --exclude=references.bib --exclude=test_checks.sh --exclude-dir=corpus > "$work/cited" || true
sed 's/.*\[\(.*\)\]$/\1/' "$work/cited" | sort -u > "$work/keys"
comm -23 "$work/keys" "$work/listed" | sort -u > "$work/unknown"
while read -r key; do
    grep "\[$key\]" "$work/cited" | head -n 3 | sed "s|\$|    <- not in $bib|"
    bad=1
done < "$work/unknown"
exit $bad
