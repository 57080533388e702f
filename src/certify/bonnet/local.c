#include "certify/bonnet/local.h"

#include "core/constants.h"
#include "core/vec3.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Widths of a first piece on bases that have a length of their own, and pieces of one span. */
static const double widest = 0.5;
enum { FEWEST = 4, LOCAL = 4, ORDERS = TAUT_BONNET_ORDERS };

/* What a basis function and its derivatives are good to, of themselves: the accuracy that
 * taut/basis.h states, for the two of a product; and the sixteen terms of a sum. */
static const double basis_error = 2 * 1e-14 + 20 * TAUT_UNIT_ROUNDOFF;
/* Roundings of a stored point, of its size with what cancelled in it (sums.h). Over random problems
 * at most 13 were seen. */
static const double point_error = 16 * TAUT_UNIT_ROUNDOFF;

int taut_bonnet_sign_of(const taut_basis *basis, double *sign)
{
    static const struct {
        const char *type;
        double sign;
    } kinds[] = {{"c-bezier", -1}, {"c-bspline", -1}, {"h-bezier", 1},
                 {"h-bspline", 1}, {"bezier", 0},     {"bspline", 0}};
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        if (strcmp(taut_basis_type(basis), kinds[k].type) == 0) {
            *sign = kinds[k].sign;
            return kinds[k].sign != 0 || taut_basis_degree(basis) <= 3;
        }
    }
    return 0;
}

taut_bonnet_cuts taut_bonnet_cuts_of(const taut_surface *surface)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    taut_bonnet_cuts cuts;
    for (int d = 0; d < 2; d++) {
        const int spans = taut_basis_span_count(bases[d]);
        const double width = (taut_basis_hi(bases[d]) - taut_basis_lo(bases[d])) / spans;
        double sign = 0;
        cuts.each[d] = spans >= FEWEST ? 1 : (FEWEST + spans - 1) / spans;
        if (taut_bonnet_sign_of(bases[d], &sign) && sign != 0 && width > widest * cuts.each[d]) {
            cuts.each[d] = (int)ceil(width / widest);
        }
        cuts.count[d] = spans * cuts.each[d];
    }
    return cuts;
}

taut_bonnet_piece taut_bonnet_piece_at(const taut_surface *surface, const taut_bonnet_cuts *cuts,
                                       int i, int j)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int at[2] = {i, j};
    taut_bonnet_piece piece;
    for (int d = 0; d < 2; d++) {
        const int span = at[d] / cuts->each[d], part = at[d] % cuts->each[d];
        const double lo = taut_basis_breaks(bases[d])[span];
        const double width = taut_basis_breaks(bases[d])[span + 1] - lo;
        piece.span[d] = span;
        piece.middle[d] = lo + width * ((part + 0.5) / cuts->each[d]);
        piece.half[d] = 0.5 * width / cuts->each[d];
    }
    return piece;
}

/* The functions alive and their derivatives by tau / L, those that are not alive 0. */
static void fill_line(const taut_basis *basis, int span, double t, double length,
                      double values[ORDERS][LOCAL])
{
    const int local = taut_basis_local(basis);
    double found[ORDERS * LOCAL], factor = 1;

    memset(values, 0, sizeof(double) * ORDERS * LOCAL);
    taut_basis_eval(basis, span, t, ORDERS - 1, found);
    for (int d = 0; d < ORDERS; d++) {
        for (int a = 0; a < local; a++) {
            values[d][a] = factor * found[d * local + a];
        }
        factor *= length;
    }
}

/* Bounds of the four functions and their derivatives for |tau| <= rho, |s| rho^2 <= 1: cosh 1 - 1
 * and sinh 1 - 1 are below 1.1 times 1/2 and 1/6. */
static void fill_bounds(double s, double rho, double bound[4], double slope[4])
{
    const double more = s == 0 ? 1 : 1.1;
    bound[0] = 1;
    bound[1] = rho;
    bound[2] = more * rho * rho / 2;
    bound[3] = more * rho * rho * rho / 6;
    slope[0] = 0;
    slope[1] = 1;
    slope[2] = rho + fabs(s) * bound[3];
    slope[3] = bound[2];
}

/* The net about one point, as much of it as acts on a span. */
typedef struct patch {
    double from[LOCAL][LOCAL][3]; /* points less the origin */
    double apart[LOCAL][LOCAL];   /* their largest coordinates */
    double size[LOCAL][LOCAL];    /* of the points, with what cancelled in them */
} patch;

