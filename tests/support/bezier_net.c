#include "bezier_net.h"

#include "check.h"
#include "shapes.h"

#include <string.h>

void bezier_net_start(bezier_net *net, int n, int m, const double u[2], const double v[2])
{
    memset(net, 0, sizeof *net);
    net->n = n;
    net->m = m;
    net->u = shape_bezier(n, u[0], u[1]);
    net->v = shape_bezier(m, v[0], v[1]);
}

void bezier_net_end(bezier_net *net)
{
    taut_basis_free(net->u);
    taut_basis_free(net->v);
}

void bezier_net_know(bezier_net *net, bezier_net_part part)
{
    for (int i = 0; i <= net->n; i++) {
        for (int j = 0; j <= net->m; j++) {
            const int in_row = i == 0 || i == net->n, in_column = j == 0 || j == net->m;
            net->known[i * (net->m + 1) + j] = in_row || (part == BEZIER_NET_FRAME && in_column);
        }
    }
}

void bezier_net_fill(bezier_net *net, double offset, double size)
{
    for (int k = 0; k < 3 * (net->n + 1) * (net->m + 1); k++) {
        net->points[k] = offset + size * random_in(-1, 1);
    }
}
