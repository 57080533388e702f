#include "certify/common/identity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a model holds of one kind. */
typedef struct shelf {
    const char *kind; /* "surfaces" or "curves" */
    int count;
    const char *(*name)(const taut_model *model, int i);
    unsigned char *seen;
} shelf;

static const char *surface_name(const taut_model *model, int i)
{
    return taut_surface_name(taut_model_surface(model, i));
}

static const char *curve_name(const taut_model *model, int i)
{
    return taut_curve_name(taut_model_curve(model, i));
}

static void find_shelves(const taut_identity *identity, shelf shelves[2])
{
    const taut_model *model = identity->model;
    shelves[0] =
        (shelf){"surfaces", taut_model_surface_count(model), surface_name, identity->surfaces};
    shelves[1] = (shelf){"curves", taut_model_curve_count(model), curve_name, identity->curves};
}

static void differs(taut_identity *identity, const char *place, const char *what)
{
    if (identity->differences++ == 0) {
        snprintf(identity->where, sizeof identity->where, "%.60s: %.90s", place, what);
    }
}

taut_status taut_identity_begin(taut_arena *arena, const taut_model *model, int with_problem,
                                taut_identity *identity)
{
    const size_t surfaces = (size_t)taut_model_surface_count(model);
    const size_t curves = (size_t)taut_model_curve_count(model);
    *identity = (taut_identity){.model = model, .with_problem = with_problem};
    identity->surfaces = taut_arena_take(arena, surfaces + 1, 1);
    identity->curves = taut_arena_take(arena, curves + 1, 1);
    identity->names = taut_arena_take(arena, surfaces + curves + 1, sizeof *identity->names);
    return taut_arena_status(arena);
}

static int find(const taut_identity *identity, int k, const char *name)
{
    shelf shelves[2];
    find_shelves(identity, shelves);
    for (int i = 0; i < shelves[k].count; i++) {
        if (strcmp(shelves[k].name(identity->model, i), name) == 0) {
            return i;
        }
    }
    return -1;
}

int taut_identity_find_surface(const taut_identity *identity, const char *name)
{
    return find(identity, 0, name);
}

int taut_identity_find_curve(const taut_identity *identity, const char *name)
{
    return find(identity, 1, name);
}

/* Are all knots of `coarse` among those of `fine`, as often at least? */
static int has_knots(const taut_basis *fine, const taut_basis *coarse)
{
    taut_basis_spec f, c;
    int at = 0;
    taut_basis_spec_of(fine, &f);
    taut_basis_spec_of(coarse, &c);
    for (int k = 0; k < c.knot_count; k++) {
        while (at < f.knot_count && f.knots[at] != c.knots[k]) {
            at++;
        }
        if (at++ >= f.knot_count) {
            return 0;
        }
    }
    return 1;
}

static int is_spline(const taut_basis *basis)
{
    return strcmp(taut_basis_type(basis), "bspline") == 0;
}

/* Is it `coarse` with knots inserted? A bezier basis becomes a bspline by that. */
static int is_refined(const taut_basis *found, const taut_basis *coarse)
{
    if (taut_basis_equal(found, coarse)) {
        return 1;
    }
    return is_spline(found) && taut_basis_degree(coarse) == taut_basis_degree(found) &&
           taut_basis_lo(found) == taut_basis_lo(coarse) &&
           taut_basis_hi(found) == taut_basis_hi(coarse) &&
           (!is_spline(coarse) || has_knots(found, coarse));
}

static const char *difference_of(const taut_basis *found, const taut_expected_basis *expected)
{
    const int degree = taut_basis_degree(found);
    if (expected->same != NULL && !taut_basis_equal(found, expected->same)) {
        return "not the basis of the problem";
    }
    if (expected->refined != NULL && !is_refined(found, expected->refined)) {
        return "not the basis of the problem with knots inserted";
    }
    if (expected->type != NULL && strcmp(taut_basis_type(found), expected->type) != 0) {
        return "a basis of another type";
    }
    if (expected->degree[1] > 0 && (degree < expected->degree[0] || degree > expected->degree[1])) {
        return "of another degree";
    }
    if (expected->spans > 0 && taut_basis_span_count(found) != expected->spans) {
        return "another number of spans";
    }
    if (expected->range != NULL && (taut_basis_lo(found) != expected->range[0] ||
                                    taut_basis_hi(found) != expected->range[1])) {
        return "over another range";
    }
    return NULL;
}

