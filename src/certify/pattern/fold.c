/* fold.c
 *
 *   no-fold     least det J over its mean, J = (y_s, y_t), proved by Bernstein coefficients over each cell between knots, cut in
 *               halves where they say too little (bound)
 *   no-overlap  an immersed disc whose border is simple is embedded. Of an outline as Bezier pieces around it: pieces that are no
 *               neighbours have boxes apart; neighbours run into one half plane, so that they meet nowhere else; halves where they
 *               do not. Residual: pairs that this leaves (bound)
 */
#include "certify/pattern/fold.h"

#include "certify/common/bernstein.h"
#include "certify/pattern/arc.h"
#include "certify/pattern/worst.h"

#include <string.h>

enum { P = 5, Q = 2 * P - 1 /* degree of det J */, DEPTH = 12, PAIR_DEPTH = 24 };
static const double fold_limit = 1e-3;
/* Of a piece for the pulse: operations, roughly. */
static const double work_of_piece = 2e7;

/* ---- no-fold ---- */

typedef double cell[P + 1][P + 1][2];
typedef double determinant[Q + 1][Q + 1];

/* The Bezier net of the cell (a, b) of a flat surface. */
static void cell_of(const taut_surface *flat, int a, int b, cell out)
{
    const taut_basis *u = taut_surface_u(flat), *v = taut_surface_v(flat);
    const int nv = taut_basis_count(v), first = taut_basis_first(u, a);
    const size_t begin = (size_t)taut_basis_first(v, b);
    double rows[P + 1][P + 1][2];
    for (int i = 0; i <= P; i++) { /* along v, of the rows that are alive */
        taut_cloth_arc_of(
            v, b, taut_surface_points(flat) + 3 * ((size_t)(first + i) * (size_t)nv + begin), 3,
            rows[i]);
    }
    for (int k = 0; k <= P; k++) {
        double part[P + 1][2];
        taut_cloth_arc_of(u, a, rows[0][k], sizeof rows[0] / sizeof(double), part);
        for (int i = 0; i <= P; i++) {
            memcpy(out[i][k], part[i], sizeof part[i]);
        }
    }
}

/* det (y_s, y_t) times the sides of the cell, degree 2 P - 1 in both. */
static void determinant_of(cell y, determinant out)
{
    const double scale = (double)P * P;
    memset(out, 0, sizeof(determinant));
    for (int i = 0; i < P; i++) {
        for (int j = 0; j <= P; j++) {
            const double s[2] = {y[i + 1][j][0] - y[i][j][0], y[i + 1][j][1] - y[i][j][1]};
            const double ws = taut_certify_binomial(P - 1, i) * taut_certify_binomial(P, j);
            for (int k = 0; k <= P; k++) {
                for (int l = 0; l < P; l++) {
                    const double t[2] = {y[k][l + 1][0] - y[k][l][0], y[k][l + 1][1] - y[k][l][1]};
                    const double wt = taut_certify_binomial(P, k) * taut_certify_binomial(P - 1, l);
                    out[i + k][j + l] += scale * ws * wt * (s[0] * t[1] - s[1] * t[0]);
                }
            }
        }
    }
    for (int i = 0; i <= Q; i++) {
        for (int j = 0; j <= Q; j++) {
            out[i][j] /= taut_certify_binomial(Q, i) * taut_certify_binomial(Q, j);
        }
    }
}

/* A bound from below of a polynomial on [0, 1]^2 that is as good as `enough`, or what depth lets it be. */
static double lowest(determinant d, double enough, int depth)
{
    double least = INFINITY, most = -INFINITY;
    determinant low, high;
    for (int i = 0; i <= Q; i++) {
        for (int j = 0; j <= Q; j++) {
            least = taut_certify_min(least, d[i][j]);
            most = taut_certify_max(most, d[i][j]);
        }
    }
    if (!(least < enough) || depth == 0 || !(most > 0)) {
        return least;
    }
    if (depth % 2 == 0) {
        taut_certify_halve(Q, Q + 1, d[0], low[0], high[0]);
    } else {
        for (int i = 0; i <= Q; i++) {
            taut_certify_halve(Q, 1, d[i], low[i], high[i]);
        }
    }
    return taut_certify_min(lowest(low, enough, depth - 1), lowest(high, enough, depth - 1));
}

