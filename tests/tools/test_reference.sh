# test_reference.sh -- the pages made of the headers have each symbol of the library; from comments to pages:
# paragraphs, formulas, parameters, links, and signs that Markdown or troff would take for their own.
. "$SOURCE/tests/tools/tools.sh"

"$SOURCE/tools/reference.sh" --check "$SOURCE" || fail "the reference"

mkdir -p "$tree/include/taut"
printf '%s\n' '/* taut/taut.h -- all. */' '' '/* First */' '#include "taut/x.h"' > "$tree/include/taut/taut.h"
cat > "$tree/include/taut/x.h" <<'HEADER'
/* taut/x.h -- what x is, a | b.
 *
 *     x_u = *y* | z
 *
 * With 1 < 2 and x_u x_v; see taut_one, [WuWang2011] and taut/x.h.
 */
#ifndef TAUT_X_H
#define TAUT_X_H

/* .5 of it. `code` of double[a][b]:
 * t      in the range, or
 *        NULL
 * Cost: nothing. */
TAUT_API int taut_one(int t,
                      int s);
TAUT_API int taut_two(void); /* at
                              * the end */

/* Which. */
typedef enum taut_kind {
    TAUT_A = 0, /* a, TAUT_NO of them */
    TAUT_B      /* b */
} taut_kind;

#define TAUT_MANY(x) \
    (x) /* so many */

#endif /* TAUT_X_H */
HEADER
"$SOURCE/tools/reference.sh" "$tree" || fail "reference.sh"
cat > "$tree/expected" <<'PAGE'
# taut/x.h

What x is, a \| b. [All headers](README.md)

```text
x_u = *y* | z
```

With 1 \< 2 and x\_u x\_v; see [`taut_one`](#taut_one), [\[WuWang2011\]](../../docs/references.bib) and [taut/x.h](x.md).

### <a id="taut_one"></a><a id="taut_two"></a>`taut_one`, `taut_two`

.5 of it. `code` of `double[a][b]`:

- `t`: in the range, or NULL

Cost: nothing.

```c
int taut_one(int t,
             int s);
int taut_two(void); /* at
                     * the end */
```

### <a id="taut_kind"></a><a id="TAUT_A"></a><a id="TAUT_B"></a>`taut_kind`

Which.

```c
typedef enum taut_kind {
    TAUT_A = 0, /* a, TAUT_NO of them */
    TAUT_B      /* b */
} taut_kind;
```

### <a id="TAUT_MANY"></a>`TAUT_MANY`

```c
#define TAUT_MANY(x) \
    (x) /* so many */
```
PAGE
diff "$tree/expected" "$tree/build/reference/x.md" || fail "the page of x.h"
sed -n 's/^| \[`\([A-Za-z_]*\)`\](x\.md#[A-Za-z_]*) | \([a-z]*\) .*/\1 \2/p' "$tree/build/reference/README.md" > "$tree/names"
printf '%s\n' 'TAUT_A constant' 'TAUT_B constant' 'taut_kind type' 'TAUT_MANY macro' 'taut_one function' 'taut_two function' |
    diff - "$tree/names" || fail "the names"

# The manual pages of the same: the header's, and the one that leads there.
"$SOURCE/tools/manual_library.sh" 1 "$tree/include/taut/taut.h" x > "$tree/taut_x.3"
for line in 'taut_x, taut_one, taut_two \- what x is, a | b' '.B #include <taut/x.h>' '\&.5 of it. \fBcode\fR of double[a][b]:' 'int taut_one(int t,' '.I t' '#define TAUT_MANY(x) \e'; do
    grep -qxF -- "$line" "$tree/taut_x.3" || fail "taut_x.3 lacks $line"
done
"$SOURCE/tools/manual_library.sh" 1 "$tree/include/taut/taut.h" > "$tree/taut.3"
for line in '.SS First' '.BR taut_x (3)' 'taut_one  *taut_x(3)' 'TAUT_B  *taut_x(3)'; do
    grep -qx -- "$line" "$tree/taut.3" || fail "taut.3 lacks $line"
done

finish
