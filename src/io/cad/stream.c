#include "io/cad/stream.h"

#include "core/fail.h"
#include "core/memory.h"
#include "io/json/utf8.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum { UNIT_BYTES = 4, NOTES_MAX = 100 };

/* What stands before the numbers of an item. */
typedef struct item_head {
    int degree[2], count[2], is_rational, notes;
    int name_length;
} item_head;

static int put(FILE *file, const void *bytes, size_t size, size_t count)
{
    return count == 0 || fwrite(bytes, size, count, file) == count;
}

static int get(FILE *file, void *bytes, size_t size, size_t count)
{
    return count == 0 || fread(bytes, size, count, file) == count;
}

int taut_cad_put_unit(void *file, const char *unit)
{
    char bytes[UNIT_BYTES] = "";
    memcpy(bytes, unit, strlen(unit) < UNIT_BYTES ? strlen(unit) : UNIT_BYTES - 1);
    return put(file, "U", 1, 1) && put(file, bytes, 1, UNIT_BYTES);
}

static size_t point_count(const int count[2])
{
    return (size_t)count[0] * (count[1] > 0 ? (size_t)count[1] : 1);
}

static size_t knot_count(const int degree[2], const int count[2], int d)
{
    return count[d] > 0 ? (size_t)count[d] + (size_t)degree[d] + 1 : 0;
}

int taut_cad_put_item(void *file, const taut_cad_item *item)
{
    const size_t length = strlen(item->name), n = point_count(item->count);
    item_head head = {{item->degree[0], item->degree[1]},
                      {item->count[0], item->count[1]},
                      item->weights != NULL,
                      item->notes,
                      length < TAUT_NAME_MAX ? (int)length : TAUT_NAME_MAX};
    return put(file, "I", 1, 1) && put(file, &head, sizeof head, 1) &&
           put(file, item->name, 1, (size_t)head.name_length) &&
           put(file, item->knots[0], sizeof(double), knot_count(head.degree, head.count, 0)) &&
           put(file, item->knots[1], sizeof(double), knot_count(head.degree, head.count, 1)) &&
           put(file, item->points, 3 * sizeof(double), n) &&
           put(file, item->weights, sizeof(double), head.is_rational ? n : 0);
}

int taut_cad_put_end(FILE *file, taut_status status, const taut_error *error)
{
    const int number = (int)status;
    return put(file, "E", 1, 1) && put(file, &number, sizeof number, 1) &&
           put(file, error, sizeof *error, 1) && fflush(file) == 0;
}

/* Cut to whole characters; what is no UTF-8 becomes '?'. */
static void mend_name(char *name, size_t length)
{
    size_t i = 0;
    while (i < length) {
        const size_t step = name[i] != '\0' ? taut_utf8_length(name + i, length - i) : 0;
        if (step == 0 && length == TAUT_NAME_MAX && length - i < 4) {
            length = i;
        } else if (step == 0) {
            name[i] = '?';
        }
        i += step > 0 ? step : 1;
    }
    name[length] = '\0';
}

static taut_status broken(taut_error *error)
{
    return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, taut_none, taut_none,
                     "OpenCASCADE gave nothing that can be read");
}

/* Are these numbers that taut takes, before memory is taken for them? */
static taut_status check_head(const item_head *head, taut_error *error)
{
    const int directions = head->count[1] > 0 ? 2 : 1;
    if (head->name_length < 0 || head->name_length > TAUT_NAME_MAX) {
        return broken(error);
    }
    for (int d = 0; d < directions; d++) {
        if (head->degree[d] < 1 || head->degree[d] > TAUT_DEGREE_MAX ||
            head->count[d] <= head->degree[d] || head->count[d] > TAUT_COUNT_MAX) {
            return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, head->count[d], TAUT_COUNT_MAX,
                             "found degree %d with %d points, expected a degree of 1 to %d and at "
                             "most %d points",
                             head->degree[d], head->count[d], TAUT_DEGREE_MAX, TAUT_COUNT_MAX);
        }
    }
    if (point_count(head->count) > TAUT_POINTS_MAX) {
        return taut_fail(error, TAUT_BAD_INPUT, "value", NULL, (double)point_count(head->count),
                         TAUT_POINTS_MAX, "found a net of %d x %d points, expected at most %d",
                         head->count[0], head->count[1], TAUT_POINTS_MAX);
    }
    return TAUT_OK;
}

/* The numbers of one item, in one block. */
typedef struct item_numbers {
    double *knots[2], *points, *weights;
} item_numbers;

static double *take_numbers(const item_head *head, item_numbers *numbers, size_t *count)
{
    const size_t ku = knot_count(head->degree, head->count, 0);
    const size_t kv = knot_count(head->degree, head->count, 1);
    const size_t n = point_count(head->count);
    double *block = NULL;
    *count = ku + kv + (head->is_rational ? 4 : 3) * n;
    block = taut_alloc(*count, sizeof *block);
    if (block != NULL) {
        numbers->knots[0] = block;
        numbers->knots[1] = block + ku;
        numbers->points = block + ku + kv;
        numbers->weights = head->is_rational ? numbers->points + 3 * n : NULL;
    }
    return block;
}

static taut_status new_basis(const item_head *head, const double *knots, int d, taut_basis **basis,
                             taut_error *error)
{
    const taut_basis_spec spec = {.type = "bspline",
                                  .degree = head->degree[d],
                                  .knot_count = (int)knot_count(head->degree, head->count, d),
                                  .knots = knots};
    return taut_basis_new(&spec, head->count[d], basis, error);
}

