#include "io/cad/prepare.h"

#include "core/date.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "geometry/exponent.h"
#include "io/cad/format_nurbs.h"
#include "platform/system.h"
#include "taut/version.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { DEGREE_MAX = 25 };
static const double default_tolerance = 1e-6;
static const double precision_of_size = 1e-7; /* what CAD systems take for one point */
static const double least_precision = 1e-290, largest_precision = 1e290;

/* Of SOURCE_DATE_EPOCH where it is set, so that a build gives the same bytes again; else now. */
static void write_date(char text[TAUT_DATE_ROOM])
{
    const char *found = getenv("SOURCE_DATE_EPOCH");
    const int64_t seconds = found != NULL ? strtoll(found, NULL, 10) : taut_system_date();
    taut_date_text(seconds >= 0 && seconds <= TAUT_DATE_MOST ? seconds : 0, text);
}

/* A box of halved coordinates, as a whole one may be twice what a double holds. */
typedef struct box {
    double lo[3], hi[3];
} box;

static void grow_box(box *b, size_t count, const double *points)
{
    for (size_t k = 0; k < 3 * count; k++) {
        b->lo[k % 3] = fmin(b->lo[k % 3], points[k] / 2);
        b->hi[k % 3] = fmax(b->hi[k % 3], points[k] / 2);
    }
}

/* The diagonal of the box around all control points. */
static double size_of(const taut_model *nurbs)
{
    box b = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < taut_model_surface_count(nurbs); i++) {
        const taut_surface *surface = taut_model_surface(nurbs, i);
        grow_box(&b, taut_point_count(surface), taut_surface_points(surface));
    }
    for (int i = 0; i < taut_model_curve_count(nurbs); i++) {
        const taut_curve *curve = taut_model_curve(nurbs, i);
        grow_box(&b, (size_t)taut_basis_count(taut_curve_t(curve)), taut_curve_points(curve));
    }
    return 2 * taut_distance(b.lo, b.hi);
}

static taut_status check_degree(const char *name, const taut_basis *basis, taut_error *error)
{
    const int degree = taut_basis_degree(basis);
    return degree <= DEGREE_MAX
               ? TAUT_OK
               : taut_fail(error, TAUT_NO_SOLUTION, "degree", NULL, degree, DEGREE_MAX,
                           "\"%.100s\" has degree %d, and CAD systems read none above %d", name,
                           degree, DEGREE_MAX);
}

static taut_status check_degrees(const taut_model *nurbs, taut_error *error)
{
    taut_status status = TAUT_OK;
    for (int i = 0; i < taut_model_surface_count(nurbs) && status == TAUT_OK; i++) {
        const taut_surface *surface = taut_model_surface(nurbs, i);
        const char *name = taut_surface_name(surface);
        status = check_degree(name, taut_surface_u(surface), error);
        status = status == TAUT_OK ? check_degree(name, taut_surface_v(surface), error) : status;
    }
    for (int i = 0; i < taut_model_curve_count(nurbs) && status == TAUT_OK; i++) {
        const taut_curve *curve = taut_model_curve(nurbs, i);
        status = check_degree(taut_curve_name(curve), taut_curve_t(curve), error);
    }
    return status;
}

double taut_cad_bound(const taut_cad_facts *facts)
{
    const double bound = facts->bound + (facts->thickness > 0 ? facts->proved : 0);
    return bound < INFINITY ? bound : taut_none;
}

void taut_cad_say_bound(const char *unit, taut_cad_facts *facts)
{
    if (facts->thickness > 0) {
        const int is_proved = facts->proved < INFINITY;
        snprintf(facts->exact, sizeof facts->exact,
                 "sheets of thickness %.6g %s, %s within %.3g %s of both sides", facts->thickness,
                 unit, is_proved ? "proved to lie" : "found",
                 facts->bound + (is_proved ? facts->proved : facts->measured), unit);
    } else if (facts->bound > 0) {
        snprintf(facts->exact, sizeof facts->exact,
                 "proved to lie within %.3g %s of the exact model", facts->bound, unit);
    } else {
        snprintf(facts->exact, sizeof facts->exact, "the exact model");
    }
}

/* What the whole is called: its construction, else the product that it was read from, else its first part, but for an
 * assembly of several. */
static const char *name_of(const taut_model *model, const taut_model *nurbs, int parts)
{
    const taut_certificate *certificate = taut_model_certificate(model);
    const char *product = taut_record_text(taut_record_get(taut_model_details(model), "product"));
    const char *name = certificate != NULL ? taut_certificate_construct(certificate) : "";
    if (name[0] == '\0' && product != NULL) {
        name = product;
    }
    if (name[0] == '\0' && parts > 0) {
        return "assembly";
    }
    if (name[0] == '\0') {
        name = taut_model_surface_count(nurbs) > 0 ? taut_surface_name(taut_model_surface(nurbs, 0))
                                                   : taut_curve_name(taut_model_curve(nurbs, 0));
    }
    return name[0] != '\0' ? name : "taut";
}

static void fill_facts(const taut_model *model, const taut_model *nurbs, taut_cad_facts *facts)
{
    snprintf(facts->name, sizeof facts->name, "%s", name_of(model, nurbs, facts->part_count));
    write_date(facts->date);
    snprintf(facts->made, sizeof facts->made, "NURBS by taut %s", TAUT_VERSION);
    taut_cad_say_bound(taut_model_unit(nurbs), facts);
    facts->precision =
        fmin(largest_precision,
             fmax(fmax(facts->bound, precision_of_size * size_of(nurbs)), least_precision));
}

taut_status taut_cad_prepare(const taut_model *model, const taut_write_options *options,
                             taut_arena *arena, taut_model **nurbs, taut_cad_facts *facts,
                             taut_error *error)
{
    const double tolerance = options->tolerance > 0 ? options->tolerance : default_tolerance;
    taut_model *made = NULL;
    *facts = (taut_cad_facts){.bound = 0};
    taut_status status = taut_format_nurbs(model, options, tolerance, &made, &facts->bound, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = options->thickness > 0 ? taut_cad_make_sheets(options, tolerance * size_of(made),
                                                           arena, &made, facts, error)
                                    : check_degrees(made, error);
    if (status == TAUT_OK) {
        status = taut_cad_keep_looks(model, options, arena, made, facts, error);
    }
    if (status != TAUT_OK) {
        taut_model_free(made);
        return status;
    }
    fill_facts(model, made, facts);
    *nurbs = made;
    return TAUT_OK;
}