/* Where the cell begins (or ends) at a point det J is 0 along it: over the part of the way to there, raised to the degree that it had.
 *
 *     sum d_i B_i^Q = s sum d_i+1 Q/(i + 1) B_i^Q-1 */
static void divide_out(int at_end, determinant d)
{
    determinant e;
    for (int i = 0; i < Q; i++) {
        for (int j = 0; j <= Q; j++) {
            e[i][j] = d[at_end ? Q - 1 - i : i + 1][j] * Q / (i + 1.0);
        }
    }
    for (int i = 0; i <= Q; i++) {
        for (int j = 0; j <= Q; j++) {
            const double share = (double)i / Q;
            d[i][j] = (i > 0 ? share * e[i - 1][j] : 0) + (i < Q ? (1 - share) * e[i][j] : 0);
        }
    }
}

/* The flat piece's least det J over its mean. */
static double fold_of(const taut_cloth_piece *piece)
{
    const taut_basis *u = taut_surface_u(piece->flat), *v = taut_surface_v(piece->flat);
    const double *bu = taut_basis_breaks(u), *bv = taut_basis_breaks(v);
    double mean = 0, least = INFINITY;
    for (int pass = 0; pass < 2; pass++) {
        for (int a = 0; a < taut_basis_span_count(u); a++) {
            for (int b = 0; b < taut_basis_span_count(v); b++) {
                const double area = (bu[a + 1] - bu[a]) * (bv[b + 1] - bv[b]);
                double sum = 0;
                cell y;
                determinant d;
                cell_of(piece->flat, a, b, y);
                determinant_of(y, d);
                for (int i = 0; pass == 0 && i <= Q; i++) {
                    for (int j = 0; j <= Q; j++) {
                        sum += d[i][j] / ((Q + 1) * (Q + 1));
                    }
                }
                if (pass == 1 && a == 0 && piece->is_point[TAUT_CLOTH_START]) {
                    divide_out(0, d);
                }
                if (pass == 1 && a == taut_basis_span_count(u) - 1 &&
                    piece->is_point[TAUT_CLOTH_END]) {
                    divide_out(1, d);
                }
                mean += sum; /* the integral over [0, 1]^2, which is of area 1 */
                if (pass == 1) {
                    const double found = lowest(d, 2 * fold_limit * mean * area, DEPTH);
                    least = taut_certify_min(least, found / area);
                }
            }
        }
    }
    return mean > 0 ? least / mean : fmin(least, -1); /* turned over as a whole */
}

/* ---- no-overlap ---- */

typedef taut_cloth_arc arc;

static int boxes_apart(const arc *a, const arc *b)
{
    for (int d = 0; d < 2; d++) {
        double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
        for (int k = 0; k <= P; k++) {
            lo[0] = fmin(lo[0], a->p[k][d]);
            hi[0] = fmax(hi[0], a->p[k][d]);
            lo[1] = fmin(lo[1], b->p[k][d]);
            hi[1] = fmax(hi[1], b->p[k][d]);
        }
        if (hi[0] < lo[1] || hi[1] < lo[0]) {
            return 1;
        }
    }
    return 0;
}

/* Do both run into one open half plane? Then, end to end, they meet nowhere else, nor themselves. Looked for among the sums of
 * their chords made unit. */