static void take_patch(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                       const taut_bonnet_piece *piece, double u[ORDERS][LOCAL],
                       double v[ORDERS][LOCAL], double origin[3], patch *p)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int nv = taut_basis_count(bases[1]);
    const int first[2] = {taut_basis_first(bases[0], piece->span[0]),
                          taut_basis_first(bases[1], piece->span[1])};

    memset(p, 0, sizeof *p);
    memset(origin, 0, 3 * sizeof *origin);
    for (int i = 0; i < taut_basis_local(bases[0]); i++) {
        for (int j = 0; j < taut_basis_local(bases[1]); j++) {
            const double *x =
                taut_surface_points(surface) + 3 * ((int64_t)(first[0] + i) * nv + first[1] + j);
            for (int c = 0; c < 3; c++) {
                p->from[i][j][c] = ldexp(x[c], -unit);
                origin[c] += p->from[i][j][c] * u[0][i] * v[0][j];
            }
            p->size[i][j] =
                ldexp(taut_bonnet_point_size(surface, scale, first[0] + i, first[1] + j), -unit);
        }
    }
    for (int i = 0; i < taut_basis_local(bases[0]); i++) {
        for (int j = 0; j < taut_basis_local(bases[1]); j++) {
            for (int c = 0; c < 3; c++) {
                p->from[i][j][c] -= origin[c];
            }
            p->apart[i][j] = taut_largest_coordinate(p->from[i][j]);
        }
    }
}

/* x[d][e] = sum (P - origin) U^(d) V^(e), along u first; and the sums of absolute values. */
static void contract(const patch *p, double u[ORDERS][LOCAL], double v[ORDERS][LOCAL],
                     taut_bonnet_local *local)
{
    for (int d = 0; d < ORDERS; d++) {
        double row[LOCAL][3], apart[LOCAL], size[LOCAL];
        memset(row, 0, sizeof row);
        memset(apart, 0, sizeof apart);
        memset(size, 0, sizeof size);
        for (int i = 0; i < LOCAL; i++) {
            for (int j = 0; j < LOCAL; j++) {
                for (int c = 0; c < 3; c++) {
                    row[j][c] += u[d][i] * p->from[i][j][c];
                }
                apart[j] += fabs(u[d][i]) * p->apart[i][j];
                size[j] += fabs(u[d][i]) * p->size[i][j];
            }
        }
        for (int e = 0; e < ORDERS; e++) {
            double *x = local->x[d][e], gross = 0, whole = 0;
            x[0] = x[1] = x[2] = 0;
            for (int j = 0; j < LOCAL; j++) {
                for (int c = 0; c < 3; c++) {
                    x[c] += v[e][j] * row[j][c];
                }
                gross += fabs(v[e][j]) * apart[j];
                whole += fabs(v[e][j]) * size[j];
            }
            local->own[d][e] = basis_error * gross;
            local->points[d][e] = point_error * whole;
        }
    }
}

/* Far from zero a parameter is rounded (sums.h), which moves each coefficient by the next. */
static void add_shifts(const taut_bonnet_scale *scale, taut_bonnet_local *local)
{
    const double u = scale->shift[0] / local->unit_length, v = scale->shift[1] / local->unit_length;
    for (int d = 0; d < ORDERS && u + v > 0; d++) {
        for (int e = 0; e < ORDERS; e++) {
            const double along = d < 3
                                     ? taut_largest_coordinate(local->x[d + 1][e])
                                     : fabs(local->s[0]) * taut_largest_coordinate(local->x[2][e]);
            const double across = e < 3
                                      ? taut_largest_coordinate(local->x[d][e + 1])
                                      : fabs(local->s[1]) * taut_largest_coordinate(local->x[d][2]);
            local->points[d][e] += 16 * (u * along + v * across);
        }
    }
}

void taut_bonnet_local_of(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                          const taut_bonnet_piece *piece, taut_bonnet_local *local)
{
    const taut_basis *bases[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const double length = ldexp(1, ilogb(fmax(piece->half[0], piece->half[1])));
    double lines[2][ORDERS][LOCAL];
    patch p;

    local->unit_length = length;
    for (int d = 0; d < 2; d++) {
        double sign = 0;
        (void)taut_bonnet_sign_of(bases[d], &sign);
        local->s[d] = sign * length * length;
        fill_line(bases[d], piece->span[d], piece->middle[d], length, lines[d]);
        /* a little more than the half: neighbours overlap, whatever rounding their middles have */
        fill_bounds(local->s[d], (1 + 1e-9) * piece->half[d] / length, local->bound[d],
                    local->slope[d]);
    }
    take_patch(surface, scale, unit, piece, lines[0], lines[1], local->origin, &p);
    contract(&p, lines[0], lines[1], local);
    add_shifts(scale, local);
}
