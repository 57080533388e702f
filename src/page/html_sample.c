#include "page/html_page.h"

#include "core/elementary/elementary.h"
#include "measure/cloth/mounted.h"
#include "measure/dual/density.h"
#include "measure/film/stress.h"
#include "taut/measure.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* `cells` cells in all: the spans cut alike, both ends of each a line, or, where there are more
 * spans than that, lines at so many breaks. */
static taut_status fill_lines(const taut_basis *basis, int cells, taut_arena *arena,
                              taut_page_lines *lines)
{
    const int spans = taut_basis_span_count(basis);
    const double *breaks = taut_basis_breaks(basis);
    const int whole = cells >= spans;
    const int per = whole ? cells / spans : 0;

    lines->count = whole ? spans * (per + 1) : cells + 1;
    lines->skipped = whole ? 0 : spans - cells;
    lines->at = taut_arena_take(arena, (size_t)lines->count, sizeof(double));
    lines->is_knot = taut_arena_take(arena, (size_t)lines->count, 1);
    if (lines->at == NULL || lines->is_knot == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < lines->count; i++) {
        if (whole) {
            const int span = i / (per + 1), part = i % (per + 1);
            const double a = breaks[span], b = breaks[span + 1], s = (double)part / per;
            const double inner = b - 1e-9 * (b - a); /* its end, seen from within */
            lines->at[i] = part < per         ? fmin(fmax((1 - s) * a + s * b, a), b)
                           : span + 1 < spans ? fmin(fmax(inner, a), b)
                                              : b;
            lines->is_knot[i] = part == 0 && span > 0;
        } else {
            lines->at[i] = breaks[(int)((int64_t)i * spans / cells)];
            lines->is_knot[i] = 0;
        }
    }
    return TAUT_OK;
}

static void fill_row(const double densities[2], size_t count, const double *vectors, size_t first,
                     taut_page_surface *page)
{
    for (size_t j = 0; j < count; j++) {
        const size_t at = first + j;
        taut_forms forms;
        taut_forms_of((const double(*)[3])(vectors + 18 * j), &forms);
        memcpy(page->points + 3 * at, vectors + 18 * j, 3 * sizeof(double));
        memcpy(page->normals + 3 * at, forms.normal, sizeof forms.normal);
        page->fields[TAUT_PAGE_H][at] = forms.regular ? forms.mean : nan("");
        page->fields[TAUT_PAGE_K][at] = forms.regular ? forms.gaussian : nan("");
        page->fields[TAUT_PAGE_I][at] =
            taut_hypot(forms.e - forms.g, 2 * forms.f) / (forms.e + forms.g);
        double stress[2] = {(double)NAN, (double)NAN};
        if (page->has_stress) {
            taut_stress_of(page->surface, densities, &forms, stress);
        }
        page->fields[TAUT_PAGE_WARP][at] = stress[0];
        page->fields[TAUT_PAGE_WEFT][at] = stress[1];
    }
}

static taut_status fill_grid(const taut_model *model, int threads, taut_arena *arena,
                             taut_page_surface *page)
{
    double densities[2] = {0, 0};
    const size_t nv = (size_t)page->v.count, count = (size_t)page->u.count * nv;
    double *vectors = taut_arena_take(arena, nv, 18 * sizeof(double));

    page->has_stress = taut_stress_densities(model, page->surface, densities);
    page->points = taut_arena_take(arena, count, 3 * sizeof(double));
    page->normals = taut_arena_take(arena, count, 3 * sizeof(double));
    for (int k = 0; k < TAUT_PAGE_FIELDS; k++) {
        page->fields[k] = taut_arena_take(arena, count, sizeof(double));
    }
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < page->u.count; i++) {
        const taut_status status = taut_surface_eval_grid(
            page->surface, 1, page->u.at + i, page->v.count, page->v.at, 2, threads, vectors);
        if (status != TAUT_OK) {
            return status;
        }
        fill_row(densities, nv, vectors, (size_t)i * nv, page);
    }
    return TAUT_OK;
}

/* Where the film is how far from least; NaN all over without a witness. */
static taut_status fill_gaps(const taut_record *details, taut_page_surface *page)
{
    const size_t nv = (size_t)page->v.count, count = (size_t)page->u.count * nv;
    taut_dual_density *density = NULL;
    const taut_status status = taut_dual_density_new(page->surface, details, &density);

    page->has_gap = status == TAUT_OK && density != NULL;
    for (size_t at = 0; status == TAUT_OK && at < count; at++) {
        page->fields[TAUT_PAGE_GAP][at] =
            density != NULL
                ? taut_dual_density_at(density, page->u.at[at / nv], page->v.at[at % nv])
                : (double)NAN;
    }
    taut_dual_density_free(density);
    return status;
}

