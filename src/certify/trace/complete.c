#include "certify/trace/complete.h"

#include "certify/common/verdict.h"
#include "certify/trace/turning.h"
#include "core/vec3.h"
#include "taut/measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GRID = 33 };
/* Ends nearer to each other on the border than this, over a side, are one; and so near to a border an
 * end lies on it. */
static const double same = 1e-9;
/* The net exists where -K, or R, is more than this of R^2, or of its largest value. */
static const double least = 1e-9;

/* t of a place of the border, 0 to 4; -1 inside. */
static double border_of(const taut_surface *surface, const double at[2])
{
    const taut_basis *bu = taut_surface_u(surface), *bv = taut_surface_v(surface);
    const double u = (at[0] - taut_basis_lo(bu)) / (taut_basis_hi(bu) - taut_basis_lo(bu));
    const double v = (at[1] - taut_basis_lo(bv)) / (taut_basis_hi(bv) - taut_basis_lo(bv));
    if (v <= same) {
        return u;
    }
    if (u >= 1 - same) {
        return 1 + v;
    }
    if (v >= 1 - same) {
        return 3 - u;
    }
    return u <= same ? 4 - v : -1;
}

static int exists_everywhere(const taut_net_lines *lines)
{
    const taut_basis *b[2] = {taut_surface_u(lines->surface), taut_surface_v(lines->surface)};
    double most = 0, lowest = INFINITY;
    for (int i = 0; i < GRID; i++) {
        for (int j = 0; j < GRID; j++) {
            const double u =
                taut_basis_lo(b[0]) + (taut_basis_hi(b[0]) - taut_basis_lo(b[0])) * i / (GRID - 1);
            const double v =
                taut_basis_lo(b[1]) + (taut_basis_hi(b[1]) - taut_basis_lo(b[1])) * j / (GRID - 1);
            taut_forms forms;
            if (taut_surface_forms_points(lines->surface, 1, &u, &v, 1, &forms) != TAUT_OK ||
                !forms.regular) {
                return 0;
            }
            const double square = forms.mean * forms.mean - forms.gaussian;
            if (lines->net == TAUT_TRACE_ASYMPTOTIC && !(-forms.gaussian > least * square)) {
                return 0;
            }
            most = fmax(most, square);
            lowest = fmin(lowest, square);
        }
    }
    return lines->net == TAUT_TRACE_ISOPARAMETRIC || lowest > least * least * most;
}

static int is_between(double t, double a, double b)
{
    return a < b ? t > a && t < b : t > a || t < b;
}

static int are_one(double a, double b)
{
    const double away = fabs(a - b);
    return away <= same || away >= 4 - same;
}

/* Do two curves with these ends cross? */
static int crosses(const double a[2], const double b[2])
{
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            if (are_one(a[i], b[j])) {
                return 1;
            }
        }
    }
    return is_between(b[0], a[0], a[1]) != is_between(b[1], a[0], a[1]);
}

/* Counts of nodes, counts[i * count + j], by the names of the two curves that theirs are made of: "A3B5", "A3B5.2". */
static void count_nodes(const taut_net_lines *lines, const taut_record *nodes, int *counts)
{
    for (size_t k = 0; k < taut_record_count(nodes); k++) {
        const char *node = taut_record_text(taut_record_get(taut_record_at(nodes, k), "node"));
        for (int i = 0; i < lines->count; i++) {
            const char *a = taut_curve_name(lines->lines[i].space);
            const size_t first = strlen(a);
            for (int j = 0; strncmp(node, a, first) == 0 && j < lines->count; j++) {
                const char *b = taut_curve_name(lines->lines[j].space), *rest = node + first;
                const size_t last = strlen(b);
                counts[(size_t)i * (size_t)lines->count + (size_t)j] +=
                    strncmp(rest, b, last) == 0 && (rest[last] == '\0' || rest[last] == '.');
            }
        }
    }
}

taut_status taut_net_complete_add(const taut_net_lines *lines, int is_proved, taut_arena *arena,
                                  taut_certificate *certificate)
{
    const taut_record *nodes = taut_record_get(taut_model_details(lines->model), "nodes");
    double(*ends)[2] = taut_arena_take(arena, (size_t)lines->count, sizeof *ends);
    taut_claim claim = {.claim = "complete",
                        .kind = is_proved && lines->net != TAUT_TRACE_ISOPARAMETRIC ? TAUT_EXACT
                                                                                    : TAUT_CHECK,
                        .limit = 0,
                        .where = ""};
    char where[160];
    double wrong = 0, known = 0;
    const size_t count = (size_t)lines->count;

    if (ends == NULL) {
        return TAUT_NO_MEMORY;
    }
    if (lines->net == TAUT_TRACE_GEODESIC || lines->surface_count > 1 ||
        (!is_proved && (!exists_everywhere(lines) || (lines->net == TAUT_TRACE_PRINCIPAL &&
                                                      taut_net_turns_forwards(lines->surface))))) {
        return TAUT_OK;
    }
    for (int k = 0; k < lines->count; k++) {
        const taut_basis *t = taut_curve_t(lines->lines[k].space);
        double at[2];
        int on = 0;
        for (int end = 0; end < 2; end++) {
            const double place = end == 0 ? taut_basis_lo(t) : taut_basis_hi(t);
            if (lines->lines[k].count != 1 ||
                !taut_net_line_window(&lines->lines[k], place, at, &on)) {
                return TAUT_OK;
            }
            ends[k][end] = border_of(lines->surface, at);
            if (ends[k][end] < 0) {
                return TAUT_OK;
            }
        }
    }
    int *counts = taut_arena_take(arena, count * count, sizeof *counts);
    if (counts == NULL) {
        return TAUT_NO_MEMORY;
    }
    count_nodes(lines, nodes, counts);
    for (int i = 0; i < lines->count; i++) {
        for (int j = 0; j < lines->count; j++) {
            if (lines->lines[i].family != 0 || lines->lines[j].family != 1) {
                continue;
            }
            const char *a = taut_curve_name(lines->lines[i].space);
            const char *b = taut_curve_name(lines->lines[j].space);
            const int found = counts[(size_t)i * count + (size_t)j];
            const int wanted = crosses(ends[i], ends[j]);
            known += found;
            if (found != wanted && wrong == 0) {
                snprintf(where, sizeof where, "%.60s and %.60s", a, b);
                claim.where = where;
            }
            wrong += abs(found - wanted);
        }
    }
    claim.residual = wrong + fabs((double)taut_record_count(nodes) - known);
    claim.holds = taut_certify_below(claim.residual, claim.limit);
    return taut_certificate_add(certificate, &claim);
}
