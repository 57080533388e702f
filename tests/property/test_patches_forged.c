/* test_patches_forged.c -- films of many patches that were changed as a whole: patches and copies left out, there twice, in each
 * other's place, turned over, mirrored; seams that part; cables; another problem's film. With the problem at hand none of them
 * holds, and without it a film of many patches is refused, as nothing says how it was held. */
#include "attack.h"
#include "check.h"
#include "edit.h"

#include "taut/certify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PATCH(name, a, b, c, d)                                                                    \
    "{\"name\":\"" name "\",\"u\":{\"type\":\"bspline\",\"degree\":4,\"count\":8},\"v\":{"         \
    "\"type\":\"bspline\",\"degree\":4,\"count\":8},\"corners\":{\"u0v0\":" a ",\"u1v0\":" b       \
    ",\"u0v1\":" c ",\"u1v1\":" d "}}"
#define SADDLE(height)                                                                             \
    "{\"taut\":1,\"construct\":\"film\",\"patches\":[" PATCH(                                      \
        "a", "[0,0,0.5]", "[1,0,0]", "[0,2,-0.5]",                                                 \
        "[1,2,0]") "," PATCH("b", "[1,0,0]", "[2,0,-0.5]", "[1,2,0]",                              \
                             "[2,2," height "]") "],\"seams\":[[\"a.u1\",\"b.u0\"]]}"

static forge_pool pool;
static edit_model edit;

static double *point_of(edit_surface *s, int i, int j)
{
    return s->points + 3 * (i * s->nv + j);
}

static void swap_points(double *a, double *b)
{
    double kept[3];
    memcpy(kept, a, sizeof kept);
    memcpy(a, b, sizeof kept);
    memcpy(b, kept, sizeof kept);
}

static void reverse(edit_surface *s, int both)
{
    for (int i = 0; i < (both ? s->nu / 2 : s->nu); i++) {
        for (int j = 0; j < (both ? s->nv : s->nv / 2); j++) {
            swap_points(point_of(s, i, j),
                        both ? point_of(s, s->nu - 1 - i, j) : point_of(s, i, s->nv - 1 - j));
        }
    }
}

/* ---- ways to forge surface k; `other` another one, as large. 0: there is nothing to do ---- */

typedef int (*way)(int k, int other);

static int is_dropped(int k, int other)
{
    (void)other;
    edit.surfaces--;
    memmove(edit.surface + k, edit.surface + k + 1,
            (size_t)(edit.surfaces - k) * sizeof *edit.surface);
    return edit.surfaces > 0;
}

static int is_twice(int k, int other)
{
    (void)other;
    edit.surface[edit.surfaces++] = edit.surface[k];
    return 1;
}

static int is_twice_renamed(int k, int other)
{
    (void)is_twice(k, other);
    edit.surface[edit.surfaces - 1].name = "copy";
    return 1;
}

static int is_run_backwards_in_u(int k, int other)
{
    (void)other;
    reverse(&edit.surface[k], 1);
    return 1;
}

static int is_run_backwards_in_v(int k, int other)
{
    (void)other;
    reverse(&edit.surface[k], 0);
    return 1;
}

static int is_transposed(int k, int other)
{
    edit_surface *s = &edit.surface[k];
    (void)other;
    for (int i = 0; i < s->nu && s->nu == s->nv; i++) {
        for (int j = 0; j < i; j++) {
            swap_points(point_of(s, i, j), point_of(s, j, i));
        }
    }
    return s->nu == s->nv;
}

static int is_mirrored(int k, int axis)
{
    edit_surface *s = &edit.surface[k];
    for (int p = 0; p < s->nu * s->nv; p++) {
        s->points[3 * p + axis] = -s->points[3 * p + axis];
    }
    return 1;
}

static int is_mirrored_x(int k, int other)
{
    (void)other;
    return is_mirrored(k, 0);
}

static int is_mirrored_y(int k, int other)
{
    (void)other;
    return is_mirrored(k, 1);
}

static int is_mirrored_z(int k, int other)
{
    (void)other;
    return is_mirrored(k, 2);
}

static int is_the_other(int k, int other)
{
    edit_surface *s = &edit.surface[k];
    memcpy(s->points, edit.surface[other].points, 3 * (size_t)(s->nu * s->nv) * sizeof *s->points);
    return 1;
}

static int has_its_place(int k, int other)
{
    double *points = edit.surface[k].points;
    edit.surface[k].points = edit.surface[other].points;
    edit.surface[other].points = points;
    return 1;
}

static int has_its_name(int k, int other)
{
    const char *name = edit.surface[k].name;
    edit.surface[k].name = edit.surface[other].name;
    edit.surface[other].name = name;
    return 1;
}

static int is_shifted(int k, int other)
{
    edit_surface *s = &edit.surface[k];
    (void)other;
    for (int n = 0; n < 3 * s->nu * s->nv; n++) {
        s->points[n] += 1e-7;
    }
    return 1;
}

static int has_another_middle(int k, int other)
{
    edit_surface *s = &edit.surface[k];
    (void)other;
    for (int c = 0; c < 3; c++) {
        point_of(s, s->nu / 2, s->nv / 2)[c] += 1e-5;
    }
    return 1;
}

/* A point on an edge that another surface has too goes off it: of a patch by one rounding, of a copy by more than it may be off. */
static int has_parted(int k, int other)
{
    edit_surface *s = &edit.surface[k];
    const edit_surface *o = &edit.surface[other];
    for (int p = 0; p < s->nu * s->nv; p++) {
        for (int q = 0; q < o->nu * o->nv; q++) {
            if (memcmp(s->points + 3 * p, o->points + 3 * q, 3 * sizeof(double)) == 0) {
                s->points[3 * p] = strchr(s->name, '\'') != NULL
                                       ? s->points[3 * p] + 1e-9
                                       : nextafter(s->points[3 * p], INFINITY);
                return 1;
            }
        }
    }
    return 0;
}

