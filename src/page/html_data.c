#include "page/html_page.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/json/out.h"
#include "io/model/model.h"
#include "mesh/colour.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int net_u(const taut_surface *s)
{
    return taut_basis_count(taut_surface_u(s));
}

static int net_v(const taut_surface *s)
{
    return taut_basis_count(taut_surface_v(s));
}

/* 16-bit numbers, low byte first, as base64. */
static void put_shorts(taut_json_out *out, const char *key, size_t count, const int16_t *shorts,
                       char *text)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const size_t bytes = 2 * count;
    size_t length = 0;

    for (size_t i = 0; i < bytes; i += 3) {
        unsigned group = 0;
        for (size_t k = i; k < i + 3; k++) {
            const unsigned number = k < bytes ? (uint16_t)shorts[k / 2] : 0;
            group = group << 8 | (k % 2 == 0 ? number & 255U : number >> 8);
        }
        for (unsigned k = 0; k < 4; k++) {
            text[length++] = i + k <= bytes ? digits[group >> (18 - 6 * k) & 63U] : '=';
        }
    }
    text[length] = '\0';
    taut_json_key(out, key);
    taut_json_put_text(out, text);
}

/* Scratch for `count` shorts and their text. */
typedef struct scratch {
    int16_t *shorts;
    char *text;
} scratch;

static scratch scratch_of(taut_arena *arena, size_t count)
{
    return (scratch){taut_arena_take(arena, count, sizeof(int16_t)),
                     taut_arena_take(arena, (2 * count + 2) / 3 * 4 + 1, 1)};
}

static void put_number(taut_json_out *out, const char *key, double x)
{
    taut_json_key(out, key);
    taut_json_put_number(out, x);
}

static void put_text(taut_json_out *out, const char *key, const char *text)
{
    taut_json_key(out, key);
    taut_json_put_text(out, text);
}

/* The points that are kept of a net: none where it is left out. */
static void put_net(taut_json_out *out, const taut_page_model *p, int nu, int nv,
                    const int every[2], const double *points, scratch s)
{
    const int far = taut_camera_is_far(&p->core, (size_t)nu * (size_t)nv, points);
    const int rows = far ? 0 : taut_page_kept(nu, every[0]);
    const int columns = far ? 0 : taut_page_kept(nv, every[1]);
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            const size_t from = (size_t)taut_page_kept_at(nu, every[0], i) * (size_t)nv +
                                (size_t)taut_page_kept_at(nv, every[1], j);
            taut_page_point(&p->box, points + 3 * from,
                            s.shorts + 3 * ((size_t)i * (size_t)columns + (size_t)j));
        }
    }
    taut_json_key(out, "net");
    taut_json_open_inline(out, '{');
    put_number(out, "nu", rows);
    put_number(out, "nv", columns);
    put_number(out, "every", every[0] > every[1] ? every[0] : every[1]);
    put_shorts(out, "points", 3 * (size_t)rows * (size_t)columns, s.shorts, s.text);
    taut_json_close(out, '}');
}

/* Where the lines are as shares of the range, and which are knots. */
static void put_lines(taut_json_out *out, const char *key, const taut_page_lines *lines, scratch s)
{
    const double low = lines->at[0], high = lines->at[lines->count - 1];
    for (int i = 0; i < lines->count; i++) {
        s.shorts[i] =
            (int16_t)lround(32767 * ((lines->at[i] / 2 - low / 2) / (high / 2 - low / 2)));
    }
    taut_json_key(out, key);
    taut_json_open_inline(out, '{');
    put_number(out, "count", lines->count);
    put_shorts(out, "at", (size_t)lines->count, s.shorts, s.text);
    taut_json_key(out, "range");
    taut_json_put_numbers(out, 2, (const double[]){low, high});
    taut_json_key(out, "knots");
    taut_json_open_inline(out, '[');
    for (int i = 0; i < lines->count; i++) {
        if (lines->is_knot[i]) {
            taut_json_put_number(out, i);
        }
    }
    taut_json_close(out, ']');
    taut_json_close(out, '}');
}

static void put_basis(taut_json_out *out, const char *key, const taut_basis *basis)
{
    char text[96];
    snprintf(text, sizeof text, "%s, %d points", taut_basis_type(basis), taut_basis_count(basis));
    put_text(out, key, text);
}

static const char *surface_name(const void *of, int i)
{
    return taut_surface_name(((const taut_page_model *)of)->surfaces[i].surface);
}

static const char *curve_name(const void *of, int i)
{
    return taut_curve_name(((const taut_page_model *)of)->curves[i].curve);
}

