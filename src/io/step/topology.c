/* topology.c -- shells as ISO 10303-42 has them: each vertex and each edge once, whatever shares it.
 *
 *     vertex    on a control point of a surface
 *     edge      a spline on the control points of its first face; for each use a curve in that
 *               face's parameters, a straight one
 *     pieces    of faces and of edges (cuts.h): each as a face or an edge of its own
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

/* Numbers of instances. Of a face in pieces (cuts.h), piece (i, j) of nu x nv, from lines (i, j) on, is the (i nv + j)-th. */
typedef struct placing {
    taut_part21 *out;
    const taut_model *model;
    const taut_shells *shells;
    const taut_step_spaces *spaces;
    const taut_step_form *forms; /* [faces] */
    const taut_step_cuts *cuts;  /* [faces] */
    const int *outside;          /* [faces]; see entities.h */
    size_t *points;              /* [faces]: the first of each net */
    size_t *vertices;
    size_t *first_piece, *surfaces, *faces; /* of each face; of each piece */
    size_t *first_edge, *edges,
        *joints; /* of each edge; of each piece, and the vertex at its end, but for the last */
    size_t *first_inside,
        *inside;  /* of each face; vertices, edges along v, edges along u between its pieces */
    size_t *uses; /* room for those of a loop */
} placing;

static const taut_basis *basis_of(const taut_surface *surface, int d)
{
    return d == 0 ? taut_surface_u(surface) : taut_surface_v(surface);
}

/* The last control point of direction d. */
static int last_of(const taut_surface *surface, int d)
{
    return taut_basis_count(basis_of(surface, d)) - 1;
}

/* The direction that edge 4 f + e runs along. */
static int along_of(int edge)
{
    return edge % 4 < 2;
}

static size_t pieces_of(const placing *p, int face, int d)
{
    return (size_t)taut_step_pieces(&p->cuts[face], d);
}

static size_t edge_pieces(const placing *p, const taut_shell_edge *edge)
{
    size_t pieces = 1;
    for (int i = 0; i < 2 && edge->side[i] >= 0; i++) {
        const size_t own = pieces_of(p, edge->side[i] / 4, along_of(edge->side[i]));
        pieces = own > pieces ? own : pieces;
    }
    return pieces;
}

/* Is this the side against which the edge's curve runs? */
static int is_against(const taut_shell_edge *edge, int side)
{
    return side == edge->side[1] && edge->reversed;
}

/* The piece of a face, at the k-th piece of its side along its own parameter. */
static size_t piece_at(const placing *p, int side, size_t k)
{
    const int face = side / 4, high = side % 2;
    const size_t nu = pieces_of(p, face, 0), nv = pieces_of(p, face, 1);
    return p->first_piece[face] +
           (along_of(side) == 1 ? (high ? nu - 1 : 0) * nv + k : k * nv + (high ? nv - 1 : 0));
}

/* Control points of the k-th of `pieces` of direction d. */
static taut_step_range range_of(const placing *p, int face, int d, size_t pieces, size_t k)
{
    return pieces == 1
               ? (taut_step_range){0, last_of(taut_model_surface(p->model, face), d)}
               : (taut_step_range){p->cuts[face].lines[d][k], p->cuts[face].lines[d][k + 1]};
}

static void parameters_of(const taut_basis *basis, taut_step_range range, double ends[2])
{
    ends[0] = taut_step_parameter(basis, range.from);
    ends[1] = taut_step_parameter(basis, range.to);
}

/* The parameters at t along direction d, at `other` across it. */
static size_t put_parameters(const placing *p, int d, double other, double t)
{
    const double at[2] = {d == 0 ? t : other, d == 0 ? other : t};
    return TAUT_NEW(p->out, "CARTESIAN_POINT('',%)", TAUT_REALS(2, at, 1));
}

/* A curve on [own] in the parameters of a surface, along d from ends[0] to ends[1]: at its own parameter where
 * it is that of the surface, else by the affine map. */