static void compare_basis(taut_identity *identity, int k, int index, const char *member,
                          const taut_basis *found, const taut_expected_basis *expected)
{
    char place[64];
    const char *what = expected != NULL ? difference_of(found, expected) : NULL;
    if (what != NULL) {
        snprintf(place, sizeof place, "/%s/%d/%s", k == 0 ? "surfaces" : "curves", index, member);
        differs(identity, place, what);
    }
}

/* Notes the object; 0: it is not there. */
static int take(taut_identity *identity, int k, int index, const char *name)
{
    shelf shelves[2];
    char text[64];
    find_shelves(identity, shelves);
    if (index < 0 || index >= shelves[k].count) {
        snprintf(text, sizeof text, "\"%.40s\" is missing", name != NULL ? name : "");
        differs(identity, k == 0 ? "/surfaces" : "/curves", text);
        return 0;
    }
    shelves[k].seen[index] = 1;
    if (identity->with_problem && name != NULL &&
        strcmp(shelves[k].name(identity->model, index), name) != 0) {
        char place[64];
        snprintf(place, sizeof place, "/%s/%d/name", shelves[k].kind, index);
        snprintf(text, sizeof text, "not \"%.40s\"", name);
        differs(identity, place, text);
    }
    return identity->with_problem;
}

void taut_identity_surface(taut_identity *identity, int index, const char *name,
                           const taut_expected_basis *u, const taut_expected_basis *v)
{
    if (take(identity, 0, index, name)) {
        const taut_surface *surface = taut_model_surface(identity->model, index);
        compare_basis(identity, 0, index, "u", taut_surface_u(surface), u);
        compare_basis(identity, 0, index, "v", taut_surface_v(surface), v);
    }
}

void taut_identity_curve(taut_identity *identity, int index, const char *name,
                         const taut_expected_basis *t)
{
    if (take(identity, 1, index, name)) {
        compare_basis(identity, 1, index, "t",
                      taut_curve_t(taut_model_curve(identity->model, index)), t);
    }
}

static int compare_names(const void *a, const void *b)
{
    const taut_identity_name *x = a, *y = b;
    const int order = strcmp(x->name, y->name);
    return order != 0 ? order : x->index - y->index;
}

/* Counts names that stand twice. */
static void count_twins(taut_identity *identity, int k)
{
    shelf shelves[2];
    char place[64];
    find_shelves(identity, shelves);
    for (int i = 0; i < shelves[k].count; i++) {
        identity->names[i] = (taut_identity_name){shelves[k].name(identity->model, i), i};
    }
    qsort(identity->names, (size_t)shelves[k].count, sizeof *identity->names, compare_names);
    for (int i = 1; i < shelves[k].count; i++) {
        if (strcmp(identity->names[i - 1].name, identity->names[i].name) == 0) {
            snprintf(place, sizeof place, "/%s/%d/name", shelves[k].kind, identity->names[i].index);
            differs(identity, place, "a name that is there twice");
        }
    }
}

/* Objects that no claim is about. */
static void count_rest(taut_identity *identity, int k, taut_record *figures)
{
    shelf shelves[2];
    char place[64];
    taut_record *list = NULL;
    find_shelves(identity, shelves);
    for (int i = 0; i < shelves[k].count; i++) {
        if (shelves[k].seen[i]) {
            continue;
        }
        if (identity->with_problem) {
            snprintf(place, sizeof place, "/%s/%d", shelves[k].kind, i);
            differs(identity, place, "nothing of the problem: no claim is about it");
            continue;
        }
        list = (taut_record *)(size_t)taut_record_get(figures, "not_certified");
        if (list == NULL) {
            list = taut_record_add_list(figures, "not_certified");
        }
        taut_record_add_text(list, NULL, shelves[k].name(identity->model, i));
    }
}

taut_status taut_identity_end(taut_identity *identity, const char *unit,
                              taut_certificate *certificate)
{
    taut_record *figures = taut_certificate_figures(certificate) != NULL
                               ? taut_record_copy(taut_certificate_figures(certificate))
                               : taut_record_new();
    taut_claim claim = {.claim = "identity", .kind = TAUT_EXACT, .where = identity->where};

    if (figures == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int k = 0; k < 2; k++) {
        count_twins(identity, k);
        count_rest(identity, k, figures);
    }
    if (unit != NULL && strcmp(taut_model_unit(identity->model), unit) != 0) {
        differs(identity, "/unit", "not the unit of the problem");
    }
    taut_certificate_set_figures(certificate, figures);
    claim.residual = identity->differences;
    claim.holds = identity->differences == 0 ? TAUT_TRUE : TAUT_FALSE;
    return taut_record_status(figures) == TAUT_OK ? taut_certificate_add(certificate, &claim)
                                                  : TAUT_NO_MEMORY;
}
