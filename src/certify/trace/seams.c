#include "certify/trace/seams.h"

#include "certify/common/verdict.h"
#include "core/vec3.h"
#include "taut/join.h"
#include "taut/measure.h"

#include <stdio.h>

enum { EDGES = 4 };
static const double limit = 1e-9;
/* Corners nearer than this, of surfaces about 1 in size, are one. */
static const double same_corner = 1e-9;
/* So near to an edge, over the window's side, a curve passes it. */
static const double on_edge = 1e-12;

/* The end of an edge, 0 or 1 as it runs: where it is, and the normal there. */
typedef struct corner {
    double x[3], normal[3];
    int is_regular;
} corner;

static corner corner_of(const taut_surface *surface, int edge, int end)
{
    const taut_basis *basis[2] = {taut_surface_u(surface), taut_surface_v(surface)};
    const int held = edge / 2;
    corner found = {{0, 0, 0}, {0, 0, 0}, 0};
    taut_forms f;
    double at[2];

    at[held] = edge % 2 == 0 ? taut_basis_lo(basis[held]) : taut_basis_hi(basis[held]);
    at[1 - held] = end == 0 ? taut_basis_lo(basis[1 - held]) : taut_basis_hi(basis[1 - held]);
    taut_surface_eval(surface, at[0], at[1], 0, found.x);
    if (taut_surface_forms_points(surface, 1, &at[0], &at[1], 1, &f) == TAUT_OK && f.regular) {
        found.is_regular = 1;
        for (int c = 0; c < 3; c++) {
            found.normal[c] = f.normal[c];
        }
    }
    return found;
}

/* Do the corners of two edges lie on each other, and the normals there on one side? */
static int corners_meet(const taut_surface *a, int edge_a, const taut_surface *b, int edge_b)
{
    const corner first[2] = {corner_of(a, edge_a, 0), corner_of(a, edge_a, 1)};
    const corner second[2] = {corner_of(b, edge_b, 0), corner_of(b, edge_b, 1)};
    const int turned = taut_distance(first[0].x, second[0].x) > same_corner;

    if (taut_distance(first[0].x, first[1].x) <= 2 * same_corner) {
        return 0;
    }
    for (int end = 0; end < 2; end++) {
        const corner *p = &first[end], *q = &second[turned ? 1 - end : end];
        if (!(taut_distance(p->x, q->x) <= same_corner) ||
            (p->is_regular && q->is_regular && taut_dot(p->normal, q->normal) < 0)) {
            return 0;
        }
    }
    return 1;
}

static taut_status look_at(const int surfaces[2], const int edges[2], taut_net_seams *seams)
{
    static const taut_edge words[EDGES] = {TAUT_EDGE_U0, TAUT_EDGE_U1, TAUT_EDGE_V0, TAUT_EDGE_V1};
    const taut_surface *a = seams->surfaces[surfaces[0]], *b = seams->surfaces[surfaces[1]];
    taut_join join;

    if (!corners_meet(a, edges[0], b, edges[1])) {
        return TAUT_OK;
    }
    const taut_status status =
        taut_join_measure(a, words[edges[0]], b, words[edges[1]], &join, NULL);
    if (status == TAUT_OK && join.g_order >= 1) {
        seams->list[seams->count++] =
            (taut_net_seam){{surfaces[0], surfaces[1]},
                            {edges[0], edges[1]},
                            join.kind == TAUT_JOIN_BOUND && join.c_order >= 1};
    }
    return status;
}

taut_status taut_net_seams_new(taut_arena *arena, int count, const taut_surface *const *surfaces,
                               taut_net_seams *seams)
{
    taut_status status = TAUT_OK;

    *seams = (taut_net_seams){.surfaces = surfaces};
    for (int i = 0; i < count; i++) {
        for (int k = i + 1; k < count; k++) {
            const int before = seams->count;
            taut_net_seam *room =
                taut_arena_take(arena, (size_t)before + EDGES * EDGES, sizeof *room);
            if (room == NULL) {
                return TAUT_NO_MEMORY;
            }
            for (int s = 0; s < before; s++) {
                room[s] = seams->list[s];
            }
            seams->list = room;
            for (int pair = 0; status == TAUT_OK && pair < EDGES * EDGES; pair++) {
                const int two[2] = {i, k}, edges[2] = {pair / EDGES, pair % EDGES};
                status = look_at(two, edges, seams);
            }
        }
    }
    return status;
}

