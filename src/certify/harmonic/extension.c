/* extension.c -- is this the harmonic neighbour? Claims:
 *
 *   harmonic    each surface over its own rectangle (claims.h). The merged surface is harmonic over
 *               the union of the two, and not over the unit square as the source's corollary has it:
 *               figure merged_square_residual is the largest control point of its Laplacian there
 *               ([NiWang2015] section 2.7).
 *   boundary    the given surface is there as it was: largest distance of its points over its size.
 *   continuity  on the shared edge: gap over size, and the difference of the derivatives across
 *               over the largest (contact c1), or the largest sine between the normals (g1). Limit:
 *               8 2^-53 (n + m) times the size of the nets over that of the derivatives, what
 *               rounding the points leaves in a derivative.
 */
#include "taut/harmonic.h"

#include "certify/certify_ops.h"
#include "certify/harmonic/claims.h"
#include "certify/harmonic/residual.h"
#include "core/constants.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "taut/measure.h"

#include <math.h>
#include <string.h>

enum { SAMPLES = 65 };

/* |a x b| / (|a| |b|); 0 where one vanishes */
static double sine(const double *a, const double *b)
{
    const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
    const double size = taut_length(a) * taut_length(b);
    return size > 0 ? taut_length(c) / size : 0;
}

/* The point of an edge at share s of its length in parameters. */
static void edge_point(const taut_surface *surface, taut_edge edge, double s, double x[3][3])
{
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const int along_v = edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1;
    const int high = edge == TAUT_EDGE_U1 || edge == TAUT_EDGE_V1;
    const taut_basis *along = along_v ? v : u, *across = along_v ? u : v;
    const double t = s >= 1
                         ? taut_basis_hi(along)
                         : taut_basis_lo(along) + s * (taut_basis_hi(along) - taut_basis_lo(along));
    const double held = high ? taut_basis_hi(across) : taut_basis_lo(across);
    (void)taut_surface_eval(surface, along_v ? held : t, along_v ? t : held, 1, &x[0][0]);
}

static double largest_coordinate(const taut_surface *surface)
{
    const size_t count = 3 * (size_t)taut_basis_count(taut_surface_u(surface)) *
                         (size_t)taut_basis_count(taut_surface_v(surface));
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        most = fmax(most, fabs(taut_surface_points(surface)[i]));
    }
    return most;
}

static taut_edge opposite(taut_edge edge)
{
    static const taut_edge others[] = {TAUT_EDGE_U1, TAUT_EDGE_U0, TAUT_EDGE_V1, TAUT_EDGE_V0};
    return others[edge];
}

static taut_status add_continuity(const taut_model *model, taut_edge edge, int g1,
                                  taut_certificate *certificate)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    const int across = edge == TAUT_EDGE_U0 || edge == TAUT_EDGE_U1 ? 1 : 2;
    const taut_basis *basis = across == 1 ? taut_surface_u(q) : taut_surface_v(q);
    const int degrees = taut_basis_degree(taut_surface_u(q)) + taut_basis_degree(taut_surface_v(q));
    const double size = fmax(largest_coordinate(p), largest_coordinate(q));
    double gap = 0, slope = 0, apart = 0, angle = 0, least = INFINITY;

    for (int k = 0; k < SAMPLES; k++) {
        double a[3][3], b[3][3];
        taut_forms fa, fb;
        double second[2][6][3] = {{{0}}};
        edge_point(p, edge, k / (SAMPLES - 1.0), a);
        edge_point(q, opposite(edge), k / (SAMPLES - 1.0), b);
        memcpy(second[0], a, sizeof a);
        memcpy(second[1], b, sizeof b);
        taut_forms_of((const double(*)[3])second[0], &fa);
        taut_forms_of((const double(*)[3])second[1], &fb);
        gap = fmax(gap, taut_length_between(a[0], b[0]));
        slope = fmax(slope, fmax(taut_length(a[across]), taut_length(b[across])));
        apart = fmax(apart, taut_length_between(a[across], b[across]));
        if (fa.regular && fb.regular) {
            angle = fmax(angle, sine(fa.normal, fb.normal));
            least = fmin(least, fmin(fa.w / fmax(fa.e, fa.g), fb.w / fmax(fb.e, fb.g)));
        }
    }
    const double width = taut_basis_hi(basis) - taut_basis_lo(basis);
    const double derivative =
        taut_basis_degree(basis) * size / width; /* that rounding applies to */
    const double limit = 8 * degrees * TAUT_UNIT_ROUNDOFF *
                         (slope > 0 ? fmax(1, derivative / slope) : 1) /
                         (g1 && least < 1 ? fmax(least, TAUT_UNIT_ROUNDOFF) : 1);
    const double jump = g1 ? angle : slope > 0 ? apart / slope : 0;
    return taut_harmonic_add_claim("continuity", fmax(size > 0 ? gap / size : 0, jump), limit,
                                   g1 ? "tangent planes" : "derivatives across", certificate);
}

