/* data.c -- how far from asymptotic four curves alone make any patch between them.
 *
 * At a corner both tangents must lie in both osculating planes and the torsions must be opposite;
 * data given to so many digits meets that to so many. A patch of degree m along the edge then tilts
 * against the osculating plane, near the corner with weight w and parameter t, by some
 *     (w / W) (2 off |r_f'| (B_0 + B_1) + |tau_e + tau_f| |r_e'| |r_f'| sin A  B_1 / m)
 *     / (|R_c| sin)
 * with B_0, B_1 the first Bernstein functions of degree m, as R_uv.N is tau_e |r_e'| |r_f'|
 * sin A from one edge and -tau_f |r_e'| |r_f'| sin A from the other (docs/papers/asymptotic.md
 * 2, 5.3). A straight edge has no osculating plane and no torsion: what rounding makes of them
 * explains nothing.
 */
#include "certify/asymptotic/parts.h"
#include "core/elementary/elementary.h"
#include "core/vec3.h"

#include <float.h>

static const double given = 1e-10; /* relative: data that meets its conditions worse is wrong */

/* The other edge at end 0 and 1 of an edge, and its end there. */
static const int partner[4][2][2] = {
    {{1, 0}, {3, 0}}, {{0, 0}, {2, 0}}, {{1, 1}, {3, 1}}, {{0, 1}, {2, 1}}};

int taut_edge_on_chord(const taut_asymptotic_model *model, int edge)
{
    const double *const p = taut_curve_points(model->curves[edge]);
    const int last = taut_basis_count(taut_curve_t(model->curves[edge])) - 1;
    double chord[3], off = 0.0;
    taut_difference(p + 3 * last, p, chord);
    for (int j = 1; j < last; j++) {
        double arm[3], normal[3];
        taut_difference(p + 3 * j, p, arm);
        taut_cross(chord, arm, normal);
        off = fmax(off, taut_norm(normal));
    }
    return off <= 4 * DBL_EPSILON * model->curve_size * taut_norm(chord);
}

/* First derivative, |r'|, the normal of the osculating plane, and torsion, at an end. */
typedef struct curve_end {
    double tangent[3], speed, normal[3], torsion;
    int straight; /* normal and torsion are 0 */
} curve_end;

static curve_end end_of(const taut_asymptotic_model *model, int edge, int end)
{
    const taut_curve *const curve = model->curves[edge];
    const int n = taut_basis_count(taut_curve_t(curve)) - 1, step = end ? -1 : 1, at = end ? n : 0;
    const double *const p = taut_curve_points(curve);
    const double *const w = taut_curve_weights(curve);
    curve_end made = {{0}, 0.0, {0}, 0.0, taut_edge_on_chord(model, edge)};
    double d[3][3] = {{0}}, g[4];
    for (int j = 0; j <= 3 && j <= n; j++) {
        g[j] = w != NULL ? w[at + j * step] : 1.0;
        if (j > 0) {
            taut_difference(p + 3 * (at + j * step), p + 3 * at, d[j - 1]);
        }
    }
    taut_add_scaled(step * n * g[1] / g[0], d[0], made.tangent);
    made.speed = taut_norm(made.tangent);
    if (made.straight) {
        return made;
    }
    taut_cross(d[0], d[1], made.normal);
    if (n >= 3 && taut_norm(made.normal) > 0) {
        made.torsion = (n - 2.0) / n * g[0] * g[3] / (g[1] * g[2]) * taut_dot(made.normal, d[2]) /
                       taut_dot(made.normal, made.normal);
    }
    return made;
}

static double off_plane(const double normal[3], const double tangent[3])
{
    const double size = taut_norm(normal) * taut_norm(tangent);
    return size > 0 ? fmin(fabs(taut_dot(normal, tangent)) / size, given) : 0.0;
}

taut_edge_data taut_edge_data_of(const taut_asymptotic_model *model, int edge)
{
    taut_edge_data data;
    for (int end = 0; end < 2; end++) {
        const int *const f = partner[edge][end];
        const curve_end own = end_of(model, edge, end);
        const curve_end other = end_of(model, f[0], f[1]);
        const double most = given * fmax(fabs(own.torsion), fabs(other.torsion));
        const double off =
            off_plane(own.normal, other.tangent) + off_plane(other.normal, own.tangent);
        double area[3];
        taut_cross(own.tangent, other.tangent, area);
        data.plane[end] = 2 * off * other.speed;
        data.twist[end] = own.straight || other.straight
                              ? 0.0
                              : fmin(fabs(own.torsion + other.torsion), most) * taut_norm(area);
    }
    return data;
}

double taut_edge_data_at(const taut_edge_data *data, int m, double t)
{
    double sum = 0.0;
    for (int end = 0; end < 2; end++) {
        const double s = end == 0 ? t : 1.0 - t;
        const double b0 = taut_pow(1.0 - s, m), b1 = m * s * taut_pow(1.0 - s, m - 1);
        sum += data->plane[end] * (b0 + b1) + data->twist[end] * b1 / m;
    }
    return sum;
}
