/* kinds.c -- the ways to forge a model. Each changes one thing, by random numbers of all sizes; two
 * may follow each other. */
#include "kinds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static edit_surface *any_surface(edit_model *edit, forge_random *random)
{
    return edit->surfaces > 0 ? &edit->surface[forge_int(random, 0, edit->surfaces - 1)] : NULL;
}

static edit_curve *any_curve(edit_model *edit, forge_random *random)
{
    return edit->curves > 0 ? &edit->curve[forge_int(random, 0, edit->curves - 1)] : NULL;
}

static double size_of(const double *points, int count)
{
    double size = 0;

    for (int i = 0; i < 3 * count; i++) {
        size = fmax(size, fabs(points[i]));
    }
    return size > 0 ? size : 1;
}

static void move_point(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const double by = forge_log(random, 1e-15, 1e3) * size_of(s->points, s->nu * s->nv);
    const int one = forge_int(random, 0, s->nu * s->nv - 1), axis = forge_int(random, 0, 3);
    for (int k = 0; k < 3; k++) {
        s->points[3 * one + k] += axis == 3 ? by * forge_in(random, -1, 1) : k == axis ? by : 0;
    }
}

/* Towards a neighbour: nearly within the surface. */
static void slide_point(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL || s->nu * s->nv < 2) {
        return;
    }
    const int n = s->nu * s->nv, step = forge_bits(random) & 1 ? 1 : s->nv;
    const int one = forge_int(random, 0, n - 1), next = (one + step) % n;
    const double by = forge_log(random, 1e-15, 10) * forge_sign(random);
    for (int k = 0; k < 3; k++) {
        s->points[3 * one + k] += by * (s->points[3 * next + k] - s->points[3 * one + k]);
    }
}

static void move_all(edit_model *edit, const forge_base *base, const forge_base *other,
                     forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const double by = forge_log(random, 1e-15, 1e3) * size_of(s->points, s->nu * s->nv);
    for (int i = 0; i < 3 * s->nu * s->nv; i++) {
        s->points[i] += by * forge_in(random, -1, 1);
    }
}

/* All of an object's inner points, leaving the boundary. */
static void move_inner(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const int rim = forge_int(random, 1, 2);
    const double by = forge_log(random, 1e-12, 1e2) * size_of(s->points, s->nu * s->nv);
    for (int i = rim; i < s->nu - rim; i++) {
        for (int j = rim; j < s->nv - rim; j++) {
            for (int k = 0; k < 3; k++) {
                s->points[3 * (i * s->nv + j) + k] += by * forge_in(random, -1, 1);
            }
        }
    }
}

static void swap_points(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const int a = forge_int(random, 0, s->nu * s->nv - 1),
              b = forge_int(random, 0, s->nu * s->nv - 1);
    for (int k = 0; k < 3; k++) {
        const double t = s->points[3 * a + k];
        s->points[3 * a + k] = s->points[3 * b + k];
        s->points[3 * b + k] = t;
    }
}

/* A ring or a row longer: straight pipes with other lengths. */
static void move_row(edit_model *edit, const forge_base *base, const forge_base *other,
                     forge_random *random)
{
    edit_surface *s = any_surface(edit, random);
    double d[3];

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const int last = forge_bits(random) & 1, row = last ? s->nu - 1 : 0;
    const int next = last ? s->nu - 2 : 1;
    const double by = forge_log(random, 1e-12, 1e3) * forge_sign(random);
    for (int k = 0; k < 3; k++) {
        d[k] = by * (s->points[3 * row * s->nv + k] - s->points[3 * next * s->nv + k]);
    }
    for (int j = 0; j < s->nv; j++) {
        for (int k = 0; k < 3; k++) {
            s->points[3 * (row * s->nv + j) + k] += d[k];
        }
    }
}

static void swap_surfaces(edit_model *edit, const forge_base *base, const forge_base *other,
                          forge_random *random)
{
    edit_surface *a = any_surface(edit, random), *b = any_surface(edit, random);
    edit_surface t;

    (void)base;
    (void)other;
    if (a == NULL) {
        return;
    }
    t = *a;
    *a = *b;
    *b = t;
    if (forge_bits(random) & 1) { /* shapes only, names stay */
        const char *name = a->name;
        a->name = b->name;
        b->name = name;
    }
}

