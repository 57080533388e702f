/* test_measure.c -- measuring when memory runs out. */
#include "calls.h"
#include "check.h"
#include "fault.h"
#include "shapes.h"

#include "taut/measure.h"

static const taut_measure_options few = {.grid = 5, .threads = 2};

static taut_status measure_surface(const void *context, void **result, taut_error *error)
{
    taut_surface_measure measure = {.area = -1};
    const taut_status status = taut_measure_surface(context, &few, &measure, error);
    (void)result;
    CHECK((status == TAUT_OK) == (measure.area >= 0), "the measure is untouched on failure");
    return status;
}

static taut_status measure_curve(const void *context, void **result, taut_error *error)
{
    taut_curve_measure measure = {.length = -1};
    const taut_status status = taut_measure_curve(context, &few, &measure, error);
    (void)result;
    CHECK((status == TAUT_OK) == (measure.length >= 0), "the measure is untouched on failure");
    return status;
}

/* The integrals alone: one of the three by its number. */
typedef struct integral {
    const taut_surface *surface;
    taut_status (*of)(const taut_surface *surface, double *value);
} integral;

static taut_status area(const taut_surface *surface, double *value)
{
    return taut_surface_area(surface, value, NULL);
}

static taut_status integrate(const void *context, void **result, taut_error *error)
{
    const integral *i = context;
    double value = -1;
    const taut_status status = i->of(i->surface, &value);
    (void)result;
    (void)error;
    CHECK((status == TAUT_OK) == (value >= 0), "the value is untouched on failure");
    return status;
}

static taut_status record_surface(const void *context, void **result, taut_error *error)
{
    static const taut_surface_measure measure = {.area = 1};
    taut_record *record = taut_record_new();
    (void)error;
    taut_measure_surface_record(context, &measure, record);
    if (taut_record_status(record) != TAUT_OK) {
        taut_record_free(record);
        return TAUT_NO_MEMORY;
    }
    *result = record;
    return TAUT_OK;
}

static taut_status forms_grid(const void *context, void **result, taut_error *error)
{
    static const double at[3] = {0, 0.5, 1};
    taut_forms forms[9] = {{.e = -1}};
    const taut_status status = taut_surface_forms_grid(context, 3, at, 3, at, 2, forms);
    (void)result;
    (void)error;
    CHECK((status == TAUT_OK) == (forms[0].e >= 0), "the forms are untouched on failure");
    return status;
}

int main(void)
{
    static const double points[4][3] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 1, 1}};
    taut_surface *surface = NULL;
    taut_surface *planar = NULL;
    taut_curve *curve = NULL;

    random_seed(20260112);
    surface = shape_saddle(0.5);
    planar = shape_saddle(0);
    curve = shape_curve(shape_bezier(3, 0, 1), &points[0][0], NULL);
    const integral integrals[] = {{surface, area},
                                  {surface, taut_surface_dirichlet_energy},
                                  {surface, taut_surface_bending_energy},
                                  {surface, taut_surface_isothermality}};
    const fault_call calls[] = {
        {"taut_measure_surface", measure_surface, NULL, surface},
        {"a planar surface", measure_surface, NULL, planar},
        {"taut_surface_forms_grid", forms_grid, NULL, surface},
        {"taut_measure_curve", measure_curve, NULL, curve},
        {"taut_surface_area", integrate, NULL, &integrals[0]},
        {"taut_surface_dirichlet_energy", integrate, NULL, &integrals[1]},
        {"taut_surface_bending_energy", integrate, NULL, &integrals[2]},
        {"taut_surface_isothermality", integrate, NULL, &integrals[3]},
        {"taut_measure_surface_record", record_surface, release_record, surface},
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        fault_loop(&calls[i]);
    }
    taut_surface_free(surface);
    taut_surface_free(planar);
    taut_curve_free(curve);
    CHECK(fault_live() == 0, "%ld blocks left", fault_live());
    return check_failures != 0;
}
