/* read.c -- problems from documents, one or a list of them: what all share, then the
 * construction's own reader. */
#include "taut/read.h"
#include "core/fail.h"
#include "core/memory.h"
#include "io/file/in.h"
#include "io/json/slice.h"
#include "io/model/model.h"
#include "io/problem/document_ops.h"
#include "io/problem/read.h"
#include "platform/system.h"

#include <stdio.h>
#include <string.h>

static const taut_document_ops *const ops_table[] = {
#define TAUT_DOCUMENT_ROW(identifier, name) &taut_document_##identifier,
    TAUT_CONSTRUCT_LIST(TAUT_DOCUMENT_ROW)
#undef TAUT_DOCUMENT_ROW
};

/* The index of the construction that the document names; a net says "trace" in its place, flat cloth "pattern". */
static taut_status read_construct(const taut_json *document, int *construct, taut_error *error)
{
    const taut_json at = taut_json_member(document, "construct");
    const char *names[TAUT_CONSTRUCT_COUNT + 1] = {NULL};
    const char *name = NULL;

    if (at.value == NULL && taut_json_find(document->value, "trace") != NULL) {
        *construct = TAUT_CONSTRUCT_INDEX_trace;
        return TAUT_OK;
    }
    if (at.value == NULL && taut_json_find(document->value, "pattern") != NULL) {
        *construct = TAUT_CONSTRUCT_INDEX_pattern;
        return TAUT_OK;
    }
    for (int i = 0; i < TAUT_CONSTRUCT_COUNT; i++) {
        names[i] = taut_construct_name(i);
    }
    if (taut_json_kind_at(document) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(document, error, "type", "an object");
    }
    if (at.value == NULL && taut_json_find(document->value, "surfaces") != NULL) {
        return taut_json_fail(&at, error, "kind", taut_none, taut_none,
                              "found nothing, expected a construction: this is a model, not a "
                              "problem");
    }
    name = taut_json_text_at(&at);
    if (name == NULL) {
        return taut_json_refuse(&at, error, "type", "the name of a construction, such as \"%s\"",
                                names[0]);
    }
    *construct = taut_construct_find(name);
    if (*construct < 0) {
        return taut_json_refuse(&at, error, "name", "a construction; the nearest one is \"%s\"",
                                taut_nearest_word(name, names, NULL));
    }
    return TAUT_OK;
}

/* Has it members of its construction only? */
static taut_status check_members(const taut_json *document, const taut_document_ops *ops,
                                 taut_error *error)
{
    const char *names[TAUT_DOCUMENT_MEMBERS + 4] = {"taut", "construct", "unit"};
    int count = 3;
    for (int i = 0; i < TAUT_DOCUMENT_MEMBERS && ops->members[i] != NULL; i++) {
        names[count++] = ops->members[i];
    }
    names[count] = NULL;
    return taut_json_object(document, names, error);
}

/* Other files that the document names lie beside it. */
static taut_status set_folder(taut_problem *problem, const char *path, taut_error *error)
{
    const char *name = path != NULL ? taut_system_last_part(path) : NULL;
    char *folder = NULL;
    if (name == path) {
        return TAUT_OK;
    }
    folder = taut_arena_text(problem->arena, path);
    if (folder == NULL) {
        return taut_fail_memory(error);
    }
    folder[name - path] = '\0';
    problem->folder = folder;
    return TAUT_OK;
}

/* What all problems have. */
static taut_status read_head(const taut_json *document, int *construct, const char **unit,
                             taut_error *error)
{
    taut_status status = read_construct(document, construct, error);
    if (status != TAUT_OK) {
        return status;
    }
    status = check_members(document, ops_table[*construct], error);
    if (status != TAUT_OK) {
        return status;
    }
    status = taut_version_document_check(document, error);
    return status == TAUT_OK ? taut_unit_document_read(document, unit, error) : status;
}

/* The problem's own text: that of a file is handed over, any other is copied. */
static taut_status keep_text(const taut_problem_source *source, taut_problem *problem,
                             taut_error *error)
{
    problem->length = source->length;
    if (source->owned != NULL) {
        problem->text = *source->owned;
        *source->owned = NULL;
        return TAUT_OK;
    }
    problem->text = taut_alloc(source->length + 1, 1);
    if (problem->text == NULL) {
        return taut_fail_memory(error);
    }
    memcpy(problem->text, source->text, source->length);
    problem->text[source->length] = '\0';
    return TAUT_OK;
}

static taut_status read_data(const taut_json *document, const taut_document_ops *ops,
                             taut_problem *problem, taut_error *error)
{
    taut_reader reader = taut_reader_of(document, NULL, error);
    void *const data = taut_arena_take(problem->arena, 1, ops->size);

    if (data == NULL) {
        return taut_fail_memory(error);
    }
    problem->data = data;
    ops->read(&reader, problem, data);
    return reader.status;
}

