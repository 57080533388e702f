/* test_run_forged.c -- which surfaces and curves a run of pipes is: their names in the order of
 * flow, and their bases. A straight pipe that is a spline is none, nor a blend that is a cylinder,
 * whatever shape they have. And a joint that gapes is not forgotten beside one that does not. */
#include "certificates.h"
#include "check.h"
#include "edit.h"
#include "pipe_runs.h"

#include <stdlib.h>
#include <string.h>

typedef struct change {
    const char *what;
    void (*apply)(edit_model *edit);
    const char *claim;
    taut_verdict expected;
} change;

static void keep(edit_model *edit)
{
    (void)edit;
}

/* The names stay where they are, the shapes go. */
static void swap_shapes(edit_model *edit)
{
    const edit_surface first = edit->surface[0];
    edit->surface[0] = edit->surface[1];
    edit->surface[1] = first;
    edit->surface[1].name = edit->surface[0].name;
    edit->surface[0].name = first.name;
}

/* Degree 2 along a straight surface: the same shape. */
static void raise(edit_model *edit, edit_surface *s)
{
    double *points = pool_take(edit->pool, (size_t)s->nv * 9 * sizeof *points);
    double *weights = pool_take(edit->pool, (size_t)s->nv * 3 * sizeof *weights);
    for (int j = 0; j < 9 * s->nv; j++) {
        const int row = j / (3 * s->nv), at = j % (3 * s->nv);
        points[j] = 0.5 * ((2 - row) * s->points[at] + row * s->points[3 * s->nv + at]);
        weights[j / 3] = s->weights[at / 3];
    }
    s->points = points;
    s->weights = weights;
    s->nu = 3;
    s->u.degree = 2;
}

static void raise_straight(edit_model *edit)
{
    raise(edit, &edit->surface[0]);
}

static void raise_cap(edit_model *edit)
{
    raise(edit, &edit->surface[edit->surfaces - 1]);
}

static void rename_all(edit_model *edit, int at, const char *name, const char *axis)
{
    edit->surface[at].name = name;
    edit->curve[at].name = axis;
}

static void skip_number(edit_model *edit)
{
    rename_all(edit, 2, "pipe7", "axis-pipe7");
}

static void lengthen_name(edit_model *edit)
{
    rename_all(edit, 0, "pipe1 ", "axis-pipe1 ");
}

static void bend_axis(edit_model *edit)
{
    edit_curve *c = &edit->curve[0];
    double *points = pool_take(edit->pool, 9 * sizeof *points);
    for (int k = 0; k < 9; k++) {
        points[k] = 0.5 * ((2 - k / 3) * c->points[k % 3] + k / 3 * c->points[3 + k % 3]);
    }
    c->points = points;
    c->n = 3;
    c->t.degree = 2;
}

/* Two points of a straight pipe change places from one ring to the other: ways that lead back, of
 * which the rounding was taken to be infinite, and so the gap to be nothing beside it. */
static void swap_ends(edit_model *edit)
{
    edit_surface *s = &edit->surface[2];
    for (int k = 0; k < 3; k++) {
        double *first = s->points + 3 * 6 + k, *last = s->points + 3 * (s->nv + 2) + k;
        const double kept = *first;
        *first = *last;
        *last = kept;
    }
}

/* The last straight pipe a little aside. */
static void move_last(edit_model *edit)
{
    edit_surface *s = &edit->surface[edit->surfaces - 3];
    for (int i = 0; i < s->nu * s->nv; i++) {
        s->points[3 * i] += 1e-9;
    }
}

static const change changes[] = {
    {"as it was made", keep, "identity", TAUT_TRUE},
    {"shapes swapped", swap_shapes, "identity", TAUT_FALSE},
    {"a straight pipe of degree 2", raise_straight, "identity", TAUT_FALSE},
    {"a cap of degree 2", raise_cap, "identity", TAUT_FALSE},
    {"a number left out", skip_number, "identity", TAUT_FALSE},
    {"a name with a blank", lengthen_name, "identity", TAUT_FALSE},
    {"a straight axis of degree 2", bend_axis, "identity", TAUT_FALSE},
    {"as it was made", keep, "joints", TAUT_TRUE},
    {"points swapped", swap_ends, "joints", TAUT_FALSE},
    {"a pipe moved", move_last, "joints", TAUT_FALSE},
};

static void test_changes(taut_pipe_joint joint)
{
    taut_pipe_run_problem problem = pipe_run_of_corners(pipe_stair, 4);
    forge_pool pool = {malloc((size_t)1 << 20), (size_t)1 << 20, 0};
    static edit_model edit;
    problem.joint = joint;
    problem.bend_radius = 0.4;
    problem.caps = 1;
    taut_model *model = pipe_run_made(&problem, 1e-3);
    for (size_t i = 0; i < sizeof changes / sizeof changes[0] && model != NULL; i++) {
        pool.used = 0;
        edit_open(model, "pipe", &pool, &edit);
        changes[i].apply(&edit);
        taut_model *other = edit_close(&edit);
        CHECK(other != NULL &&
                  pipe_run_verdict(other, &problem, changes[i].claim) == changes[i].expected,
              "%s: %s", changes[i].what, changes[i].claim);
        taut_model_free(other);
    }
    taut_model_free(model);
    free(pool.bytes);
}

/* A quintic axis is not that of equal normals, nor the other way round; a run is no blend. */
static void test_problems(void)
{
    taut_pipe_run_problem problem = pipe_run_of_corners(pipe_stair, 4);
    taut_pipe_problem single = {.axis = {.kind = TAUT_PIPE_POLYGON,
                                         .polygon = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 3, 5}}},
                                .section = {.radius = 0.2}};
    problem.bend_radius = 0.4;
    for (int k = 0; k < 2; k++) {
        taut_certificate *certificate = NULL;
        problem.joint = k == 0 ? TAUT_PIPE_G1 : TAUT_PIPE_G2;
        taut_model *model = pipe_run_made(&problem, 1e-3);
        CHECK(taut_pipe_certify(model, &single, NULL, &certificate, NULL) == TAUT_OK, "a run");
        CHECK(claim_of(certificate, "identity")->holds == TAUT_FALSE, "a run is no blend");
        problem.joint = k == 0 ? TAUT_PIPE_G2 : TAUT_PIPE_G1;
        CHECK(pipe_run_verdict(model, &problem, "identity") == TAUT_FALSE, "another axis");
        taut_certificate_free(certificate);
        taut_model_free(model);
    }
}

int main(void)
{
    test_changes(TAUT_PIPE_G1);
    test_changes(TAUT_PIPE_G2);
    test_problems();
    return check_failures != 0;
}
