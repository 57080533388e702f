#include "cloths.h"

#include "check.h"
#include "cli/embedded_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

made_cloth cloth_make(const char *surface, const char *members)
{
    made_cloth made = {.status = TAUT_OK};
    const size_t room = strlen(surface) + strlen(members) + 200;
    char *text = malloc(room);

    if (text == NULL) {
        made.status = TAUT_NO_MEMORY;
        return made;
    }
    const int length = snprintf(
        text, room, "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": %s, %s }", surface, members);
    made.status = taut_problem_read_text(text, (size_t)length, "cloth", &made.problem, &made.error);
    if (made.status == TAUT_OK) {
        made.status = taut_make(made.problem, NULL, &made.model, &made.error);
    }
    if (made.status == TAUT_OK) {
        made.status = taut_certify(made.model, made.problem, NULL, &made.proof, &made.error);
    }
    free(text);
    return made;
}

made_cloth cloth_try_example(const char *name, const char *members)
{
    const taut_embedded *file = taut_examples;
    char wanted[128];
    snprintf(wanted, sizeof wanted, "%s.json", name);
    while (file->name != NULL && strcmp(file->name, wanted) != 0) {
        file++;
    }
    return cloth_make(file->name != NULL ? file->text : "{}", members);
}

made_cloth cloth_of_example(const char *name, const char *members)
{
    const made_cloth made = cloth_try_example(name, members);
    CHECK(made.status == TAUT_OK, "%s: %s", name, made.error.message);
    return made;
}

void cloth_free(made_cloth *made)
{
    taut_certificate_free(made->proof);
    taut_model_free(made->model);
    taut_problem_free(made->problem);
}

const taut_record *cloth_told(const made_cloth *made, const char *list, const char *name)
{
    const taut_record *items = taut_record_get(taut_model_details(made->model), list);
    for (size_t k = 0; k < taut_record_count(items); k++) {
        const taut_record *item = taut_record_at(items, k);
        if (strcmp(taut_record_text(taut_record_get(item, "name")), name) == 0) {
            return item;
        }
    }
    return NULL;
}

double cloth_number(const made_cloth *made, const char *list, const char *name, const char *path)
{
    const taut_record *at = cloth_told(made, list, name);
    while (at != NULL && path[0] != '\0') {
        const size_t length = strcspn(path, "/");
        char word[64];
        snprintf(word, sizeof word, "%.*s", (int)length, path);
        at = taut_record_kind_of(at) == TAUT_RECORD_LIST ? taut_record_at(at, (size_t)atoi(word))
                                                         : taut_record_get(at, word);
        path += length + (path[length] != '\0');
    }
    return taut_record_number(at);
}

taut_record *cloth_edited(const taut_record *from, const char *key, const char *old,
                          const char *new)
{
    taut_record *to =
        taut_record_kind_of(from) == TAUT_RECORD_LIST ? taut_record_new_list() : taut_record_new();
    const int is_list = taut_record_kind_of(from) == TAUT_RECORD_LIST;
    for (size_t k = 0; k < taut_record_count(from); k++) {
        const taut_record *item = taut_record_at(from, k);
        const char *name = is_list ? NULL : taut_record_key(from, k);
        if (new == NULL && name != NULL &&strcmp(name, key) == 0) {
            continue;
        }
        switch (taut_record_kind_of(item)) {
        case TAUT_RECORD_NUMBER: {
            const double value = taut_record_number(item);
            const int is_it = strcmp(key, "part") == 0 && value == atof(old);
            taut_record_add_number(to, name, is_it ? atof(new) : value);
            break;
        }
        case TAUT_RECORD_BOOL:
            taut_record_add_bool(to, name, taut_record_bool(item));
            break;
        case TAUT_RECORD_TEXT: {
            const int is_it =
                name != NULL && strcmp(name, key) == 0 && strcmp(taut_record_text(item), old) == 0;
            taut_record_add_text(to, name, is_it ? new : taut_record_text(item));
            break;
        }
        case TAUT_RECORD_NULL:
            taut_record_add_null(to, name);
            break;
        default: {
            taut_record *child = cloth_edited(item, key, old, new);
            taut_record_add_record(to, name, child);
            taut_record_free(child);
        }
        }
    }
    return to;
}
