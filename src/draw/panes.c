/* panes.c -- the panes of a figure; the frames of a deformation stand side by side. */
#include "draw/panes.h"

#include "core/fail.h"
#include "draw/label.h"
#include "draw/view.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Are the surfaces of a model the frames of a deformation? So it is when `details.lambda` lists one
 * number for each of several surfaces. */
static const taut_record *lambdas_of(const taut_model *model)
{
    return taut_record_get(taut_model_details(model), "lambda");
}

static int is_deformation(const taut_model *model)
{
    return taut_model_surface_count(model) > 1 && taut_model_curve_count(model) == 0 &&
           taut_record_kind_of(lambdas_of(model)) == TAUT_RECORD_LIST &&
           taut_record_count(lambdas_of(model)) == (size_t)taut_model_surface_count(model);
}

/* "lambda 0.2" for frame i of such a model, in the arena; NULL without memory. */
static const char *frame_label(const taut_model *model, int i, taut_arena *arena)
{
    enum { ROOM = 32 };
    char *label = taut_arena_take(arena, ROOM, 1);
    if (label != NULL) {
        snprintf(label, ROOM, "lambda %.4g",
                 taut_record_number(taut_record_at(lambdas_of(model), (size_t)i)));
    }
    return label;
}

static int shown_of(const taut_model *model, const taut_write_options *options)
{
    const taut_pane all = {.model = model, .surface = -1};
    int shown = 0;
    for (int i = 0; i < taut_model_surface_count(model); i++) {
        shown += taut_pane_shows(&all, options, i);
    }
    return shown;
}

/* Surface after surface of one model, `of` in all. */
static taut_status split_surfaces(const taut_model *model, taut_arena *arena, taut_panes *panes)
{
    const int has_frames = is_deformation(model);
    panes->of = taut_model_surface_count(model);
    panes->count = panes->of < TAUT_PANES_MAX ? panes->of : TAUT_PANES_MAX;
    for (int k = 0; k < panes->count; k++) {
        const int i =
            (int)((int64_t)k * (panes->of - 1) / (panes->count > 1 ? panes->count - 1 : 1));
        panes->pane[k] = (taut_pane){
            .model = model, .surface = i, .label = taut_surface_name(taut_model_surface(model, i))};
        if (has_frames) {
            panes->pane[k].label = frame_label(model, i, arena);
        }
        if (panes->pane[k].label == NULL) {
            return TAUT_NO_MEMORY;
        }
    }
    panes->is_one_size = 1;
    return TAUT_OK;
}

taut_status taut_panes_new(int count, const taut_model *const *models,
                           const taut_write_options *options, taut_arena *arena, taut_panes *panes,
                           taut_error *error)
{
    memset(panes, 0, sizeof *panes);
    for (int i = 0; i < count; i++) {
        if (models[i] == NULL) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                             "a figure needs a model");
        }
        if (options->surface != NULL && shown_of(models[i], options) == 0) {
            return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, 0, 1,
                             "no surface is named \"%s\"", options->surface);
        }
    }
    if (count == 1 && options->surface == NULL &&
        (options->side_by_side || is_deformation(models[0])) &&
        taut_model_surface_count(models[0]) > 1) {
        return split_surfaces(models[0], arena, panes) == TAUT_OK ? TAUT_OK
                                                                  : taut_fail_memory(error);
    }
    panes->count = panes->of = count;
    for (int i = 0; i < count; i++) {
        panes->pane[i] = (taut_pane){.model = models[i], .surface = -1};
        if (count > 1 && options->labels != NULL) {
            panes->pane[i].label = options->labels[i];
        }
    }
    return TAUT_OK;
}

int taut_panes_sheets(const taut_panes *panes, const taut_write_options *options)
{
    int sheets = 0;
    for (int i = 0; i < panes->count; i++) {
        sheets += panes->is_one_size ? 1 : shown_of(panes->pane[i].model, options);
    }
    return sheets;
}

/* Around each pane, and above it for its label. */
static const double beside = 24, above = 52, below = 8;

/* Columns such that a pane of 4 by 3 is largest. */
static int choose_columns(int count, double width, double height)
{
    double best = 0;
    int columns = 1;
    for (int c = 1; c <= count; c++) {
        const double size = fmin(width / c / 4, height / ((count + c - 1) / c) / 3);
        if (size >= best) {
            best = size;
            columns = c;
        }
    }
    return columns;
}

