#include "certify/pattern/skyline.h"

#include <math.h>

taut_status taut_skyline_new(taut_arena *arena, int n, const int *first, taut_skyline *matrix)
{
    size_t sum = 0;
    *matrix = (taut_skyline){.n = n, .first = first};
    for (int i = 0; i < n; i++) {
        sum += (size_t)(i - first[i] + 1);
    }
    matrix->rows = taut_arena_take(arena, (size_t)n, sizeof *matrix->rows);
    double *entries = taut_arena_take(arena, sum, sizeof *entries);
    if (matrix->rows == NULL || entries == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < n; i++) {
        matrix->rows[i] = entries;
        entries += i - first[i] + 1;
    }
    return TAUT_OK;
}

double taut_skyline_room(const taut_skyline *matrix)
{
    double sum = 0;
    for (int i = 0; i < matrix->n; i++) {
        sum += i - matrix->first[i] + 1;
    }
    return sum;
}

int taut_skyline_factor(taut_skyline *matrix, taut_pulse *pulse)
{
    const int *first = matrix->first;
    for (int i = 0; i < matrix->n; i++) {
        double *row = matrix->rows[i], work = 0;
        for (int k = first[i]; k < i; k++) {
            const double *other = matrix->rows[k];
            double sum = row[k - first[i]];
            const int from = first[i] > first[k] ? first[i] : first[k];
            work += 2.0 * (k - from);
            for (int m = from; m < k; m++) {
                sum -= row[m - first[i]] * other[m - first[k]];
            }
            row[k - first[i]] = sum / other[k - first[k]];
        }
        double pivot = row[i - first[i]];
        for (int m = first[i]; m < i; m++) {
            pivot -= row[m - first[i]] * row[m - first[i]];
        }
        if (!(pivot > 0) || taut_pulse_beat(pulse, work)) {
            return 0;
        }
        row[i - first[i]] = sqrt(pivot);
    }
    return 1;
}

void taut_skyline_solve(const taut_skyline *factor, double *x)
{
    const int *first = factor->first;
    for (int i = 0; i < factor->n; i++) {
        const double *row = factor->rows[i];
        for (int m = first[i]; m < i; m++) {
            x[i] -= row[m - first[i]] * x[m];
        }
        x[i] /= row[i - first[i]];
    }
    for (int i = factor->n - 1; i >= 0; i--) {
        const double *row = factor->rows[i];
        x[i] /= row[i - first[i]];
        for (int m = first[i]; m < i; m++) {
            x[m] -= row[m - first[i]] * x[i];
        }
    }
}
