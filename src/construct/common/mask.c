#include "construct/common/mask.h"

#include <string.h>

/* The indices of the nonzero flags. */
static int list_flagged(int count, const unsigned char *flags, int *index)
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        if (flags[i]) {
            index[found++] = i;
        }
    }
    return found;
}

static void mark_unknowns(const taut_mask *mask, unsigned char *in_row, unsigned char *in_column)
{
    for (int i = 0; i < mask->nu; i++) {
        const unsigned char *known = mask->known + (size_t)i * (size_t)mask->nv;
        for (int j = 0; j < mask->nv; j++) {
            if (!known[j]) {
                in_row[i] = in_column[j] = 1;
            }
        }
    }
}

static void fill_hull(taut_mask *mask)
{
    unsigned char *out = mask->hull_known;
    for (int a = 0; a < mask->rows; a++) {
        const unsigned char *known = mask->known + (size_t)mask->row[a] * (size_t)mask->nv;
        for (int b = 0; b < mask->columns; b++) {
            *out = known[mask->column[b]] != 0;
            mask->unknowns += !*out;
            out++;
        }
    }
    mask->is_box = mask->unknowns == (size_t)mask->rows * (size_t)mask->columns;
    mask->is_interior = mask->is_box && mask->nu > 2 && mask->nv > 2 &&
                        mask->rows == mask->nu - 2 && mask->columns == mask->nv - 2 &&
                        mask->row[0] == 1 && mask->column[0] == 1 &&
                        mask->row[mask->rows - 1] == mask->nu - 2 &&
                        mask->column[mask->columns - 1] == mask->nv - 2;
}

taut_status taut_mask_new(int nu, int nv, const unsigned char *known, taut_arena *arena,
                          taut_mask *mask)
{
    taut_mask made = {.nu = nu, .nv = nv, .known = known};
    unsigned char *in_row = taut_arena_take(arena, (size_t)nu, 1);
    unsigned char *in_column = taut_arena_take(arena, (size_t)nv, 1);

    made.row = taut_arena_take(arena, (size_t)nu, sizeof(int));
    made.column = taut_arena_take(arena, (size_t)nv, sizeof(int));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    mark_unknowns(&made, in_row, in_column);
    made.rows = list_flagged(nu, in_row, made.row);
    made.columns = list_flagged(nv, in_column, made.column);
    made.hull_known = taut_arena_take(arena, (size_t)made.rows * (size_t)made.columns, 1);
    if (made.hull_known == NULL) {
        return TAUT_NO_MEMORY;
    }
    fill_hull(&made);
    *mask = made;
    return TAUT_OK;
}

void taut_mask_gather(const taut_mask *mask, const double *net, double *hull)
{
    for (int a = 0; a < mask->rows; a++) {
        const double *row = net + 3 * (size_t)mask->row[a] * (size_t)mask->nv;
        for (int b = 0; b < mask->columns; b++) {
            memcpy(hull, row + 3 * (size_t)mask->column[b], 3 * sizeof(double));
            hull += 3;
        }
    }
}

void taut_mask_add(const taut_mask *mask, const double *hull, double *net)
{
    const unsigned char *known = mask->hull_known;
    for (int a = 0; a < mask->rows; a++) {
        double *row = net + 3 * (size_t)mask->row[a] * (size_t)mask->nv;
        for (int b = 0; b < mask->columns; b++, hull += 3) {
            double *point = row + 3 * (size_t)mask->column[b];
            for (int c = 0; !*known && c < 3; c++) {
                point[c] += hull[c];
            }
            known++;
        }
    }
}

void taut_mask_clear_known(const taut_mask *mask, double *net)
{
    const size_t count = (size_t)mask->nu * (size_t)mask->nv;
    for (size_t i = 0; i < count; i++) {
        if (mask->known[i]) {
            memset(net + 3 * i, 0, 3 * sizeof(double));
        }
    }
}

void taut_mask_reduce(const taut_mask *mask, double *net)
{
    const size_t count = (size_t)mask->nu * (size_t)mask->nv;

    for (size_t i = 0; mask->leader != NULL && i < count; i++) {
        const size_t leader = (size_t)mask->leader[i];
        for (size_t c = 0; leader != i && c < 3; c++) {
            net[3 * leader + c] += net[3 * i + c];
        }
    }
    taut_mask_clear_known(mask, net);
    for (size_t i = 0; mask->allowed != NULL && i < count; i++) {
        taut_mask_project(mask->allowed + 6 * i, net + 3 * i);
    }
}

void taut_mask_follow(const taut_mask *mask, double *net)
{
    const size_t count = (size_t)mask->nu * (size_t)mask->nv;

    for (size_t i = 0; mask->leader != NULL && i < count; i++) {
        memmove(net + 3 * i, net + 3 * (size_t)mask->leader[i], 3 * sizeof(double));
    }
}
