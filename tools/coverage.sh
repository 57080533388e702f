#!/bin/bash
# coverage.sh [LAYER...] -- builds with gcc's counters in build/coverage, runs all tests but those of tools, and prints which
# share of each layer's lines they ran (basis, geometry, construct, certify, io, or those named; `all` for every one). A line
# that no test can reach says why in place:
#
#         if (sum < 0) { /* not reached: squares add up to no less than 0 */
#             taut_free(points);
#             return TAUT_INTERNAL;
#         }
#
# Behind code the reason is for that line and the deeper ones below it; alone on its line, for the rest of its block. Such lines
# are not counted unless they were run. What was missed is in build/coverage/missed.txt, and each reason all of whose lines were
# run; the exit code is 1 where it is not empty.
set -u
cd "$(dirname "$0")/.." || exit 1
root=$PWD
build=$root/build/coverage
layers=("$@")
[ ${#layers[@]} -gt 0 ] || layers=(basis geometry construct certify io)
[ "${layers[0]}" = all ] && mapfile -t layers < <(cd src && ls -d */ | tr -d /)

# A child that ends by _exit would lose its counts.
mkdir -p "$build"
cat > "$build/count_at_exit.h" <<'END'
extern void _exit(int) __attribute__((noreturn));
extern void __gcov_dump(void);
static inline __attribute__((noreturn, unused)) void count_and_exit(int code)
{
    __gcov_dump();
    (_exit)(code);
}
#define _exit(code) count_and_exit(code)
END
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_C_FLAGS="-O1 --coverage -fprofile-update=atomic -include $build/count_at_exit.h" \
    > "$build.log" 2>&1 && cmake --build "$build" >> "$build.log" 2>&1 || { tail -n 20 "$build.log"; exit 1; }
find "$build" -name '*.gcda' -delete
ctest --test-dir "$build" -E '^tools/' -j "$(nproc)" > "$build/tests.log" 2>&1
# but for one, whose limits the counters' files meet too
sed -n '/tests FAILED/,/^Errors/s/^\t/failed: /p' "$build/tests.log" | grep -v 'cli/write_errors'

# gcov's text: "count:line:source"; '#####' where a line never ran. One object per source, so the counts are whole.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: > "$build/missed.txt"
for layer in "${layers[@]}"; do
    mkdir -p "$work/$layer"
    (cd "$work/$layer" && find "$build/CMakeFiles" -path "*/src/$layer/*.gcda" -exec gcov -p {} + > /dev/null 2>&1)
    cat "$work/$layer"/*src#"$layer"#*.gcov 2> /dev/null | awk -v layer="$layer" -v missed="$build/missed.txt" '
        /^ *-: *0:Source:/ { reason = ""; file = $0; sub(/.*:Source:/, "", file); sub(/.*\/src\//, "src/", file); next }
        {
            count = $0; sub(/:.*/, "", count); gsub(/[ *]/, "", count)
            rest = substr($0, index($0, ":") + 1)
            line = rest; sub(/:.*/, "", line); gsub(/ /, "", line)
            source = substr(rest, index(rest, ":") + 1)
            key = file ":" line
            depth = match(source, /[^ ]/)
            if (source ~ /not reached:/) {
                reason = key
                from = source ~ /^ *\/\*/ ? depth : depth + 1
                excused[key] = reason
            } else if (reason != "" && depth >= from) {
                excused[key] = reason
            } else if (depth > 0) {
                reason = ""
            }
            if (count == "-") { next }
            if (!(key in seen)) { seen[key] = 1; order[++n] = key; text[key] = source }
            if (count !~ /^[#=]+$/) { ran[key] = 1 }
        }
        END {
            for (i = 1; i <= n; i++) {
                key = order[i]
                if (key in excused && !(key in ran)) { excuses++; true_reason[excused[key]] = 1; continue }
                lines++
                if (key in ran) { hit++ } else { print key ": " text[key] >> missed }
            }
            printf "%-10s %6.2f %%   %d of %d lines, %d not reachable\n", layer, lines ? 100 * hit / lines : 0, hit, lines, excuses
            for (key in excused) {
                if (!(excused[key] in true_reason) && !told[excused[key]]++) { print excused[key] ": was reached" >> missed }
            }
        }'
done
echo "missed: $(wc -l < "$build/missed.txt") lines, in build/coverage/missed.txt"
[ ! -s "$build/missed.txt" ]