static size_t put_trace(const placing *p, size_t surface, int d, double other, const double own[2],
                        const double ends[2])
{
    size_t line = 0;
    if (ends[0] == own[0] && ends[1] == own[1]) {
        const size_t from = put_parameters(p, d, other, 0);
        line = TAUT_NEW(p->out, "LINE('',%,%)", TAUT_REF(from), TAUT_REF(p->spaces->along[d]));
    } else {
        const size_t from = put_parameters(p, d, other, ends[0]);
        const size_t to = put_parameters(p, d, other, ends[1]);
        line = TAUT_NEW(
            p->out, "B_SPLINE_CURVE_WITH_KNOTS('',1,(%,%),.UNSPECIFIED.,.F.,.F.,%,%,.UNSPECIFIED.)",
            TAUT_REF(from), TAUT_REF(to), TAUT_TIMES(2, own), TAUT_KNOTS(2, own));
    }
    const size_t whole = TAUT_NEW(p->out, "DEFINITIONAL_REPRESENTATION('',(%),%)", TAUT_REF(line),
                                  TAUT_REF(p->spaces->plane));
    return TAUT_NEW(p->out, "PCURVE('',%,%)", TAUT_REF(surface), TAUT_REF(whole));
}

/* The k-th of `pieces` of an edge in the parameters of the face of `side`. */
static size_t put_trace_of(const placing *p, const taut_shell_edge *edge, size_t pieces, size_t k,
                           int side)
{
    const int first = edge->side[0], against = is_against(edge, side), d = along_of(side);
    const taut_surface *surface = taut_model_surface(p->model, side / 4);
    const taut_basis *across = basis_of(surface, 1 - d);
    const size_t here = against ? pieces - 1 - k : k;
    double own[2], ends[2];
    parameters_of(basis_of(taut_model_surface(p->model, first / 4), along_of(first)),
                  range_of(p, first / 4, along_of(first), pieces, k), own);
    parameters_of(basis_of(surface, d), range_of(p, side / 4, d, pieces, here), ends);
    if (against) {
        const double swap = ends[0];
        ends[0] = ends[1];
        ends[1] = swap;
    }
    return put_trace(p, p->surfaces[piece_at(p, side, here)], d,
                     side % 2 == 0 ? taut_basis_lo(across) : taut_basis_hi(across), own, ends);
}

