#include "construct/common/pattern.h"

#include <string.h>

/* The indices of the nonzero flags. */
static int list(int count, const unsigned char *flags, int *index)
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        if (flags[i]) {
            index[found++] = i;
        }
    }
    return found;
}

static void mark(const taut_pattern *pattern, unsigned char *in_row, unsigned char *in_column)
{
    for (int i = 0; i < pattern->nu; i++) {
        const unsigned char *known = pattern->known + (size_t)i * (size_t)pattern->nv;
        for (int j = 0; j < pattern->nv; j++) {
            if (!known[j]) {
                in_row[i] = in_column[j] = 1;
            }
        }
    }
}

static void fill_hull(taut_pattern *pattern)
{
    unsigned char *out = pattern->hull_known;
    for (int a = 0; a < pattern->rows; a++) {
        const unsigned char *known = pattern->known + (size_t)pattern->row[a] * (size_t)pattern->nv;
        for (int b = 0; b < pattern->columns; b++) {
            *out = known[pattern->column[b]] != 0;
            pattern->unknowns += !*out;
            out++;
        }
    }
    pattern->is_box = pattern->unknowns == (size_t)pattern->rows * (size_t)pattern->columns;
    pattern->is_interior =
        pattern->is_box && pattern->nu > 2 && pattern->nv > 2 && pattern->rows == pattern->nu - 2 &&
        pattern->columns == pattern->nv - 2 && pattern->row[0] == 1 && pattern->column[0] == 1 &&
        pattern->row[pattern->rows - 1] == pattern->nu - 2 &&
        pattern->column[pattern->columns - 1] == pattern->nv - 2;
}

taut_status taut_pattern_new(int nu, int nv, const unsigned char *known, taut_arena *arena,
                             taut_pattern *pattern)
{
    taut_pattern made = {nu, nv, known, 0, 0, 0, NULL, NULL, 0, 0, NULL};
    unsigned char *in_row = taut_arena_take(arena, (size_t)nu, 1);
    unsigned char *in_column = taut_arena_take(arena, (size_t)nv, 1);

    made.row = taut_arena_take(arena, (size_t)nu, sizeof(int));
    made.column = taut_arena_take(arena, (size_t)nv, sizeof(int));
    if (in_row == NULL || in_column == NULL || made.row == NULL || made.column == NULL) {
        return TAUT_NO_MEMORY;
    }
    mark(&made, in_row, in_column);
    made.rows = list(nu, in_row, made.row);
    made.columns = list(nv, in_column, made.column);
    made.hull_known = taut_arena_take(arena, (size_t)made.rows * (size_t)made.columns, 1);
    if (made.hull_known == NULL) {
        return TAUT_NO_MEMORY;
    }
    fill_hull(&made);
    *pattern = made;
    return TAUT_OK;
}

void taut_pattern_gather(const taut_pattern *pattern, const double *net, double *hull)
{
    for (int a = 0; a < pattern->rows; a++) {
        const double *row = net + 3 * (size_t)pattern->row[a] * (size_t)pattern->nv;
        for (int b = 0; b < pattern->columns; b++) {
            memcpy(hull, row + 3 * (size_t)pattern->column[b], 3 * sizeof(double));
            hull += 3;
        }
    }
}

void taut_pattern_add(const taut_pattern *pattern, const double *hull, double *net)
{
    const unsigned char *known = pattern->hull_known;
    for (int a = 0; a < pattern->rows; a++) {
        double *row = net + 3 * (size_t)pattern->row[a] * (size_t)pattern->nv;
        for (int b = 0; b < pattern->columns; b++, hull += 3) {
            double *point = row + 3 * (size_t)pattern->column[b];
            for (int c = 0; !*known && c < 3; c++) {
                point[c] += hull[c];
            }
            known++;
        }
    }
}

void taut_pattern_clear_known(const taut_pattern *pattern, double *net)
{
    const size_t count = (size_t)pattern->nu * (size_t)pattern->nv;
    for (size_t i = 0; i < count; i++) {
        if (pattern->known[i]) {
            memset(net + 3 * i, 0, 3 * sizeof(double));
        }
    }
}
