#include "construct/film/complex/border.h"

#include <math.h>

static const double *swell_of(const taut_film_border *b, const taut_film_energy *e, int i)
{
    return e->swells + 3 * (size_t)b->cell[i] * (size_t)e->layout->complex.nodes;
}

static double dot(const taut_film_energy *e, const double *x, const double *y)
{
    double sum = 0;
    for (size_t k = 0; k < 3 * (size_t)e->layout->complex.nodes; k++) {
        sum += x[k] * y[k];
    }
    return sum;
}

taut_status taut_film_border_new(const taut_film_layout *layout, taut_arena *arena,
                                 taut_film_border *border)
{
    const taut_film_problem *problem = layout->complex.problem;
    size_t count = 0;

    for (int k = 0; k < problem->cell_count; k++) {
        count += problem->cells[k].has_volume != 0;
    }
    *border = (taut_film_border){.count = (int)count};
    border->cell = taut_arena_take(arena, count, sizeof(int));
    border->p = taut_arena_take(arena, count, sizeof(double));
    border->z = taut_arena_take(arena, count * (size_t)layout->complex.nodes, 3 * sizeof(double));
    border->s = taut_arena_take(arena, count * count, sizeof(double));
    border->excess = taut_arena_take(arena, count, sizeof(double));
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0, i = 0; k < problem->cell_count; k++) {
        if (problem->cells[k].has_volume) {
            border->cell[i++] = k;
        }
    }
    return TAUT_OK;
}

double taut_film_border_look(taut_film_border *border, const taut_film_energy *energy)
{
    double largest = 0;

    for (int i = 0; i < border->count; i++) {
        const double given = energy->layout->volumes[border->cell[i]];
        border->excess[i] = energy->volumes[border->cell[i]] - given;
        largest = fmax(largest, fabs(border->excess[i] / given));
    }
    return largest;
}

int taut_film_border_factor(taut_film_border *border, const taut_film_energy *energy, int negative,
                            double *right)
{
    const int m = border->count;
    int positive = 0;

    for (int i = 0; i < m; i++) {
        double *z = border->z + 3 * (size_t)i * (size_t)energy->layout->complex.nodes;
        taut_film_energy_solve(energy, swell_of(border, energy, i), right, z);
        for (int j = 0; j < m; j++) {
            border->s[i * m + j] = dot(energy, swell_of(border, energy, j), z);
        }
    }
    for (int i = 0; i < m; i++) { /* S = L D L', no pivots exchanged */
        for (int j = 0; j <= i; j++) {
            double sum = border->s[i * m + j];
            for (int k = 0; k < j; k++) {
                sum -= border->s[i * m + k] * border->s[j * m + k] * border->s[k * m + k];
            }
            border->s[i * m + j] = i == j ? sum : sum / border->s[j * m + j];
        }
        positive += border->s[i * m + i] > 0;
    }
    return negative + positive - m;
}

void taut_film_border_step(taut_film_border *border, const taut_film_energy *energy,
                           const double *gradient, double *right, double *d)
{
    const int m = border->count;
    const size_t numbers = 3 * (size_t)energy->layout->complex.nodes;

    taut_film_energy_solve(energy, gradient, right, d);
    for (int i = 0; i < m; i++) {
        border->p[i] = dot(energy, swell_of(border, energy, i), d) - border->excess[i];
        for (int k = 0; k < i; k++) {
            border->p[i] -= border->s[i * m + k] * border->p[k];
        }
    }
    for (int i = m - 1; i >= 0; i--) {
        border->p[i] /= border->s[i * m + i];
        for (int k = i + 1; k < m; k++) {
            border->p[i] -= border->s[k * m + i] * border->p[k];
        }
    }
    for (size_t k = 0; k < numbers; k++) {
        d[k] = -d[k];
        for (int i = 0; i < m; i++) {
            d[k] += border->p[i] * border->z[(size_t)i * numbers + k];
        }
    }
}