/* Does the way round the unturned face of a side go along the edge's curve? */
static int is_along(const taut_shell_edge *edge, int side)
{
    return taut_shell_is_along(side) != is_against(edge, side);
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

/* Is a face a form whose edges are circles or lines? */
static int is_round(const placing *p, int face)
{
    return is_form(p, face) && p->forms[face].is_round;
}

/* The curve of the k-th piece of an edge: a circle or a line where its faces have such, else a spline. */
static size_t put_curve_of(const placing *p, const taut_shell_edge *edge, size_t pieces, size_t k)
{
    const int face = edge->side[0] / 4, e = edge->side[0] % 4, d = along_of(e);
    const taut_surface *surface = taut_model_surface(p->model, face);
    if (is_round(p, face) && (edge->side[1] < 0 || is_round(p, edge->side[1] / 4))) {
        return taut_step_put_form_edge(p->out, &p->forms[face], surface, e);
    }
    const taut_step_row row = {.along = d,
                               .line = e % 2 == 0 ? 0 : last_of(surface, 1 - d),
                               .range = range_of(p, face, d, pieces, k)};
    return taut_step_put_row(p->out, surface, p->points[face], &row);
}

static size_t put_edge_curve(const placing *p, size_t begin, size_t end, size_t curve)
{
    return TAUT_NEW(p->out, "EDGE_CURVE('',%,%,%,.T.)", TAUT_REF(begin), TAUT_REF(end),
                    TAUT_REF(curve));
}

static size_t put_curve_with(const placing *p, const char *kind, size_t curve, size_t count,
                             const size_t traces[2])
{
    return TAUT_NEW(p->out, "%('',%,%,.CURVE_3D.)", TAUT_WORD(kind), TAUT_REF(curve),
                    TAUT_REFS(count, traces));
}

static size_t put_edge(const placing *p, int at, size_t k)
{
    const taut_shell_edge *edge = &p->shells->edges[at];
    const size_t pieces = edge_pieces(p, edge), *joints = p->joints + p->first_edge[at];
    const int *side = edge->side, uses = side[1] >= 0 ? 2 : 1;
    const int is_seam =
        uses == 2 && side[1] / 4 == side[0] / 4 &&
        piece_at(p, side[0], k) == piece_at(p, side[1], edge->reversed ? pieces - 1 - k : k);
    /* of a seam the use along the curve is told first */
    const int first = is_seam && !is_along(edge, side[0]);
    size_t curve = put_curve_of(p, edge, pieces, k), traces[2] = {0, 0}, count = 0;
    for (int i = 0; i < uses; i++) {
        const int of = side[first ? 1 - i : i];
        if (!is_form(p, of / 4)) {
            traces[count++] = put_trace_of(p, edge, pieces, k, of);
        }
    }
    if (count > 0) {
        curve = put_curve_with(p, is_seam ? "SEAM_CURVE" : "SURFACE_CURVE", curve, count, traces);
    }
    return put_edge_curve(p, k == 0 ? p->vertices[edge->vertex[0]] : joints[k - 1],
                          k == pieces - 1 ? p->vertices[edge->vertex[1]] : joints[k], curve);
}

/* A vertex at a control point. */
static size_t put_vertex(const placing *p, int face, int u, int v)
{
    const taut_surface *surface = taut_model_surface(p->model, face);
    const size_t at = (size_t)u * ((size_t)last_of(surface, 1) + 1) + (size_t)v;
    const size_t point = is_form(p, face)
                             ? TAUT_NEW(p->out, "CARTESIAN_POINT('',%)",
                                        TAUT_REALS(3, taut_surface_points(surface) + 3 * at, 1))
                             : p->points[face] + at;
    return TAUT_NEW(p->out, "VERTEX_POINT('',%)", TAUT_REF(point));
}

static size_t put_corner(const placing *p, int corner)
{
    const taut_surface *surface = taut_model_surface(p->model, corner / 4);
    return put_vertex(p, corner / 4, corner % 4 >= 2 ? last_of(surface, 0) : 0,
                      corner % 2 == 1 ? last_of(surface, 1) : 0);
}

/* The vertex between the k-th piece of an edge and the next. */
static size_t put_joint(const placing *p, const taut_shell_edge *edge, size_t pieces, size_t k)
{
    const int side = edge->side[0], d = along_of(side);
    const int line = range_of(p, side / 4, d, pieces, k).to;
    const int across = side % 2 == 0 ? 0 : last_of(taut_model_surface(p->model, side / 4), 1 - d);
    return put_vertex(p, side / 4, d == 0 ? line : across, d == 0 ? across : line);
}

/* The vertex at a corner of a face. */
static size_t vertex_at(const placing *p, int face, int corner)
{
    const taut_shell_face *f = &p->shells->faces[face];
    for (int e = 0; e < 4; e++) {
        const int side = 4 * face + e;
        for (int end = 0; end < 2 && f->edge[e] >= 0; end++) {
            const taut_shell_edge *edge = &p->shells->edges[f->edge[e]];
            if (taut_shell_corner(side, end) == 4 * face + corner) {
                return p->vertices[edge->vertex[is_against(edge, side) ? 1 - end : end]];
            }
        }
    }
    return p->vertices[f->pole];
}

/* The vertex where lines (i, j) of a face meet. */
static size_t vertex_of(const placing *p, int face, size_t i, size_t j)
{
    const size_t nu = pieces_of(p, face, 0), nv = pieces_of(p, face, 1);
    const int on_u = i == 0 || i == nu, on_v = j == 0 || j == nv;
    const int e = on_u ? TAUT_EDGE_U0 + (i > 0) : TAUT_EDGE_V0 + (j > 0);
    const size_t k = on_u ? j : i, count = on_u ? nv : nu;
    if (!on_u && !on_v) {
        return p->inside[p->first_inside[face] + (i - 1) * (nv - 1) + j - 1];
    }
    const int at = p->shells->faces[face].edge[e];
    if ((on_u && on_v) || at < 0) {
        return vertex_at(p, face, 2 * (i == nu) + (j == nv));
    }
    const int against = is_against(&p->shells->edges[at], 4 * face + e);
    return p->joints[p->first_edge[at] + (against ? count - k : k) - 1];
}

/* Where the edges along direction d are among what is inside a face, the one at line k > 0, piece m. */
static size_t *inner_edge(const placing *p, int face, int d, size_t k, size_t m)
{
    const size_t nu = pieces_of(p, face, 0), nv = pieces_of(p, face, 1);
    const size_t before = (nu - 1) * (nv - 1) + (d == 0 ? (nu - 1) * nv : 0);
    return &p->inside[p->first_inside[face] + before + (k - 1) * (d == 0 ? nu : nv) + m];
}

/* The edge along d on line k between two pieces of a face, at the m-th piece of d. */
static size_t put_inner_edge(const placing *p, int face, int d, size_t k, size_t m)
{
    const taut_surface *surface = taut_model_surface(p->model, face);
    const taut_step_row row = {.along = d,
                               .line = p->cuts[face].lines[1 - d][k],
                               .range = range_of(p, face, d, pieces_of(p, face, d), m)};
    const double other = taut_step_parameter(basis_of(surface, 1 - d), row.line);
    const size_t nv = pieces_of(p, face, 1);
    double ends[2];
    size_t traces[2];
    parameters_of(basis_of(surface, d), row.range, ends);
    const size_t curve = taut_step_put_row(p->out, surface, p->points[face], &row);
    for (size_t i = 0; i < 2; i++) {
        const size_t piece = d == 0 ? m * nv + k - 1 + i : (k - 1 + i) * nv + m;
        traces[i] = put_trace(p, p->surfaces[p->first_piece[face] + piece], d, other, ends, ends);
    }
    const size_t both = put_curve_with(p, "SURFACE_CURVE", curve, 2, traces);
    return put_edge_curve(p, d == 0 ? vertex_of(p, face, m, k) : vertex_of(p, face, k, m),
                          d == 0 ? vertex_of(p, face, m + 1, k) : vertex_of(p, face, k, m + 1),
                          both);
}

static size_t put_oriented(const placing *p, size_t edge, int along)
{
    return TAUT_NEW(p->out, "ORIENTED_EDGE('',*,*,%,%)", TAUT_REF(edge), TAUT_TRUTH(along));
}

/* The uses of edge e by a face, of its k-th piece or, where the face is whole, all: going round with the inside on the
 * left. How many, from uses[0] on. */
static size_t put_uses(const placing *p, int face, int e, size_t k, size_t *uses)
{
    const taut_shell_face *f = &p->shells->faces[face];
    const taut_shell_edge *edge = &p->shells->edges[f->edge[e]];
    const size_t pieces = edge_pieces(p, edge), first = p->first_edge[f->edge[e]];
    const int along = is_along(edge, 4 * face + e) != f->turned;
    if (pieces_of(p, face, along_of(e)) == pieces) {
        const size_t at = is_against(edge, 4 * face + e) ? pieces - 1 - k : k;
        uses[0] = put_oriented(p, p->edges[first + at], along);
        return 1;
    }
    for (size_t i = 0; i < pieces; i++) {
        uses[i] = put_oriented(p, p->edges[first + (along ? i : pieces - 1 - i)], along);
    }
    return pieces;
}

/* The loop of piece (i, j) of a face. */
static size_t put_loop(const placing *p, int face, size_t i, size_t j)
{
    static const int round[4] = {TAUT_EDGE_V0, TAUT_EDGE_U1, TAUT_EDGE_V1, TAUT_EDGE_U0};
    const taut_shell_face *f = &p->shells->faces[face];
    size_t count = 0;
    for (int n = 0; n < 4; n++) {
        const int e = round[f->turned ? 3 - n : n], d = along_of(e);
        const size_t line = (d == 1 ? i : j) + (e % 2 == 1), k = d == 1 ? j : i;
        if (line > 0 && line < pieces_of(p, face, 1 - d)) {
            p->uses[count++] = put_oriented(p, *inner_edge(p, face, d, line, k),
                                            taut_shell_is_along(e) != f->turned);
        } else if (f->edge[e] >= 0) {
            count += put_uses(p, face, e, k, p->uses + count);
        }
    }
    return count > 0 ? TAUT_NEW(p->out, "EDGE_LOOP('',%)", TAUT_REFS(count, p->uses))
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
            const size_t uses = put_uses(p, face, e, 0, p->uses);
            const size_t loop = TAUT_NEW(p->out, "EDGE_LOOP('',%)", TAUT_REFS(uses, p->uses));
            bounds[count++] =
                TAUT_NEW(p->out, "%('',%,.T.)",
                         TAUT_WORD(outer ? "FACE_OUTER_BOUND" : "FACE_BOUND"), TAUT_REF(loop));
        }
    }
    return count;
}

