/* geomdl.c -- writing the format `geomdl.json`: the exchange JSON of NURBS-Python (geomdl).
 *
 *     { "shape": { "type": "surface", "count": n, "data": [
 *         { "type": "spline", "rational": r, "dimension": 3,
 *           "degree_u": p, "degree_v": q, "knotvector_u": [...], "knotvector_v": [...],
 *           "size_u": m, "size_v": n,
 *           "control_points": { "points": [[x,y,z], ...], "weights": [...] } } ] } }
 *
 * Points run with v fastest, as here. A file holds surfaces or curves, not both: the curves of a
 * model with surfaces stay out. Members that only geomdl understands (delta, trims, id) are not
 * read. */
#include "core/fail.h"
#include "io/cad/format_nurbs.h"
#include "io/format.h"
#include "io/json/out.h"
#include "taut/operations.h"

static const double default_tolerance = 1e-6;
static const double delta = 0.02; /* how finely geomdl is to evaluate */

/* "degree_u", "knotvector_u", "size_u": with u, v, or for curves nothing. */
static void put_direction(taut_json_out *out, const taut_basis *basis, const char *const keys[3])
{
    taut_basis_spec spec;
    taut_basis_spec_of(basis, &spec);
    taut_json_pair_number(out, keys[0], spec.degree);
    taut_json_pair_numbers(out, keys[1], (size_t)spec.knot_count, spec.knots);
    if (keys[2] != NULL) {
        taut_json_pair_number(out, keys[2], taut_basis_count(basis));
    }
}

static void put_head(taut_json_out *out, const char *name, int is_rational)
{
    taut_json_open(out, '{');
    taut_json_pair_text(out, "type", "spline");
    taut_json_pair_text(out, "name", name);
    taut_json_pair_verdict(out, "rational", is_rational ? TAUT_TRUE : TAUT_FALSE);
    taut_json_pair_number(out, "dimension", 3);
}

/* All points in one list, and their weights. */
static void put_points(taut_json_out *out, size_t count, const double *points,
                       const double *weights)
{
    taut_json_open_pair(out, "control_points", '{');
    taut_json_pair_net(out, "points", 0, count, 3, points);
    if (weights != NULL) {
        taut_json_pair_net(out, "weights", 0, count, 1, weights);
    }
    taut_json_close(out, '}');
}

static void put_surface(taut_json_out *out, const taut_surface *surface)
{
    static const char *const of_u[] = {"degree_u", "knotvector_u", "size_u"};
    static const char *const of_v[] = {"degree_v", "knotvector_v", "size_v"};
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    put_head(out, taut_surface_name(surface), taut_surface_weights(surface) != NULL);
    put_direction(out, u, of_u);
    put_direction(out, v, of_v);
    put_points(out, (size_t)taut_basis_count(u) * (size_t)taut_basis_count(v),
               taut_surface_points(surface), taut_surface_weights(surface));
    taut_json_pair_numbers(out, "delta", 2, (const double[]){delta, delta});
    taut_json_close(out, '}');
}

static void put_curve(taut_json_out *out, const taut_curve *curve)
{
    static const char *const keys[] = {"degree", "knotvector", NULL};
    const taut_basis *t = taut_curve_t(curve);
    put_head(out, taut_curve_name(curve), taut_curve_weights(curve) != NULL);
    put_direction(out, t, keys);
    put_points(out, (size_t)taut_basis_count(t), taut_curve_points(curve),
               taut_curve_weights(curve));
    taut_json_pair_number(out, "delta", delta);
    taut_json_close(out, '}');
}

static taut_status write_nurbs(const taut_model *nurbs, const taut_monitor *monitor, FILE *file,
                               taut_error *error)
{
    const int surfaces = taut_model_surface_count(nurbs), curves = taut_model_curve_count(nurbs);
    taut_json_out out = taut_json_out_to(file);
    taut_status status = TAUT_OK;

    taut_sink_watch(&out.sink, monitor);
    taut_json_open(&out, '{');
    taut_json_open_pair(&out, "shape", '{');
    taut_json_pair_text(&out, "type", surfaces > 0 ? "surface" : "curve");
    taut_json_pair_number(&out, "count", surfaces > 0 ? surfaces : curves);
    taut_json_open_pair(&out, "data", '[');
    for (int i = 0; i < surfaces; i++) {
        put_surface(&out, taut_model_surface(nurbs, i));
    }
    for (int i = 0; surfaces == 0 && i < curves; i++) {
        put_curve(&out, taut_model_curve(nurbs, i));
    }
    taut_json_close(&out, ']');
    taut_json_close(&out, '}');
    taut_json_close(&out, '}');
    status = taut_json_out_finish(&out);
    return status == TAUT_NO_MEMORY ? taut_fail_memory(error) : status;
}

static taut_status write_geomdl(const taut_model *model, const taut_write_options *options,
                                FILE *out, taut_error *error)
{
    const double tolerance = options->tolerance > 0 ? options->tolerance : default_tolerance;
    taut_model *nurbs = NULL;
    double bound = 0;
    taut_status status = taut_format_nurbs(model, options, tolerance, &nurbs, &bound, error);

    if (status != TAUT_OK) {
        return status;
    }
    status = write_nurbs(nurbs, &options->monitor, out, error);
    taut_model_free(nurbs);
    if (status == TAUT_OK && options->bound != NULL) {
        *options->bound = bound;
    }
    return status;
}

const taut_format_ops taut_format_geomdl = {.write = write_geomdl};
