#!/bin/sh
# reproduction.sh [--check] [TAUT] -- writes docs/reproduction.md out of `taut reproduce`; --check says whether it is current.
set -eu
cd "$(dirname "$0")/.."
check=
if [ "${1:-}" = --check ]; then
    check=1
    shift
fi
taut=${1:-build/release/bin/taut}
page=$(mktemp)
trap 'rm -f "$page"' EXIT
cat > "$page" <<'END'
# What the papers print, and what Taut finds

Every number that the papers print, recomputed (what one prints twice, as points and as a polynomial, once). `taut
reproduce` prints the same rows on any machine, `taut reproduce PAPER --json` for a program, and `make reproduction`
writes this page; that it is current is a test (`tests/cli/test_reproduction.sh`).

Each row names where the paper prints the number, what it prints digit for digit, what Taut finds, and a verdict:

- **agrees**: within half a unit of the last digit printed, or within the tolerance that the row states for exact
  numbers;
- **erratum**: the paper is wrong; ours is what is right, or shows how the printed number arose, and the last column
  says which;
- **beyond the paper**: a number the paper leaves out, held against a reference;
- **differs**: ours should agree and does not. There must be none: the program then exits with 1.

Ours is written to the digits that its tolerance vouches for; points are counted from 0, also where a paper counts
from 1. The rows, with tolerances and their reasons, are in [data/papers](../data/papers), the corrected mathematics
in [papers](papers), the keys in [references.bib](references.bib).

| quantity | is |
|---|---|
| `point [NAME] I J` | control point (i, j) of the surface (of that name), its coordinates |
| `at U V` | point of the first surface at (u, v) |
| `weight I J`, `curve_point NAME J`, `curve_weight NAME J` | of the first surface, of the curve of that name |
| `curvature NAME T`, `function NAME I T` | of that curve at t; the i-th function of its basis there |
| `figure NAME` | of the certificate |
| `detail NAME...`, `count NAME...` | of the model's `details`; the number of their items |
| `claim NAME`, `holds NAME` | residual of a claim; 1 if it holds, else 0 |
| `max_abs_mean N`, `mean_abs_mean` | largest \|H\| on a grid of N x N (101 x 101 where N is missing); mean of \|H\| over the area |
| `gaussian [NAME] U V`, `min_gaussian`, `max_gaussian` | K at (u, v); least and largest K on a grid |
| `edge_length EDGE` | of the first surface |
| `triangulated_area N` | area of the triangles between N x N cells: how one paper computed areas |
| `unnormalised_max N`, `unnormalised_mean N` | of \|H\| W, the normal not made unit: how one paper computed curvatures |
| `cotes_point P I J` | point (i, j) when the rows are solved with a Newton-Cotes rule of P panels, as one paper did |
| `basis_k U`, `basis_m U` | the numbers k and m (k_h, m_h) of the c- or h- basis along u or v |
| `literal_index`, `literal_h42`, `literal_slope` | how far off one printed formula is when taken literally; 0.0 is what the paper says: that it is exact |

END
if ! "$taut" reproduce --markdown >> "$page"; then
    grep '| differs |' "$page" || true
    echo "numbers that should agree with the papers do not"
    exit 1
fi
if [ -z "$check" ]; then
    cp "$page" docs/reproduction.md
elif ! cmp -s "$page" docs/reproduction.md; then
    diff docs/reproduction.md "$page" | head -n 20 || true
    echo "docs/reproduction.md is not what taut reproduce says: make reproduction"
    exit 1
fi
