#include "construct/asymptotic/low.h"

#include "construct/asymptotic/conditions.h"
#include "core/elementary/elementary.h"
#include "core/fail.h"
#include "core/vec3.h"
#include "numeric/dense.h"

#include <string.h>

static const double plane_match = 1e-9; /* relative: data that passed (C2), (C3) to 1e-10 */

/* a x = b for the 4 x 3 matrix of the columns p, p', p'', all with the corner as the origin: from
 * any other the weights' derivatives times the corner hide what bends the edge. The part of b
 * outside stays over. Lengths are taken in units in which they are as large as the weights. */
static void in_plane(const taut_low_end *end, const double b[4], double x[3])
{
    double a[12], right[4], scale[3], lengths = 0.0, weights = 0.0;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) {
            lengths = fmax(lengths, fabs(end->near[k][i]));
        }
        weights = fmax(weights, fabs(end->near[k][3]));
    }
    for (int i = 0; i < 4; i++) {
        right[i] = b[i] / (i < 3 ? lengths : weights);
    }
    for (int k = 0; k < 3; k++) {
        scale[k] = 0.0;
        for (int i = 0; i < 4; i++) {
            a[4 * k + i] = end->near[k][i] / (i < 3 ? lengths : weights);
            scale[k] = fmax(scale[k], fabs(a[4 * k + i]));
        }
        for (int i = 0; i < 4; i++) {
            a[4 * k + i] /= scale[k];
        }
    }
    (void)taut_least_norm(4, 3, a, right, 1e-13, x, NULL);
    for (int k = 0; k < 3; k++) {
        x[k] /= scale[k];
    }
}

/* h of degree n, spoilt, to its derivatives at an end. */
static void derive(int n, int end, double h[TAUT_QUAD_POINTS][4], double p[4][4])
{
    double factor = 1.0;
    for (int order = 0; order <= 3; order++) {
        for (int k = 0; k < 4; k++) {
            p[order][k] = factor * h[end == 0 ? 0 : n - order][k];
        }
        factor *= n - order;
        for (int j = 0; j < n - order; j++) {
            for (int k = 0; k < 4; k++) {
                h[j][k] = h[j + 1][k] - h[j][k];
            }
        }
    }
}

static void fill_end(const taut_quad *quad, int e, int end, taut_low_end *made)
{
    const int n = quad->degree;
    double h[TAUT_QUAD_POINTS][4];
    taut_quad_edge moved = quad->edges[e];
    taut_quad_homogeneous(&quad->edges[e], n, h);
    derive(n, end, h, made->p);
    for (int j = 0; j <= n; j++) {
        taut_difference(quad->edges[e].points[j], taut_quad_point(quad, e, end, 0),
                        moved.points[j]);
    }
    taut_quad_homogeneous(&moved, n, h);
    derive(n, end, h, made->near);
}

/* a p' + b p'' + c p''': S_uv but for the slopes of a, b, c, with the corner as the origin. */
static void fixed_part(const taut_low_end *end, double out[4])
{
    for (int k = 0; k < 4; k++) {
        out[k] = end->abc[0] * end->near[1][k] + end->abc[1] * end->near[2][k] +
                 end->abc[2] * end->near[3][k];
    }
}

/* s with the corner as the origin. */
static void to_corner(const taut_low_end *end, const double s[4], double out[4])
{
    for (int k = 0; k < 3; k++) {
        out[k] = s[k] - s[3] * end->p[0][k] / end->p[0][3];
    }
    out[3] = s[3];
}

/* R_uv from S_uv with the corner as the origin: (S_uv - W_u R_v - W_v R_u) / W. */
static void twist_of(const taut_low *l, int c, const double s[4], double twist[3])
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const taut_low_end *const u = &l->ends[m[0].edge][m[0].end], *const v =
                                                                     &l->ends[m[1].edge][m[1].end];
    for (int k = 0; k < 3; k++) {
        twist[k] =
            (s[k] - u->p[1][3] * l->plane_v[c][k] - v->p[1][3] * l->plane_u[c][k]) / u->p[0][3];
    }
}