/* Where a flat piece is mounted, and its strain; NaN all over of any other surface. */
static taut_status fill_strain(const taut_model *model, taut_arena *arena, taut_page_surface *page)
{
    const size_t nv = (size_t)page->v.count, count = (size_t)page->u.count * nv;
    taut_mounted piece;
    const taut_status status = taut_mounted_new(model, page->surface, arena, &piece);

    page->mounted = page->mounted_normals = NULL;
    if (status == TAUT_OK && piece.flat != NULL) {
        page->mounted = taut_arena_take(arena, count, 3 * sizeof(double));
        page->mounted_normals = taut_arena_take(arena, count, 3 * sizeof(double));
        if (page->mounted == NULL || page->mounted_normals == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    for (size_t at = 0; status == TAUT_OK && at < count; at++) {
        double *strain = &page->fields[TAUT_PAGE_STRAIN][at];
        *strain = (double)NAN;
        if (page->mounted != NULL) {
            taut_mounted_at(&piece, page->u.at[at / nv], page->v.at[at % nv],
                            page->mounted + 3 * at, page->mounted_normals + 3 * at, strain);
        }
    }
    return status;
}

/* The least step, the same along u and v, that leaves at most `most` points of the net. */
static void thin_net(const taut_surface *surface, int most, int every[2])
{
    const int nu = taut_basis_count(taut_surface_u(surface));
    const int nv = taut_basis_count(taut_surface_v(surface));
    int step = 1;
    while (step < nu + nv && (double)taut_page_kept(nu, step) * taut_page_kept(nv, step) > most) {
        step++;
    }
    every[0] = every[1] = step;
}

static int cells_of(const taut_basis *basis, int most, int divide)
{
    const double asked = (double)divide * taut_basis_span_count(basis);
    return divide > 0 && asked < most ? (int)asked : most;
}

taut_status taut_page_sample(const taut_surface *surface, const taut_model *model, int vertices,
                             int divide, int net, int threads, taut_arena *arena,
                             taut_page_surface *page)
{
    taut_status status = TAUT_OK;
    const int side = (int)sqrt((double)vertices) - 1;
    const int u = cells_of(taut_surface_u(surface), side, divide);
    const int v = cells_of(taut_surface_v(surface), side, divide);

    page->surface = surface;
    thin_net(surface, net, page->every);
    if (fill_lines(taut_surface_u(surface), u, arena, &page->u) != TAUT_OK ||
        fill_lines(taut_surface_v(surface), v, arena, &page->v) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    status = fill_grid(model, threads, arena, page);
    if (status == TAUT_OK) {
        status = fill_gaps(taut_model_details(model), page);
    }
    return status == TAUT_OK ? fill_strain(model, arena, page) : status;
}

int taut_page_kept(int count, int every)
{
    return (count - 2 + every) / every + 1;
}

int taut_page_kept_at(int count, int every, int i)
{
    return i * every < count - 1 ? i * every : count - 1;
}

static int16_t to_short(double x)
{
    return (int16_t)lround(32767 * fmin(fmax(x, -1), 1));
}

int16_t taut_page_value(double value, double limit)
{
    if (isnan(value)) {
        return INT16_MIN;
    }
    return fabs(value) > limit ? (int16_t)(value > 0 ? 32767 : -32767)
                               : (int16_t)lround(32766 * (value / limit));
}

void taut_page_normal(const double normal[3], int16_t packed[2])
{
    const double sum = fabs(normal[0]) + fabs(normal[1]) + fabs(normal[2]);
    double a = normal[0] / sum, b = normal[1] / sum;
    if (!(sum > 0)) {
        packed[0] = packed[1] = INT16_MIN;
        return;
    }
    if (normal[2] < 0) {
        const double folded = (1 - fabs(b)) * (a < 0 ? -1 : 1);
        b = (1 - fabs(a)) * (b < 0 ? -1 : 1);
        a = folded;
    }
    packed[0] = to_short(a);
    packed[1] = to_short(b);
}

void taut_page_point(const taut_camera *box, const double point[3], int16_t packed[3])
{
    double p[3];
    taut_camera_normalise(box, point, p);
    for (int c = 0; c < 3; c++) {
        packed[c] = isfinite(p[c]) ? to_short(p[c]) : (int16_t)0;
    }
}
