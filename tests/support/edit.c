/* edit.c -- see edit.h. */
#include "edit.h"

#include "taut/read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *pool_take(forge_pool *pool, size_t bytes)
{
    void *at = pool->bytes + pool->used;

    bytes = (bytes + 15) / 16 * 16;
    if (bytes > pool->size - pool->used) {
        fprintf(stderr, "forge: the pool of a forgery is used up\n");
        exit(2);
    }
    pool->used += bytes;
    return at;
}

uint64_t forge_bits(forge_random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double forge_in(forge_random *random, double lo, double hi)
{
    return lo + (hi - lo) * ((double)(forge_bits(random) >> 11) / 9007199254740992.0);
}

int forge_int(forge_random *random, int lo, int hi)
{
    return lo + (int)(forge_bits(random) % (uint64_t)(hi - lo + 1));
}

double forge_log(forge_random *random, double lo, double hi)
{
    return pow(10, forge_in(random, log10(lo), log10(hi)));
}

double forge_sign(forge_random *random)
{
    return forge_bits(random) & 1 ? 1 : -1;
}

static double *copy_numbers(forge_pool *pool, const double *from, int count)
{
    double *to;

    if (from == NULL) {
        return NULL;
    }
    to = pool_take(pool, (size_t)count * sizeof *to);
    memcpy(to, from, (size_t)count * sizeof *to);
    return to;
}

void edit_open(const taut_model *model, const char *construct, forge_pool *pool, edit_model *edit)
{
    memset(edit, 0, sizeof *edit);
    edit->pool = pool;
    edit->construct = construct;
    edit->unit = taut_model_unit(model);
    for (int i = 0; i < taut_model_surface_count(model) && i < EDIT_OBJECTS_MAX; i++) {
        const taut_surface *from = taut_model_surface(model, i);
        edit_surface *to = &edit->surface[edit->surfaces++];
        to->name = taut_surface_name(from);
        to->nu = taut_basis_count(taut_surface_u(from));
        to->nv = taut_basis_count(taut_surface_v(from));
        taut_basis_spec_of(taut_surface_u(from), &to->u);
        taut_basis_spec_of(taut_surface_v(from), &to->v);
        to->points = copy_numbers(pool, taut_surface_points(from), 3 * to->nu * to->nv);
        to->weights = copy_numbers(pool, taut_surface_weights(from), to->nu * to->nv);
    }
    for (int i = 0; i < taut_model_curve_count(model) && i < EDIT_OBJECTS_MAX; i++) {
        const taut_curve *from = taut_model_curve(model, i);
        edit_curve *to = &edit->curve[edit->curves++];
        to->name = taut_curve_name(from);
        to->n = taut_basis_count(taut_curve_t(from));
        taut_basis_spec_of(taut_curve_t(from), &to->t);
        to->points = copy_numbers(pool, taut_curve_points(from), 3 * to->n);
        to->weights = copy_numbers(pool, taut_curve_weights(from), to->n);
    }
    edit->details = taut_record_copy(taut_model_details(model));
}

static taut_basis *basis_of(const taut_basis_spec *spec, int count)
{
    taut_basis *basis = NULL;

    if (taut_basis_new(spec, count, &basis, NULL) != TAUT_OK) {
        return NULL;
    }
    if (taut_basis_count(basis) != count) {
        taut_basis_free(basis);
        return NULL;
    }
    return basis;
}

static int add_surface(taut_model *model, const edit_surface *from)
{
    taut_basis *u = basis_of(&from->u, from->nu), *v = basis_of(&from->v, from->nv);
    taut_surface *surface = NULL;
    int ok = u != NULL && v != NULL &&
             taut_surface_new(from->name, u, v, from->points, from->weights, &surface, NULL) ==
                 TAUT_OK &&
             taut_model_add_surface(model, surface) == TAUT_OK;

    taut_basis_free(u);
    taut_basis_free(v);
    return ok;
}

static int add_curve(taut_model *model, const edit_curve *from)
{
    taut_basis *t = basis_of(&from->t, from->n);
    taut_curve *curve = NULL;
    int ok = t != NULL &&
             taut_curve_new(from->name, t, from->points, from->weights, &curve, NULL) == TAUT_OK &&
             taut_model_add_curve(model, curve) == TAUT_OK;

    taut_basis_free(t);
    return ok;
}

taut_model *edit_close(edit_model *edit)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    int ok = taut_model_new(&model) == TAUT_OK;

    for (int i = 0; ok && i < edit->surfaces; i++) {
        ok = add_surface(model, &edit->surface[i]);
    }
    for (int i = 0; ok && i < edit->curves; i++) {
        ok = add_curve(model, &edit->curve[i]);
    }
    ok = ok && taut_model_set_unit(model, edit->unit) == TAUT_OK;
    if (ok && taut_certificate_new(edit->construct, &certificate) == TAUT_OK) {
        taut_model_set_certificate(model, certificate);
    }
    if (ok) {
        taut_model_set_details(model, edit->details);
    } else {
        taut_record_free(edit->details);
        taut_model_free(model);
        model = NULL;
    }
    edit->details = NULL;
    return model;
}

int base_open(const char *name, const char *text, size_t length, forge_base *base)
{
    memset(base, 0, sizeof *base);
    base->name = name;
    base->text = text;
    base->length = length;
    if (taut_problem_read_text(text, length, name, &base->problem, NULL) != TAUT_OK ||
        taut_record_read_text(text, length, name, &base->document, NULL) != TAUT_OK ||
        taut_make(base->problem, NULL, &base->model, NULL) != TAUT_OK) {
        base_close(base);
        return 0;
    }
    base->construct = taut_problem_construction(base->problem);
    return 1;
}

void base_close(forge_base *base)
{
    taut_problem_free(base->problem);
    taut_record_free(base->document);
    taut_model_free(base->model);
    memset(base, 0, sizeof *base);
}
