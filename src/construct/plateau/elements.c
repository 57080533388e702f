#include "construct/plateau/elements.h"

#include "core/arena.h"
#include "core/memory.h"
#include "platform/parallel.h"

/* Of Gauss points: what is known of them stays in the nearest cache. */
enum { POINTS_AT_ONCE = 64, BATCH = 64 /* cells */ };
static const double batch_bytes = 4e6;
static const double work_least = 4e6; /* operations that are worth a thread */

/* Of the points that are added at once. */
typedef struct bench {
    double *slope_u, *slope_v, *flux_u, *flux_v; /* [points][wide] */
    double *normal;                              /* [points][TAUT_AREA_BLOCK - 1] */
} bench;

struct taut_area_elements {
    taut_arena *arena;
    int count;
    const taut_area_functional *const *nets;
    taut_area_beside *beside;
    const void *context;
    int *first;   /* [count + 1]: cells before each net */
    size_t each;  /* numbers of the largest element */
    int batch;    /* cells */
    double *made; /* [batch][each] */
    int from, to; /* the cells that are made */
    int next;     /* cell */
    int workers;
    bench *benches; /* [workers] */
};

static int cells_of(const taut_area_axis *axis)
{
    return axis->count / axis->nodes;
}

static double work_of_cell(const taut_area_functional *net)
{
    const double local = (double)net->u.local * net->v.local;
    return 13 * local * local * net->u.nodes * net->v.nodes;
}

static taut_status take_benches(taut_area_elements *e, size_t points, size_t wide)
{
    e->benches = taut_arena_take(e->arena, (size_t)e->workers, sizeof *e->benches);
    for (int k = 0; e->benches != NULL && k < e->workers; k++) {
        bench *b = &e->benches[k];
        double **arrays[4] = {&b->slope_u, &b->slope_v, &b->flux_u, &b->flux_v};
        for (int i = 0; i < 4; i++) {
            *arrays[i] = taut_arena_take(e->arena, points * wide, sizeof(double));
        }
        b->normal = taut_arena_take(e->arena, points, (TAUT_AREA_BLOCK - 1) * sizeof(double));
    }
    return taut_arena_status(e->arena);
}

static taut_status make_elements(const taut_area_functional *const *nets, int threads,
                                 taut_area_elements *e)
{
    size_t wide = 0, points = POINTS_AT_ONCE;
    double work = 0;

    e->first = taut_arena_take(e->arena, (size_t)e->count + 1, sizeof(int));
    if (e->first == NULL) {
        return TAUT_NO_MEMORY;
    }
    for (int n = 0; n < e->count; n++) {
        const taut_area_functional *net = nets[n];
        const int cells = cells_of(&net->u) * cells_of(&net->v);
        const size_t w = (size_t)taut_area_wide(net), nodes = (size_t)net->v.nodes;
        const size_t each = (size_t)net->u.local * (size_t)net->v.local * TAUT_AREA_BLOCK * w;
        e->first[n + 1] = e->first[n] + cells;
        e->each = each > e->each ? each : e->each;
        wide = w > wide ? w : wide;
        points = nodes > points ? nodes : points;
        work += cells * work_of_cell(net);
    }
    const double fit = batch_bytes / ((double)e->each * sizeof(double));
    e->workers = taut_parallel_workers(work < work_least ? 1 : threads, e->first[e->count]);
    e->batch = e->workers == 1    ? 1
               : fit >= BATCH     ? BATCH
               : fit > e->workers ? (int)fit
                                  : e->workers;
    e->made = taut_arena_take(e->arena, (size_t)e->batch, e->each * sizeof(double));
    return take_benches(e, points, wide);
}

taut_status taut_area_elements_new(int count, const taut_area_functional *const *nets, int threads,
                                   taut_area_elements **elements)
{
    taut_area_elements *e = taut_alloc_zero(1, sizeof *e);

    if (e == NULL) {
        return TAUT_NO_MEMORY;
    }
    e->arena = taut_arena_new();
    e->count = count;
    const taut_status status = make_elements(nets, threads, e);
    if (status != TAUT_OK) {
        taut_area_elements_free(e);
        return status;
    }
    *elements = e;
    return TAUT_OK;
}

void taut_area_elements_free(taut_area_elements *elements)
{
    if (elements != NULL) {
        taut_arena_free(elements->arena);
        taut_free(elements);
    }
}

void taut_area_elements_begin(taut_area_elements *elements, const taut_area_functional *const *nets,
                              taut_area_beside *beside, const void *context)
{
    elements->nets = nets;
    elements->beside = beside;
    elements->context = context;
    elements->from = elements->to = elements->next = 0;
}

/* The slopes of x in each point alive at node k of v: N_i' N_j and N_i N_j', or with weights
 * w_ij (N_i' N_j - N_i N_j w_u / w) / w. */
