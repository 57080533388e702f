/* density.c -- where a film is how far from least: |m - X|^2 / 2, which does not cancel. */
#include "measure/dual/density.h"

#include "core/memory.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

struct taut_dual_density {
    taut_surface *film, *psi; /* psi is the first coordinate of a surface */
    double frame[3][3];
};

void taut_dual_density_free(taut_dual_density *density)
{
    if (density != NULL) {
        taut_surface_free(density->film);
        taut_surface_free(density->psi);
        taut_free(density);
    }
}

/* A basis from its members; NULL where they make none. */
static taut_status read_basis(const taut_record *record, taut_basis **basis)
{
    const taut_record *knots = taut_record_get(record, "knots");
    const taut_record *range = taut_record_get(record, "range");
    const double degree = taut_record_number(taut_record_get(record, "degree"));
    const size_t count = taut_record_count(knots);
    taut_basis_spec spec = {.type = taut_record_text(taut_record_get(record, "type"))};
    double *numbers = taut_alloc(count, sizeof(double));
    taut_status status = TAUT_OK;

    if (numbers == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) {
        numbers[k] = taut_record_number(taut_record_at(knots, k));
    }
    spec.degree = degree >= 1 && degree <= TAUT_DEGREE_MAX ? (int)degree : 0;
    spec.knot_count = count <= TAUT_COUNT_MAX ? (int)count : 0;
    spec.knots = spec.knot_count > 0 ? numbers : NULL;
    spec.has_range = taut_record_count(range) == 2;
    for (size_t k = 0; k < 2 && spec.has_range; k++) {
        spec.range[k] = taut_record_number(taut_record_at(range, k));
    }
    status = taut_basis_new(&spec, 0, basis, NULL);
    taut_free(numbers);
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}

/* psi as a surface; NULL where the coefficients do not fit. */
static taut_status read_psi(const taut_record *witness, const taut_basis *u, const taut_basis *v,
                            taut_surface **psi)
{
    const taut_record *rows = taut_record_get(witness, "coefficients");
    const size_t nu = (size_t)taut_basis_count(u), nv = (size_t)taut_basis_count(v);
    double *points = NULL;
    taut_status status = TAUT_OK;

    if (taut_record_count(rows) != nu || taut_record_count(taut_record_at(rows, 0)) != nv) {
        return TAUT_OK;
    }
    points = taut_alloc_zero(3 * nu * nv, sizeof(double));
    if (points == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < nu * nv; k++) {
        const taut_record *row = taut_record_at(rows, k / nv);
        points[3 * k] = taut_record_number(taut_record_at(row, k % nv));
    }
    status = taut_surface_new("", u, v, points, NULL, psi, NULL);
    taut_free(points);
    return status == TAUT_NO_MEMORY ? status : TAUT_OK;
}

/* 0 where the direction is none. */
static int make_frame(const taut_record *direction, double frame[3][3])
{
    double axis[3] = {0, 0, 0}, size = 0;
    int flat = 0;

    for (size_t c = 0; c < 3; c++) {
        frame[2][c] = taut_record_number(taut_record_at(direction, c));
        flat = fabs(frame[2][c]) < fabs(frame[2][flat]) ? (int)c : flat;
    }
    size = taut_norm(frame[2]);
    axis[flat] = 1;
    taut_cross(frame[2], axis, frame[1]);
    const double across = taut_norm(frame[1]);
    for (int c = 0; c < 3; c++) {
        frame[2][c] /= size;
        frame[1][c] /= across;
    }
    taut_cross(frame[1], frame[2], frame[0]);
    return isfinite(taut_norm(frame[0])) && size > 0;
}

static int has_range_of(const taut_basis *a, const taut_basis *b)
{
    return a != NULL && b != NULL && taut_basis_lo(a) == taut_basis_lo(b) &&
           taut_basis_hi(a) == taut_basis_hi(b);
}

static taut_status fill(const taut_surface *film, const taut_record *witness,
                        taut_dual_density *made)
{
    taut_basis *u = NULL, *v = NULL;
    taut_status status = read_basis(taut_record_get(witness, "u"), &u);

    if (status == TAUT_OK) {
        status = read_basis(taut_record_get(witness, "v"), &v);
    }
    if (status == TAUT_OK && has_range_of(u, taut_surface_u(film)) &&
        has_range_of(v, taut_surface_v(film)) &&
        make_frame(taut_record_get(witness, "direction"), made->frame)) {
        status = read_psi(witness, u, v, &made->psi);
    }
    if (status == TAUT_OK && made->psi != NULL) {
        status = taut_surface_copy(film, &made->film);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    return status;
}

taut_status taut_dual_density_new(const taut_surface *film, const taut_record *details,
                                  taut_dual_density **density)
{
    taut_dual_density *made = taut_alloc_zero(1, sizeof *made);
    taut_status status = made != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    *density = NULL;
    if (status == TAUT_OK) {
        status = fill(film, taut_record_get(details, "least"), made);
    }
    if (status != TAUT_OK || made->film == NULL) {
        taut_dual_density_free(made);
        return status;
    }
    *density = made;
    return TAUT_OK;
}

double taut_dual_density_at(const taut_dual_density *density, double u, double v)
{
    double jet[3][3], psi[3][3], along[2][3], m[3], x[3], apart[3];

    if (taut_surface_eval(density->film, u, v, 1, &jet[0][0]) != TAUT_OK ||
        taut_surface_eval(density->psi, u, v, 1, &psi[0][0]) != TAUT_OK) {
        return (double)NAN;
    }
    for (int c = 0; c < 3; c++) {
        along[0][c] = taut_dot(density->frame[c], jet[TAUT_XU]);
        along[1][c] = taut_dot(density->frame[c], jet[TAUT_XV]);
    }
    taut_cross(along[0], along[1], m);
    const double length = taut_norm(m), sign = m[2] < 0 ? -1 : 1;
    for (int c = 0; c < 2; c++) {
        x[c] = (psi[TAUT_XU][0] * along[1][c] - psi[TAUT_XV][0] * along[0][c]) / m[2];
    }
    x[2] = sqrt(1 - x[0] * x[0] - x[1] * x[1]);
    for (int c = 0; c < 3; c++) {
        m[c] *= sign / length;
    }
    taut_difference(m, x, apart);
    const double d = 0.5 * taut_dot(apart, apart);
    return isfinite(d) ? d : (double)NAN;
}
