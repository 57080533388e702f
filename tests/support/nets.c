#include "nets.h"

#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

made_net net_make(const char *net, const char *surface, const char *members)
{
    return net_make_by(net, surface, members, 1);
}

void net_heights(const int degree[2], const int count[2], const double *heights, char *text,
                 size_t room)
{
    size_t length = (size_t)snprintf(text, room, "{ \"taut\": 1, \"surfaces\": [{ ");
    for (int d = 0; d < 2; d++) {
        length += (size_t)snprintf(text + length, room - length,
                                   "\"%s\": { \"type\": \"%s\", \"degree\": %d", d == 0 ? "u" : "v",
                                   count[d] > degree[d] + 1 ? "bspline" : "bezier", degree[d]);
        if (count[d] > degree[d] + 1) {
            length += (size_t)snprintf(text + length, room - length, ", \"count\": %d", count[d]);
        }
        length += (size_t)snprintf(text + length, room - length, " }, ");
    }
    length += (size_t)snprintf(text + length, room - length, "\"points\": ");
    for (int i = 0; i < count[0]; i++) {
        for (int j = 0; j < count[1]; j++) {
            length += (size_t)snprintf(text + length, room - length, "%s[%.17g, %.17g, %.17g]",
                                       j > 0    ? ", "
                                       : i == 0 ? "[["
                                                : ", [",
                                       2.0 * i / (count[0] - 1), 2.0 * j / (count[1] - 1),
                                       heights[i * count[1] + j]);
        }
        length += (size_t)snprintf(text + length, room - length, "]");
    }
    snprintf(text + length, room - length, "] }] }");
}

made_net net_make_by(const char *net, const char *surface, const char *members, int threads)
{
    const taut_make_options options = {.threads = threads};
    const taut_certify_options proof = {.threads = threads};
    made_net made = {.status = TAUT_OK};
    const size_t room = strlen(surface) + strlen(members) + 200;
    char *text = malloc(room);

    if (text == NULL) {
        made.status = TAUT_NO_MEMORY;
        return made;
    }
    const int length = snprintf(text, room, "{ \"taut\": 1, \"trace\": \"%s\", \"of\": %s%s%s }",
                                net, surface, members[0] != '\0' ? ", " : "", members);
    made.status = taut_problem_read_text(text, (size_t)length, "net", &made.problem, &made.error);
    if (made.status == TAUT_OK) {
        made.status = taut_make(made.problem, &options, &made.model, &made.error);
    }
    if (made.status == TAUT_OK) {
        made.status = taut_certify(made.model, made.problem, &proof, &made.proof, &made.error);
    }
    free(text);
    return made;
}

void net_free(made_net *made)
{
    taut_certificate_free(made->proof);
    taut_model_free(made->model);
    taut_problem_free(made->problem);
}

const taut_record *net_lath(const made_net *made, const char *name)
{
    const taut_record *laths = taut_record_get(taut_model_details(made->model), "laths");
    for (size_t k = 0; k < taut_record_count(laths); k++) {
        const taut_record *lath = taut_record_at(laths, k);
        if (strcmp(taut_record_text(taut_record_get(lath, "name")), name) == 0) {
            return lath;
        }
    }
    return NULL;
}

double net_number(const made_net *made, const char *lath, const char *key)
{
    return taut_record_number(taut_record_get(net_lath(made, lath), key));
}

double net_end(const made_net *made, const char *lath, const char *key, int i)
{
    return taut_record_number(
        taut_record_at(taut_record_get(net_lath(made, lath), key), (size_t)i));
}

int net_count(const made_net *made, const char *list)
{
    return (int)taut_record_count(taut_record_get(taut_model_details(made->model), list));
}