static size_t put_face(const placing *p, int face, size_t i, size_t j)
{
    const int against = p->forms[face].inwards; /* 0 of a spline */
    size_t bounds[2] = {0, 0}, count = 1;
    if (p->forms[face].kind == TAUT_STEP_PLANE) {
        count = put_rings(p, face, bounds);
    } else {
        const size_t loop = put_loop(p, face, i, j);
        bounds[0] = TAUT_NEW(p->out, "FACE_OUTER_BOUND('',%,.T.)", TAUT_REF(loop));
    }
    return TAUT_NEW(p->out, "ADVANCED_FACE(%,%,%,%)",
                    TAUT_TEXT(taut_surface_name(taut_model_surface(p->model, face))),
                    TAUT_REFS(count, bounds),
                    TAUT_REF(p->surfaces[p->first_piece[face] + i * pieces_of(p, face, 1) + j]),
                    TAUT_TRUTH(p->shells->faces[face].turned == against));
}

/* What is between the pieces of a face. */
static void put_inside(const placing *p, int face)
{
    const size_t nu = pieces_of(p, face, 0), nv = pieces_of(p, face, 1);
    const taut_step_cuts *c = &p->cuts[face];
    size_t *at = p->inside + p->first_inside[face];
    for (size_t i = 1; i < nu; i++) {
        for (size_t j = 1; j < nv; j++) {
            *at++ = put_vertex(p, face, c->lines[0][i], c->lines[1][j]);
        }
    }
    for (int d = 1; d >= 0; d--) {
        for (size_t k = 1; k < (d == 1 ? nu : nv); k++) {
            for (size_t m = 0; m < (d == 1 ? nv : nu); m++) {
                *inner_edge(p, face, d, k, m) = put_inner_edge(p, face, d, k, m);
            }
        }
    }
}

