#include "construct/harmonic/wide_solve.h"

#include "numeric/wide.h"

#include <string.h>

/* Nonzero when it is to end: so many rows of so many numbers. */
static int beat(taut_pulse *pulse, int rows, int numbers)
{
    return taut_pulse_beat(pulse, (double)TAUT_TWICE_WORK * rows * numbers);
}

/* The reflection of column k that takes block[.][k] to zero against r[k][k]. */
static void reflect_column(int k, int n, taut_twice *r, int rows, taut_twice *block,
                           taut_twice *dots)
{
    const int rest = n - k - 1;
    taut_twice sum = {0, 0};
    for (int i = 0; i < rows; i++) {
        sum = taut_twice_gain(sum, block[i * n + k], block[i * n + k]);
    }
    if (sum.high == 0) {
        return;
    }
    const taut_twice head = r[k * n + k];
    const taut_twice root = taut_twice_root(taut_twice_gain(sum, head, head));
    const taut_twice norm = head.high > 0 ? taut_twice_negative(root) : root;
    const taut_twice first = taut_twice_less(head, norm);
    const taut_twice scale = taut_twice_over(taut_twice_of(-2), taut_twice_gain(sum, first, first));
    for (int j = k + 1; j < n; j++) {
        dots[j] = taut_twice_times(first, r[k * n + j]);
    }
    for (int i = 0; i < rows; i++) {
        taut_wide_gain(rest, block[i * n + k], block + i * n + k + 1, dots + k + 1);
    }
    for (int j = k + 1; j < n; j++) {
        dots[j] = taut_twice_times(scale, dots[j]);
    }
    taut_wide_gain(rest, first, dots + k + 1, r + k * n + k + 1);
    for (int i = 0; i < rows; i++) {
        taut_wide_gain(rest, block[i * n + k], dots + k + 1, block + i * n + k + 1);
    }
    r[k * n + k] = norm;
}

void taut_wide_append(int columns, int n, taut_twice *r, int rows, taut_twice *block,
                      taut_twice *scratch, taut_pulse *pulse)
{
    for (int k = 0; k < columns && !beat(pulse, 2 * rows, n - k); k++) {
        reflect_column(k, n, r, rows, block, scratch);
    }
}

void taut_wide_back(int columns, int n, taut_twice *r, taut_pulse *pulse)
{
    const int sides = n - columns;
    for (int k = columns - 1; k >= 0 && !beat(pulse, columns - k, sides); k--) {
        taut_twice *x = r + k * n + columns;
        for (int s = 0; s < sides; s++) {
            x[s] = taut_twice_negative(x[s]);
        }
        for (int j = k + 1; j < columns; j++) {
            taut_wide_gain(sides, r[k * n + j], r + j * n + columns, x);
        }
        for (int s = 0; s < sides; s++) {
            x[s] = taut_twice_over(taut_twice_negative(x[s]), r[k * n + k]);
        }
    }
}

static taut_twice dot_rows(int n, const taut_twice *a, const taut_twice *b)
{
    taut_twice sum = {0, 0};
    for (int i = 0; i < n; i++) {
        sum = taut_twice_gain(sum, a[i], b[i]);
    }
    return sum;
}

/* row -= (row . unit) unit, and the same of its right-hand sides (NULL: none). */
static void project_row(int n, const taut_twice *unit, taut_twice *row, int sides,
                        const taut_twice *unit_side, taut_twice *side)
{
    const taut_twice share = taut_twice_negative(dot_rows(n, unit, row));
    taut_wide_gain(n, share, unit, row);
    taut_wide_gain(sides, share, unit_side, side);
}

static int find_longest(int rows, int n, const taut_twice *c)
{
    double most = -1;
    int at = 0;
    for (int i = 0; i < rows; i++) {
        const double size = taut_twice_round(dot_rows(n, c + i * n, c + i * n));
        if (size > most) {
            most = size;
            at = i;
        }
    }
    return at;
}

/* The null space: of all unit vectors the one that is farthest from what there is, again and again.
 */
static void complete_basis(int n, int rank, taut_twice *basis, taut_pulse *pulse)
{
    for (int k = rank; k < n && !beat(pulse, 4 * k, n); k++) {
        taut_twice *row = basis + k * n;
        double most = -1;
        int at = 0;
        for (int i = 0; i < n; i++) {
            double left = 1;
            for (int j = 0; j < k; j++) {
                left -= basis[j * n + i].high * basis[j * n + i].high;
            }
            at = left > most ? i : at;
            most = left > most ? left : most;
        }
        memset(row, 0, (size_t)n * sizeof *row);
        row[at] = taut_twice_of(1);
        for (int pass = 0; pass < 2; pass++) {
            for (int j = 0; j < k; j++) {
                project_row(n, basis + j * n, row, 0, NULL, NULL);
            }
        }
        const taut_twice size = taut_twice_root(dot_rows(n, row, row));
        for (int i = 0; i < n; i++) {
            row[i] = taut_twice_over(row[i], size);
        }
    }
}

void taut_wide_constrain(int rows, int n, int rank, int sides, taut_twice *c, taut_twice *d,
                         taut_twice *basis, taut_twice *x, taut_pulse *pulse)
{
    memset(x, 0, (size_t)sides * (size_t)n * sizeof *x);
    for (int k = 0; k < rank && !beat(pulse, 2 * rows, n + sides); k++) {
        const int at = k + find_longest(rows - k, n, c + k * n);
        taut_twice *row = c + k * n, *side = d + k * sides;
        for (int i = 0; i < n && at != k; i++) { /* change places */
            const taut_twice other = row[i];
            row[i] = c[at * n + i];
            c[at * n + i] = other;
        }
        for (int s = 0; s < sides && at != k; s++) {
            const taut_twice other = side[s];
            side[s] = d[at * sides + s];
            d[at * sides + s] = other;
        }
        for (int j = 0; j < k; j++) { /* once more: the first time was as the others went */
            project_row(n, c + j * n, row, sides, d + j * sides, side);
        }
        const taut_twice size = taut_twice_root(dot_rows(n, row, row));
        for (int i = 0; i < n; i++) {
            row[i] = taut_twice_over(row[i], size);
        }
        for (int s = 0; s < sides; s++) {
            side[s] = taut_twice_over(side[s], size);
            taut_wide_gain(n, side[s], row, x + s * n);
        }
        for (int i = k + 1; i < rows; i++) {
            project_row(n, row, c + i * n, sides, side, d + i * sides);
        }
    }
    memcpy(basis, c, (size_t)rank * (size_t)n * sizeof *basis);
    complete_basis(n, rank, basis, pulse);
}