static void turn_points(edit_surface *s, forge_pool *pool, int flip_u, int flip_v)
{
    const int n = s->nu * s->nv;
    double *points = pool_take(pool, (size_t)n * 3 * sizeof *points);

    for (int i = 0; i < s->nu; i++) {
        for (int j = 0; j < s->nv; j++) {
            const int from = (flip_u ? s->nu - 1 - i : i) * s->nv + (flip_v ? s->nv - 1 - j : j);
            memcpy(points + 3 * (i * s->nv + j), s->points + 3 * from, 3 * sizeof *points);
        }
    }
    s->points = points;
}

static void reverse_surface(edit_model *edit, const forge_base *base, const forge_base *other,
                            forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s != NULL) {
        turn_points(s, edit->pool, forge_int(random, 0, 1), forge_int(random, 0, 1));
    }
}

static void need_weights(edit_model *edit, edit_surface *s)
{
    if (s->weights == NULL) {
        s->weights = pool_take(edit->pool, (size_t)(s->nu * s->nv) * sizeof *s->weights);
        for (int i = 0; i < s->nu * s->nv; i++) {
            s->weights[i] = 1;
        }
    }
}

static void mobius(edit_model *edit, const forge_base *base, const forge_base *other,
                   forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    const double c = forge_log(random, 1e-3, 1e3), d = forge_log(random, 1e-3, 1e3);
    need_weights(edit, s);
    for (int i = 0; i < s->nu; i++) {
        for (int j = 0; j < s->nv; j++) {
            s->weights[i * s->nv + j] *= pow(c, i) * pow(d, j);
        }
    }
    for (int e = 0; e < edit->curves; e++) { /* its edges alike */
        edit_curve *t = &edit->curve[e];
        const int along_u = t->name[0] == 'v';
        if (t->weights != NULL && strlen(t->name) == 2) {
            for (int i = 0; i < t->n; i++) {
                t->weights[i] *= pow(along_u ? c : d, i);
            }
        }
    }
}

static void change_weights(edit_model *edit, const forge_base *base, const forge_base *other,
                           forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    need_weights(edit, s);
    if (forge_bits(random) & 1) {
        s->weights[forge_int(random, 0, s->nu * s->nv - 1)] *= forge_log(random, 1e-4, 1e4);
        return;
    }
    const double most = forge_log(random, 1.0001, 1e3);
    for (int i = 0; i < s->nu * s->nv; i++) {
        s->weights[i] *= forge_log(random, 1 / most, most);
    }
}

static void change_knots(edit_model *edit, const forge_base *base, const forge_base *other,
                         forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL) {
        return;
    }
    taut_basis_spec *spec = forge_bits(random) & 1 ? &s->u : &s->v;
    if (spec->knots != NULL) {
        double *knots = pool_take(edit->pool, (size_t)spec->knot_count * sizeof *knots);
        const double by = forge_log(random, 1e-15, 1) * forge_sign(random);
        const int one = forge_int(random, 0, spec->knot_count - 1);
        memcpy(knots, spec->knots, (size_t)spec->knot_count * sizeof *knots);
        if (forge_bits(random) & 1) {
            for (int i = 0; i < spec->knot_count; i++) {
                knots[i] = knots[i] * (1 + by) + by;
            }
        } else {
            knots[one] += by * (knots[spec->knot_count - 1] - knots[0]);
        }
        spec->knots = knots;
    } else if (spec->alpha > 0 || spec->beta > 0) {
        const double by = 1 + forge_log(random, 1e-15, 0.5) * forge_sign(random);
        spec->alpha *= by;
        spec->beta *= by;
        spec->has_range = 0;
    } else {
        const double by = forge_log(random, 1e-15, 10);
        spec->range[0] = spec->has_range ? spec->range[0] : 0;
        spec->range[1] = (spec->has_range ? spec->range[1] : 1) * (1 + by);
        spec->has_range = 1;
    }
}

/* Degree raised by one in u, a bezier net only: the same surface. */
static void raise_degree(edit_model *edit, const forge_base *base, const forge_base *other,
                         forge_random *random)
{
    edit_surface *s = any_surface(edit, random);

    (void)base;
    (void)other;
    if (s == NULL || strcmp(s->u.type, "bezier") != 0 || s->weights != NULL) {
        return;
    }
    const int n = s->nu;
    double *points = pool_take(edit->pool, (size_t)(n + 1) * (size_t)s->nv * 3 * sizeof *points);
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j < 3 * s->nv; j++) {
            const double f = (double)i / n;
            points[3 * s->nv * i + j] = (i > 0 ? f * s->points[3 * s->nv * (i - 1) + j] : 0) +
                                        (i < n ? (1 - f) * s->points[3 * s->nv * i + j] : 0);
        }
    }
    s->points = points;
    s->nu++;
    s->u.degree++;
}