static taut_status add_curve(const item_head *head, const char *name, const item_numbers *numbers,
                             taut_model *model, taut_error *error)
{
    taut_basis *t = NULL;
    taut_curve *curve = NULL;
    taut_status status = new_basis(head, numbers->knots[0], 0, &t, error);
    if (status == TAUT_OK) {
        status = taut_curve_new(name, t, numbers->points, numbers->weights, &curve, error);
    }
    if (status == TAUT_OK && taut_model_add_curve(model, curve) != TAUT_OK) {
        taut_curve_free(curve);
        status = taut_fail_memory(error);
    }
    taut_basis_free(t);
    return status;
}

static taut_status add_surface(const item_head *head, const char *name, const item_numbers *numbers,
                               taut_model *model, taut_error *error)
{
    taut_basis *u = NULL, *v = NULL;
    taut_surface *surface = NULL;
    taut_status status = new_basis(head, numbers->knots[0], 0, &u, error);
    if (status == TAUT_OK) {
        status = new_basis(head, numbers->knots[1], 1, &v, error);
    }
    if (status == TAUT_OK) {
        status = taut_surface_new(name, u, v, numbers->points, numbers->weights, &surface, error);
    }
    if (status == TAUT_OK && taut_model_add_surface(model, surface) != TAUT_OK) {
        taut_surface_free(surface);
        status = taut_fail_memory(error);
    }
    taut_basis_free(u);
    taut_basis_free(v);
    return status;
}

/* Says of an item what is to be said. */
static void add_notes(const item_head *head, const char *name, int index, taut_record *notes)
{
    const char *what = head->count[1] > 0 ? "surface" : "curve";
    char text[TAUT_NAME_MAX + 160];
    for (int note = TAUT_CAD_TRIMMED; note <= TAUT_CAD_APPROXIMATE; note *= 2) {
        if ((head->notes & note) != 0 && taut_record_count(notes) < NOTES_MAX) {
            snprintf(text, sizeof text, "%s %d \"%s\": %s", what, index, name,
                     note == TAUT_CAD_TRIMMED
                         ? "the face is trimmed; this is the whole surface under it"
                         : "the original is no NURBS; this comes near it");
            taut_record_add_text(notes, NULL, text);
        }
    }
}

static taut_status get_item(FILE *file, taut_cad_result *result, taut_error *error)
{
    item_head head;
    char name[TAUT_NAME_MAX + 1];
    item_numbers numbers;
    size_t count = 0;
    double *block = NULL;
    taut_status status = TAUT_OK;

    if (result->model == NULL || !get(file, &head, sizeof head, 1)) {
        return broken(error);
    }
    status = check_head(&head, error);
    if (status != TAUT_OK) {
        return status;
    }
    if (!get(file, name, 1, (size_t)head.name_length)) {
        return broken(error);
    }
    mend_name(name, (size_t)head.name_length);
    block = take_numbers(&head, &numbers, &count);
    if (block == NULL) {
        return taut_fail_memory(error);
    }
    const int is_surface = head.count[1] > 0;
    const int index = is_surface ? taut_model_surface_count(result->model)
                                 : taut_model_curve_count(result->model);
    if (!get(file, block, sizeof *block, count)) {
        status = broken(error);
    } else if (index >= TAUT_OBJECTS_MAX) {
        status = taut_fail(error, TAUT_BAD_INPUT, "value", NULL, index, TAUT_OBJECTS_MAX,
                           "found more than %d %s", TAUT_OBJECTS_MAX,
                           is_surface ? "surfaces" : "curves");
    } else {
        status =
            (is_surface ? add_surface : add_curve)(&head, name, &numbers, result->model, error);
    }
    if (status == TAUT_OK) {
        add_notes(&head, name, index, result->notes);
    } else if (status == TAUT_BAD_INPUT) {
        char prefix[48];
        snprintf(prefix, sizeof prefix, "/%s/%d", is_surface ? "surfaces" : "curves", index);
        taut_error_prefix(error, prefix);
    }
    taut_free(block);
    return status;
}

static taut_status get_unit(FILE *file, taut_cad_result *result, taut_error *error)
{
    char unit[UNIT_BYTES];
    if (result->model == NULL || !get(file, unit, 1, UNIT_BYTES) || unit[UNIT_BYTES - 1] != '\0' ||
        taut_model_set_unit(result->model, unit) != TAUT_OK) {
        return broken(error);
    }
    return TAUT_OK;
}

static taut_status get_end(FILE *file, taut_cad_result *result, taut_error *error)
{
    taut_error found;
    int status = 0;
    if (!get(file, &status, sizeof status, 1) || !get(file, &found, sizeof found, 1)) {
        return TAUT_OK; /* died while saying so */
    }
    found.where[sizeof found.where - 1] = found.message[sizeof found.message - 1] = '\0';
    result->has_ended = 1;
    result->status = (taut_status)status;
    if (status != TAUT_OK && error != NULL) {
        *error = found;
    }
    return TAUT_OK;
}

taut_status taut_cad_get_all(FILE *file, taut_cad_result *result, taut_error *error)
{
    taut_status status = TAUT_OK;
    int tag = 0;
    while (status == TAUT_OK && !result->has_ended && (tag = fgetc(file)) != EOF) {
        if (tag == 'U') {
            status = get_unit(file, result, error);
        } else if (tag == 'I') {
            status = get_item(file, result, error);
        } else if (tag == 'E') {
            status = get_end(file, result, error);
            if (!result->has_ended) {
                break;
            }
        } else {
            status = broken(error);
        }
    }
    return status;
}
