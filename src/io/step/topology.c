/* topology.c -- shells as ISO 10303-42 has them: each vertex and each edge once, whatever shares it.
 *
 *     vertex    on a control point of a surface
 *     edge      a spline on the control points of its first face; for each use a curve in that
 *               face's parameters, a straight one
 *     face      one loop, the inside on the left; what is one point is left out of it, as readers
 *               expect; all of it one point: that vertex
 *     form      a disc, cylinder or torus (elementary.h) has no curves in its parameters; a plane has no seam
 *               either, and a loop for each of its rings
 *     shell     with a volume a MANIFOLD_SOLID_BREP, turned outwards; that of a hollow within another, a
 *               BREP_WITH_VOIDS; else in a surface model
 */
#include "core/fail.h"
#include "io/step/elementary.h"
#include "io/step/entities.h"
#include "mesh/colour.h"
#include "shell/shell.h"

/* Numbers of instances, by face, edge and vertex. */
typedef struct placing {
    taut_part21 *out;
    const taut_model *model;
    const taut_shells *shells;
    const taut_step_spaces *spaces;
    const taut_step_form *forms;       /* [faces] */
    const int *outside;                /* [faces]; see entities.h */
    size_t *points, *surfaces, *faces; /* [faces]; points: the first of each net */
    size_t *edges, *vertices;
} placing;

static const taut_basis *basis_along(const taut_surface *surface, int edge)
{
    return edge % 4 < 2 ? taut_surface_v(surface) : taut_surface_u(surface);
}

/* The parameters at t along edge 4 f + e. */
static size_t put_parameters(const placing *p, int edge, double t)
{
    const taut_surface *surface = taut_model_surface(p->model, edge / 4);
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    const double at[2] = {edge % 4 == TAUT_EDGE_U0   ? taut_basis_lo(u)
                          : edge % 4 == TAUT_EDGE_U1 ? taut_basis_hi(u)
                                                     : t,
                          edge % 4 == TAUT_EDGE_V0   ? taut_basis_lo(v)
                          : edge % 4 == TAUT_EDGE_V1 ? taut_basis_hi(v)
                                                     : t};
    return TAUT_NEW(p->out, "CARTESIAN_POINT('',%)", TAUT_REALS(2, at, 1));
}

/* The edge in the parameters of the face of `side`: at the curve's own parameter where it is that of
 * the face, else by the affine map. */
static size_t put_trace(const placing *p, const taut_shell_edge *edge, int side)
{
    const taut_basis *own =
        basis_along(taut_model_surface(p->model, edge->side[0] / 4), edge->side[0]);
    const taut_basis *here = basis_along(taut_model_surface(p->model, side / 4), side);
    const double lo = taut_basis_lo(own), hi = taut_basis_hi(own);
    const double begin = taut_basis_lo(here), end = taut_basis_hi(here);
    const int against = side == edge->side[1] && edge->reversed;
    size_t line = 0;

    if (begin == lo && end == hi && !against) {
        const size_t from = put_parameters(p, side, 0);
        line = TAUT_NEW(p->out, "LINE('',%,%)", TAUT_REF(from),
                        TAUT_REF(p->spaces->along[side % 4 < 2]));
    } else {
        const double knots[4] = {lo, lo, hi, hi};
        const size_t from = put_parameters(p, side, against ? end : begin);
        const size_t to = put_parameters(p, side, against ? begin : end);
        line = TAUT_NEW(
            p->out, "B_SPLINE_CURVE_WITH_KNOTS('',1,(%,%),.UNSPECIFIED.,.F.,.F.,%,%,.UNSPECIFIED.)",
            TAUT_REF(from), TAUT_REF(to), TAUT_TIMES(4, knots), TAUT_KNOTS(4, knots));
    }
    const size_t whole = TAUT_NEW(p->out, "DEFINITIONAL_REPRESENTATION('',(%),%)", TAUT_REF(line),
                                  TAUT_REF(p->spaces->plane));
    return TAUT_NEW(p->out, "PCURVE('',%,%)", TAUT_REF(p->surfaces[side / 4]), TAUT_REF(whole));
}