static void scale_by(edit_model *edit, double by, const double offset[3])
{
    for (int i = 0; i < edit->surfaces; i++) {
        edit_surface *s = &edit->surface[i];
        for (int k = 0; k < 3 * s->nu * s->nv; k++) {
            s->points[k] = s->points[k] * by + offset[k % 3];
        }
    }
    for (int i = 0; i < edit->curves; i++) {
        edit_curve *c = &edit->curve[i];
        for (int k = 0; k < 3 * c->n; k++) {
            c->points[k] = c->points[k] * by + offset[k % 3];
        }
    }
}

static void change_size(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    static const double here[3] = {0, 0, 0};

    (void)base;
    (void)other;
    scale_by(edit, ldexp(1, forge_int(random, -996, 996)), here);
}

static void change_place(edit_model *edit, const forge_base *base, const forge_base *other,
                         forge_random *random)
{
    const double far = forge_log(random, 1e-9, 1e12);
    double offset[3];

    (void)base;
    (void)other;
    for (int k = 0; k < 3; k++) {
        offset[k] = far * forge_in(random, -1, 1);
    }
    scale_by(edit, 1, offset);
}

static void turn_all(edit_model *edit, const forge_base *base, const forge_base *other,
                     forge_random *random)
{
    const double a = forge_in(random, -4, 4), c = cos(a), s = sin(a);

    (void)base;
    (void)other;
    for (int i = 0; i < edit->surfaces + edit->curves; i++) {
        const int curve = i >= edit->surfaces;
        double *p = curve ? edit->curve[i - edit->surfaces].points : edit->surface[i].points;
        const int n =
            curve ? edit->curve[i - edit->surfaces].n : edit->surface[i].nu * edit->surface[i].nv;
        for (int k = 0; k < n; k++) {
            const double x = p[3 * k], y = p[3 * k + 1];
            p[3 * k] = c * x - s * y;
            p[3 * k + 1] = s * x + c * y;
        }
    }
}

/* The model of another problem of the same construction. */
static void other_model(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    (void)base;
    (void)random;
    taut_record_free(edit->details);
    edit_open(other->model, edit->construct, edit->pool, edit);
}

static void change_unit(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    static const char *const units[] = {"m", "cm", "in", "ft"};

    (void)base;
    (void)other;
    edit->unit = units[forge_int(random, 0, 3)];
}

/* ---- details ---- */

static int leaves_of(const taut_record *record)
{
    int count = 1;

    for (size_t i = 0; i < taut_record_count(record); i++) {
        count += leaves_of(taut_record_at(record, i));
    }
    return count;
}

typedef struct detail_lie {
    int at, target, how;
    double number;
    const char *word;
} detail_lie;

static void copy_members(const taut_record *from, taut_record *to, detail_lie *lie);

static void copy_item(const taut_record *from, taut_record *to, const char *key, detail_lie *lie)
{
    const taut_record_kind kind = taut_record_kind_of(from);

    if (lie->at++ == lie->target) {
        if (lie->how == 0) {
            taut_record_add_null(to, key);
        } else if (lie->how == 1) {
            taut_record_add_text(to, key, lie->word);
        } else if (lie->how == 2) {
            taut_record_add_number(to, key, lie->number);
        } else if (lie->how == 3) {
            taut_record_add_number(to, key, lie->number * taut_record_number(from));
        } else if (lie->how == 4) {
            taut_record_add_list(to, key);
        } /* 5: left out */
        return;
    }
    if (kind == TAUT_RECORD_NUMBER) {
        taut_record_add_number(to, key, taut_record_number(from));
    } else if (kind == TAUT_RECORD_TEXT) {
        taut_record_add_text(to, key, taut_record_text(from));
    } else if (kind == TAUT_RECORD_BOOL) {
        taut_record_add_bool(to, key, taut_record_bool(from));
    } else if (kind == TAUT_RECORD_LIST) {
        copy_members(from, taut_record_add_list(to, key), lie);
    } else if (kind == TAUT_RECORD_OBJECT) {
        copy_members(from, taut_record_add_object(to, key), lie);
    } else {
        taut_record_add_null(to, key);
    }
}