static int has_no_cable(int k, int other)
{
    (void)other;
    if (k >= edit.curves) {
        return 0;
    }
    edit.curve[k] = edit.curve[--edit.curves];
    return 1;
}

static int has_a_cable_twice(int k, int other)
{
    (void)other;
    if (k >= edit.curves) {
        return 0;
    }
    edit.curve[edit.curves++] = edit.curve[k];
    return 1;
}

static int has_a_cable_backwards(int k, int other)
{
    (void)other;
    for (int i = 0; k < edit.curves && i < edit.curve[k].n / 2; i++) {
        swap_points(edit.curve[k].points + 3 * i,
                    edit.curve[k].points + 3 * (edit.curve[k].n - 1 - i));
    }
    return k < edit.curves;
}

static const struct {
    const char *name;
    way apply;
} ways[] = {
    {"left out", is_dropped},
    {"twice", is_twice},
    {"twice, by another name", is_twice_renamed},
    {"run backwards in u", is_run_backwards_in_u},
    {"run backwards in v", is_run_backwards_in_v},
    {"u and v exchanged", is_transposed},
    {"mirrored in x", is_mirrored_x},
    {"mirrored in y", is_mirrored_y},
    {"mirrored in z", is_mirrored_z},
    {"in the other's place too", is_the_other},
    {"in the other's place, and that in its", has_its_place},
    {"named as the other, and that as it", has_its_name},
    {"shifted", is_shifted},
    {"with another point inside", has_another_middle},
    {"parted from the other", has_parted},
    {"without a cable", has_no_cable},
    {"with a cable twice", has_a_cable_twice},
    {"with a cable backwards", has_a_cable_backwards},
};

/* ---- ---- */

static taut_verdict verdict_of(const taut_model *model, const taut_problem *problem,
                               taut_error *error)
{
    taut_certificate *certificate = NULL;
    taut_verdict holds = TAUT_FALSE; /* refused */
    if (taut_certify(model, problem, NULL, &certificate, error) == TAUT_OK) {
        holds = taut_certificate_holds(certificate);
    }
    taut_certificate_free(certificate);
    return holds;
}

static void check_alone(const taut_model *model, const char *name)
{
    taut_error error = {.status = TAUT_OK};
    CHECK(verdict_of(model, NULL, &error) == TAUT_FALSE && error.status == TAUT_BAD_INPUT,
          "%s, without the problem: %s", name, error.message);
}

/* Every way of each `step`th surface, the next one being the other; the ways that went. */
static int forge_all(const subject *s, const char *name, int step)
{
    const int count = taut_model_surface_count(s->model);
    int forged = 0;
    for (int k = 0; k < count; k += step) {
        for (size_t w = 0; w < sizeof ways / sizeof ways[0]; w++) {
            pool.used = 0;
            edit_open(s->model, "film", &pool, &edit);
            const int goes = ways[w].apply(k, (k + 1) % count);
            taut_model *model = edit_close(&edit);
            CHECK(model != NULL || !goes || ways[w].apply == is_twice ||
                      ways[w].apply == has_a_cable_twice,
                  "%s: %s", name, ways[w].name);
            if (model != NULL && goes) {
                CHECK(verdict_of(model, s->problem, NULL) == TAUT_FALSE, "%s: surface %d %s", name,
                      k, ways[w].name);
                check_alone(model, name);
                forged++;
            }
            taut_model_free(model);
        }
    }
    return forged;
}

/* As it was made, and with its surfaces in another order, it holds. */
static void check_as_made(const subject *s, const char *name)
{
    pool.used = 0;
    edit_open(s->model, "film", &pool, &edit);
    for (int k = 0; k < edit.surfaces / 2; k++) {
        const edit_surface kept = edit.surface[k];
        edit.surface[k] = edit.surface[edit.surfaces - 1 - k];
        edit.surface[edit.surfaces - 1 - k] = kept;
    }
    taut_model *model = edit_close(&edit);
    CHECK(verdict_of(s->model, s->problem, NULL) == TAUT_TRUE, "%s as it was made", name);
    CHECK(verdict_of(model, s->problem, NULL) == TAUT_TRUE, "%s in another order", name);
    check_alone(s->model, name);
    taut_model_free(model);
}

/* Films of the same patches, bases and names whose corners differ. */
static void check_others(void)
{
    subject one = subject_of(SADDLE("0.5")), two = subject_of(SADDLE("0.50000001"));
    CHECK(verdict_of(one.model, one.problem, NULL) == TAUT_TRUE, "its own film");
    CHECK(verdict_of(one.model, two.problem, NULL) == TAUT_FALSE, "another problem's film");
    CHECK(verdict_of(two.model, one.problem, NULL) == TAUT_FALSE, "another problem's film");
    check_as_made(&one, "saddle");
    CHECK(forge_all(&one, "saddle", 1) > 20, "the saddle is forged");
    subject_free(&one);
    subject_free(&two);
}

int main(void)
{
    static const struct {
        const char *name;
        int step;
    } examples[] = {{"film-ridge", 1}, {"film-tent", 2}, {"film-bubbles", 7}};

    pool = (forge_pool){malloc((size_t)4 << 20), (size_t)4 << 20, 0};
    check_others();
    for (size_t e = 0; e < sizeof examples / sizeof examples[0]; e++) {
        subject s = subject_example(examples[e].name);
        check_as_made(&s, examples[e].name);
        CHECK(forge_all(&s, examples[e].name, examples[e].step) > 20, "%s is forged",
              examples[e].name);
        subject_free(&s);
    }
    free(pool.bytes);
    return check_failures != 0;
}
