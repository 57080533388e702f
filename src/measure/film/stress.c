#include "measure/film/stress.h"

#include "taut/certify.h"

#include <math.h>

/* What is said of surface number i: of all alike, or of patch i of a list that images repeat. */
static const taut_record *said_of(const taut_record *said, size_t i)
{
    const size_t count = taut_record_count(said);
    const int is_list = count > 0 && !isfinite(taut_record_number(taut_record_at(said, 0)));

    return is_list ? taut_record_at(said, i % count) : said;
}

int taut_stress_densities(const taut_model *model, const taut_surface *surface, double densities[2])
{
    const taut_certificate *certificate = taut_model_certificate(model);
    int i = 0;

    if (certificate == NULL) {
        return 0;
    }
    while (i < taut_model_surface_count(model) && taut_model_surface(model, i) != surface) {
        i++;
    }
    const taut_record *pair =
        said_of(taut_record_get(taut_certificate_figures(certificate), "force_density"), (size_t)i);
    if (taut_record_count(pair) != 2) {
        return 0;
    }
    for (size_t d = 0; d < 2; d++) {
        densities[d] = taut_record_number(taut_record_at(pair, d));
        if (!(densities[d] > 0 && isfinite(densities[d]))) {
            return 0;
        }
    }
    return 1;
}

static double range_of(const taut_basis *basis)
{
    return taut_basis_hi(basis) - taut_basis_lo(basis);
}

void taut_stress_of(const taut_surface *surface, const double densities[2], const taut_forms *forms,
                    double stress[2])
{
    const double u = sqrt(forms->e) * range_of(taut_surface_u(surface)),
                 v = sqrt(forms->g) * range_of(taut_surface_v(surface));

    stress[0] = u > 0 && v > 0 ? densities[0] * (u / v) : (double)NAN;
    stress[1] = u > 0 && v > 0 ? densities[1] * (v / u) : (double)NAN;
}