static int rows_of(const taut_panes *panes)
{
    return (panes->count + panes->columns - 1) / panes->columns;
}

/* In rows and columns; room for a label above each of several. */
static void place_panes(taut_panes *panes, const double page[4])
{
    const double width = page[2] - page[0], height = page[3] - page[1];

    if (panes->columns == 0) {
        panes->columns = choose_columns(panes->count, width, height);
    }
    for (int i = 0; i < panes->count; i++) {
        const double w = width / panes->columns, h = height / rows_of(panes);
        const double x = page[0] + i % panes->columns * w, y = page[1] + i / panes->columns * h;
        const double single = panes->count == 1 ? TAUT_PANES_MARGIN : 0;
        const double place[4] = {x + fmax(single, beside), y + (panes->count > 1 ? above : single),
                                 x + w - fmax(single, beside), y + h - fmax(single, below)};
        memcpy(panes->place[i], place, sizeof place);
    }
}

void taut_panes_used(const taut_panes *panes, double size[2])
{
    double most[2] = {0, 0};
    for (int i = 0; i < panes->count; i++) {
        const taut_camera *camera = &panes->pane[i].camera;
        for (int c = 0; c < 2; c++) {
            most[c] = fmax(most[c], camera->scale * (camera->seen[1][c] - camera->seen[0][c]));
        }
    }
    const int single = panes->count == 1;
    size[0] = panes->columns * (most[0] + 2 * (single ? TAUT_PANES_MARGIN : beside));
    size[1] = rows_of(panes) * (most[1] + (single ? 2 * TAUT_PANES_MARGIN : above + below));
}

/* The same teeth mean the same in all panes of one model. */
static void share_combs(taut_panes *panes)
{
    double most = 0, scale = INFINITY;
    for (int i = 0; i < panes->count; i++) {
        const taut_pane *pane = &panes->pane[i];
        most = fmax(most, pane->comb_most);
        scale = pane->comb_scale > 0 ? fmin(scale, pane->comb_scale) : scale;
    }
    for (int i = 0; i < panes->count; i++) {
        taut_pane *pane = &panes->pane[i];
        pane->comb_most = most;
        pane->comb_scale = isfinite(scale) ? scale : 0;
        for (int k = 0; k < pane->sheet_count && pane->combs != NULL; k++) {
            taut_combs_scale(&pane->combs[k], pane->comb_scale);
        }
    }
}

/* Settles a box for each pane, or, at one size, one of all. 0 where one is empty. */
static int settle_boxes(taut_panes *panes, taut_camera *box[])
{
    taut_camera *all = box[0];
    for (int i = 1; i < panes->count && panes->is_one_size; i++) {
        if (box[i]->low[0] <= box[i]->high[0]) {
            taut_camera_include(all, 1, box[i]->low);
            taut_camera_include(all, 1, box[i]->high);
        }
    }
    for (int i = 0; i < panes->count; i++) {
        if (i > 0 && panes->is_one_size) {
            *box[i] = *all;
        } else if (!taut_camera_settle(box[i])) {
            return 0;
        }
    }
    return 1;
}

/* The box of the world: first without nets, to see which of them are far beyond it. */
static int settle_cameras(taut_panes *panes, const taut_write_options *options)
{
    taut_camera *core[TAUT_PANES_MAX], *whole[TAUT_PANES_MAX];
    for (int i = 0; i < panes->count; i++) {
        core[i] = &panes->pane[i].core;
        whole[i] = &panes->pane[i].camera;
        taut_camera_init(core[i]);
        taut_pane_visit_core(&panes->pane[i], core[i], taut_camera_include);
    }
    if (!settle_boxes(panes, core)) {
        return 0;
    }
    for (int i = 0; i < panes->count; i++) {
        *whole[i] = *core[i];
        taut_pane_visit_nets(&panes->pane[i], options, whole[i], taut_camera_include);
    }
    return settle_boxes(panes, whole);
}

