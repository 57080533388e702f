#include "cloths.h"

#include "check.h"

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
