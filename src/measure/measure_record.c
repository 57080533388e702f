/* measure_record.c -- the documents of `taut measure --json`. A NaN is written as null. */
#include "taut/measure.h"
#include "taut/recognise.h"

static void add_box(const double box[2][3], taut_record *record)
{
    taut_record *list = taut_record_add_list(record, "bounding_box");
    for (int side = 0; side < 2; side++) {
        taut_record_add_numbers(list, NULL, 3, box[side]);
    }
}

static void add_edges(const taut_edge_measure edges[4], taut_record *record)
{
    static const char *const names[4] = {"u0", "u1", "v0", "v1"};
    taut_record *all = taut_record_add_object(record, "edges");
    for (int i = 0; i < 4; i++) {
        taut_record *edge = taut_record_add_object(all, names[i]);
        taut_record_add_number(edge, "length", edges[i].length);
        taut_record_add_number(edge, "max_abs_normal_curvature", edges[i].max_abs_normal_curvature);
        taut_record_add_number(edge, "max_angle_normal_binormal",
                               edges[i].max_angle_normal_binormal);
    }
}

/* An integral, and where it is not good to 1e-10 how far it may be off. */
static void add_integral(taut_record *record, const char *name, double value,
                         const char *error_name, double error)
{
    taut_record_add_number(record, name, value);
    if (!(error <= 0)) {
        taut_record_add_number(record, error_name, error);
    }
}

/* Planar surfaces only: one_sign is true, false or null, and then why. */
static void add_jacobian(const taut_jacobian *jacobian, taut_record *record)
{
    taut_record *child = NULL;
    if (jacobian->state == TAUT_JACOBIAN_NONE) {
        return;
    }
    child = taut_record_add_object(record, "jacobian");
    if (jacobian->state == TAUT_JACOBIAN_ONE_SIGN || jacobian->state == TAUT_JACOBIAN_FOLDS) {
        taut_record_add_bool(child, "one_sign", jacobian->state == TAUT_JACOBIAN_ONE_SIGN);
    } else {
        taut_record_add_null(child, "one_sign");
        taut_record_add_text(child, "reason",
                             jacobian->state == TAUT_JACOBIAN_UNDECIDED
                                 ? "too near to zero to tell"
                                 : "only for polynomial surfaces without weights");
    }
    if (jacobian->state != TAUT_JACOBIAN_UNSUPPORTED) {
        taut_record_add_number(child, "sign", jacobian->sign);
        taut_record_add_number(child, "lowest", jacobian->lowest);
        taut_record_add_numbers(child, "lowest_at", 2, jacobian->at);
    }
}

/* Which of the minimal surfaces with planar curvature lines, or their associates, this is, if any.
 */
static void add_family(const taut_surface *surface, taut_record *record)
{
    taut_family_member member;
    if (taut_surface_recognise(surface, &member, NULL) == TAUT_OK) {
        taut_record *family = taut_record_add_object(record, "minimal_family");
        taut_record_add_text(family, "surface", member.name);
        taut_record_add_number(family, "scale", member.scale);
        taut_record_add_number(family, "lambda", member.lambda);
        taut_record_add_number(family, "theta", member.theta);
        taut_record_add_number(family, "residual", member.residual);
    }
}

void taut_measure_surface_record(const taut_surface *surface, const taut_surface_measure *measure,
                                 taut_record *record)
{
    taut_record *child = NULL;

    taut_record_add_text(record, "name", taut_surface_name(surface));
    add_integral(record, "area", measure->area, "area_error", measure->area_error);
    add_integral(record, "dirichlet_energy", measure->dirichlet_energy, "dirichlet_energy_error",
                 measure->dirichlet_energy_error);
    add_integral(record, "bending_energy", measure->bending_energy, "bending_energy_error",
                 measure->bending_energy_error);
    add_box(measure->box, record);
    child = taut_record_add_object(record, "mean_curvature");
    taut_record_add_number(child, "max_abs", measure->max_abs_mean);
    taut_record_add_numbers(child, "max_abs_at", 2, measure->max_abs_mean_at);
    taut_record_add_number(child, "mean_abs", measure->mean_abs_mean);
    child = taut_record_add_object(record, "gaussian_curvature");
    taut_record_add_number(child, "min", measure->min_gaussian);
    taut_record_add_number(child, "max", measure->max_gaussian);
    child = taut_record_add_object(record, "isothermality");
    taut_record_add_number(child, "max_e_minus_g", measure->max_e_minus_g);
    taut_record_add_number(child, "max_f", measure->max_f);
    add_integral(child, "integral", measure->isothermality, "integral_error",
                 measure->isothermality_error);
    child = taut_record_add_object(record, "harmonicity");
    taut_record_add_number(child, "max_abs_laplacian", measure->max_laplacian);
    add_edges(measure->edges, record);
    add_family(surface, record);
    taut_record_add_number(record, "singular_points", (double)measure->singular_points);
    add_jacobian(&measure->jacobian, record);
}

void taut_measure_curve_record(const taut_curve *curve, const taut_curve_measure *measure,
                               taut_record *record)
{
    taut_record_add_text(record, "name", taut_curve_name(curve));
    taut_record_add_number(record, "length", measure->length);
    taut_record_add_number(record, "max_curvature", measure->max_curvature);
    taut_record_add_number(record, "max_torsion", measure->max_torsion);
}
