#include "certify/trace/family.h"

#include <math.h>

int taut_net_is_of_family(taut_trace_net net, int family, const taut_forms *f, const double way[2],
                          double *off)
{
    const double a = way[0], b = way[1];
    const double speed = f->e * a * a + 2 * f->f * a * b + f->g * b * b;
    const double normal = (f->l * a * a + 2 * f->m * a * b + f->n * b * b) / speed;
    const double twist = ((f->m * a + f->n * b) * (f->e * a + f->f * b) -
                          (f->l * a + f->m * b) * (f->f * a + f->g * b)) /
                         (f->w * speed);
    *off = net == TAUT_TRACE_ASYMPTOTIC ? normal : twist;
    return net == TAUT_TRACE_ASYMPTOTIC ? (family == 0) == (twist > 0)
                                        : (family == 0) == (normal > f->mean);
}

int taut_net_family_way(taut_trace_net net, int family, const taut_forms *f, double way[2])
{
    const double mixed[3] = {f->e * f->m - f->f * f->l, (f->e * f->n - f->g * f->l) / 2,
                             f->f * f->n - f->g * f->m};
    const double first = net == TAUT_TRACE_ASYMPTOTIC ? f->l : mixed[0];
    const double middle = net == TAUT_TRACE_ASYMPTOTIC ? f->m : mixed[1];
    const double last = net == TAUT_TRACE_ASYMPTOTIC ? f->n : mixed[2];
    const double square = middle * middle - first * last;

    if (net == TAUT_TRACE_ISOPARAMETRIC) {
        way[0] = family == 1;
        way[1] = family == 0;
        return f->regular;
    }
    if (!f->regular || !(square > 0)) {
        return 0;
    }
    const double whole = -(middle + copysign(sqrt(square), middle));
    for (int k = 0; k < 2; k++) { /* as numbers of one another: a root may be infinite */
        double off = 0;
        way[0] = k == 0 ? whole : last;
        way[1] = k == 0 ? first : whole;
        if (taut_net_is_of_family(net, family, f, way, &off)) {
            return 1;
        }
    }
    return 0;
}
