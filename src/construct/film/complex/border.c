#include "construct/film/complex/border.h"

#include <math.h>

const double *taut_film_border_row(const taut_film_border *border, const taut_film_energy *energy,
                                   int i)
{
    const size_t nodes = (size_t)energy->layout->complex.nodes;
    return i < border->cells ? energy->swells + 3 * (size_t)border->which[i] * nodes
                             : energy->stretches[border->which[i]];
}

static double stiffness_of(const taut_film_border *b, const taut_film_energy *e, int i)
{
    return taut_film_law_stiffness(&e->layout->drawn[b->which[i]], e->soft);
}

int taut_film_border_is_spring(const taut_film_border *border, const taut_film_energy *energy,
                               int i)
{
    return i >= border->cells && stiffness_of(border, energy, i) > 0;
}

/* A spring that is slack does nothing. */
static int is_slack(const taut_film_border *b, const taut_film_energy *e, int i)
{
    return taut_film_border_is_spring(b, e, i) && !(e->forces[b->which[i]] > 0);
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
    const taut_film_complex *c = &layout->complex;
    const size_t most = (size_t)c->problem->cell_count + (size_t)c->rope_count;

    *border = (taut_film_border){.which = taut_arena_take(arena, most, sizeof(int))};
    if (border->which == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < c->problem->cell_count; k++) {
        if (c->problem->cells[k].has_volume) {
            border->which[border->cells++] = k;
        }
    }
    border->count = border->cells;
    for (int k = 0; k < c->rope_count; k++) {
        if (layout->drawn[k].law != TAUT_FILM_FORCE) {
            border->which[border->count++] = k;
        }
    }
    const size_t count = (size_t)border->count;
    border->p = taut_arena_take(arena, count, sizeof(double));
    border->z = taut_arena_take(arena, count * (size_t)c->nodes, 3 * sizeof(double));
    border->s = taut_arena_take(arena, count * count, sizeof(double));
    border->excess = taut_arena_take(arena, count, sizeof(double));
    border->springs = taut_arena_take(arena, count, sizeof(double));
    return taut_arena_status(arena);
}

double taut_film_border_look(taut_film_border *border, const taut_film_energy *energy)
{
    double largest = 0;

    for (int i = 0; i < border->count; i++) {
        const int k = border->which[i];
        const double given =
            i < border->cells ? energy->layout->volumes[k] : energy->layout->drawn[k].length;
        border->excess[i] = taut_film_border_is_spring(border, energy, i) ? 0
                            : i < border->cells ? energy->volumes[k] - given
                                                : energy->lengths[k] - given;
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
        const int slack = is_slack(border, energy, i);
        taut_film_energy_solve(energy, taut_film_border_row(border, energy, i), right, z);
        border->springs[i] = slack ? INFINITY
                             : taut_film_border_is_spring(border, energy, i)
                                 ? 1 / stiffness_of(border, energy, i)
                                 : 0;
        for (int j = 0; j < m; j++) {
            border->s[i * m + j] =
                slack ? 0 : dot(energy, taut_film_border_row(border, energy, j), z);
        }
    }
    for (int i = 0; i < m; i++) {
        for (int j = 0; isinf(border->springs[i]) && j < m; j++) {
            border->s[j * m + i] = j == i;
        }
        border->s[i * m + i] += isinf(border->springs[i]) ? 0 : border->springs[i];
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
        border->p[i] =
            isinf(border->springs[i])
                ? 0
                : dot(energy, taut_film_border_row(border, energy, i), d) - border->excess[i];
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
