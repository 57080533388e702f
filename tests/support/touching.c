#include "touching.h"

#include "core/vec3.h"

#include <math.h>
#include <string.h>

double touching_radius(const touching_jet x, const double y[3])
{
    double d[3], across[3];
    taut_difference(y, x[0], d);
    taut_cross(d, x[1], across);
    const double distance = taut_norm(across) / taut_norm(x[1]), square = taut_dot(d, d);
    return distance > 1e-9 * sqrt(square) ? square / (2 * distance) : (double)INFINITY;
}

double touching_curvature_radius(const touching_jet x)
{
    double across[3];
    taut_cross(x[1], x[2], across);
    return taut_norm(across) > 0 ? pow(taut_norm(x[1]), 3) / taut_norm(across) : (double)INFINITY;
}

void touching_keep(touching_kept *kept, double value, const double at[2])
{
    int slot = kept->count;
    for (; slot > 0 && value < kept->values[slot - 1]; slot--) {
        if (slot < kept->most) {
            kept->values[slot] = kept->values[slot - 1];
            memcpy(kept->at[slot], kept->at[slot - 1], sizeof kept->at[slot]);
        }
    }
    if (slot < kept->most && isfinite(value)) {
        kept->values[slot] = value;
        memcpy(kept->at[slot], at, sizeof kept->at[slot]);
        kept->count += kept->count < kept->most;
    }
}

double touching_descend(touching_pair *value, const void *context, const double start[2],
                        double step, double shortest)
{
    static const int moves[8][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                    {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    double t[2] = {start[0], start[1]}, best = value(context, t);
    for (int rounds = 0; step > shortest && rounds < 4000; rounds++) {
        int better = 0;
        for (int k = 0; k < 8 && !better; k++) {
            const double next[2] = {fmin(1, fmax(0, t[0] + step * moves[k][0])),
                                    fmin(1, fmax(0, t[1] + step * moves[k][1]))};
            const double found = value(context, next);
            if (found < best) {
                best = found;
                memcpy(t, next, sizeof t);
                better = 1;
            }
        }
        step *= better ? 1.5 : 0.5;
    }
    return best;
}

double touching_least(touching_point *value, const void *context, double lo, double hi)
{
    for (int i = 0; i < 100; i++) {
        const double left = (2 * lo + hi) / 3, right = (lo + 2 * hi) / 3;
        if (value(context, left) < value(context, right)) {
            hi = right;
        } else {
            lo = left;
        }
    }
    return value(context, 0.5 * (lo + hi));
}
