/* integrals.c -- area and total curvature, iint W du dv and iint K W du dv.
 *
 * Gauss rules on rectangles, cut across their longer side, or in four where the sides are alike,
 * until their quarters agree with the whole, to 1e-13 of all or to their noise: of W, W slope; of K
 * W, sqrt|K| bend + |K| W slope (sums.h). Where W varies much over the nodes, a peak of K
 * may lie between them, so that agreement says nothing. Coordinates may grow like cosh v, so that
 * sums are taken where points are: seen from one common origin (as measure/integrate/cell.h does, for
 * surfaces of one size) the small ones would be lost. The cuts follow what is integrated and not
 * the segments, of which there may be any number.
 */
#include "certify/bonnet/parts.h"
#include "core/constants.h"
#include "numeric/quadrature.h"
#include "numeric/sum.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { NODES = 10, BLOCKS = 8, DEPTH = 40, ORDERS = TAUT_BONNET_ORDERS };
/* What is integrated: W, K W, and the noise of each. */
enum { AREA, CURVATURE, NOISE, FIELDS = 4 };

/* W over its least at the nodes of a cell that is trusted: W = F0^2/w^2 grows about so much from
 * the middle of a peak, |K| = w^4/F0^4, to where 99 hundredths of it are inside. */
static const double most_varied = 100;

typedef struct cell {
    double lo[2], hi[2];
    double value[FIELDS];
    double varied; /* largest W over the least, at the nodes */
    int depth;
} cell;

typedef struct rule {
    taut_bonnet_sums sums;
    const taut_basis *basis[2];
    taut_bonnet_line lines[2][NODES];
    double nodes[NODES], weights[NODES];
    int64_t most; /* cuts */
} rule;

static void fields_of(const taut_bonnet_spot *spot, double fields[FIELDS])
{
    const taut_forms *f = &spot->forms;
    const double k = f->regular ? f->gaussian : 0;
    fields[AREA] = f->w;
    fields[CURVATURE] = k * f->w;
    fields[NOISE + AREA] = f->regular ? f->w * spot->slope : 0;
    fields[NOISE + CURVATURE] =
        f->regular ? sqrt(fabs(k)) * spot->bend + fabs(k) * f->w * spot->slope : 0;
}

static void integrate(rule *r, cell *c)
{
    const double half[2] = {0.5 * (c->hi[0] - c->lo[0]), 0.5 * (c->hi[1] - c->lo[1])};
    double least = INFINITY, largest = 0;
    taut_sum sums[FIELDS];

    memset(sums, 0, sizeof sums);
    for (int d = 0; d < 2; d++) {
        for (int i = 0; i < NODES; i++) {
            const double t = c->lo[d] + half[d] * (1 + r->nodes[i]);
            taut_bonnet_line_fill(r->basis[d], taut_basis_span(r->basis[d], t), t, &r->lines[d][i]);
        }
    }
    for (int i = 0; i < NODES; i++) {
        taut_bonnet_sums_contract(&r->sums, &r->lines[0][i], r->lines[1][0].first,
                                  r->lines[1][NODES - 1].first + r->lines[1][0].local);
        for (int j = 0; j < NODES; j++) {
            const double weight = r->weights[i] * r->weights[j] * half[0] * half[1];
            double fields[FIELDS];
            taut_bonnet_spot spot;
            taut_bonnet_sums_at(&r->sums, &r->lines[1][j], &spot);
            fields_of(&spot, fields);
            least = fmin(least, fields[AREA]);
            largest = fmax(largest, fields[AREA]);
            for (int k = 0; k < FIELDS; k++) {
                taut_sum_add(&sums[k], weight * fields[k]);
            }
        }
    }
    for (int k = 0; k < FIELDS; k++) {
        c->value[k] = taut_sum_total(&sums[k]);
    }
    c->varied = least > 0 ? largest / least : INFINITY;
}

/* Block k of at most BLOCKS, on breaks. */
static void block(const taut_basis *basis, int k, double *lo, double *hi)
{
    const int spans = taut_basis_span_count(basis), blocks = spans < BLOCKS ? spans : BLOCKS;
    *lo = taut_basis_breaks(basis)[(int64_t)k * spans / blocks];
    *hi = taut_basis_breaks(basis)[(int64_t)(k + 1) * spans / blocks];
}

/* The parts of a cell, cut along the directions that `along` says; returns how many. */
static int cut_cell(const cell *whole, const int along[2], cell parts[4])
{
    int count = 1;

    parts[0] = *whole;
    parts[0].depth++;
    for (int d = 0; d < 2; d++) {
        const double middle = whole->lo[d] + 0.5 * (whole->hi[d] - whole->lo[d]);
        for (int k = 0; along[d] && k < count; k++) {
            parts[count + k] = parts[k];
            parts[k].hi[d] = middle;
            parts[count + k].lo[d] = middle;
        }
        count *= along[d] ? 2 : 1;
    }
    return count;
}

/* Cuts a cell and integrates over the parts. */
static int integrate_parts(rule *r, const cell *whole, const int along[2], cell parts[4])
{
    const int count = cut_cell(whole, along, parts);
    for (int q = 0; q < count; q++) {
        integrate(r, &parts[q]);
    }
    return count;
}