/* Its own, else that of its group. */
static int colour_of(const taut_page_model *p, int i)
{
    int k = 0;
    while (k < taut_model_surface_count(p->model) &&
           taut_model_surface(p->model, k) != p->surfaces[i].surface) {
        k++;
    }
    const int said = taut_colour_said(p->model, k);
    return said >= 0 ? said : taut_colour_group(surface_name, p, p->count, i);
}

static taut_status put_surface(taut_json_out *out, const taut_page_model *p,
                               const taut_page_surface *s)
{
    static const char *const names[TAUT_PAGE_FIELDS] = {"H", "K", "I", "G", "S", "U", "V"};
    const taut_surface *surface = s->surface;
    const size_t count = (size_t)s->u.count * (size_t)s->v.count;
    const size_t net = (size_t)taut_page_kept(net_u(surface), s->every[0]) *
                       (size_t)taut_page_kept(net_v(surface), s->every[1]);
    const scratch room = scratch_of(p->arena, 3 * (count > net ? count : net));

    if (room.shorts == NULL || room.text == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_json_open(out, '{');
    put_text(out, "name", taut_surface_name(surface));
    put_number(out, "colour", colour_of(p, (int)(s - p->surfaces)));
    put_basis(out, "basis_u", taut_surface_u(surface));
    put_basis(out, "basis_v", taut_surface_v(surface));
    put_lines(out, "u", &s->u, room);
    put_lines(out, "v", &s->v, room);
    for (size_t i = 0; i < count; i++) {
        taut_page_point(&p->box, s->points + 3 * i, room.shorts + 3 * i);
    }
    put_shorts(out, "points", 3 * count, room.shorts, room.text);
    for (size_t i = 0; i < count; i++) {
        taut_page_normal(s->normals + 3 * i, room.shorts + 2 * i);
    }
    put_shorts(out, "normals", 2 * count, room.shorts, room.text);
    for (int k = 0; k < TAUT_PAGE_FIELDS; k++) {
        if ((k == TAUT_PAGE_GAP && !s->has_gap) || (k == TAUT_PAGE_STRAIN && s->mounted == NULL) ||
            (k >= TAUT_PAGE_WARP && !s->has_stress)) {
            continue;
        }
        for (size_t i = 0; i < count; i++) {
            room.shorts[i] = taut_page_value(s->fields[k][i], p->limits[k]);
        }
        put_shorts(out, names[k], count, room.shorts, room.text);
    }
    if (s->mounted != NULL) {
        for (size_t i = 0; i < count; i++) {
            taut_page_point(&p->box, s->mounted + 3 * i, room.shorts + 3 * i);
        }
        put_shorts(out, "mounted", 3 * count, room.shorts, room.text);
        for (size_t i = 0; i < count; i++) {
            taut_page_normal(s->mounted_normals + 3 * i, room.shorts + 2 * i);
        }
        put_shorts(out, "mounted_normals", 2 * count, room.shorts, room.text);
    }
    put_net(out, p, net_u(surface), net_v(surface), s->every, taut_surface_points(surface), room);
    taut_json_close(out, '}');
    return TAUT_OK;
}

/* How far a lath is used, by the details of a net: 1 is all of its strength; negative where they do not say. */
static double use_of(const taut_page_model *p, const char *name)
{
    const taut_record *laths = taut_record_get(taut_model_details(p->model), "laths");
    for (size_t k = 0; k < taut_record_count(laths); k++) {
        const taut_record *lath = taut_record_at(laths, k);
        const taut_record *use = taut_record_get(taut_record_get(lath, "stress"), "use");
        if (use != NULL && strcmp(taut_record_text(taut_record_get(lath, "name")), name) == 0) {
            return taut_record_number(use);
        }
    }
    return -1;
}

/* Laths to half of their strength, to all of it, and beyond: told apart by every common colour vision, dark enough
 * on the surfaces' colours. */
static double ink_of(double use)
{
    return use <= 0.5 ? 0x0b5d8c : use <= 1 ? 0xa86a00 : 0xb3001b;
}

static taut_status put_curve(taut_json_out *out, const taut_page_model *p,
                             const taut_page_curve *line)
{
    const taut_curve *curve = line->curve;
    const int points = taut_basis_count(taut_curve_t(curve));
    const int every[2] = {1, (points + TAUT_PAGE_ALONG - 1) / TAUT_PAGE_ALONG};
    const size_t count = line->count;
    const scratch room =
        scratch_of(p->arena, 3 * (count > TAUT_PAGE_ALONG + 2 ? count : TAUT_PAGE_ALONG + 2));

    if (room.shorts == NULL || room.text == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        taut_page_point(&p->box, line->points + 3 * i, room.shorts + 3 * i);
    }
    taut_json_open(out, '{');
    put_text(out, "name", taut_curve_name(curve));
    put_number(out, "colour",
               taut_colour_group(curve_name, p, p->curve_count, (int)(line - p->curves)));
    const double use = use_of(p, taut_curve_name(curve));
    if (use >= 0) {
        put_number(out, "ink", ink_of(use));
        put_number(out, "use", use);
    }
    put_shorts(out, "points", 3 * count, room.shorts, room.text);
    put_net(out, p, 1, points, every, taut_curve_points(curve), room);
    taut_json_close(out, '}');
    return TAUT_OK;
}

/* The nodes of a net that has all its curves here: names, and points beside them. */
static taut_status put_nodes(taut_json_out *out, const taut_page_model *p)
{
    const taut_record *details = taut_model_details(p->model);
    const taut_record *nodes = taut_record_get(details, "nodes");
    const int is_net = p->curve_count > 0 && taut_record_get(details, "trace") != NULL;
    const size_t all = is_net ? taut_record_count(nodes) : 0;
    const size_t count = all < TAUT_PAGE_NODES ? all : TAUT_PAGE_NODES;
    const scratch room = scratch_of(p->arena, 3 * count + 3);

    if (room.shorts == NULL || room.text == NULL) {
        return TAUT_NO_MEMORY;
    }
    taut_json_key(out, "nodes");
    taut_json_open(out, '{');
    taut_json_key(out, "names");
    taut_json_open(out, '[');
    for (size_t k = 0; k < count; k++) {
        const taut_record *node = taut_record_at(nodes, k), *at = taut_record_get(node, "point");
        double point[3];
        taut_json_put_text(out, taut_record_text(taut_record_get(node, "node")));
        for (size_t c = 0; c < 3; c++) {
            point[c] = taut_record_number(taut_record_at(at, c));
        }
        taut_page_point(&p->box, point, room.shorts + 3 * k);
    }
    taut_json_close(out, ']');
    put_shorts(out, "points", 3 * count, room.shorts, room.text);
    taut_json_close(out, '}');
    return TAUT_OK;
}

/* What the page does not show, in sentences for people. */
static void put_dropped(taut_json_out *out, const taut_page_model *p)
{
    const int curves = p->options->surface == NULL ? taut_model_curve_count(p->model) : 0;
    const taut_page_surface *first = p->count > 0 ? &p->surfaces[0] : NULL;
    int every = 1, skipped = 0;
    char text[200];

    for (int i = 0; i < p->count; i++) {
        const taut_page_surface *s = &p->surfaces[i];
        every = s->every[0] > every ? s->every[0] : every;
        skipped = s->u.skipped + s->v.skipped > skipped ? s->u.skipped + s->v.skipped : skipped;
    }
    taut_json_key(out, "dropped");
    taut_json_open(out, '[');
    if (p->left_out > 0) {
        snprintf(text, sizeof text, "The last %d surfaces are left out.", p->left_out);
        taut_json_put_text(out, text);
    }
    if (skipped > 0 && first != NULL) {
        snprintf(text, sizeof text,
                 "Each surface is drawn on %d by %d points, coarser than its knots; the model's "
                 "file has it whole.",
                 first->u.count, first->v.count);
        taut_json_put_text(out, text);
    }
    if (every > 1) {
        snprintf(text, sizeof text, "Of the control net one point in %d is kept each way.", every);
        taut_json_put_text(out, text);
    }
    if (p->far_nets > 0) {
        snprintf(text, sizeof text,
                 "%d of %d control nets left out: they reach more than three times as far as the "
                 "surfaces and curves.",
                 p->far_nets, p->count + p->curve_count);
        taut_json_put_text(out, text);
    }
    if (curves > p->curve_count) {
        snprintf(text, sizeof text, "The last %d curves are left out.", curves - p->curve_count);
        taut_json_put_text(out, text);
    }
    taut_json_close(out, ']');
}

/* The colours of the scale from -1 to 1, as figures have them. */
static void put_map(taut_json_out *out)
{
    enum { COLOURS = 33 };
    taut_json_key(out, "map");
    taut_json_open_inline(out, '[');
    for (int i = 0; i < COLOURS; i++) {
        const taut_ink ink = taut_colour_diverging(2.0 * i / (COLOURS - 1) - 1);
        taut_json_put_number(out, ink.r * 65536 + ink.g * 256 + ink.b);
    }
    taut_json_close(out, ']');
}

/* Frames of one deformation: several surfaces of one shape of net and one kind of basis, which
 * `details` counts as frames or gives a list of parameters for, one each. */
static int is_frames(const taut_page_model *p)
{
    const taut_record *details = taut_model_details(p->model);
    const taut_record *frames = taut_record_get(details, "frames");
    const taut_record *lambda = taut_record_get(details, "lambda");
    const int counted = taut_record_number(frames) == p->count ||
                        taut_record_count(frames) == (size_t)p->count ||
                        taut_record_count(lambda) == (size_t)p->count;
    return p->count > 1 && (counted || p->options->side_by_side);
}

/* Which claims were not proved since they were read, by number; nothing where all were. */
static void put_saved(taut_json_out *out, const taut_certificate *certificate)
{
    int found = 0;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        if (!taut_certificate_claim(certificate, i)->as_saved) {
            continue;
        }
        if (!found) {
            taut_json_key(out, "saved");
            taut_json_open_inline(out, '[');
            found = 1;
        }
        taut_json_put_number(out, i);
    }
    if (found) {
        taut_json_close(out, ']');
    }
}