/* Does the way round the unturned face of a side go along the edge's curve? */
static int is_along(const taut_shell_edge *edge, int side)
{
    return taut_shell_is_along(side) != (side == edge->side[1] && edge->reversed);
}

static int is_form(const placing *p, int face)
{
    return p->forms[face].kind != TAUT_STEP_SPLINE;
}

/* Is a side of an edge the seam of a plane, which no file shows? */
static int is_hidden(const placing *p, int side)
{
    const taut_step_form *form = &p->forms[side / 4];
    return form->kind == TAUT_STEP_PLANE && !taut_step_is_ring(form, side % 4);
}

/* The curve of an edge: a circle or a line where all its faces are forms, else a spline. */
static size_t put_curve_of(const placing *p, const taut_shell_edge *edge)
{
    const int face = edge->side[0] / 4, e = edge->side[0] % 4;
    const taut_surface *surface = taut_model_surface(p->model, face);
    if (is_form(p, face) && (edge->side[1] < 0 || is_form(p, edge->side[1] / 4))) {
        return taut_step_put_form_edge(p->out, &p->forms[face], surface, e);
    }
    return taut_step_put_edge(p->out, surface, p->points[face], e);
}

static size_t put_edge(const placing *p, const taut_shell_edge *edge)
{
    const int face = edge->side[0] / 4, uses = edge->side[1] >= 0 ? 2 : 1;
    const int is_seam = uses == 2 && edge->side[1] / 4 == face;
    /* of a seam the use along the curve is told first */
    const int first = is_seam && !is_along(edge, edge->side[0]);
    size_t curve = put_curve_of(p, edge), traces[2] = {0, 0}, count = 0;
    for (int k = 0; k < uses; k++) {
        const int side = edge->side[first ? 1 - k : k];
        if (!is_form(p, side / 4)) {
            traces[count++] = put_trace(p, edge, side);
        }
    }
    if (count > 0) {
        curve = TAUT_NEW(p->out, "%('',%,%,.CURVE_3D.)",
                         TAUT_WORD(is_seam ? "SEAM_CURVE" : "SURFACE_CURVE"), TAUT_REF(curve),
                         TAUT_REFS(count, traces));
    }
    return TAUT_NEW(p->out, "EDGE_CURVE('',%,%,%,.T.)", TAUT_REF(p->vertices[edge->vertex[0]]),
                    TAUT_REF(p->vertices[edge->vertex[1]]), TAUT_REF(curve));
}

static size_t put_vertex(const placing *p, int corner)
{
    const taut_surface *surface = taut_model_surface(p->model, corner / 4);
    const size_t nu = (size_t)taut_basis_count(taut_surface_u(surface));
    const size_t nv = (size_t)taut_basis_count(taut_surface_v(surface));
    const size_t at = (corner % 4 >= 2 ? (nu - 1) * nv : 0) + (corner % 2 == 1 ? nv - 1 : 0);
    const size_t point = is_form(p, corner / 4)
                             ? TAUT_NEW(p->out, "CARTESIAN_POINT('',%)",
                                        TAUT_REALS(3, taut_surface_points(surface) + 3 * at, 1))
                             : p->points[corner / 4] + at;
    return TAUT_NEW(p->out, "VERTEX_POINT('',%)", TAUT_REF(point));
}

/* The use of edge e by a face, going round with the inside on the left. */
static size_t put_use(const placing *p, int face, int e)
{
    const taut_shell_face *f = &p->shells->faces[face];
    const int along = is_along(&p->shells->edges[f->edge[e]], 4 * face + e);
    return TAUT_NEW(p->out, "ORIENTED_EDGE('',*,*,%,%)", TAUT_REF(p->edges[f->edge[e]]),
                    TAUT_TRUTH(along != f->turned));
}

