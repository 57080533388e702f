#include "construct/film/complex/volume.h"

#include "core/vec3.h"
#include "numeric/sum.h"

#include <string.h>

void taut_volume_places(const taut_area_functional *area, const double *net, double *rows,
                        double *places)
{
    const taut_area_axis *u = &area->u, *v = &area->v;
    const size_t nv = (size_t)area->nv;

    for (int line = 0; line < u->count; line++) {
        memset(rows, 0, 6 * nv * sizeof(double));
        for (int i = 0; i < u->local; i++) {
            const double *from = net + 3 * nv * (size_t)(u->first[line] + i);
            const double n = u->value[line * u->local + i], m = u->slope[line * u->local + i];
            for (size_t k = 0; k < 3 * nv; k++) {
                rows[k] += n * from[k];
                rows[3 * nv + k] += m * from[k];
            }
        }
        for (int k = 0; k < v->count; k++, places += TAUT_VOLUME_PLACE) {
            memset(places, 0, TAUT_VOLUME_PLACE * sizeof(double));
            for (int j = 0; j < v->local; j++) {
                const double *still = rows + 3 * (size_t)(v->first[k] + j), *moved = still + 3 * nv;
                const double n = v->value[k * v->local + j];
                taut_add_scaled(n, still, places);
                taut_add_scaled(n, moved, places + 3);
                taut_add_scaled(v->slope[k * v->local + j], still, places + 6);
            }
        }
    }
}

double taut_volume_patch(const taut_area_functional *area, const double *places,
                         const double from[3], double share, double *gradient)
{
    const taut_area_axis *u = &area->u, *v = &area->v;
    taut_sum sum = {0, 0};

    for (int line = 0; line < u->count; line++) {
        for (int k = 0; k < v->count; k++, places += TAUT_VOLUME_PLACE) {
            const double weight = u->weights[line] * v->weights[k] / 3;
            double y[3], n[3], to_u[3], to_v[3];
            taut_difference(places, from, y);
            taut_cross(places + 3, places + 6, n);
            taut_sum_add(&sum, weight * taut_dot(y, n));
            if (gradient == NULL) {
                continue;
            }
            taut_cross(places + 6, y, to_u);
            taut_cross(y, places + 3, to_v);
            for (int i = 0; i < u->local; i++) {
                const double a = share * weight * u->value[line * u->local + i],
                             b = share * weight * u->slope[line * u->local + i];
                double *to = gradient + 3 * ((size_t)(u->first[line] + i) * (size_t)area->nv +
                                             (size_t)v->first[k]);
                for (int j = 0; j < v->local; j++, to += 3) {
                    const double c = v->value[k * v->local + j], d = v->slope[k * v->local + j];
                    taut_add_scaled(a * c, n, to);
                    taut_add_scaled(b * c, to_u, to);
                    taut_add_scaled(a * d, to_v, to);
                }
            }
        }
    }
    return taut_sum_total(&sum);
}
