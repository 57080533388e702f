#include "construct/plateau/held.h"

#include <math.h>
#include <string.h>

/* A condition that is left with less of its length by those before it is one of their combinations. */
static const double dependent = 1e-10;

static double dot(size_t count, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

double taut_held_numbers(int conditions, size_t points, int is_directed)
{
    return 6.0 * conditions * (is_directed ? 1.0 : 3.0) * (double)points;
}

/* row = coordinate c of condition k. */
static void fill_row(const taut_conditions *all, const taut_mask *mask, const double *directions,
                     int k, int c, double *row)
{
    const taut_condition *at = &all->at[k];

    for (int a = 0; a < all->local[0]; a++) {
        for (int b = 0; b < all->local[1]; b++) {
            const size_t i =
                (size_t)(at->first[0] + a) * (size_t)all->nv + (size_t)(at->first[1] + b);
            const double own = mask->known[i] ? 0 : at->coefficients[a * all->local[1] + b];
            if (directions != NULL) {
                row[i] = own * directions[3 * i + (size_t)c];
            } else {
                row[3 * i + (size_t)c] = own;
            }
        }
    }
}

/* Gram and Schmidt, twice. 0 where hardly anything is left of the row, over `most`. */
static int make_orthonormal(const taut_held *held, double most, double *row)
{
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < held->count; k++) {
            const double *other = taut_held_row(held, k);
            const double part = dot(held->size, other, row);
            for (size_t i = 0; part != 0 && i < held->size; i++) {
                row[i] -= part * other[i];
            }
        }
    }
    const double left = sqrt(dot(held->size, row, row));
    if (!(left > dependent * most)) {
        return 0;
    }
    for (size_t i = 0; i < held->size; i++) {
        row[i] /= left;
    }
    return 1;
}

static double length_of(const taut_conditions *all, int k)
{
    const size_t count = (size_t)all->local[0] * (size_t)all->local[1];
    return sqrt(dot(count, all->at[k].coefficients, all->at[k].coefficients));
}

taut_status taut_held_new(const taut_conditions *conditions, const taut_mask *mask,
                          const double *directions, taut_arena *arena, taut_held *held)
{
    const size_t most = 3 * (size_t)conditions->count;
    const size_t points = (size_t)mask->nu * (size_t)mask->nv;

    *held = (taut_held){.size = directions != NULL ? points : 3 * points};
    held->row = taut_arena_take(arena, most * held->size, sizeof(double));
    held->image = taut_arena_take(arena, most * held->size, sizeof(double));
    held->small = taut_arena_take(arena, most * most, sizeof(double));
    held->part = taut_arena_take(arena, most, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < conditions->count; k++) {
        for (int c = 0; c < 3; c++) {
            double *row = held->row + (size_t)held->count * held->size;
            memset(row, 0, held->size * sizeof(double));
            fill_row(conditions, mask, directions, k, c, row);
            held->count += make_orthonormal(held, length_of(conditions, k), row);
        }
    }
    return TAUT_OK;
}

void taut_held_project(const taut_held *held, double *z)
{
    for (int r = 0; r < held->count; r++) {
        const double *row = taut_held_row(held, r);
        const double part = dot(held->size, row, z);
        for (size_t i = 0; i < held->size; i++) {
            z[i] -= part * row[i];
        }
    }
}

int taut_held_factor(taut_held *held)
{
    const size_t n = (size_t)held->count;

    for (size_t i = 0; i < n; i++) {
        double *row = held->small + i * n;
        for (size_t j = 0; j <= i; j++) {
            const double *other = held->small + j * n;
            double sum =
                dot(held->size, taut_held_row(held, (int)j), taut_held_image(held, (int)i));
            for (size_t k = 0; k < j; k++) {
                sum -= row[k] * other[k];
            }
            if (i == j && !(sum > 0)) {
                return 0;
            }
            row[j] = i == j ? sqrt(sum) : sum / other[j];
        }
    }
    return 1;
}

void taut_held_correct(const taut_held *held, double *z)
{
    const size_t n = (size_t)held->count;
    double *part = held->part;

    for (size_t i = 0; i < n; i++) {
        part[i] = dot(held->size, taut_held_row(held, (int)i), z);
        for (size_t k = 0; k < i; k++) {
            part[i] -= held->small[i * n + k] * part[k];
        }
        part[i] /= held->small[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++) {
            part[i] -= held->small[k * n + i] * part[k];
        }
        part[i] /= held->small[i * n + i];
    }
    for (size_t r = 0; r < n; r++) {
        const double *image = taut_held_image(held, (int)r);
        for (size_t i = 0; i < held->size; i++) {
            z[i] -= part[r] * image[i];
        }
    }
    taut_held_project(held, z); /* what rounding left */
}
