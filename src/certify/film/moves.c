#include "certify/film/moves.h"

#include "certify/common/lowest.h"
#include "core/vec3.h"

#include <math.h>
#include <string.h>

enum { SHIFTS = 60 };
static const double work_of_pair = 20; /* operations of two moves at a node, roughly */

/* ---- which moves there are ---- */

static void make_unit(double x[3])
{
    const double size = taut_norm(x);
    for (int c = 0; c < 3 && size > 0; c++) {
        x[c] /= size;
    }
}

static void add_move(taut_film_moves *moves, int point, const double direction[3])
{
    if (taut_dot(direction, direction) > 0.5) { /* unit, or none */
        moves->point[moves->count] = point;
        memcpy(moves->direction + 3 * moves->count, direction, 3 * sizeof(double));
        moves->count++;
    }
}

/* The moves across a tangent, in the plane of a normal where there is one. */
static void add_across(taut_film_moves *moves, int point, const double t[3], const double *normal)
{
    const double x = fabs(t[0]), y = fabs(t[1]), z = fabs(t[2]);
    double axis[3] = {0, 0, 0}, p[3], q[3];

    if (normal != NULL) {
        taut_cross(normal, t, p);
        make_unit(p);
        add_move(moves, point, p);
        return;
    }
    axis[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1; /* least along the tangent */
    taut_cross(t, axis, p);
    make_unit(p);
    taut_cross(t, p, q);
    add_move(moves, point, p);
    add_move(moves, point, q);
}

/* All moves that leave the planes of the normals. */
static void add_free(taut_film_moves *moves, int point, double normals[3][3], int count)
{
    for (int k = 0; count < 3 && k < 3; k++) {
        double x[3] = {k == 0, k == 1, k == 2};
        for (int n = 0; n < count; n++) {
            taut_add_scaled(-taut_dot(x, normals[n]), normals[n], x);
        }
        if (taut_norm(x) > 0.5) { /* one of the axes is that far from every plane */
            make_unit(x);
            add_move(moves, point, x);
            memcpy(normals[count++], x, sizeof x);
        }
    }
}

static void add_moves(const taut_film_sheet *sheet, const double *moments, int i, int j,
                      taut_film_moves *moves)
{
    const int at = i * sheet->nv + j;
    double x[3], normals[3][3];
    int e = -1;
    const taut_film_way way = taut_film_sheet_way(sheet, i, j, &e);

    if (way == TAUT_FILM_STILL) {
        return;
    }
    const int count = taut_film_sheet_normals(sheet, i, j, normals);
    if (taut_film_sheet_has_threads(sheet->problem)) {
        add_free(moves, at, normals, count);
    } else if (way == TAUT_FILM_INSIDE) {
        memcpy(x, moments + 3 * at, sizeof x);
        make_unit(x);
        add_move(moves, at, x);
    } else if (way == TAUT_FILM_ALONG) {
        taut_film_sheet_tangent(sheet, e, e < 2 ? j : i, x);
        add_across(moves, at, x, count > 0 ? normals[0] : NULL);
    } else {
        add_free(moves, at, normals, count);
    }
}

taut_status taut_film_moves_new(const taut_film_sheet *sheet, const double *moments,
                                taut_film_moves *moves)
{
    const size_t points = (size_t)sheet->nu * (size_t)sheet->nv;

    *moves = (taut_film_moves){.count = 0};
    moves->point = taut_arena_take(sheet->arena, 3 * points, sizeof(int));
    moves->direction = taut_arena_take(sheet->arena, 3 * points, 3 * sizeof(double));
    moves->first = taut_arena_take(sheet->arena, points + 1, sizeof(int));
    if (taut_arena_status(sheet->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int i = 0; i < sheet->nu; i++) {
        for (int j = 0; j < sheet->nv; j++) {
            moves->first[i * sheet->nv + j] = moves->count;
            add_moves(sheet, moments, i, j, moves);
        }
    }
    moves->first[points] = moves->count;
    return TAUT_OK;
}

double taut_film_moves_largest(const taut_film_moves *moves, const double *gradient, int *point)
{
    double largest = 0;
    *point = 0;
    for (int k = 0; k < moves->count; k++) {
        const double size =
            fabs(taut_dot(gradient + 3 * (size_t)moves->point[k], moves->direction + 3 * k));
        if (!(size <= largest) && !isnan(largest)) {
            largest = size;
            *point = moves->point[k];
        }
    }
    return largest;
}

/* ---- matrices: rows from the first entry that is not 0 to the diagonal ---- */

typedef struct profile {
    int count;
    const int *begin; /* [count]: column of the first entry of a row */
    const size_t *at; /* [count]: row i, column j at a[at[i] + j - begin[i]] */
    size_t size;
} profile;

/* A condition beside the matrix. With g = dL along the moves, a given length asks for g . x = 0; an
 * elastic cable adds k g g^T, which is the same with a spring:
 *
 *     [ K    g   ]      has as many eigenvalues below 0 as K + k g g^T, and one more;
 *     [ g^T -1/k ]      with 0 in place of 1/k, as K where g . x = 0, and one more
 */
typedef struct condition {
    double *g, *image; /* [count]: of the moves; by the factors at hand */
    double spring;     /* 1 / k, or 0 */
} condition;

typedef struct pencil {
    profile shape;
    double *k, *m, *factor; /* [size] */
    condition conditions[4];
    int condition_count;
    double small[4][4]; /* D - G^T K^-1 G as L D L^T: below the diagonal L, on it D */
    taut_pulse *pulse;  /* once it says stop, nothing here has a meaning */
} pencil;

/* The first node behind those that see the functions of node a. */
static int end_of_run(const taut_table *table, int a)
{
    int end = a + 1;
    while (end < table->count && table->first[end] == table->first[a]) {
        end++;
    }
    return end;
}

/* The moves that are alive together begin no later than the first of them. */
static void begin_rows(const taut_film_sheet *sheet, const taut_film_moves *moves, int i, int j,
                       int *begin)
{
    const int local_v = sheet->v.table->local, count = sheet->u.table->local * local_v;
    int least = moves->count;

    for (int round = 0; round < 2; round++) {
        for (int p = 0; p < count; p++) {
            const int point = taut_film_sheet_owner(sheet, i + p / local_v, j + p % local_v);
            for (int k = moves->first[point]; k < moves->first[point + 1]; k++) {
                least = k < least ? k : least;
                begin[k] = round == 1 && least < begin[k] ? least : begin[k];
            }
        }
    }
}

static taut_status make_pencil(const taut_film_sheet *sheet, const taut_film_moves *moves,
                               pencil *p)
{
    taut_arena *arena = sheet->arena;
    const taut_table *u = sheet->u.table, *v = sheet->v.table;
    int *begin = taut_arena_take(arena, (size_t)moves->count, sizeof(int));
    size_t *at = taut_arena_take(arena, (size_t)moves->count, sizeof(size_t));

    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    p->shape = (profile){.count = moves->count, .begin = begin, .at = at};
    for (int k = 0; k < moves->count; k++) {
        begin[k] = k;
    }
    for (int a = 0; a < u->count; a = end_of_run(u, a)) {
        for (int b = 0; b < v->count; b = end_of_run(v, b)) {
            begin_rows(sheet, moves, u->first[a], v->first[b], begin);
        }
    }
    for (int k = 0; k < moves->count; k++) {
        at[k] = p->shape.size;
        p->shape.size += (size_t)(k - begin[k] + 1);
    }
    p->k = taut_arena_take(arena, p->shape.size, sizeof(double));
    p->m = taut_arena_take(arena, p->shape.size, sizeof(double));
    p->factor = taut_arena_take(arena, p->shape.size, sizeof(double));
    return taut_arena_status(arena);
}

/* Of the lower triangle: either order will do. */
static size_t entry(const profile *shape, int a, int b)
{
    const int i = a > b ? a : b, j = a > b ? b : a;
    return shape->at[i] + (size_t)(j - shape->begin[i]);
}

/* What the moves of a cell are at a node, side by side. Products that belong to one move are made once. */
typedef struct node_moves {
    double *along;           /* [count]: n . direction */
    double *value, *du, *dv; /* N, N_u, N_v */
    double *along_value;     /* along N, along N_u, along N_v */
    double *along_du, *along_dv;
    double *turned[3]; /* n x direction */
} node_moves;

enum { NODE_ARRAYS = 10, CELL_ARRAYS = 3 };

/* A cell: nodes that see the same functions, and what their moves have together, the lower triangle row by row. */
typedef struct cell {
    int u, v, end_u, end_v; /* nodes */
    int count;
    int *index, *nu, *nv; /* [count]: of the move; which functions of those alive */
    double *direction[3];
    node_moves at;
    double *k, *m; /* [count (count + 1) / 2] */
} cell;

static taut_status make_cell(const taut_film_sheet *sheet, cell *c)
{
    const size_t most = 3 * (size_t)sheet->u.table->local * (size_t)sheet->v.table->local;
    double *next = taut_arena_take_raw(sheet->arena, (NODE_ARRAYS + 3) * most, sizeof(double));
    double **arrays[NODE_ARRAYS + 3] = {
        &c->at.along,     &c->at.value,     &c->at.du,        &c->at.dv,        &c->at.along_value,
        &c->at.along_du,  &c->at.along_dv,  &c->at.turned[0], &c->at.turned[1], &c->at.turned[2],
        &c->direction[0], &c->direction[1], &c->direction[2]};

    c->index = taut_arena_take_raw(sheet->arena, CELL_ARRAYS * most, sizeof(int));
    c->k = taut_arena_take_raw(sheet->arena, most * (most + 1) / 2, sizeof(double));
    c->m = taut_arena_take_raw(sheet->arena, most * (most + 1) / 2, sizeof(double));
    if (taut_arena_status(sheet->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    c->nu = c->index + most;
    c->nv = c->nu + most;
    for (int i = 0; i < NODE_ARRAYS + 3; i++, next += most) {
        *arrays[i] = next;
    }
    return TAUT_OK;
}

static void enter_cell(const taut_film_sheet *sheet, const taut_film_moves *moves, cell *c)
{
    const taut_table *u = sheet->u.moves, *v = sheet->v.moves;

    c->count = 0;
    for (int i = 0; i < u->local; i++) {
        for (int j = 0; j < v->local; j++) {
            const int point = taut_film_sheet_owner(sheet, u->first[c->u] + i, v->first[c->v] + j);
            for (int k = moves->first[point]; k < moves->first[point + 1]; k++, c->count++) {
                c->index[c->count] = k;
                c->nu[c->count] = i;
                c->nv[c->count] = j;
                for (int x = 0; x < 3; x++) {
                    c->direction[x][c->count] = moves->direction[3 * k + x];
                }
            }
        }
    }
    const size_t pairs = (size_t)c->count * ((size_t)c->count + 1) / 2;
    memset(c->k, 0, pairs * sizeof(double));
    memset(c->m, 0, pairs * sizeof(double));
}

/* What the moves are at node (a, b). */
static void enter_node(const taut_film_sheet *sheet, int a, int b, const double n[3], cell *c)
{
    const double *nu = taut_table_row(sheet->u.moves, a, 0),
                 *du = taut_table_row(sheet->u.moves, a, 1);
    const double *nv = taut_table_row(sheet->v.moves, b, 0),
                 *dv = taut_table_row(sheet->v.moves, b, 1);
    node_moves *at = &c->at;

    for (int x = 0; x < c->count; x++) {
        const double way[3] = {c->direction[0][x], c->direction[1][x], c->direction[2][x]};
        double turned[3];
        at->value[x] = nu[c->nu[x]] * nv[c->nv[x]];
        at->du[x] = du[c->nu[x]] * nv[c->nv[x]];
        at->dv[x] = nu[c->nu[x]] * dv[c->nv[x]];
        at->along[x] = taut_dot(n, way);
        at->along_value[x] = at->along[x] * at->value[x];
        at->along_du[x] = at->along[x] * at->du[x];
        at->along_dv[x] = at->along[x] * at->dv[x];
        taut_cross(n, way, turned);
        for (int i = 0; i < 3; i++) {
            at->turned[i][x] = turned[i];
        }
    }
}

/* Adds a node of threads: alike in every direction. */
static void add_threads(cell *c, const taut_film_place *place, const double threads[2])
{
    const node_moves *at = &c->at;
    double *k = c->k, *m = c->m;

    for (int x = 0; x < c->count; k += x + 1, m += x + 1, x++) {
        const double moves = place->weight * place->w * at->along_value[x];
        const double du = place->weight * threads[0] * at->du[x],
                     dv = place->weight * threads[1] * at->dv[x];
        for (int y = 0; y <= x; y++) {
            k[y] +=
                (c->direction[0][x] * c->direction[0][y] + c->direction[1][x] * c->direction[1][y] +
                 c->direction[2][x] * c->direction[2][y]) *
                (du * at->du[y] + dv * at->dv[y]);
            m[y] += moves * at->along_value[y];
        }
    }
}

/* k[y] += (p . along)(y) + det(x, y, n) (turn . (N_v, -N_u))(y), m[y] += mass (along N)(y): a loop
 * that a compiler makes of vectors. */
static void add_row(int count, const double p[2], const double turn[2], const double turned[3],
                    double mass, const double *restrict along_value,
                    const double *restrict along_du, const double *restrict along_dv,
                    const double *restrict du, const double *restrict dv, const double *restrict d0,
                    const double *restrict d1, const double *restrict d2, double *restrict k,
                    double *restrict m)
{
    const double pu = p[0], pv = p[1], tu = turn[0], tv = turn[1];
    const double t0 = turned[0], t1 = turned[1], t2 = turned[2];

    for (int y = 0; y < count; y++) {
        k[y] += pu * along_du[y] + pv * along_dv[y] +
                (t0 * d0[y] + t1 * d1[y] + t2 * d2[y]) * (tu * dv[y] - tv * du[y]);
        m[y] += mass * along_value[y];
    }
}

/* Adds a node of a film of one tension. */
static void add_place(cell *c, const taut_film_place *place)
{
    const node_moves *at = &c->at;
    const double e = place->weight * place->e / place->w, f = place->weight * place->f / place->w,
                 g = place->weight * place->g / place->w, mass = place->weight * place->w;
    double *k = c->k, *m = c->m;

    for (int x = 0; x < c->count; k += x + 1, m += x + 1, x++) {
        const double along[2] = {g * at->along_du[x] - f * at->along_dv[x],
                                 e * at->along_dv[x] - f * at->along_du[x]};
        const double turn[2] = {place->weight * at->du[x], place->weight * at->dv[x]};
        const double turned[3] = {at->turned[0][x], at->turned[1][x], at->turned[2][x]};
        add_row(x + 1, along, turn, turned, mass * at->along_value[x], at->along_value,
                at->along_du, at->along_dv, at->du, at->dv, c->direction[0], c->direction[1],
                c->direction[2], k, m);
    }
}

static void leave_cell(const cell *c, pencil *p)
{
    const double *k = c->k, *m = c->m;

    for (int x = 0; x < c->count; x++) {
        for (int y = 0; y <= x; y++, k++, m++) {
            const int a = c->index[x], b = c->index[y];
            const size_t at = entry(&p->shape, a, b);
            const double times = x != y && a == b ? 2 : 1; /* of a pole */
            p->k[at] += times * *k;
            p->m[at] += times * *m;
        }
    }
}

static void add_cell(const taut_film_sheet *sheet, const taut_film_moves *moves, cell *c, pencil *p)
{
    enter_cell(sheet, moves, c);
    for (int a = c->u; a < c->end_u; a++) {
        taut_film_sheet_line(sheet, a);
        for (int b = c->v; b < c->end_v; b++) {
            taut_film_place place;
            double n[3];
            taut_film_sheet_place(sheet, a, b, &place);
            for (int x = 0; x < 3; x++) {
                n[x] = place.normal[x] / place.w;
            }
            enter_node(sheet, a, b, n, c);
            if (taut_film_sheet_has_threads(sheet->problem)) {
                double threads[2];
                taut_film_sheet_threads(sheet, sheet->u.at[a], sheet->v.at[b], threads);
                add_threads(c, &place, threads);
            } else {
                add_place(c, &place);
            }
        }
    }
    leave_cell(c, p);
}

/* What moves k and o of a line weigh together at a node: functions x and y there. */
static void add_line_pair(const taut_film_sheet *sheet, int e, int node, const double t[3],
                          double speed, double size, const taut_film_moves *moves, int x, int k,
                          int y, int o, pencil *p)
{
    const taut_film_nodes *nodes = e < 2 ? &sheet->v : &sheet->u;
    const double *n = taut_table_row(nodes->moves, node, 0);
    const double *slope = taut_table_row(nodes->moves, node, 1), weight = nodes->weights[node];
    const double *s = moves->direction + 3 * k, *d = moves->direction + 3 * o;
    const double across = taut_dot(s, d) - taut_dot(s, t) * taut_dot(d, t);
    const size_t at = entry(&p->shape, k, o);

    p->k[at] += sheet->ratios[e] * weight / speed * slope[x] * slope[y] * across;
    p->m[at] += size * weight * speed * n[x] * n[y] * across;
}

/* Across the cable or the slide of edge e. */
static void add_line(const taut_film_sheet *sheet, const taut_film_moves *moves, int e, double size,
                     pencil *p)
{
    const taut_film_nodes *nodes = e < 2 ? &sheet->v : &sheet->u;
    const taut_table *table = nodes->moves;

    for (int node = 0; node < table->count; node++) {
        double t[3];
        taut_film_sheet_slope(sheet, e, node, t);
        const double speed = taut_length(t);
        for (int c = 0; c < 3; c++) {
            t[c] /= speed;
        }
        for (int x = 0; x < table->local; x++) {
            const int px = taut_film_sheet_on_edge(sheet, e, table->first[node] + x);
            for (int y = 0; y <= x; y++) {
                const int py = taut_film_sheet_on_edge(sheet, e, table->first[node] + y);
                for (int k = moves->first[px]; k < moves->first[px + 1]; k++) {
                    const int end = y == x ? k + 1 : moves->first[py + 1];
                    for (int o = moves->first[py]; o < end; o++) {
                        add_line_pair(sheet, e, node, t, speed, size, moves, x, k, y, o, p);
                    }
                }
            }
        }
    }
}

/* What cable e asks for, if it is one that gives way. */
static taut_status add_condition(const taut_film_sheet *sheet, const taut_film_moves *moves, int e,
                                 pencil *p)
{
    const taut_film_law law = sheet->problem->edges[e].law;
    const int count = e < 2 ? sheet->nv : sheet->nu;

    if (law == TAUT_FILM_FORCE) {
        return TAUT_OK;
    }
    double *pull = taut_arena_take(sheet->arena, (size_t)count, 3 * sizeof(double));
    condition *c = &p->conditions[p->condition_count++];
    c->g = taut_arena_take(sheet->arena, (size_t)moves->count, sizeof(double));
    c->image = taut_arena_take(sheet->arena, (size_t)moves->count, sizeof(double));
    c->spring = law == TAUT_FILM_ELASTIC ? 1 / sheet->stiffness[e] : 0;
    if (taut_arena_status(sheet->arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_film_sheet_pull(sheet, e, pull);
    for (int i = 0; i < count; i++) {
        const int at = taut_film_sheet_on_edge(sheet, e, i);
        for (int k = moves->first[at]; k < moves->first[at + 1]; k++) {
            c->g[k] += taut_dot(pull + 3 * i, moves->direction + 3 * k);
        }
    }
    return TAUT_OK;
}

static taut_status fill_pencil(const taut_film_sheet *sheet, const taut_film_moves *moves,
                               double size, int with_lines, pencil *p)
{
    const taut_table *u = sheet->u.moves, *v = sheet->v.moves;
    cell c;

    if (make_cell(sheet, &c) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (c.u = 0; c.u < u->count; c.u = c.end_u) {
        c.end_u = end_of_run(u, c.u);
        for (c.v = 0; c.v < v->count; c.v = c.end_v) {
            c.end_v = end_of_run(v, c.v);
            add_cell(sheet, moves, &c, p);
            if (taut_pulse_beat(p->pulse, work_of_pair * c.count * c.count *
                                              ((c.end_u - c.u) * (c.end_v - c.v)))) {
                return TAUT_INTERRUPTED;
            }
        }
    }
    if (!with_lines) {
        return TAUT_OK;
    }
    for (int e = 0; e < 4; e++) {
        if (sheet->problem->edges[e].kind == TAUT_FILM_SLIDE) {
            add_line(sheet, moves, e, size, p);
        }
        if (taut_film_sheet_is_cable(sheet, e)) {
            add_line(sheet, moves, e, size, p);
            if (add_condition(sheet, moves, e, p) != TAUT_OK) {
                return TAUT_NO_MEMORY;
            }
        }
    }
    return TAUT_OK;
}

/* ---- eigenvalues ---- */

/* factor = the factors L D L^T of K - shift M; how many of D are not above 0: as many eigenvalues
 * are not above the shift (Sylvester). */
static int factor_profile(pencil *p, double shift)
{
    const profile *s = &p->shape;
    int below = 0;

    for (size_t k = 0; k < s->size; k++) {
        p->factor[k] = p->k[k] - shift * p->m[k];
    }
    for (int i = 0; i < s->count; i++) {
        double *row = p->factor + s->at[i];
        for (int j = s->begin[i]; j < i; j++) { /* row holds L D until its end */
            const double *other = p->factor + s->at[j];
            const int from = s->begin[j] > s->begin[i] ? s->begin[j] : s->begin[i];
            double sum = row[j - s->begin[i]];
            for (int k = from; k < j; k++) {
                sum -= row[k - s->begin[i]] * other[k - s->begin[j]];
            }
            row[j - s->begin[i]] = sum;
        }
        double pivot = row[i - s->begin[i]];
        for (int j = s->begin[i]; j < i; j++) {
            const double d = p->factor[entry(s, j, j)], product = row[j - s->begin[i]];
            row[j - s->begin[i]] = product / d;
            pivot -= product * (product / d);
        }
        row[i - s->begin[i]] = pivot;
        below += !(pivot > 0);
        const double length = i - s->begin[i];
        if (taut_pulse_beat(p->pulse, length * length)) {
            return 0;
        }
    }
    return below;
}

static void solve_profile(const pencil *p, double *x)
{
    const profile *s = &p->shape;
    for (int i = 0; i < s->count; i++) {
        const double *row = p->factor + s->at[i];
        for (int j = s->begin[i]; j < i; j++) {
            x[i] -= row[j - s->begin[i]] * x[j];
        }
    }
    for (int i = 0; i < s->count; i++) {
        x[i] /= p->factor[entry(s, i, i)];
    }
    for (int i = s->count - 1; i >= 0; i--) {
        const double *row = p->factor + s->at[i];
        for (int j = s->begin[i]; j < i; j++) {
            x[j] -= row[j - s->begin[i]] * x[i];
        }
    }
}

static void multiply(const profile *s, const double *a, const double *x, double *y)
{
    memset(y, 0, (size_t)s->count * sizeof(double));
    for (int i = 0; i < s->count; i++) {
        const double *row = a + s->at[i];
        double sum = 0;
        for (int j = s->begin[i]; j < i; j++) {
            sum += row[j - s->begin[i]] * x[j];
            y[j] += row[j - s->begin[i]] * x[i];
        }
        y[i] = sum + row[i - s->begin[i]] * x[i]; /* rows before give nothing to this one */
    }
}

static double dot(int n, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

/* D - G^T (K - shift M)^-1 G; how many of its eigenvalues are not above 0. */
static int factor_conditions(pencil *p)
{
    const int n = p->condition_count;
    int below = 0;

    for (int i = 0; i < n; i++) {
        condition *c = &p->conditions[i];
        memcpy(c->image, c->g, (size_t)p->shape.count * sizeof(double));
        solve_profile(p, c->image);
        for (int j = 0; j <= i; j++) {
            p->small[i][j] =
                (i == j ? -c->spring : 0) - dot(p->shape.count, p->conditions[j].g, c->image);
        }
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = p->small[i][j];
            for (int k = 0; k < j; k++) {
                sum -= p->small[i][k] * p->small[j][k] * p->small[k][k];
            }
            p->small[i][j] = i == j ? sum : sum / p->small[j][j];
        }
        below += !(p->small[i][i] > 0);
    }
    return below;
}

/* How many eigenvalues of K - shift M are not above 0 where the conditions hold. */
static int factorise(pencil *p, double shift)
{
    const int below = factor_profile(p, shift);
    return below + factor_conditions(p) - p->condition_count;
}

/* x = the solution of K x + G y = x, G^T x - spring y = 0. */
static void solve(const pencil *p, double *x)
{
    const int n = p->condition_count;
    double y[4];

    solve_profile(p, x);
    for (int i = 0; i < n; i++) { /* (D - G^T K^-1 G) y = - G^T K^-1 x */
        y[i] = -dot(p->shape.count, p->conditions[i].g, x);
        for (int k = 0; k < i; k++) {
            y[i] -= p->small[i][k] * y[k];
        }
    }
    for (int i = 0; i < n; i++) {
        y[i] /= p->small[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) {
            y[i] -= p->small[k][i] * y[k];
        }
        for (int k = 0; k < p->shape.count; k++) {
            x[k] -= y[i] * p->conditions[i].image[k];
        }
    }
}

/* y = K x, springs too. */
static void multiply_stiff(const pencil *p, const double *x, double *y)
{
    multiply(&p->shape, p->k, x, y);
    for (int i = 0; i < p->condition_count; i++) {
        const condition *c = &p->conditions[i];
        const double along = c->spring > 0 ? dot(p->shape.count, c->g, x) / c->spring : 0;
        for (int k = 0; k < p->shape.count; k++) {
            y[k] += along * c->g[k];
        }
    }
}

static void solve_of(const void *of, double *x)
{
    solve(of, x);
}

static void weigh_of(const void *of, const double *x, double *y)
{
    const pencil *p = of;
    multiply(&p->shape, p->m, x, y);
}

taut_status taut_film_moves_lowest(const taut_film_sheet *sheet, const taut_film_moves *moves,
                                   double size, double limit, taut_pulse *pulse, double *lowest,
                                   int *below)
{
    pencil p = {.pulse = pulse};
    double shift = limit;

    *below = -1;
    if (moves->count == 0) {
        return TAUT_NOT_CONVERGED;
    }
    double *x = taut_arena_take(sheet->arena, (size_t)moves->count, sizeof(double));
    double *y = taut_arena_take(sheet->arena, (size_t)moves->count, sizeof(double));
    if (taut_arena_status(sheet->arena) != TAUT_OK || make_pencil(sheet, moves, &p) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    taut_status status = fill_pencil(sheet, moves, size, 1, &p);
    if (status != TAUT_OK) {
        return status;
    }
    const int found = factorise(&p, limit);
    for (int k = 0, under = found; under > 0 && !taut_pulse_is_stopped(pulse); k++) {
        if (k == SHIFTS) {
            return TAUT_NOT_CONVERGED;
        }
        shift = k == 0 ? -1 : 2 * shift;
        under = factorise(&p, shift);
    }
    if (taut_pulse_is_stopped(pulse)) {
        return TAUT_INTERRUPTED;
    }
    const taut_lowest form = {.count = p.shape.count,
                              .of = &p,
                              .solve = solve_of,
                              .weigh = weigh_of,
                              .work = 8.0 * (double)p.shape.size};
    status = taut_certify_lowest(&form, sheet->arena, pulse, x);
    if (status == TAUT_OK) {
        multiply_stiff(&p, x, y);
        *lowest = dot(p.shape.count, x, y); /* x is of unit mass */
        status = isfinite(*lowest) ? TAUT_OK : TAUT_NOT_CONVERGED;
    }
    *below = status == TAUT_OK ? found : -1;
    return status;
}

taut_status taut_film_moves_bound(const taut_film_sheet *sheet, const taut_film_moves *moves,
                                  const double *gradient, taut_pulse *pulse, double *gain)
{
    pencil p = {.pulse = pulse};
    double *x = taut_arena_take(sheet->arena, (size_t)moves->count, sizeof(double));

    if (x == NULL || make_pencil(sheet, moves, &p) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    const taut_status status = fill_pencil(sheet, moves, 1, 0, &p);
    if (status != TAUT_OK) {
        return status;
    }
    const int below = factor_profile(&p, 0);
    if (taut_pulse_is_stopped(pulse)) {
        return TAUT_INTERRUPTED;
    }
    if (below > 0) {
        return TAUT_NOT_CONVERGED;
    }
    double sum = 0;
    for (int k = 0; k < moves->count; k++) {
        x[k] = taut_dot(gradient + 3 * (size_t)moves->point[k], moves->direction + 3 * k);
    }
    solve_profile(&p, x);
    for (int k = 0; k < moves->count; k++) {
        sum += x[k] * taut_dot(gradient + 3 * (size_t)moves->point[k], moves->direction + 3 * k);
    }
    *gain = 0.5 * sum;
    return TAUT_OK;
}