static void put_head(taut_json_out *out, const taut_page_model *p)
{
    const taut_certificate *certificate = taut_model_certificate(p->model);
    put_text(out, "title", p->options->title != NULL ? p->options->title : "");
    put_text(out, "unit", taut_model_unit(p->model));
    taut_json_key(out, "view");
    taut_json_put_numbers(out, 2, p->view);
    put_number(out, "frames", is_frames(p));
    taut_json_key(out, "centre");
    taut_json_put_numbers(out, 3, p->box.centre);
    put_number(out, "half", p->box.half);
    put_map(out);
    taut_json_key(out, "limits");
    taut_json_put_numbers(out, TAUT_PAGE_FIELDS, p->limits);
    taut_json_key(out, "sign");
    taut_json_open_inline(out, '[');
    for (int k = 0; k < TAUT_PAGE_FIELDS; k++) {
        taut_json_put_number(out, p->sign[k]);
    }
    taut_json_close(out, ']');
    taut_json_key(out, "cut");
    taut_json_open_inline(out, '[');
    for (int k = 0; k < TAUT_PAGE_FIELDS; k++) {
        taut_json_put_number(out, p->cut[k]);
    }
    taut_json_close(out, ']');
    put_dropped(out, p);
    if (certificate != NULL) {
        taut_json_key(out, "certificate");
        taut_certificate_document_write(out, certificate);
        put_saved(out, certificate);
    }
    if (taut_model_details(p->model) != NULL) {
        taut_json_key(out, "details");
        taut_json_put_record(out, taut_model_details(p->model));
    }
}