taut_status taut_problem_document_read(const taut_json *document, const char *path,
                                       const taut_problem_source *source, taut_problem **problem,
                                       taut_error *error)
{
    const char *unit = "mm";
    taut_problem *made = NULL;
    int construct = 0;
    taut_status status = read_head(document, &construct, &unit, error);

    if (status != TAUT_OK) {
        return status;
    }
    if (taut_problem_new(construct, &made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    snprintf(made->unit, sizeof made->unit, "%s", unit);
    status = set_folder(made, path, error);
    if (status == TAUT_OK) {
        status = read_data(document, ops_table[construct], made, error);
    }
    if (status == TAUT_OK) {
        status = keep_text(source, made, error);
    }
    if (status != TAUT_OK) {
        taut_problem_free(made);
        return status;
    }
    *problem = made;
    return TAUT_OK;
}

/* A text, where it comes from, and what it becomes. */
typedef struct one_problem {
    const char *path; /* NULL: no file */
    taut_problem_source source;
    taut_problem **problem;
} one_problem;

static taut_status read_one(const taut_json *root, void *into, taut_error *error)
{
    const one_problem *one = into;
    return taut_problem_document_read(root, one->path, &one->source, one->problem, error);
}

taut_status taut_problem_read_from(const char *text, size_t length, const char *name,
                                   const char *path, taut_problem **problem, taut_error *error)
{
    one_problem one = {path, {text, length, NULL}, problem};
    return taut_json_read_text(text, length, name, NULL, read_one, &one, error);
}

taut_status taut_problem_read_text(const char *text, size_t length, const char *name,
                                   taut_problem **problem, taut_error *error)
{
    if ((text == NULL && length > 0) || problem == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_read_text needs a text and a place for the problem");
    }
    return taut_problem_read_from(text, length, name != NULL ? name : "text", NULL, problem, error);
}

taut_status taut_problem_read_file(const char *path, taut_pulse *pulse, taut_json_read *read,
                                   void *into, taut_problem_source *source, taut_error *error)
{
    char *text = NULL;
    taut_status status = taut_file_read(path, &text, &source->length, error);

    if (status != TAUT_OK) {
        return status;
    }
    source->text = text;
    source->owned = &text;
    status =
        taut_json_read_text(text, source->length, strcmp(path, "-") == 0 ? "standard input" : path,
                            pulse, read, into, error);
    taut_free(text);
    return status;
}

taut_status taut_problem_read(const char *path, taut_problem **problem, taut_error *error)
{
    one_problem one = {.path = path, .problem = problem};
    if (path == NULL || problem == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_read needs a path and a place for the problem");
    }
    return taut_problem_read_file(path, NULL, read_one, &one, &one.source, error);
}

struct taut_problem_list {
    taut_problem **problems;
    int count, is_list;
};

void taut_problem_list_free(taut_problem_list *list)
{
    if (list != NULL) {
        for (int i = 0; i < list->count; i++) {
            taut_problem_free(list->problems[i]);
        }
        taut_free(list->problems);
        taut_free(list);
    }
}

int taut_problem_list_count(const taut_problem_list *list)
{
    return list->count;
}

const taut_problem *taut_problem_list_at(const taut_problem_list *list, int i)
{
    return i >= 0 && i < list->count ? list->problems[i] : NULL;
}

int taut_problem_list_is_list(const taut_problem_list *list)
{
    return list->is_list;
}

typedef struct many_problems {
    const char *path; /* NULL: no file */
    taut_problem_source source;
    taut_problem_list **list;
} many_problems;

/* Fills a list that is empty; what was read before a failure is in it. */
static taut_status fill_list(const taut_json *root, const many_problems *many,
                             taut_problem_list *list, taut_error *error)
{
    taut_json_scan items = taut_json_scan_items(many->source.text, many->source.length);
    size_t count = 1;
    taut_status status = TAUT_OK;

    list->is_list = taut_json_kind_at(root) == TAUT_JSON_ARRAY;
    if (list->is_list) {
        status = taut_json_array(root, 1, TAUT_OBJECTS_MAX, "problems", &count, error);
    }
    if (status != TAUT_OK) {
        return status;
    }
    list->problems = taut_alloc_zero(count, sizeof(taut_problem *));
    if (list->problems == NULL) {
        return taut_fail_memory(error);
    }
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json item = list->is_list ? taut_json_item(root, i) : *root;
        taut_problem_source source = many->source;
        if (list->is_list) {
            source.text = taut_json_scan_next(&items, &source.length);
            source.owned = NULL;
        }
        status = taut_problem_document_read(&item, many->path, &source, &list->problems[i], error);
        list->count += status == TAUT_OK;
    }
    return status;
}

static taut_status read_many(const taut_json *root, void *into, taut_error *error)
{
    const many_problems *many = into;
    taut_problem_list *made = taut_alloc_zero(1, sizeof *made);
    const taut_status status =
        made != NULL ? fill_list(root, many, made, error) : taut_fail_memory(error);

    if (status != TAUT_OK) {
        taut_problem_list_free(made);
        return status;
    }
    *many->list = made;
    return TAUT_OK;
}

taut_status taut_problem_list_read_text(const char *text, size_t length, const char *name,
                                        taut_problem_list **list, taut_error *error)
{
    many_problems many = {NULL, {text, length, NULL}, list};
    if ((text == NULL && length > 0) || list == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_list_read_text needs a text and a place for the list");
    }
    return taut_json_read_text(text, length, name != NULL ? name : "text", NULL, read_many, &many,
                               error);
}

taut_status taut_problem_list_read(const char *path, taut_problem_list **list, taut_error *error)
{
    many_problems many = {.path = path, .list = list};
    if (path == NULL || list == NULL) {
        return taut_fail(error, TAUT_BAD_ARGUMENT, "argument", NULL, taut_none, taut_none,
                         "taut_problem_list_read needs a path and a place for the list");
    }
    return taut_problem_read_file(path, NULL, read_many, &many, &many.source, error);
}
