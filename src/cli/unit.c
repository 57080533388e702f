/* unit.c -- models that come together are brought to one unit, and numbers get theirs. */
#include "cli/cli.h"

#include <stdio.h>
#include <string.h>

int cli_one_unit(const char *file, const taut_model *first, taut_model **model, int told)
{
    const char *unit = taut_model_unit(first);
    taut_model *converted = NULL;
    taut_error error;
    char text[80];

    if (strcmp(taut_model_unit(*model), unit) == 0) {
        return 0;
    }
    if (taut_model_to_unit(*model, unit, &converted, &error) != TAUT_OK) {
        return cli_fail_in(file, &error);
    }
    snprintf(text, sizeof text, "it is in %s, and converted to %s", taut_model_unit(*model), unit);
    if (!told) {
        cli_warn(file, text);
    }
    taut_model_free(*model);
    *model = converted;
    return 0;
}

const char *cli_unit_of(const char *key, const char *unit, char room[CLI_UNIT_ROOM])
{
    static const struct {
        const char *key;
        int power; /* of the unit of length */
    } rows[] = {{"area", 2},
                {"areas", 2},
                {"area_error", 2},
                {"dirichlet_area", 2},
                {"flat_area", 2},
                {"surface_area", 2},
                {"curve_length", 1},
                {"lower_bound", 2},
                {"length", 1},
                {"lengths", 1},
                {"unstressed", 1},
                {"total_length", 1},
                {"seam_length", 1},
                {"radius", 1},
                {"bend_radius", 1},
                {"least_bend_radius", 1},
                {"wall", 1},
                {"distance", 1},
                {"boundary_gap", 1},
                {"max_gap", 1},
                {"gap_bound", 1},
                {"bounding_box", 1},
                {"largest_radius", 1},
                {"volume", 3},
                {"volumes", 3},
                {"wall_volume", 3},
                {"point", 1},
                {"du", 1}, /* derivatives by parameters, which have no unit */
                {"dv", 1},
                {"duu", 1},
                {"duv", 1},
                {"dvv", 1},
                {"d1", 1},
                {"d2", 1},
                {"d3", 1},
                {"curvature", -1},
                {"torsion", -1},
                {"max_curvature", -1},
                {"mean_curvature", -1},
                {"max_torsion", -1},
                {"gaussian_curvature", -2},
                {"gap", 2},
                {"max_abs_normal_curvature", -1},
                {"mean_abs_mean_curvature", -1},
                {"rms_mean_curvature", -1},
                {"max_abs_mean_curvature", -1}};

    room[0] = '\0';
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (strcmp(key, rows[i].key) == 0) {
            const int power = rows[i].power, size = power < 0 ? -power : power;
            const char *square = size == 3 ? "^3" : size == 2 ? "^2" : "";
            snprintf(room, CLI_UNIT_ROOM, " %s%s%s", power < 0 ? "1/" : "", unit, square);
        }
    }
    return room;
}
