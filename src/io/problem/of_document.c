#include "io/problem/of_document.h"

#include "core/fail.h"
#include "geometry/keep.h"
#include "io/format.h"
#include "io/model/model.h"
#include "io/problem/read.h"
#include "platform/system.h"
#include "taut/read.h"

#include <stdio.h>
#include <string.h>

enum { PATH_ROOM = 4096 };

typedef struct target {
    taut_problem *problem; /* whose document it is */
    const taut_model **model;
    const taut_problem **of;
    int untrim; /* trimmed faces of a file are read as the whole surfaces under them */
} target;

static void release_problem(void *problem)
{
    taut_problem_free(problem);
}

static taut_status keep_either(const target *to, taut_problem *made, taut_model *model,
                               taut_error *error)
{
    if (made != NULL) {
        if (!taut_arena_keep(to->problem->arena, made, release_problem)) {
            return taut_fail_memory(error);
        }
        *to->of = made;
        return TAUT_OK;
    }
    if (!taut_keep_model(to->problem->arena, model)) {
        return taut_fail_memory(error);
    }
    *to->model = model;
    return TAUT_OK;
}

/* An object: a problem, but none of curves or pieces on a surface, or a model. */
static taut_status read_object(const taut_json *at, const char *path,
                               const taut_problem_source *source, const target *to,
                               taut_error *error)
{
    const taut_json net = taut_json_member(at, "trace"), cloth = taut_json_member(at, "pattern");
    const taut_json *inner = net.value != NULL ? &net : &cloth;
    taut_problem *made = NULL;
    taut_model *model = NULL;
    taut_status status = TAUT_OK;

    if (inner->value != NULL) {
        return taut_json_fail(inner, error, "kind", taut_none, taut_none,
                              "found a %s, expected the surface itself",
                              net.value != NULL ? "net" : "pattern");
    }
    if (taut_json_member(at, "construct").value != NULL) {
        status = taut_problem_document_read(at, path, source, &made, error);
    } else {
        status = taut_model_document_read(at, &model, error);
    }
    return status == TAUT_OK ? keep_either(to, made, model, error) : status;
}

typedef struct file {
    const target *to;
    const char *path;
    taut_problem_source source;
} file;

static taut_status read_root(const taut_json *root, void *into, taut_error *error)
{
    const file *f = into;
    return read_object(root, f->path, &f->source, f->to, error);
}

static taut_status read_named(const char *path, const target *to, taut_error *error)
{
    const taut_format_ops *ops = taut_format_ops_at(taut_format_of(path, NULL));
    const taut_read_options options = {.untrim = to->untrim};
    file f = {.to = to, .path = path};
    taut_model *model = NULL;

    if (ops == NULL || ops->read == NULL) {
        return taut_problem_read_file(path, NULL, read_root, &f, &f.source, error);
    }
    const taut_status status = taut_model_format_read(ops, path, &options, &model, error);
    return status == TAUT_OK ? keep_either(to, NULL, model, error) : status;
}

/* A file beside the document; what is wrong with it is told at the member that names it. */
static taut_status read_file(const taut_json *at, const char *name, const target *to,
                             taut_error *error)
{
    const char *folder = taut_system_is_rooted(name) ? "" : to->problem->folder;
    taut_error found = {.status = TAUT_OK};
    char path[PATH_ROOM];

    if (name[0] == '\0' || strcmp(name, "-") == 0 ||
        snprintf(path, sizeof path, "%s%s", folder, name) >= PATH_ROOM) {
        return taut_json_refuse(at, error, "value", "the name of a file");
    }
    const taut_status status = read_named(path, to, &found);
    if (status == TAUT_OK) {
        return TAUT_OK;
    }
    taut_json_fail(at, error, found.reason, found.found, found.limit, "%.200s%s%s", found.where,
                   found.where[0] != '\0' ? ": " : "", found.message);
    if (error != NULL) {
        error->status = status;
    }
    return status;
}

static taut_status read_of(const taut_json *at, void *into, taut_error *error)
{
    const target *to = into;
    const char *name = taut_json_text_at(at);
    const taut_problem_source none = {"", 0, NULL};
    char path[PATH_ROOM];

    if (name != NULL) {
        return read_file(at, name, to, error);
    }
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_refuse(at, error, "type", "a model, a problem or the name of a file");
    }
    if (snprintf(path, sizeof path, "%s.", to->problem->folder) >= PATH_ROOM) {
        return taut_json_refuse(at, error, "value", "a shorter path of the document");
    }
    return read_object(at, path, &none, to, error);
}

/* The unit is that of the surface. */
static void take_unit(taut_reader *document, const target *to)
{
    taut_problem *problem = to->problem;
    const char *unit = *to->model != NULL ? taut_model_unit(*to->model)
                       : *to->of != NULL  ? (*to->of)->unit
                                          : problem->unit;
    const taut_json at = taut_json_member(document->object, "unit");
    if (document->status == TAUT_OK && at.value != NULL && strcmp(unit, problem->unit) != 0) {
        document->status =
            taut_json_fail(&at, document->error, "conflict", taut_none, taut_none,
                           "found \"%s\", but the surface is in \"%s\"", problem->unit, unit);
        return;
    }
    snprintf(problem->unit, sizeof problem->unit, "%s", unit);
}

void taut_of_document_read(taut_reader *document, taut_problem *problem, const taut_model **model,
                           const taut_problem **of)
{
    target to = {.problem = problem, .model = model, .of = of};
    taut_reader_flag(document, "untrim", &to.untrim);
    taut_reader_member(document, "of", read_of, &to);
    take_unit(document, &to);
}
