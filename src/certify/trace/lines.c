#include "certify/trace/lines.h"

#include "core/fail.h"
#include "geometry/exponent.h"
#include "geometry/stretch.h"

#include <math.h>
#include <string.h>

static const char *const nets[] = {"asymptotic", "principal", "geodesic", "isoparametric"};

/* Do curves go on from one surface to the next: as the problem says, or else as the stretches do? */
static int is_carried(const taut_trace_problem *problem, const taut_record *domain)
{
    return problem != NULL ? problem->carry
                           : taut_record_get(taut_record_at(domain, 0), "surface") != NULL;
}

/* The surface that a stretch names; -1 where there is none. */
static int surface_of(const taut_net_lines *lines, const taut_record *stretch)
{
    const char *name = taut_record_text(taut_record_get(stretch, "surface"));
    for (int k = 0; lines->surface_count > 1 && k < lines->surface_count; k++) {
        if (strcmp(taut_surface_name(taut_model_surface(lines->model, k)), name) == 0) {
            return k;
        }
    }
    return lines->surface_count > 1 ? -1 : 0;
}

/* Of all surfaces, from the first one's first point. */
static double size_of(const taut_net_lines *lines)
{
    const double *origin = taut_surface_points(lines->surface);
    double half = taut_half_size(taut_point_count(lines->surface), origin);
    for (int i = 1; i < lines->surface_count; i++) {
        const taut_surface *surface = taut_model_surface(lines->model, i);
        const double *points = taut_surface_points(surface);
        for (size_t k = 0; k < 3 * taut_point_count(surface); k++) {
            half = fmax(half, fabs(points[k] / 2 - origin[k % 3] / 2));
        }
    }
    return 2 * half;
}

/* The stretches of a name, end to end over the range of the curve; none where they are not. */
static taut_status read_window(const taut_net_lines *lines, const taut_record *domain,
                               taut_arena *arena, taut_net_line *line)
{
    const size_t items = taut_record_count(domain);
    const char *name = taut_curve_name(line->space);
    double at = taut_basis_lo(taut_curve_t(line->space));

    line->window = taut_arena_take(arena, items + 1, sizeof *line->window);
    line->on = taut_arena_take(arena, items + 1, sizeof *line->on);
    if (line->window == NULL || line->on == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t k = 0; k < items; k++) {
        const taut_record *item = taut_record_at(domain, k);
        if (strcmp(taut_record_text(taut_record_get(item, "name")), name) != 0) {
            continue;
        }
        taut_curve *stretch = NULL;
        const taut_status status = taut_stretch_read(item, arena, &stretch);
        if (status != TAUT_OK) {
            return status;
        }
        const int on = surface_of(lines, item);
        if (stretch == NULL || on < 0 || taut_basis_lo(taut_curve_t(stretch)) != at) {
            line->count = 0;
            return TAUT_OK;
        }
        at = taut_basis_hi(taut_curve_t(stretch));
        line->on[line->count] = on;
        line->window[line->count++] = stretch;
    }
    if (at != taut_basis_hi(taut_curve_t(line->space))) {
        line->count = 0;
    }
    return TAUT_OK;
}

static taut_status find_net(const taut_model *model, const taut_trace_problem *problem,
                            taut_trace_net *net, taut_error *error)
{
    const char *word = taut_record_text(taut_record_get(taut_model_details(model), "trace"));
    if (problem != NULL) {
        *net = problem->net;
        return TAUT_OK;
    }
    for (int k = 0; k < 4; k++) {
        if (strcmp(word, nets[k]) == 0) {
            *net = (taut_trace_net)k;
            return TAUT_OK;
        }
    }
    return taut_fail(error, TAUT_BAD_INPUT, "details", "/details/trace", taut_none, taut_none,
                     "the model does not say which net it is: give its document too");
}

taut_status taut_net_lines_new(taut_arena *arena, const taut_model *model,
                               const taut_trace_problem *problem, taut_net_lines *lines,
                               taut_error *error)
{
    const taut_record *domain = taut_record_get(taut_model_details(model), "domain");
    const int count = taut_model_curve_count(model);
    taut_status status = TAUT_OK;

    *lines = (taut_net_lines){.model = model, .surface = taut_model_surface(model, 0)};
    if (lines->surface == NULL || count == 0) {
        return taut_fail(error, TAUT_BAD_INPUT, "model",
                         lines->surface == NULL ? "/surfaces" : "/curves", taut_none, taut_none,
                         "the model has no %s, and so no net",
                         lines->surface == NULL ? "surface" : "curve");
    }
    status = find_net(model, problem, &lines->net, error);
    if (status != TAUT_OK) {
        return status;
    }
    lines->surface_count = is_carried(problem, domain) ? taut_model_surface_count(model) : 1;
    lines->size = size_of(lines);
    lines->lines = taut_arena_take(arena, (size_t)count, sizeof *lines->lines);
    for (int i = 0; lines->lines != NULL && i < count; i++) {
        taut_net_line *line = &lines->lines[lines->count++];
        line->space = taut_model_curve(model, i);
        line->index = i;
        line->family = taut_curve_name(line->space)[0] == 'B';
        line->length =
            taut_basis_hi(taut_curve_t(line->space)) - taut_basis_lo(taut_curve_t(line->space));
        status = read_window(lines, domain, arena, line);
        if (status != TAUT_OK) {
            return taut_fail_memory(error);
        }
    }
    return lines->lines != NULL ? TAUT_OK : taut_fail_memory(error);
}

int taut_net_line_window(const taut_net_line *line, double t, double at[2], int *on)
{
    for (int k = 0; k < line->count; k++) {
        const taut_basis *basis = taut_curve_t(line->window[k]);
        double point[3];
        if (t >= taut_basis_lo(basis) && t <= taut_basis_hi(basis)) {
            taut_curve_eval(line->window[k], t, 0, point);
            at[0] = point[0];
            at[1] = point[1];
            *on = line->on[k];
            return 1;
        }
    }
    return 0;
}

static const taut_net_line *line_of(const taut_net_lines *lines, const char *name, size_t length)
{
    for (int k = 0; k < lines->count; k++) {
        const char *one = taut_curve_name(lines->lines[k].space);
        size_t same = 0; /* short names: no call is worth it */
        while (same < length && one[same] == name[same]) {
            same++;
        }
        if (same == length && one[same] == '\0') {
            return &lines->lines[k];
        }
    }
    return NULL;
}

int taut_net_lines_of_node(const taut_net_lines *lines, const char *name,
                           const taut_net_line *both[2])
{
    size_t first = 1;
    while (name[0] != '\0' && name[first] >= '0' && name[first] <= '9') {
        first++;
    }
    const size_t rest = name[0] != '\0' ? strcspn(name + first, ".") : 0;
    both[0] = name[0] != '\0' ? line_of(lines, name, first) : NULL;
    both[1] = rest > 0 ? line_of(lines, name + first, rest) : NULL;
    return both[0] != NULL && both[1] != NULL && both[0] != both[1];
}