int taut_panes_aim(taut_panes *panes, const taut_write_options *options, const double page[4])
{
    double view[2] = {options->view[0], options->view[1]}, most = INFINITY;

    place_panes(panes, page);
    if (panes->is_one_size && options->combs) {
        share_combs(panes);
    }
    if (!settle_cameras(panes, options)) {
        return 0;
    }
    if (!options->has_view) {
        taut_pane *first = &panes->pane[0];
        taut_view_choose(&first->camera, first->sheet_count, first->sheets, view);
    }
    for (int round = 0; round < (panes->is_one_size ? 2 : 1); round++) {
        for (int i = 0; i < panes->count; i++) {
            taut_camera *camera = &panes->pane[i].camera;
            taut_camera_aim(camera, view[0], view[1]);
            taut_pane_visit_core(&panes->pane[i], camera, taut_camera_see);
            taut_pane_visit_nets(&panes->pane[i], options, camera, taut_camera_see);
            if (camera->seen[0][0] > camera->seen[1][0]) { /* a surface of no finite point */
                static const double nothing[3] = {0, 0, 0};
                taut_camera_see(camera, 1, nothing);
            }
            taut_camera_fit_within(camera, panes->place[i], most);
        }
        for (int i = 0; i < panes->count && panes->is_one_size; i++) {
            most = fmin(most, panes->pane[i].camera.scale);
        }
    }
    return 1;
}

/* Adds "; " where something stands already, and the text. */
static void append_note(char *note, size_t size, const char *text)
{
    const size_t used = strlen(note);
    snprintf(note + used, size - used, "%s%s", used > 0 ? "; " : "", text);
}

/* What a certificate that fails, or that nobody proved since it was read, takes from the picture. */
static const char *blame_certificate(const taut_certificate *certificate)
{
    const int count = certificate != NULL ? taut_certificate_claim_count(certificate) : 0;
    int saved = 0;

    for (int i = 0; i < count; i++) {
        saved += taut_certificate_claim(certificate, i)->as_saved != 0;
    }
    if (count > 0 && taut_certificate_holds(certificate) == TAUT_FALSE) {
        return "not all claims hold";
    }
    return count > 0 && saved == count ? "certificate as saved, not proved again" : NULL;
}

/* The force of the longest arrow, of the first pane that has any. */
static void note_arrows(const taut_panes *panes, char *note, size_t size)
{
    const taut_pane *first = NULL;
    char text[160], number[48];

    for (int i = panes->count - 1; i >= 0; i--) {
        first = panes->pane[i].arrow_most > 0 ? &panes->pane[i] : first;
    }
    if (first == NULL) {
        append_note(note, size, "no reactions: there is no certificate that has them");
        return;
    }
    taut_label_number(first->arrow_most, number, sizeof number);
    snprintf(text, sizeof text,
             "reactions%s: as the cables pull at the supports, the longest arrow is a force of %s",
             panes->count > 1 ? ", each model at its own scale" : "", number);
    append_note(note, size, text);
}

void taut_panes_note(const taut_panes *panes, const taut_write_options *options, double limit,
                     char *note, size_t size)
{
    const char *unit = taut_model_unit(panes->pane[0].model);
    char text[160], number[48];

    int far = 0, nets = 0;

    note[0] = '\0';
    for (int i = 0; i < panes->count; i++) {
        const char *blame = blame_certificate(taut_model_certificate(panes->pane[i].model));
        if (blame != NULL) {
            append_note(note, size, blame);
            break;
        }
    }
    if (panes->of > panes->count) {
        snprintf(text, sizeof text, "%d of %d surfaces", panes->count, panes->of);
        append_note(note, size, text);
    }
    for (int i = 0; i < panes->count; i++) {
        far += taut_pane_far_nets(&panes->pane[i], options);
        nets += taut_pane_nets(&panes->pane[i], options);
    }
    if (far > 0) {
        snprintf(text, sizeof text, "%d of %d control nets left out: they reach far beyond", far,
                 nets);
        append_note(note, size, text);
    }
    if (options->isolines > 0 && options->colour != TAUT_COLOUR_PLAIN) {
        taut_label_number(limit / options->isolines, number, sizeof number);
        snprintf(text, sizeof text, "a line every %s", number);
        append_note(note, size, text);
    }
    if (options->reactions) {
        note_arrows(panes, note, size);
    }
    if (options->combs) {
        taut_label_number(panes->pane[0].comb_most, number, sizeof number);
        snprintf(text, sizeof text,
                 panes->count > 1 && !panes->is_one_size
                     ? "combs, each model at its own scale: the longest tooth of the first is a "
                       "curvature of %s/%s"
                     : "combs: the longest tooth is a curvature of %s/%s",
                 number, unit);
        append_note(note, size, text);
    }
}