void taut_low_twist(const taut_low *l, int c, const double s[4], double twist[3])
{
    double moved[4];
    to_corner(&l->ends[taut_quad_corner[c][0].edge][taut_quad_corner[c][0].end], s, moved);
    twist_of(l, c, moved, twist);
}

/* The normal part of R_uv: of the curved edges' agreeing values, of the bilinear twist if both are
 * straight. */
static taut_status normal_part(const taut_low *l, int c, double part[3], taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    double normal[3], twist[3], found[2] = {0, 0}, sum = 0.0, size = 0.0, noise = 0.0;
    int count = 0;
    taut_cross(l->plane_u[c], l->plane_v[c], normal);
    for (int k = 0; k < 2; k++) {
        double s[4];
        if (!l->quad->edges[m[k].edge].straight) {
            fixed_part(&l->ends[m[k].edge][m[k].end], s);
            twist_of(l, c, s, twist);
            found[k] = taut_dot(twist, normal);
            size = fmax(size, taut_norm(twist) * taut_norm(normal));
            noise += taut_quad_torsion_rounding(l->quad, m[k].edge, m[k].end,
                                                taut_quad_torsion(l->quad, m[k].edge, m[k].end));
            sum += found[k];
            count++;
        }
    }
    if (count == 2 &&
        !(fabs(found[0] - found[1]) <= plane_match * size + noise * taut_dot(normal, normal))) {
        return taut_fail(error, TAUT_NO_SOLUTION, "twist", "", (found[0] - found[1]) / size,
                         plane_match,
                         "the edges have no common twist at corner %s, because their torsions are "
                         "not opposite",
                         taut_asymptotic_corner_name(c));
    }
    if (count == 0) {
        for (int k = 0; k < 3; k++) {
            twist[k] = taut_quad_point(l->quad, 0, 0, 0)[k] - taut_quad_point(l->quad, 0, 1, 0)[k] -
                       taut_quad_point(l->quad, 2, 0, 0)[k] + taut_quad_point(l->quad, 2, 1, 0)[k];
        }
        sum = taut_dot(twist, normal);
        count = 1;
    }
    memset(part, 0, 3 * sizeof *part);
    taut_add_scaled(sum / count / taut_dot(normal, normal), normal, part);
    return TAUT_OK;
}

static taut_status fill_corner(taut_low *l, int c, taut_error *error)
{
    const taut_quad_meeting *const m = taut_quad_corner[c];
    const taut_low_end *const u = &l->ends[m[0].edge][m[0].end], *const v =
                                                                     &l->ends[m[1].edge][m[1].end];
    const double w = u->p[0][3], w_uv = u->p[1][3] * v->p[1][3] / w;
    double part[3];
    taut_status status = TAUT_OK;
    for (int k = 0; k < 3; k++) {
        l->plane_u[c][k] = u->near[1][k] / w;
        l->plane_v[c][k] = v->near[1][k] / w;
    }
    status = normal_part(l, c, part, error);
    for (int k = 0; k < 3 && status == TAUT_OK; k++) {
        l->base[c][k] = w * part[k] + u->p[1][3] * l->plane_v[c][k] +
                        v->p[1][3] * l->plane_u[c][k] + w_uv * u->p[0][k] / w;
        l->move[c][0][k] = w * l->plane_u[c][k];
        l->move[c][1][k] = w * l->plane_v[c][k];
        l->move[c][2][k] = u->p[0][k];
    }
    l->base[c][3] = w_uv;
    l->move[c][0][3] = l->move[c][1][3] = 0.0;
    l->move[c][2][3] = w;
    return status;
}