static void copy_members(const taut_record *from, taut_record *to, detail_lie *lie)
{
    const int list = taut_record_kind_of(from) == TAUT_RECORD_LIST;

    for (size_t i = 0; i < taut_record_count(from); i++) {
        copy_item(taut_record_at(from, i), to, list ? NULL : taut_record_key(from, i), lie);
    }
}

static const char *const words[] = {"all",   "corner", "boundary", "pattern",    "project",
                                    "raise", "none",   "c1",       "c2",         "g1",
                                    "g2",    "normal", "full",     "canal",      "NaN",
                                    "",      "auto",   "strict",   "naive-sweep"};

static void lie_in_details(edit_model *edit, const forge_base *base, const forge_base *other,
                           forge_random *random)
{
    taut_record *details = taut_record_new();
    detail_lie lie = {.how = forge_int(random, 0, 5)};

    (void)base;
    (void)other;
    lie.target = forge_int(random, 0, leaves_of(edit->details));
    lie.number = forge_log(random, 1e-9, 1e9) * forge_sign(random);
    lie.word = words[forge_int(random, 0, (int)(sizeof words / sizeof words[0]) - 1)];
    copy_members(edit->details, details, &lie);
    taut_record_free(edit->details);
    edit->details = details;
}

/* A member that means something to somebody. */
static void add_details(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    static const char *const names[] = {"known",   "repair", "contact", "method", "frame",
                                        "surface", "domain", "joint",   "aspect"};
    static const char *const numbers[] = {"aspect",    "deviation", "tolerance", "radius",
                                          "amplitude", "lambda",    "residual",  "bend_radius"};

    (void)base;
    (void)other;
    if (edit->details == NULL) {
        edit->details = taut_record_new();
    }
    const char *word = words[forge_int(random, 0, (int)(sizeof words / sizeof words[0]) - 1)];
    if (forge_bits(random) & 1) {
        const char *name = names[forge_int(random, 0, 8)];
        if (strcmp(name, "repair") == 0) {
            taut_record *repair = taut_record_add_object(edit->details, name);
            taut_record_add_text(repair, "kind", word);
            taut_record_add_number(repair, "change", forge_log(random, 1e-9, 1e3));
        } else {
            taut_record_add_text(edit->details, name, word);
        }
    } else {
        taut_record_add_number(edit->details, numbers[forge_int(random, 0, 7)],
                               forge_log(random, 1e-9, 1e9));
    }
}

static void add_object(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    static const char *const names[] = {"extra", "", "blend", "axis", "u0"};

    (void)base;
    (void)other;
    if (edit->surfaces == 0 || edit->surfaces >= EDIT_OBJECTS_MAX ||
        edit->curves >= EDIT_OBJECTS_MAX) {
        return;
    }
    const char *name = names[forge_int(random, 0, 4)];
    if (edit->curves > 0 && forge_int(random, 0, 2) == 0) {
        edit->curve[edit->curves] = edit->curve[forge_int(random, 0, edit->curves - 1)];
        if (forge_bits(random) & 1) {
            edit->curve[edit->curves].name = name;
        }
        edit->curves++;
        return;
    }
    edit_surface copy = edit->surface[forge_int(random, 0, edit->surfaces - 1)];
    if (forge_bits(random) & 1) {
        copy.name = name;
    }
    if (forge_bits(random) & 1) {
        turn_points(&copy, edit->pool, 1, 0);
        copy.points[0] += size_of(copy.points, copy.nu * copy.nv);
    }
    if (forge_bits(random) & 1) { /* before all others */
        memmove(edit->surface + 1, edit->surface, (size_t)edit->surfaces * sizeof copy);
        edit->surface[0] = copy;
    } else {
        edit->surface[edit->surfaces] = copy;
    }
    edit->surfaces++;
}

static void drop_object(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    (void)base;
    (void)other;
    if (edit->curves > 0 && forge_bits(random) & 1) {
        const int i = forge_int(random, 0, edit->curves - 1);
        edit->curve[i] = edit->curve[--edit->curves];
    } else if (edit->surfaces > 1) {
        const int i = forge_int(random, 0, edit->surfaces - 1);
        memmove(edit->surface + i, edit->surface + i + 1,
                (size_t)(edit->surfaces - 1 - i) * sizeof edit->surface[0]);
        edit->surfaces--;
    }
}

static void change_name(edit_model *edit, const forge_base *base, const forge_base *other,
                        forge_random *random)
{
    edit_surface *s = any_surface(edit, random);
    edit_curve *c = any_curve(edit, random);

    (void)base;
    (void)other;
    if (c != NULL && forge_bits(random) & 1) {
        c->name = forge_bits(random) & 1 ? "other" : any_curve(edit, random)->name;
    } else if (s != NULL) {
        s->name = forge_bits(random) & 1 ? "other" : any_surface(edit, random)->name;
    }
}

