#include "io/mesh/fields.h"

#include "core/elementary/elementary.h"
#include "core/memory.h"
#include "taut/measure.h"

#include <math.h>

void taut_fields_of(const double *vectors, double fields[TAUT_FIELDS])
{
    taut_forms forms;
    taut_forms_of((const double(*)[3])vectors, &forms);
    fields[TAUT_FIELD_H] = forms.regular ? forms.mean : nan("");
    fields[TAUT_FIELD_K] = forms.regular ? forms.gaussian : nan("");
    fields[TAUT_FIELD_E_MINUS_G] = forms.e - forms.g;
    fields[TAUT_FIELD_F] = forms.f;
    fields[TAUT_FIELD_I] = taut_hypot(forms.e - forms.g, 2 * forms.f) / (forms.e + forms.g);
}

taut_status taut_mesh_fields(const taut_surface *surface, const taut_mesh *mesh,
                             const taut_mesh_group *group, int threads, taut_pulse *pulse,
                             double *fields)
{
    const double *parameters = taut_mesh_parameters(mesh) + 2 * group->first_vertex;
    const size_t nv = (size_t)group->nv;
    double *v = taut_alloc(nv, sizeof *v);
    double *vectors = taut_alloc_aligned(nv, 18 * sizeof *vectors);
    taut_status status = v != NULL && vectors != NULL ? TAUT_OK : TAUT_NO_MEMORY;

    for (size_t j = 0; status == TAUT_OK && j < nv; j++) {
        v[j] = parameters[2 * j + 1];
    }
    for (size_t i = 0; status == TAUT_OK && i < (size_t)group->nu; i++) {
        const double u = parameters[2 * i * nv];
        status = taut_surface_eval_grid(surface, 1, &u, group->nv, v, 2, threads, vectors);
        for (size_t j = 0; status == TAUT_OK && j < nv; j++) {
            taut_fields_of(vectors + 18 * j, fields + TAUT_FIELDS * (i * nv + j));
        }
        if (status == TAUT_OK && taut_pulse_beat(pulse, (double)TAUT_FIELDS_WORK * (double)nv)) {
            status = TAUT_INTERRUPTED;
        }
    }
    taut_free(v);
    taut_free(vectors);
    return status;
}
