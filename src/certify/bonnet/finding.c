#include "certify/bonnet/parts.h"

static const double most = 1e30;

void taut_bonnet_raise(taut_bonnet_finding *largest, double residual, double noise, double u,
                       double v)
{
    if (!(residual <= largest->residual)) {
        largest->residual = residual < most ? residual : most;
        largest->at[0] = u;
        largest->at[1] = v;
    }
    if (!(noise <= largest->noise)) {
        largest->noise = noise < most ? noise : most;
    }
}