static void change_construct(edit_model *edit, const forge_base *base, const forge_base *other,
                             forge_random *random)
{
    (void)base;
    (void)other;
    edit->construct = taut_construct_name(forge_int(random, 0, taut_construct_count() - 1));
}

static void move_curve(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    edit_curve *c = any_curve(edit, random);

    (void)base;
    (void)other;
    if (c == NULL) {
        return;
    }
    const double by = forge_log(random, 1e-15, 1e3) * size_of(c->points, c->n);
    const int one = forge_int(random, 0, c->n - 1);
    for (int k = 0; k < 3; k++) {
        c->points[3 * one + k] += by * forge_in(random, -1, 1);
    }
}

static void turn_curve(edit_model *edit, const forge_base *base, const forge_base *other,
                       forge_random *random)
{
    edit_curve *c = any_curve(edit, random);

    (void)base;
    (void)other;
    if (c == NULL) {
        return;
    }
    for (int i = 0; 2 * i < c->n - 1; i++) {
        for (int k = 0; k < 3; k++) {
            const double t = c->points[3 * i + k];
            c->points[3 * i + k] = c->points[3 * (c->n - 1 - i) + k];
            c->points[3 * (c->n - 1 - i) + k] = t;
        }
    }
}

/* A part of a surface: half of a bspline's columns with their knots. */
static void cut_off(edit_model *edit, const forge_base *base, const forge_base *other,
                    forge_random *random)
{
    (void)base;
    (void)other;
    (void)random;
    for (int i = 0; i < edit->surfaces; i++) {
        edit_surface *s = &edit->surface[i];
        if (s->v.knots == NULL || s->v.degree != 2 || s->nv != 9 || s->weights == NULL) {
            continue;
        }
        double *knots = pool_take(edit->pool, 8 * sizeof *knots);
        double *points = pool_take(edit->pool, (size_t)s->nu * 15 * sizeof *points);
        double *weights = pool_take(edit->pool, (size_t)s->nu * 5 * sizeof *weights);
        memcpy(knots, s->v.knots, 7 * sizeof *knots);
        knots[7] = knots[6];
        for (int r = 0; r < s->nu; r++) {
            memcpy(points + 15 * r, s->points + 27 * r, 15 * sizeof *points);
            memcpy(weights + 5 * r, s->weights + 9 * r, 5 * sizeof *weights);
        }
        knots[5] = knots[6] = knots[7] = s->v.knots[6];
        s->v.knots = knots;
        s->v.knot_count = 8;
        s->nv = 5;
        s->points = points;
        s->weights = weights;
    }
}

static void nothing(edit_model *edit, const forge_base *base, const forge_base *other,
                    forge_random *random)
{
    (void)edit;
    (void)base;
    (void)other;
    (void)random;
}

const forge_kind forge_kinds[] = {
    {"none", nothing},
    {"point moved", move_point},
    {"point slid", slide_point},
    {"all points moved", move_all},
    {"inner points moved", move_inner},
    {"points swapped", swap_points},
    {"row moved", move_row},
    {"surfaces swapped", swap_surfaces},
    {"surface reversed", reverse_surface},
    {"other parameters", mobius},
    {"weights", change_weights},
    {"knots, ranges, shapes", change_knots},
    {"degree raised", raise_degree},
    {"size 2^-996..2^996", change_size},
    {"far away", change_place},
    {"turned", turn_all},
    {"other model", other_model},
    {"unit", change_unit},
    {"details changed", lie_in_details},
    {"details added", add_details},
    {"object added", add_object},
    {"object dropped", drop_object},
    {"names", change_name},
    {"other construction", change_construct},
    {"curve moved", move_curve},
    {"curve reversed", turn_curve},
    {"cut in half", cut_off},
    {"a part", forge_part},
    {"u and v exchanged", forge_transposed},
    {"mirrored", forge_mirrored},
    {"scaled 1e-300..1e300", forge_scaled},
    {"curve's parameters", forge_curve_parameters},
    {"run backwards", forge_backwards},
    {"weights 1e-8..1e8", forge_far_weights},
    {"witness", forge_witness},
};
const int forge_kind_count = (int)(sizeof forge_kinds / sizeof forge_kinds[0]);
