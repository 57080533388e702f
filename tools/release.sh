#!/bin/bash
# release.sh [--parts "PART ..."] [OUT] -- what a release is made of, in one folder (default out/taut-VERSION), from a clean
# tree whose commit has the tag vVERSION: the tarball, the Debian package, the wheel, the zip and the wheel for Windows, the studio page,
# the site, the notes out of CHANGELOG.md, and checksums of them all. Refuses anything else, and leaves no folder then.
#
#     parts   tarball deb wheel windows studio site notes (all without --parts; checksums always)
set -eu
cd "$(dirname "$0")/.."
parts="tarball deb wheel windows studio site notes"
if [ "${1:-}" = --parts ]; then
    parts=$2
    shift 2
fi

refuse() {
    echo "release.sh: $*" >&2
    exit 1
}

version=$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ -n "$version" ] || refuse "CMakeLists.txt says no version"
out=${1:-out/taut-$version}
[ -z "$(git status --porcelain)" ] || refuse "the tree is not clean: $(git status --porcelain | head -n 3 | tr '\n' ' ')"
[ "$(git tag --points-at HEAD --list "v$version")" = "v$version" ] || refuse "this commit has no tag v$version"
heading=$(grep -m 1 "^## $version" CHANGELOG.md) || refuse "CHANGELOG.md has no section $version"
case $heading in
*unreleased*) refuse "CHANGELOG.md calls $version unreleased: give it its date" ;;
"## $version, "[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]) ;;
*) refuse "CHANGELOG.md: \"$heading\" is not \"## $version, YEAR-MONTH-DAY\"" ;;
esac
for file in include/taut/version.h python/taut/_library.py CITATION.cff; do
    [ ! -e "$file" ] || grep -qE "(VERSION =? ?\"|version: )$version\"?$" "$file" || refuse "$file is of another version"
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/release"
one() { # one PATTERN: the only file of that name
    # shellcheck disable=SC2086
    set -- $1
    [ $# = 1 ] && [ -e "$1" ] || refuse "expected one file, found: $*"
    echo "$1"
}

for part in $parts; do
    echo "== $part"
    case $part in
    tarball) # the same bytes from the same commit: git writes its date into each entry, gzip none
        git archive --format=tar --prefix="taut-$version/" HEAD | gzip -9n > "$work/release/taut-$version.tar.gz"
        ;;
    notes)
        awk -v heading="$heading" '$0 == heading { on = 1; next } /^## / { on = 0 } on' CHANGELOG.md > "$work/release/NOTES.md"
        grep -q . "$work/release/NOTES.md" || refuse "CHANGELOG.md says nothing of $version"
        ;;
    deb)
        rm -f build/*.deb
        make deb
        cp "$(one 'build/*.deb')" "$work/release/"
        ;;
    wheel)
        make python
        cp "$(one 'build/python/*.whl')" "$work/release/"
        ;;
    windows)
        rm -f build/taut-*-windows-*.zip
        make windows
        tools/python.sh windows
        cp "$(one 'build/taut-*-windows-*.zip')" "$(one 'build/python-windows/*.whl')" "$work/release/"
        ;;
    studio)
        make studio
        cp out/studio.html "$work/release/taut-$version-studio.html"
        ;;
    site)
        make site
        tar --sort=name --owner=0 --group=0 --mtime="@$(git log -1 --format=%ct)" -C out -czf "$work/release/taut-$version-site.tar.gz" site
        ;;
    *) refuse "no part \"$part\"; there are tarball, deb, wheel, windows, studio, site and notes" ;;
    esac
done
(cd "$work/release" && sha256sum -- * > "$work/SHA256SUMS" && mv "$work/SHA256SUMS" .)
rm -rf "$out"
mkdir -p "$(dirname "$out")"
cp -r "$work/release" "$out"
echo "$out:"
ls -l "$out" | awk 'NR > 1 { printf "  %12d  %s\n", $5, $9 }'
