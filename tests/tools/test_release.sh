# test_release.sh -- a release comes from a clean commit with the tag of its version and a dated section in the changelog, and
# from nothing else; its files are those of the commit, with right checksums, the same twice. Parts that need the build are
# left to `make release`.
. "$SOURCE/tests/tools/tools.sh"

release() { # release CODE PATTERN: the parts that need no build
    (cd "$tree/project" && tools/release.sh --parts "tarball notes" "$tree/out") > "$tree/said" 2>&1
    code=$?
    [ $code = "$1" ] || fail "exit $code, expected $1: $(cat "$tree/said")"
    grep -q "$2" "$tree/said" || fail "no line like $2: $(cat "$tree/said")"
    [ "$1" = 0 ] || [ ! -e "$tree/out" ] || fail "a folder is left: $2"
}
commit() {
    git -C "$tree/project" add -A
    git -C "$tree/project" -c user.name=Test -c user.email=test@localhost commit -qm "$1"
}

mkdir -p "$tree/project/tools" "$tree/project/include/taut"
cp "$SOURCE/tools/release.sh" "$tree/project/tools/"
cd "$tree/project" || exit 1
git init -q .
echo 'project(taut VERSION 1.2.3 LANGUAGES C)' > CMakeLists.txt
echo '#define TAUT_VERSION "1.2.3"' > include/taut/version.h
printf '# Changelog\n\n## 1.2.3, unreleased\n\n- This.\n\n## 1.2.2, 2025-01-01\n\n- That.\n' > CHANGELOG.md
commit one
release 1 'has no tag v1.2.3'
git tag v1.2.3
release 1 'calls 1.2.3 unreleased'
sed -i 's/unreleased/soon/' CHANGELOG.md
release 1 'is not clean'
commit two
git tag -f v1.2.3 > /dev/null
release 1 'YEAR-MONTH-DAY'
sed -i 's/soon/2026-01-31/' CHANGELOG.md
echo '#define TAUT_VERSION "1.2.2"' > include/taut/version.h
commit three
git tag -f v1.2.3 > /dev/null
release 1 'version.h is of another version'
echo '#define TAUT_VERSION "1.2.3"' > include/taut/version.h
commit four
release 1 'has no tag'
git tag -f v1.2.3 > /dev/null
release 0 'taut-1.2.3.tar.gz'
[ "$(ls "$tree/out" | tr '\n' ' ')" = 'NOTES.md SHA256SUMS taut-1.2.3.tar.gz ' ] || fail "files: $(ls "$tree/out")"
(cd "$tree/out" && sha256sum --quiet -c SHA256SUMS) || fail "checksums"
[ "$(grep . "$tree/out/NOTES.md")" = '- This.' ] || fail "notes: $(cat "$tree/out/NOTES.md")"
tar -xzf "$tree/out/taut-1.2.3.tar.gz" -C "$tree"
diff -r --exclude=.git "$tree/project" "$tree/taut-1.2.3" || fail "the tarball differs from the commit"
cp "$tree/out/SHA256SUMS" "$tree/before"
release 0 'taut-1.2.3.tar.gz'
cmp "$tree/before" "$tree/out/SHA256SUMS" || fail "the same commit gives other bytes"
finish