static taut_status put_page(const taut_page_model *p, char **text, size_t *length)
{
    taut_json_out out = taut_json_out_to(NULL);
    taut_status status = TAUT_OK, ended = TAUT_OK;

    taut_sink_watch(&out.sink, &p->options->monitor);
    taut_json_open(&out, '{');
    put_head(&out, p);
    taut_json_key(&out, "surfaces");
    taut_json_open(&out, '[');
    for (int i = 0; i < p->count && status == TAUT_OK; i++) {
        status = put_surface(&out, p, &p->surfaces[i]);
    }
    taut_json_close(&out, ']');
    taut_json_key(&out, "curves");
    taut_json_open(&out, '[');
    for (int i = 0; i < p->curve_count && status == TAUT_OK; i++) {
        status = put_curve(&out, p, &p->curves[i]);
    }
    taut_json_close(&out, ']');
    if (status == TAUT_OK) {
        status = put_nodes(&out, p);
    }
    taut_json_close(&out, '}');
    ended = taut_json_out_finish(&out);
    if (status == TAUT_OK && ended == TAUT_OK) {
        *text = out.sink.text;
        *length = out.sink.length;
    } else if (ended == TAUT_OK) {
        taut_free(out.sink.text);
    }
    return status != TAUT_OK ? status : ended;
}

taut_status taut_html_data(const taut_model *model, const taut_write_options *options, char **text,
                           size_t *length, taut_error *error)
{
    taut_page_model p = {.model = model, .options = options, .arena = taut_arena_new()};
    taut_status status = p.arena != NULL ? taut_page_prepare(&p, error) : taut_fail_memory(error);

    if (status == TAUT_OK) {
        status = taut_fail_status(error, put_page(&p, text, length));
    }
    taut_arena_free(p.arena);
    return status;
}