/* The slopes of a, b, c that S_uv = s asks of the curved edges at a corner: their number. */
static int corner_slopes(const taut_low *l, int c, const double s[4], int derivative, double out[6])
{
    int count = 0;
    for (int k = 0; k < 2; k++) {
        const taut_quad_meeting *const m = &taut_quad_corner[c][k];
        double rest[4], fixed[4];
        if (l->quad->edges[m->edge].straight) {
            continue;
        }
        fixed_part(&l->ends[m->edge][m->end], fixed);
        to_corner(&l->ends[m->edge][m->end], s, rest);
        for (int i = 0; i < 4; i++) {
            rest[i] -= derivative ? 0.0 : fixed[i];
        }
        in_plane(&l->ends[m->edge][m->end], rest, out + count);
        count += 3;
    }
    return count;
}

/* Changes the corner's three coordinates so that the slopes' squares are a constant plus |x|^2:
 * Gram-Schmidt on the slopes' derivatives, then a shift to their least. */
static void normalise_corner(taut_low *l, int c)
{
    double slopes[6], along[3][6];
    const int count = corner_slopes(l, c, l->base[c], 0, slopes);
    if (count == 0) {
        return;
    }
    for (int j = 0; j < 3; j++) {
        double length = 0.0, shift = 0.0;
        (void)corner_slopes(l, c, l->move[c][j], 1, along[j]);
        for (int pass = 0; pass < 2; pass++) { /* twice is enough for orthogonality */
            for (int i = 0; i < j; i++) {
                double part = 0.0;
                for (int k = 0; k < count; k++) {
                    part += along[i][k] * along[j][k];
                }
                for (int k = 0; k < count; k++) {
                    along[j][k] -= part * along[i][k];
                }
                for (int k = 0; k < 4; k++) {
                    l->move[c][j][k] -= part * l->move[c][i][k];
                }
            }
        }
        for (int k = 0; k < count; k++) {
            length = taut_hypot(length, along[j][k]);
        }
        for (int k = 0; k < count; k++) {
            along[j][k] /= length;
            shift += along[j][k] * slopes[k];
        }
        for (int k = 0; k < 4; k++) {
            l->move[c][j][k] /= length;
            l->base[c][k] -= shift * l->move[c][j][k];
        }
    }
}

void taut_low_s(const taut_low *l, int c, const double *x, double s[4])
{
    memcpy(s, l->base[c], 4 * sizeof *s);
    for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 4; k++) {
            s[k] += x[3 * c + j] * l->move[c][j][k];
        }
    }
}

/* The Bernstein coefficients of a, b, c on edge e. */
void taut_low_cubics(const taut_low *l, int e, const double *x, double abc[3][4])
{
    for (int end = 0; end < 2; end++) {
        const taut_low_end *const at = &l->ends[e][end];
        double s[4], rest[4], fixed[4], slope[3];
        taut_low_s(l, taut_quad_partner[e][end].corner, x, s);
        to_corner(at, s, rest);
        fixed_part(at, fixed);
        for (int k = 0; k < 4; k++) {
            rest[k] -= fixed[k];
        }
        in_plane(at, rest, slope);
        for (int k = 0; k < 3; k++) {
            abc[k][end == 0 ? 0 : 3] = at->abc[k];
            abc[k][end == 0 ? 1 : 2] = at->abc[k] + (end == 0 ? slope[k] : -slope[k]) / 3;
        }
    }
}

taut_status taut_low_corners(const taut_quad *quad, taut_low *l, taut_error *error)
{
    memset(l, 0, sizeof *l);
    l->quad = quad;
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            fill_end(l->quad, e, end, &l->ends[e][end]);
        }
    }
    for (int e = 0; e < 4; e++) {
        for (int end = 0; end < 2; end++) {
            const taut_quad_meeting *const f = &taut_quad_partner[e][end];
            if (!l->quad->edges[e].straight) {
                in_plane(&l->ends[e][end], l->ends[f->edge][f->end].near[1], l->ends[e][end].abc);
            }
        }
    }
    for (int c = 0; c < 4; c++) {
        const taut_status status = fill_corner(l, c, error);
        if (status != TAUT_OK) {
            return status;
        }
        normalise_corner(l, c);
    }
    return TAUT_OK;
}