int taut_net_seams_join(const taut_net_seams *seams, int surface, int edge)
{
    int count = 0;
    for (int k = 0; k < seams->count; k++) {
        const taut_net_seam *seam = &seams->list[k];
        count += (seam->surfaces[0] == surface && seam->edges[0] == edge) ||
                 (seam->surfaces[1] == surface && seam->edges[1] == edge);
    }
    return count == 1;
}

static int lies_on(const taut_surface *surface, int edge, const double at[2])
{
    const taut_basis *basis = edge / 2 == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
    const double lo = taut_basis_lo(basis), hi = taut_basis_hi(basis);
    return fabs(at[edge / 2] - (edge % 2 == 0 ? lo : hi)) <= on_edge * (hi - lo);
}

/* Is there a join that is proved between the two places? */
static int is_proved(const taut_net_seams *seams, const int on[2], const double at[2][2])
{
    for (int k = 0; k < seams->count; k++) {
        const taut_net_seam *seam = &seams->list[k];
        const int turned = seam->surfaces[0] != on[0];
        if (seam->surfaces[turned] == on[0] && seam->surfaces[1 - turned] == on[1] &&
            lies_on(seams->surfaces[on[0]], seam->edges[turned], at[0]) &&
            lies_on(seams->surfaces[on[1]], seam->edges[1 - turned], at[1])) {
            return seam->is_proved;
        }
    }
    return 0;
}

/* From stretch k - 1 of a line to k. */
static double judge_passing(const taut_net_seams *seams, const taut_net_line *line, int k,
                            int *proved)
{
    const int on[2] = {line->on[k - 1], line->on[k]};
    double at[2][2], x[2][3], point[3], away = 0;
    taut_forms f[2];

    for (int side = 0; side < 2; side++) {
        const taut_curve *window = line->window[k - 1 + side];
        const taut_basis *t = taut_curve_t(window);
        const taut_surface *surface = seams->surfaces[on[side]];
        taut_curve_eval(window, side == 0 ? taut_basis_hi(t) : taut_basis_lo(t), 0, point);
        for (int d = 0; d < 2; d++) {
            const taut_basis *basis = d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
            at[side][d] = fmin(fmax(point[d], taut_basis_lo(basis)), taut_basis_hi(basis));
            away = fmax(away, fabs(point[d] - at[side][d]) /
                                  (taut_basis_hi(basis) - taut_basis_lo(basis)));
        }
        if (taut_surface_eval(surface, at[side][0], at[side][1], 0, x[side]) != TAUT_OK ||
            taut_surface_forms_points(surface, 1, &at[side][0], &at[side][1], 1, &f[side]) !=
                TAUT_OK ||
            !f[side].regular) {
            return INFINITY;
        }
    }
    *proved &= is_proved(seams, on, (const double(*)[2])at);
    away = fmax(away, taut_distance(x[0], x[1]));
    return fmax(away, taut_distance(f[0].normal, f[1].normal));
}

taut_status taut_net_seams_add(const taut_net_seams *seams, const taut_net_lines *lines,
                               taut_certificate *certificate)
{
    int proved = 1;
    char where[96] = "";
    taut_claim claim = {.claim = "seams", .limit = limit, .where = where};

    for (int i = 0; i < lines->count; i++) {
        const taut_net_line *line = &lines->lines[i];
        for (int k = 1; k < line->count; k++) {
            if (line->on[k - 1] == line->on[k]) {
                continue;
            }
            const double here = judge_passing(seams, line, k, &proved);
            if (where[0] == '\0' || !(here <= claim.residual)) {
                snprintf(where, sizeof where, "%.40s at %.6g", taut_curve_name(line->space),
                         taut_basis_lo(taut_curve_t(line->window[k])));
            }
            claim.residual = taut_certify_max(claim.residual, here);
        }
    }
    claim.kind = proved ? TAUT_BOUND : TAUT_CHECK;
    claim.holds = isinf(claim.residual) ? TAUT_FALSE : taut_certify_below(claim.residual, limit);
    return taut_certificate_add(certificate, &claim);
}
