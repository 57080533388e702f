#include "pattern/flat/density.h"

static double symmetric_dot(const taut_flat_law *d, const double e[3], const double f[3])
{
    /* e, f: (11, 22, 12); shear strains enter as 2 * 12 */
    return d->d11 * e[0] * f[0] + d->d22 * e[1] * f[1] + d->d12 * (e[0] * f[1] + e[1] * f[0]) +
           4 * d->d33 * e[2] * f[2];
}

int taut_flat_stretch(const double j[2][2], const double g[3], double inverse[2][2], double *det,
                      double c[3])
{
    *det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    if (!(*det > 0)) {
        return 0;
    }
    inverse[0][0] = j[1][1] / *det;
    inverse[0][1] = -j[0][1] / *det;
    inverse[1][0] = -j[1][0] / *det;
    inverse[1][1] = j[0][0] / *det;
    for (int k = 0; k < 3; k++) {
        const int m = k == 1, n = k != 0;
        c[k] = inverse[0][m] * (g[0] * inverse[0][n] + g[1] * inverse[1][n]) +
               inverse[1][m] * (g[1] * inverse[0][n] + g[2] * inverse[1][n]);
    }
    return 1;
}

int taut_flat_density(const taut_flat_law *law, const double shrink[2], const double j[2][2],
                      const double g[3], int order, taut_flat_form *f)
{
    double c[3]; /* 11, 22, 12 */
    const double s0 = shrink[0], s1 = shrink[1];
    const double scale[3] = {s0 * s0 / 2, s1 * s1 / 2, s0 * s1 / 2};
    double e[3], de[4][3];

    if (!taut_flat_stretch(j, g, f->inverse, &f->det, c)) {
        return 0;
    }
    const double full[2][2] = {{c[0], c[2]}, {c[2], c[1]}};
    const double weight = f->det / (s0 * s1);
    e[0] = scale[0] * c[0] - 0.5;
    e[1] = scale[1] * c[1] - 0.5;
    e[2] = scale[2] * c[2];
    const double phi = 0.5 * symmetric_dot(law, e, e);
    f->w = phi * weight;
    if (order == 0) {
        return 1;
    }
    for (int h = 0; h < 4; h++) { /* H = e_k e_l': (C H)_mn = C_mk [n = l] */
        const int k = h / 2, l = h % 2;
        de[h][0] = -scale[0] * (l == 0 ? 2 * full[0][k] : 0);
        de[h][1] = -scale[1] * (l == 1 ? 2 * full[1][k] : 0);
        de[h][2] = -scale[2] * full[1 - l][k];
        f->first[h] = (symmetric_dot(law, e, de[h]) + (k == l ? phi : 0)) * weight;
    }
    for (int h = 0; h < 4; h++) {
        for (int o = 0; o <= h; o++) {
            const int k = h / 2, l = h % 2, m = o / 2, n = o % 2;
            double p[2][2] = {{0, 0}, {0, 0}}, d[2][2];
            if (l == m) {
                p[k][n] += 1; /* A B */
            }
            if (n == k) {
                p[m][l] += 1; /* B A */
            }
            for (int x = 0; x < 2; x++) {
                for (int z = 0; z < 2; z++) {
                    d[x][z] = p[0][x] * full[0][z] + p[1][x] * full[1][z] + full[x][0] * p[0][z] +
                              full[x][1] * p[1][z] + (x == l && z == n ? full[k][m] : 0) +
                              (x == n && z == l ? full[m][k] : 0);
                }
            }
            const double dd[3] = {scale[0] * d[0][0], scale[1] * d[1][1], scale[2] * d[0][1]};
            const double trace_h = k == l, trace_o = m == n;
            f->second[h][o] = f->second[o][h] =
                (symmetric_dot(law, de[h], de[o]) + symmetric_dot(law, e, dd) +
                 symmetric_dot(law, e, de[h]) * trace_o + symmetric_dot(law, e, de[o]) * trace_h +
                 phi * (trace_h * trace_o - (l == m && n == k))) *
                weight;
        }
    }
    return 1;
}