static size_t put_loop(const placing *p, int face)
{
    static const int round[4] = {TAUT_EDGE_V0, TAUT_EDGE_U1, TAUT_EDGE_V1, TAUT_EDGE_U0};
    const taut_shell_face *f = &p->shells->faces[face];
    size_t uses[4] = {0}, count = 0;
    for (int k = 0; k < 4; k++) {
        const int e = round[f->turned ? 3 - k : k];
        if (f->edge[e] >= 0) {
            uses[count++] = put_use(p, face, e);
        }
    }
    return count > 0 ? TAUT_NEW(p->out, "EDGE_LOOP('',%)", TAUT_REFS(count, uses))
                     : TAUT_NEW(p->out, "VERTEX_LOOP('',%)", TAUT_REF(p->vertices[f->pole]));
}

/* The rings of a plane, each a loop; the wider one is outside. */
static size_t put_rings(const placing *p, int face, size_t bounds[2])
{
    const taut_step_form *form = &p->forms[face];
    size_t count = 0;
    for (int end = 0; end < 2; end++) {
        const int e = 2 * (form->around == 0) + end;
        if (p->shells->faces[face].edge[e] >= 0) {
            const int outer = form->rings[end].radius > form->rings[1 - end].radius;
            const size_t use = put_use(p, face, e);
            const size_t loop = TAUT_NEW(p->out, "EDGE_LOOP('',(%))", TAUT_REF(use));
            bounds[count++] =
                TAUT_NEW(p->out, "%('',%,.T.)",
                         TAUT_WORD(outer ? "FACE_OUTER_BOUND" : "FACE_BOUND"), TAUT_REF(loop));
        }
    }
    return count;
}

static size_t put_face(const placing *p, int face)
{
    const int against = p->forms[face].inwards; /* 0 of a spline */
    size_t bounds[2] = {0, 0}, count = 1;
    if (p->forms[face].kind == TAUT_STEP_PLANE) {
        count = put_rings(p, face, bounds);
    } else {
        const size_t loop = put_loop(p, face);
        bounds[0] = TAUT_NEW(p->out, "FACE_OUTER_BOUND('',%,.T.)", TAUT_REF(loop));
    }
    return TAUT_NEW(p->out, "ADVANCED_FACE(%,%,%,%)",
                    TAUT_TEXT(taut_surface_name(taut_model_surface(p->model, face))),
                    TAUT_REFS(count, bounds), TAUT_REF(p->surfaces[face]),
                    TAUT_TRUTH(p->shells->faces[face].turned == against));
}

/* The vertices and edges that are seen: all but the seams of planes, and what only these come to. */
static void put_edges(placing *p)
{
    const taut_shells *shells = p->shells;
    for (int e = 0; e < shells->edge_count; e++) {
        const taut_shell_edge *edge = &shells->edges[e];
        for (int end = 0; end < 2 && !is_hidden(p, edge->side[0]); end++) {
            size_t *vertex = &p->vertices[edge->vertex[end]];
            *vertex = *vertex != 0 ? *vertex : put_vertex(p, shells->vertices[edge->vertex[end]]);
        }
    }
    for (int f = 0; f < shells->face_count; f++) {
        const int pole = shells->faces[f].pole;
        if (pole >= 0 && !is_form(p, f) && p->vertices[pole] == 0) {
            p->vertices[pole] = put_vertex(p, shells->vertices[pole]);
        }
    }
    for (int e = 0; e < shells->edge_count; e++) {
        if (!is_hidden(p, shells->edges[e].side[0])) {
            p->edges[e] = put_edge(p, &shells->edges[e]);
        }
    }
}

static size_t put_faces_of(const placing *p, const taut_shell *shell, size_t *list)
{
    for (int k = 0; k < shell->face_count; k++) {
        list[k] = p->faces[shell->faces[k]];
    }
    return TAUT_NEW(p->out, "%('',%)", TAUT_WORD(shell->closed ? "CLOSED_SHELL" : "OPEN_SHELL"),
                    TAUT_REFS((size_t)shell->face_count, list));
}