static void find_slopes(const taut_area_functional *functional, int line, int k, double *slope_u,
                        double *slope_v)
{
    const size_t local_u = (size_t)functional->u.local, local_v = (size_t)functional->v.local;
    const double *n = functional->u.value + (size_t)line * local_u;
    const double *d = functional->u.slope + (size_t)line * local_u;
    const double *m = functional->v.value + (size_t)k * local_v;
    const double *e = functional->v.slope + (size_t)k * local_v;
    const int is_rational = functional->quotient != NULL;
    double q[3] = {1, 0, 0};
    size_t p = 0;

    if (is_rational) {
        taut_area_functional_quotient(functional, line, k, q);
    }

    for (size_t a = 0; a < local_u; a++) {
        for (size_t b = 0; b < local_v; b++, p++) {
            slope_u[p] = d[a] * m[b];
            slope_v[p] = n[a] * e[b];
            if (is_rational) {
                const size_t i = (size_t)functional->u.first[line] + a;
                const size_t j = (size_t)functional->v.first[k] + b;
                const double w = functional->weights[i * (size_t)functional->nv + j] * q[0];
                slope_u[p] = w * (slope_u[p] - n[a] * m[b] * q[1]);
                slope_v[p] = w * (slope_v[p] - n[a] * m[b] * q[2]);
            }
        }
    }
}

/* What Gauss point (line, k) gives to every pair of functions: the g-th of those that are added at once. */
static void lay_point(const bench *at, const taut_area_functional *functional, int line, int k,
                      int g)
{
    const size_t wide = (size_t)taut_area_wide(functional), from = (size_t)g * wide;
    const int local = functional->u.local * functional->v.local;
    const double *pu = at->slope_u + from, *pv = at->slope_v + from;
    double *normal = at->normal + g * (TAUT_AREA_BLOCK - 1), state[TAUT_AREA_STATE];

    find_slopes(functional, line, k, at->slope_u + from, at->slope_v + from);
    taut_area_functional_state(functional, line, k, state);
    const double *n = state, e = state[3], m = state[4], h = state[5];
    for (int c = 0, entry = 0; c < 3; c++) {
        for (int d = 0; d <= c; d++) {
            normal[entry++] = n[c] * n[d];
        }
        normal[6 + c] = state[6] * n[c];
    }
    if (functional->density != NULL) { /* alike in every direction, and nothing turns */
        for (int c = 0; c < TAUT_AREA_BLOCK - 1; c++) {
            normal[c] = c == 0 || c == 2 || c == 5;
        }
    }
    for (size_t p = 0; p < (size_t)local; p++) {
        at->flux_u[from + p] = h * pu[p] - m * pv[p];
        at->flux_v[from + p] = e * pv[p] - m * pu[p];
    }
}

/* Adds the points of some lines in one cell to the element, or begins it with them. */
static void add_lines(const bench *at, const taut_area_functional *functional, int line, int lines,
                      int k, int begins, double *element)
{
    const int nodes = functional->v.nodes;
    const taut_area_pairs points = {.nodes = lines * nodes,
                                    .begins = begins,
                                    .local = functional->u.local * functional->v.local,
                                    .wide = taut_area_wide(functional),
                                    .slope_u = at->slope_u,
                                    .slope_v = at->slope_v,
                                    .flux_u = at->flux_u,
                                    .flux_v = at->flux_v,
                                    .normal = at->normal};
    for (int g = 0; g < points.nodes; g++) {
        lay_point(at, functional, line + g / nodes, k + g % nodes, g);
    }
    functional->ops->pairs(&points, element);
}

/* Which net a cell is of. */
static int net_of(const taut_area_elements *elements, int cell)
{
    int net = 0;
    while (cell >= elements->first[net + 1]) {
        net++;
    }
    return net;
}

static void make_element(const taut_area_elements *elements, const bench *at, int cell,
                         double *element)
{
    const int net = net_of(elements, cell);
    const taut_area_functional *functional = elements->nets[net];
    const int across = cells_of(&functional->v), number = cell - elements->first[net];
    const int nodes = functional->u.nodes, wanted = POINTS_AT_ONCE / functional->v.nodes;
    const int at_once = wanted < 1 ? 1 : wanted < nodes ? wanted : nodes;
    const int line = number / across * nodes, k = number % across * functional->v.nodes;

    for (int g = 0; g < nodes; g += at_once) {
        const int lines = at_once < nodes - g ? at_once : nodes - g;
        add_lines(at, functional, line + g, lines, k, g == 0, element);
    }
    for (int g = 0; elements->beside != NULL && g < nodes * functional->v.nodes; g++) {
        elements->beside(elements->context, net, line + g / functional->v.nodes,
                         k + g % functional->v.nodes, element);
    }
}

static void run_task(void *context, int worker, int64_t task)
{
    taut_area_elements *elements = context;

    make_element(elements, &elements->benches[worker], elements->from + (int)task,
                 elements->made + (size_t)task * elements->each);
}

const double *taut_area_elements_next(taut_area_elements *elements)
{
    if (elements->next == elements->to) {
        const int left = elements->first[elements->count] - elements->next;
        const int batch = elements->batch < left ? elements->batch : left;
        elements->from = elements->to;
        elements->to += batch;
        taut_parallel_run(elements->workers < batch ? elements->workers : batch, batch, run_task,
                          elements);
    }
    return elements->made + (size_t)(elements->next++ - elements->from) * elements->each;
}