static taut_status add_boundary(const taut_model *model, const taut_surface *given,
                                taut_certificate *certificate)
{
    const taut_surface *found = taut_model_surface(model, 0);
    const int same = taut_basis_equal(taut_surface_u(found), taut_surface_u(given)) &&
                     taut_basis_equal(taut_surface_v(found), taut_surface_v(given));
    const size_t count = 3 * (size_t)taut_basis_count(taut_surface_u(given)) *
                         (size_t)taut_basis_count(taut_surface_v(given));
    const double size = largest_coordinate(given);
    double most = same ? 0 : 1;
    for (size_t i = 0; same && i < count; i++) {
        most = fmax(most, fabs(taut_surface_points(found)[i] - taut_surface_points(given)[i]));
    }
    return taut_harmonic_add_claim("boundary", size > 0 && same ? most / size : most, 0,
                                   most > 0 ? "/surfaces/0" : "", certificate);
}

/* The edge the problem names, or without it the one where the first two surfaces' ranges meet. */
static taut_edge edge_of(const taut_model *model, const taut_harmonic_extension_problem *problem)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    return problem != NULL ? problem->edge : taut_certify_shared_edge(p, q);
}

/* (1 + 2 h)^n, h the ratio of the widths: what the points' rounding grows to when they are carried
 * on. */
static double growth_of(const taut_model *model)
{
    const taut_surface *p = taut_model_surface(model, 0), *q = taut_model_surface(model, 1);
    const int along_v = taut_basis_equal(taut_surface_u(p), taut_surface_u(q));
    const taut_basis *old = along_v ? taut_surface_v(p) : taut_surface_u(p);
    const taut_basis *beyond = along_v ? taut_surface_v(q) : taut_surface_u(q);
    const double h =
        (taut_basis_hi(beyond) - taut_basis_lo(beyond)) / (taut_basis_hi(old) - taut_basis_lo(old));
    return pow(1 + 2 * h, taut_basis_degree(old));
}

static taut_status add_figures(const taut_model *model, taut_certificate *certificate)
{
    taut_record *figures = taut_record_new();
    const taut_status status = taut_harmonic_add_figures(model, figures);

    if (taut_model_surface_count(model) > 2) {
        taut_record_add_number(figures, "merged_square_residual",
                               taut_harmonic_residual_of(taut_model_surface(model, 2), 1).largest);
        taut_record_add_text(figures, "merged_remark",
                             "h is harmonic over its own rectangle, not over the unit square");
    }
    taut_certificate_set_figures(certificate, figures);
    return status == TAUT_OK ? taut_record_status(figures) : status;
}

static taut_status add_all(const taut_model *model, const taut_harmonic_extension_problem *problem,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    const int g1 =
        problem != NULL ? problem->given == TAUT_EXTENSION_G1 : taut_model_surface_count(model) < 3;
    taut_status status = taut_harmonic_add_harmonic(model, options->exact,
                                                    g1 ? 0 : growth_of(model), certificate, error);

    if (status == TAUT_OK && problem != NULL) {
        status = add_boundary(model, problem->surface, certificate);
    }
    if (status != TAUT_OK) {
        return status;
    }
    status = add_continuity(model, edge_of(model, problem), g1, certificate);
    return status == TAUT_OK ? add_figures(model, certificate) : status;
}

static taut_status certify(const taut_model *model, const void *data,
                           const taut_certify_options *options, taut_certificate *certificate,
                           taut_error *error)
{
    taut_status status = taut_harmonic_check_model(model, 2, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = add_all(model, data, options, certificate, error);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

const taut_certify_ops taut_certify_harmonic_extension = {.certify = certify, .exact = 1};