/* The shell of a hollow within this one, or -1. */
static int hollow_of(const placing *p, int shell)
{
    int f = 0;
    while (f < p->shells->face_count &&
           !(p->outside[f] >= 0 && p->shells->faces[p->outside[f]].shell == shell)) {
        f++;
    }
    return f < p->shells->face_count ? p->shells->faces[f].shell : -1;
}

/* A body with a hollow, whose shell looks out of the material when it is turned. */
static size_t put_hollow(const placing *p, const char *name, size_t outer, const taut_shell *inner,
                         size_t *list)
{
    const size_t made = put_faces_of(p, inner, list);
    const size_t against = TAUT_NEW(p->out, "ORIENTED_CLOSED_SHELL('',*,%,.F.)", TAUT_REF(made));
    return TAUT_NEW(p->out, "BREP_WITH_VOIDS(%,%,(%))", TAUT_TEXT(name), TAUT_REF(outer),
                    TAUT_REF(against));
}

/* A shell's item; a body that is one face bears its name. `list` is room for its faces. */
static void put_shell(const placing *p, int s, size_t *list, taut_step_content *content)
{
    const taut_shell *shell = &p->shells->shells[s];
    if (p->outside[shell->faces[0]] >= 0) {
        return; /* with its outside */
    }
    const int hollow = hollow_of(p, s);
    const int kind = shell->solid ? TAUT_STEP_SOLIDS : TAUT_STEP_SHELLS;
    const char *name = shell->face_count == 1
                           ? taut_surface_name(taut_model_surface(p->model, shell->faces[0]))
                           : "";
    const size_t made = put_faces_of(p, shell, list);
    content->items[kind][++content->counts[kind]] =
        hollow >= 0 ? put_hollow(p, name, made, &p->shells->shells[hollow], list)
        : shell->solid
            ? TAUT_NEW(p->out, "MANIFOLD_SOLID_BREP(%,%)", TAUT_TEXT(name), TAUT_REF(made))
            : TAUT_NEW(p->out, "SHELL_BASED_SURFACE_MODEL(%,(%))", TAUT_TEXT(name), TAUT_REF(made));
}

taut_status taut_step_put_faces(taut_part21 *out, const taut_model *model,
                                const taut_shells *shells, const taut_step_form *forms,
                                const int *outside, const taut_step_spaces *spaces,
                                taut_arena *arena, taut_step_content *content)
{
    const size_t count = (size_t)shells->face_count;
    placing p = {.out = out,
                 .model = model,
                 .shells = shells,
                 .forms = forms,
                 .outside = outside,
                 .spaces = spaces};
    size_t styles[TAUT_STEP_COLOURS] = {0};

    p.points = taut_arena_take(arena, count, sizeof *p.points);
    p.surfaces = taut_arena_take(arena, count, sizeof *p.surfaces);
    p.faces = taut_arena_take(arena, count, sizeof *p.faces);
    p.edges = taut_arena_take(arena, (size_t)shells->edge_count, sizeof *p.edges);
    p.vertices = taut_arena_take(arena, (size_t)shells->vertex_count, sizeof *p.vertices);
    size_t *list = taut_arena_take(arena, count, sizeof *list);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int f = 0; f < shells->face_count; f++) {
        p.surfaces[f] =
            is_form(&p, f) ? taut_step_put_form(out, &forms[f])
                           : taut_step_put_surface(out, taut_model_surface(model, f), &p.points[f]);
    }
    put_edges(&p);
    for (int f = 0; f < shells->face_count; f++) {
        p.faces[f] = put_face(&p, f);
        content->styles[content->style_count++] =
            taut_step_style_face(out, p.faces[f], taut_colour_of_surface(model, f), styles);
    }
    for (int s = 0; s < shells->shell_count; s++) {
        put_shell(&p, s, list, content);
    }
    return TAUT_OK;
}
