#include "meshes.h"

#include "check.h"

taut_mesh *mesh_of(const taut_model *model, double tolerance, int divide)
{
    const taut_mesh_options options = {.tolerance = tolerance, .divide = divide};
    taut_mesh *mesh = NULL;
    taut_error error = {.status = TAUT_OK};
    CHECK(taut_mesh_new(model, &options, &mesh, &error) == TAUT_OK, "%s", error.message);
    return mesh;
}
