#include "bases.h"

#include "check.h"

#include <string.h>

taut_basis_spec spec_of_spans(const char *type, double length, int segments, double lo)
{
    taut_basis_spec spec = {.type = type};
    *(type[0] == 'c' ? &spec.alpha : &spec.beta) = length;
    spec.segments = strstr(type, "bspline") != NULL ? segments : 0;
    spec.range[0] = lo;
    spec.range[1] = lo + length * (spec.segments > 0 ? spec.segments : 1);
    return spec;
}

int random_knots(int degree, int most, double lo, double *knots)
{
    const int spans = random_int(1, most);
    double t = lo;
    int n = 0;
    for (int i = 0; i <= degree; i++) {
        knots[n++] = t;
    }
    for (int s = 0; s < spans; s++) {
        const int times = s + 1 < spans ? random_int(1, degree) : degree + 1;
        t += random_log(1e-3, 1);
        for (int i = 0; i < times; i++) {
            knots[n++] = t;
        }
    }
    return n;
}