static int runs_on(const arc *a, const arc *b)
{
    double sum[2] = {0, 0};
    const arc *both[2] = {a, b};
    for (int k = 0; k < 2; k++) {
        const double chord[2] = {both[k]->p[P][0] - both[k]->p[0][0],
                                 both[k]->p[P][1] - both[k]->p[0][1]};
        const double length = sqrt(chord[0] * chord[0] + chord[1] * chord[1]);
        sum[0] += chord[0] / length;
        sum[1] += chord[1] / length;
    }
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < P; i++) {
            const double step[2] = {both[k]->p[i + 1][0] - both[k]->p[i][0],
                                    both[k]->p[i + 1][1] - both[k]->p[i][1]};
            if (!(step[0] * sum[0] + step[1] * sum[1] > 0)) {
                return 0;
            }
        }
    }
    return 1;
}

static int is_apart(const arc *a, const arc *b, int depth)
{
    arc la, ha, lb, hb;
    if (boxes_apart(a, b)) {
        return 1;
    }
    if (depth == 0) {
        return 0;
    }
    taut_cloth_arc_halve(a, &la, &ha);
    taut_cloth_arc_halve(b, &lb, &hb);
    return is_apart(&la, &lb, depth - 1) && is_apart(&la, &hb, depth - 1) &&
           is_apart(&ha, &lb, depth - 1) && is_apart(&ha, &hb, depth - 1);
}

/* Of neighbours, b after a. */
static int meets_once(const arc *a, const arc *b, int depth)
{
    arc la, ha, lb, hb;
    if (runs_on(a, b)) {
        return 1;
    }
    if (depth == 0) {
        return 0;
    }
    taut_cloth_arc_halve(a, &la, &ha);
    taut_cloth_arc_halve(b, &lb, &hb);
    return meets_once(&la, &ha, depth - 1) && meets_once(&ha, &lb, depth - 1) &&
           meets_once(&lb, &hb, depth - 1) && is_apart(&la, &lb, depth - 1) &&
           is_apart(&la, &hb, depth - 1) && is_apart(&ha, &hb, depth - 1);
}

/* Pairs of arcs of a closed outline that are not proved apart. */
static double count_meetings(int count, const arc *arcs)
{
    double pairs = 0;
    for (int i = 0; i < count; i++) {
        const arc *next = &arcs[(i + 1) % count];
        pairs += arcs[i].p[P][0] != next->p[0][0] || arcs[i].p[P][1] != next->p[0][1] ||
                 !meets_once(&arcs[i], next, PAIR_DEPTH);
        for (int k = i + 2; k < count; k++) {
            if (i > 0 || k < count - 1) {
                pairs += !is_apart(&arcs[i], &arcs[k], PAIR_DEPTH);
            }
        }
    }
    return pairs;
}

/* The edge of a tip: one place but for what cutting at knots rounds. */
static int is_place(const arc *a)
{
    static const double rounding = 2e-15;
    const double room = rounding * fmax(fabs(a->p[0][0]), fabs(a->p[0][1]));
    int all = 1;
    for (int k = 1; k <= P; k++) {
        all &= fabs(a->p[k][0] - a->p[0][0]) <= room && fabs(a->p[k][1] - a->p[0][1]) <= room;
    }
    return all;
}

