#include "construct/harmonic/wide_solve.h"

#include <math.h>
#include <string.h>

/* The reflection of column k that takes block[.][k] to zero against r[k][k]. */
static void reflect_column(int k, int n, taut_wide *r, int rows, taut_wide *block)
{
    taut_wide sum = 0;
    for (int i = 0; i < rows; i++) {
        sum += block[i * n + k] * block[i * n + k];
    }
    if (sum == 0) {
        return;
    }
    const taut_wide head = r[k * n + k];
    const taut_wide norm = head > 0 ? -sqrtl(head * head + sum) : sqrtl(head * head + sum);
    const taut_wide first = head - norm, scale = 2 / (first * first + sum);
    for (int j = k + 1; j < n; j++) {
        taut_wide dot = first * r[k * n + j];
        for (int i = 0; i < rows; i++) {
            dot += block[i * n + k] * block[i * n + j];
        }
        dot *= scale;
        r[k * n + j] -= dot * first;
        for (int i = 0; i < rows; i++) {
            block[i * n + j] -= dot * block[i * n + k];
        }
    }
    r[k * n + k] = norm;
}

void taut_wide_append(int columns, int n, taut_wide *r, int rows, taut_wide *block)
{
    for (int k = 0; k < columns; k++) {
        reflect_column(k, n, r, rows, block);
    }
}

void taut_wide_back(int columns, int n, const taut_wide *r, long stride, taut_wide *x)
{
    for (int k = columns - 1; k >= 0; k--) {
        taut_wide sum = x[k * stride];
        for (int j = k + 1; j < columns; j++) {
            sum -= r[k * n + j] * x[j * stride];
        }
        x[k * stride] = sum / r[k * n + k];
    }
}

static taut_wide dot_rows(int n, const taut_wide *a, const taut_wide *b)
{
    taut_wide sum = 0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

/* row -= (row . unit) unit, and the same of its right-hand sides (NULL: none). */
static void project_row(int n, const taut_wide *unit, taut_wide *row, int sides,
                        const taut_wide *unit_side, taut_wide *side)
{
    const taut_wide share = dot_rows(n, unit, row);
    for (int i = 0; i < n; i++) {
        row[i] -= share * unit[i];
    }
    for (int s = 0; s < sides; s++) {
        side[s] -= share * unit_side[s];
    }
}

static int find_longest(int rows, int n, const taut_wide *c)
{
    taut_wide most = -1;
    int at = 0;
    for (int i = 0; i < rows; i++) {
        const taut_wide size = dot_rows(n, c + i * n, c + i * n);
        if (size > most) {
            most = size;
            at = i;
        }
    }
    return at;
}

/* The null space: of all unit vectors the one that is farthest from what there is, again and again.
 */
static void complete_basis(int n, int rank, taut_wide *basis)
{
    for (int k = rank; k < n; k++) {
        taut_wide *row = basis + k * n, most = -1;
        int at = 0;
        for (int i = 0; i < n; i++) {
            taut_wide left = 1;
            for (int j = 0; j < k; j++) {
                left -= basis[j * n + i] * basis[j * n + i];
            }
            at = left > most ? i : at;
            most = left > most ? left : most;
        }
        memset(row, 0, (size_t)n * sizeof *row);
        row[at] = 1;
        for (int pass = 0; pass < 2; pass++) {
            for (int j = 0; j < k; j++) {
                project_row(n, basis + j * n, row, 0, NULL, NULL);
            }
        }
        const taut_wide size = sqrtl(dot_rows(n, row, row));
        for (int i = 0; i < n; i++) {
            row[i] /= size;
        }
    }
}

void taut_wide_constrain(int rows, int n, int rank, int sides, taut_wide *c, taut_wide *d,
                         taut_wide *basis, taut_wide *x)
{
    memset(x, 0, (size_t)sides * (size_t)n * sizeof *x);
    for (int k = 0; k < rank; k++) {
        const int at = k + find_longest(rows - k, n, c + k * n);
        taut_wide *row = c + k * n, *side = d + k * sides;
        for (int i = 0; i < n && at != k; i++) { /* change places */
            const taut_wide other = row[i];
            row[i] = c[at * n + i];
            c[at * n + i] = other;
        }
        for (int s = 0; s < sides && at != k; s++) {
            const taut_wide other = side[s];
            side[s] = d[at * sides + s];
            d[at * sides + s] = other;
        }
        for (int j = 0; j < k; j++) { /* once more: the first time was as the others went */
            project_row(n, c + j * n, row, sides, d + j * sides, side);
        }
        const taut_wide size = sqrtl(dot_rows(n, row, row));
        for (int i = 0; i < n; i++) {
            row[i] /= size;
        }
        for (int s = 0; s < sides; s++) {
            side[s] /= size;
            for (int i = 0; i < n; i++) {
                x[s * n + i] += side[s] * row[i];
            }
        }
        for (int i = k + 1; i < rows; i++) {
            project_row(n, row, c + i * n, sides, side, d + i * sides);
        }
    }
    memcpy(basis, c, (size_t)rank * (size_t)n * sizeof *basis);
    complete_basis(n, rank, basis);
}
