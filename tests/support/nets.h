/* nets.h -- nets of curves from the text of a document, made and proved. */
#ifndef TAUT_TEST_NETS_H
#define TAUT_TEST_NETS_H

#include "taut/taut.h"

/* Surfaces for `of`, as JSON: minimal ones, and x y. */
#define BONNET(theta)                                                                              \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0.29, \"sign\": \"-\", \"alpha\": "     \
    "1.2, \"beta\": 0.9, \"theta\": " theta " }"
#define CATENOID                                                                                   \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0, \"sign\": \"+\", \"alpha\": 2, "     \
    "\"beta\": 2, \"start\": [-1, -1] }"
#define HELICOID                                                                                   \
    "{ \"taut\": 1, \"construct\": \"bonnet\", \"lambda\": 0, \"sign\": \"+\", \"theta\": "        \
    "1.5707963267948966, \"alpha\": 3, \"beta\": 2.5, \"start\": [-1, -1.5] }"
#define BILINEAR                                                                                   \
    "{ \"taut\": 1, \"surfaces\": [{ \"u\": { \"type\": \"bezier\", \"degree\": 1, \"range\": "    \
    "[-1, 1] }, \"v\": { \"type\": \"bezier\", \"degree\": 1, \"range\": [-1, 1] }, \"points\": "  \
    "[[[-1, -1, 1.1], [-1, 1, -1.1]], [[1, -1, -1.1], [1, 1, 1.1]]] }] }"

/* A surface over [0, 2]^2, its points on a regular grid at heights[nu][nv]; Bezier where there
 * are no more than degree + 1. */
void net_heights(const int degree[2], const int count[2], const double *heights, char *text,
                 size_t room);

typedef struct made_net {
    taut_problem *problem;
    taut_model *model;
    taut_certificate *proof;
    taut_status status; /* of the first call that failed */
    taut_error error;
} made_net;

/* "trace": net, "of": surface (JSON), and the rest of the members, such as "\"seeds\": [...]". */
made_net net_make(const char *net, const char *surface, const char *members);
/* The same by so many threads. */
made_net net_make_by(const char *net, const char *surface, const char *members, int threads);
void net_free(made_net *made);

/* A lath of details by its name, or NULL; and a number of it, of a list in it. */
const taut_record *net_lath(const made_net *made, const char *name);
double net_number(const made_net *made, const char *lath, const char *key);
double net_end(const made_net *made, const char *lath, const char *key, int i);
int net_count(const made_net *made, const char *list);

#endif /* TAUT_TEST_NETS_H */
