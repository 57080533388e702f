#include "problem/problem.h"

#include "core/memory.h"

#include <string.h>

static const char *const names[] = {
#define TAUT_CONSTRUCT_NAME(identifier, name) name,
    TAUT_CONSTRUCT_LIST(TAUT_CONSTRUCT_NAME)
#undef TAUT_CONSTRUCT_NAME
};

int taut_construct_count(void)
{
    return TAUT_CONSTRUCT_COUNT;
}

const char *taut_construct_name(int i)
{
    return i >= 0 && i < TAUT_CONSTRUCT_COUNT ? names[i] : NULL;
}

int taut_construct_find(const char *name)
{
    for (int i = 0; i < TAUT_CONSTRUCT_COUNT; i++) {
        if (strcmp(names[i], name) == 0) {
            return i;
        }
    }
    return -1;
}

taut_status taut_problem_new(int construct, taut_problem **problem)
{
    taut_problem *made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    made->construct = construct;
    made->arena = taut_arena_new();
    if (made->arena == NULL) {
        taut_free(made);
        return TAUT_NO_MEMORY;
    }
    memcpy(made->unit, "mm", 3);
    made->folder = "";
    *problem = made;
    return TAUT_OK;
}

void taut_problem_free(taut_problem *problem)
{
    if (problem != NULL) {
        taut_arena_free(problem->arena);
        taut_free(problem->text);
        taut_record_free(problem->notes);
        taut_free(problem);
    }
}

taut_status taut_problem_note(taut_problem *problem, const char *sentence)
{
    if (problem->notes == NULL) {
        problem->notes = taut_record_new_list();
    }
    taut_record_add_text(problem->notes, NULL, sentence);
    return taut_record_status(problem->notes);
}

const char *taut_problem_construction(const taut_problem *problem)
{
    return names[problem->construct];
}

const char *taut_problem_text(const taut_problem *problem, size_t *length)
{
    if (length != NULL) {
        *length = problem->length;
    }
    return problem->text;
}