/* The vertices and edges that are seen: all but the seams of planes, and what only these come to. */
static void put_edges(placing *p)
{
    const taut_shells *shells = p->shells;
    for (int e = 0; e < shells->edge_count; e++) {
        const taut_shell_edge *edge = &shells->edges[e];
        const size_t pieces = edge_pieces(p, edge);
        for (int end = 0; end < 2 && !is_hidden(p, edge->side[0]); end++) {
            size_t *vertex = &p->vertices[edge->vertex[end]];
            *vertex = *vertex != 0 ? *vertex : put_corner(p, shells->vertices[edge->vertex[end]]);
        }
        for (size_t k = 0; k + 1 < pieces; k++) {
            p->joints[p->first_edge[e] + k] = put_joint(p, edge, pieces, k);
        }
    }
    for (int f = 0; f < shells->face_count; f++) {
        const int pole = shells->faces[f].pole;
        if (pole >= 0 && !is_form(p, f) && p->vertices[pole] == 0) {
            p->vertices[pole] = put_corner(p, shells->vertices[pole]);
        }
    }
    for (int e = 0; e < shells->edge_count; e++) {
        const size_t pieces = edge_pieces(p, &shells->edges[e]);
        for (size_t k = 0; k < pieces && !is_hidden(p, shells->edges[e].side[0]); k++) {
            p->edges[p->first_edge[e] + k] = put_edge(p, e, k);
        }
    }
    for (int f = 0; f < shells->face_count; f++) {
        put_inside(p, f);
    }
}