static taut_status overlap_of(const taut_cloth *cloth, const taut_cloth_piece *piece,
                              taut_arena *arena, double *pairs)
{
    const taut_basis *cut = taut_curve_t(piece->cut);
    const taut_basis *bases[2] = {taut_surface_u(piece->flat), taut_surface_v(piece->flat)};
    const int spans[2] = {taut_basis_span_count(bases[0]), taut_basis_span_count(bases[1])};
    const int around = taut_basis_span_count(cut), border = 2 * (spans[0] + spans[1]);
    arc *arcs = taut_arena_take(arena, (size_t)(around > border ? around : border), sizeof *arcs);
    const int has_tip = piece->is_point[TAUT_CLOTH_START] || piece->is_point[TAUT_CLOTH_END];
    int count = 0;
    (void)cloth;

    if (arcs == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < around; i++) {
        taut_cloth_arc_of(cut, i,
                          taut_curve_points(piece->cut) + 3 * (size_t)taut_basis_first(cut, i), 3,
                          arcs[count].p);
        count += !has_tip || !is_place(&arcs[count]);
    }
    *pairs = count_meetings(count, arcs);
    count = 0;
    const size_t nv = (size_t)taut_basis_count(bases[1]), nu = (size_t)taut_basis_count(bases[0]);
    const double *net = taut_surface_points(piece->flat);
    const double *from[4] = {net, net + 3 * (nu - 1) * nv, net + 3 * (nv - 1), net};
    for (int e = 0; e < TAUT_CLOTH_EDGES; e++) {
        const int across = e == TAUT_CLOTH_END || e == TAUT_CLOTH_START;
        const int is_back = e == TAUT_CLOTH_LEFT || e == TAUT_CLOTH_START;
        for (int i = 0; !piece->is_point[e] && i < spans[across]; i++) {
            arc *one = &arcs[count++];
            double p[P + 1][2];
            const int span = is_back ? spans[across] - 1 - i : i;
            const size_t stride = across ? 3 : 3 * nv;
            taut_cloth_arc_of(bases[across], span,
                              from[e] + stride * (size_t)taut_basis_first(bases[across], span),
                              stride, p);
            for (int k = 0; k <= P; k++) {
                memcpy(one->p[k], p[is_back ? P - k : k], sizeof p[k]);
            }
        }
    }
    *pairs += count_meetings(count, arcs);
    return TAUT_OK;
}

/* ---- of all pieces ---- */

typedef struct folds {
    const taut_cloth *cloth;
    double *fold, *pairs;
    taut_status *status;
} folds;

static void look_at(void *context, int worker, int64_t task)
{
    const folds *f = context;
    const taut_cloth_piece *piece = &f->cloth->pieces[task];
    taut_arena *scratch = taut_arena_new();
    (void)worker;
    f->fold[task] = fold_of(piece);
    f->status[task] =
        scratch != NULL ? overlap_of(f->cloth, piece, scratch, &f->pairs[task]) : TAUT_NO_MEMORY;
    taut_arena_free(scratch);
}

taut_status taut_cloth_add_folds(const taut_cloth *cloth, taut_arena *arena,
                                 taut_certificate *certificate)
{
    const size_t count = (size_t)cloth->piece_count;
    const int workers = taut_crew_workers(cloth->crew, (int64_t)count);
    folds f = {cloth, taut_arena_take(arena, count + 1, sizeof *f.fold),
               taut_arena_take(arena, count + 1, sizeof *f.pairs),
               taut_arena_take(arena, count + 1, sizeof *f.status)};
    taut_worst overlap = {0, ""};
    taut_claim claim = {.claim = "no-fold", .kind = TAUT_BOUND, .limit = fold_limit, .where = ""};
    claim.residual = INFINITY;

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    if (taut_crew_run(cloth->crew, workers, (int64_t)count, work_of_piece, look_at, &f)) {
        return TAUT_INTERRUPTED;
    }
    for (int k = 0; k < cloth->piece_count; k++) {
        const taut_cloth_piece *piece = &cloth->pieces[k];
        if (f.status[k] != TAUT_OK) {
            return f.status[k];
        }
        claim.where = !(f.fold[k] >= claim.residual) ? piece->name : claim.where;
        claim.residual = taut_certify_min(claim.residual, f.fold[k]);
        overlap.residual += f.pairs[k];
        if (f.pairs[k] > 0 && overlap.where[0] == '\0') {
            snprintf(overlap.where, sizeof overlap.where, "%.40s", piece->name);
        }
    }
    claim.holds = taut_certify_above(claim.residual, claim.limit);
    const taut_status status = taut_certificate_add(certificate, &claim);
    return status == TAUT_OK ? taut_worst_add(&overlap, "no-overlap", TAUT_BOUND, 0, certificate)
                             : status;
}