static int agree(const double *a, const double *b, const double allowed[2])
{
    return fabs(a[AREA] - b[AREA]) <= fmax(allowed[AREA], 4 * a[NOISE + AREA]) &&
           fabs(a[CURVATURE] - b[CURVATURE]) <= fmax(allowed[CURVATURE], 4 * a[NOISE + CURVATURE]);
}

/* Adds the integral over a cell: of its quarters, once they agree with it; else goes on with its
 * parts. */
static void add_cell(rule *r, const cell *whole, const double allowed[2], int64_t *cut,
                     taut_sum total[FIELDS])
{
    static const int both[2] = {1, 1};
    cell stack[3 * DEPTH + 4];
    int held = 0;

    stack[held++] = *whole;
    while (held > 0) {
        const cell c = stack[--held];
        const double side[2] = {c.hi[0] - c.lo[0], c.hi[1] - c.lo[1]};
        const int along[2] = {2 * side[0] > side[1], 2 * side[1] > side[0]};
        cell parts[4];
        double sum[FIELDS] = {0, 0, 0, 0};
        integrate_parts(r, &c, both, parts);
        for (int k = 0; k < FIELDS; k++) {
            sum[k] = parts[0].value[k] + parts[1].value[k] + parts[2].value[k] + parts[3].value[k];
        }
        if ((c.varied <= most_varied && agree(sum, c.value, allowed)) || c.depth >= DEPTH ||
            *cut >= r->most) {
            for (int k = 0; k < FIELDS; k++) {
                taut_sum_add(&total[k], sum[k]);
            }
            continue;
        }
        const int count = along[0] && along[1] ? 4 : integrate_parts(r, &c, along, parts);
        memcpy(stack + held, parts, (size_t)count * sizeof *parts);
        held += count;
        ++*cut;
    }
}

static taut_status rule_init(const taut_surface *surface, const taut_bonnet_scale *scale,
                             taut_arena *arena, rule *r)
{
    taut_status status = taut_bonnet_sums_init(surface, scale, arena, &r->sums);

    r->basis[0] = taut_surface_u(surface);
    r->basis[1] = taut_surface_v(surface);
    taut_gauss_rule(NODES, r->nodes, r->weights);
    for (int k = 0; k < 2 * NODES && status == TAUT_OK; k++) {
        const size_t size = ORDERS * (size_t)taut_basis_local(r->basis[k / NODES]);
        double *values = taut_arena_take(arena, size, sizeof *values);
        r->lines[k / NODES][k % NODES].values = values;
        status = values != NULL ? TAUT_OK : TAUT_NO_MEMORY;
    }
    return status;
}

/* The blocks, each integrated as one cell. */
static int blocks_of(rule *r, cell *cells)
{
    int count = 0;
    for (int i = 0; i < taut_basis_span_count(r->basis[0]) && i < BLOCKS; i++) {
        for (int j = 0; j < taut_basis_span_count(r->basis[1]) && j < BLOCKS; j++) {
            cell *c = &cells[count++];
            c->depth = 0;
            block(r->basis[0], i, &c->lo[0], &c->hi[0]);
            block(r->basis[1], j, &c->lo[1], &c->hi[1]);
            integrate(r, c);
        }
    }
    return count;
}

/* Two rounds: where nearly all lies in a peak, only the first tells how large the whole is, and so
 * how close the second must come. */
taut_status taut_bonnet_integrate(const taut_surface *surface, const taut_bonnet_scale *scale,
                                  taut_arena *arena, int64_t most, taut_bonnet_integrals *integrals)
{
    static const double round_closeness[2] = {1e-3, 1e-13};
    cell cells[BLOCKS * BLOCKS];
    double whole[2] = {0, 0};
    taut_sum total[FIELDS];
    rule r;
    int64_t cut = 0;
    int count = 0;
    const taut_status status = rule_init(surface, scale, arena, &r);

    if (status != TAUT_OK) {
        return status;
    }
    r.most = most;
    count = blocks_of(&r, cells);
    for (int i = 0; i < count; i++) {
        whole[0] += fabs(cells[i].value[0]);
        whole[1] += fabs(cells[i].value[1]);
    }
    for (int k = 0; k < 2; k++) {
        const double close = round_closeness[k] / count;
        const double allowed[2] = {close * whole[0], close * whole[1]};
        memset(total, 0, sizeof total);
        cut = 0;
        for (int i = 0; i < count; i++) {
            add_cell(&r, &cells[i], allowed, &cut, total);
        }
        whole[0] = fabs(taut_sum_total(&total[0]));
        whole[1] = fabs(taut_sum_total(&total[1]));
    }
    for (int k = 0; k < 2; k++) {
        integrals->value[k] = taut_sum_total(&total[k]);
        integrals->noise[k] = taut_sum_total(&total[NOISE + k]) / fabs(integrals->value[k]) +
                              0.25 * TAUT_UNIT_ROUNDOFF * (double)cut;
        if (cut >= r.most) { /* not reached: by a test, for the 8 s so many cuts take; a net in
                                   one plane that folds over, W = 0 along lines, comes here */
            integrals->noise[k] = INFINITY;
        }
    }
    return TAUT_OK;
}