static size_t put_faces_of(const placing *p, const taut_shell *shell, size_t *list)
{
    size_t count = 0;
    for (int k = 0; k < shell->face_count; k++) {
        const int f = shell->faces[k];
        for (size_t i = p->first_piece[f]; i < p->first_piece[f + 1]; i++) {
            list[count++] = p->faces[i];
        }
    }
    return TAUT_NEW(p->out, "%('',%)", TAUT_WORD(shell->closed ? "CLOSED_SHELL" : "OPEN_SHELL"),
                    TAUT_REFS(count, list));
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

/* Room for all numbers, and where those of faces and edges begin. `list`: room for all pieces. */
static taut_status lay_out(placing *p, taut_arena *arena, size_t **list)
{
    const size_t faces = (size_t)p->shells->face_count, edges = (size_t)p->shells->edge_count;
    size_t pieces = 0, of_edges = 0, inside = 0, most = 0;
    p->points = taut_arena_take(arena, faces, sizeof *p->points);
    p->first_piece = taut_arena_take(arena, faces + 1, sizeof *p->first_piece);
    p->first_inside = taut_arena_take(arena, faces, sizeof *p->first_inside);
    p->first_edge = taut_arena_take(arena, edges, sizeof *p->first_edge);
    p->vertices = taut_arena_take(arena, (size_t)p->shells->vertex_count, sizeof *p->vertices);
    if (taut_arena_status(arena) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (size_t f = 0; f < faces; f++) {
        const size_t nu = pieces_of(p, (int)f, 0), nv = pieces_of(p, (int)f, 1);
        p->first_piece[f] = pieces;
        p->first_inside[f] = inside;
        pieces += nu * nv;
        inside += (nu - 1) * (nv - 1) + (nu - 1) * nv + nu * (nv - 1);
    }
    p->first_piece[faces] = pieces;
    for (size_t e = 0; e < edges; e++) {
        const size_t own = edge_pieces(p, &p->shells->edges[e]);
        p->first_edge[e] = of_edges;
        of_edges += own;
        most = own > most ? own : most;
    }
    p->surfaces = taut_arena_take(arena, pieces, sizeof *p->surfaces);
    p->faces = taut_arena_take(arena, pieces, sizeof *p->faces);
    p->edges = taut_arena_take(arena, of_edges, sizeof *p->edges);
    p->joints = taut_arena_take(arena, of_edges, sizeof *p->joints);
    p->inside = taut_arena_take(arena, inside, sizeof *p->inside);
    p->uses = taut_arena_take(arena, 4 * most, sizeof *p->uses);
    *list = taut_arena_take(arena, pieces, sizeof **list);
    return taut_arena_status(arena);
}

/* The surfaces of a face's pieces. */
static void put_surfaces(const placing *p, int face)
{
    const taut_surface *surface = taut_model_surface(p->model, face);
    size_t *at = p->surfaces + p->first_piece[face];
    if (is_form(p, face)) {
        *at = taut_step_put_form(p->out, &p->forms[face]);
        return;
    }
    const size_t nu = pieces_of(p, face, 0), nv = pieces_of(p, face, 1);
    p->points[face] = taut_step_put_net(p->out, surface);
    for (size_t i = 0; i < nu; i++) {
        for (size_t j = 0; j < nv; j++) {
            const taut_step_range ranges[2] = {range_of(p, face, 0, nu, i),
                                               range_of(p, face, 1, nv, j)};
            *at++ = taut_step_put_surface(p->out, surface, p->points[face], ranges);
        }
    }
}

taut_status taut_step_put_faces(taut_part21 *out, const taut_model *model,
                                const taut_shells *shells, const taut_step_form *forms,
                                const taut_step_cuts *cuts, const int *outside,
                                const taut_step_spaces *spaces, taut_arena *arena,
                                taut_step_content *content)
{
    placing p = {.out = out,
                 .model = model,
                 .shells = shells,
                 .forms = forms,
                 .cuts = cuts,
                 .outside = outside,
                 .spaces = spaces};
    size_t styles[TAUT_STEP_COLOURS] = {0}, *list = NULL;

    if (lay_out(&p, arena, &list) != TAUT_OK) {
        return TAUT_NO_MEMORY;
    }
    for (int f = 0; f < shells->face_count; f++) {
        put_surfaces(&p, f);
    }
    put_edges(&p);
    for (int f = 0; f < shells->face_count; f++) {
        const size_t nv = pieces_of(&p, f, 1);
        for (size_t i = p.first_piece[f]; i < p.first_piece[f + 1]; i++) {
            const size_t k = i - p.first_piece[f];
            p.faces[i] = put_face(&p, f, k / nv, k % nv);
            content->styles[content->style_count++] =
                taut_step_style_face(out, p.faces[i], taut_colour_of_surface(model, f), styles);
        }
    }
    for (int s = 0; s < shells->shell_count; s++) {
        put_shell(&p, s, list, content);
    }
    return TAUT_OK;
}
