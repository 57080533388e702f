/* saddle.c -- evaluates and measures a surface whose curvature is known.
 *
 *     x(u, v) = (u, v, u v),   K = -1 / (1 + u^2 + v^2)^2
 *
 *     cc saddle.c $(pkg-config --cflags --libs taut) -lm -o saddle
 */
#include <math.h>
#include <stdio.h>
#include <taut/taut.h>

/* The bilinear patch on four points. */
static taut_status make_patch(taut_surface **patch, taut_error *error)
{
    static const double points[2][2][3] = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};
    const taut_basis_spec line = {.type = "bezier", .degree = 1};
    taut_basis *basis = NULL;
    taut_status status = taut_basis_new(&line, 2, &basis, error);
    if (status == TAUT_OK) {
        status = taut_surface_new("saddle", basis, basis, &points[0][0][0], NULL, patch, error);
    }
    taut_basis_free(basis); /* the surface keeps its own copy */
    return status;
}

/* The largest difference of K from the formula over a grid. */
static taut_status compare(const taut_surface *patch, double *most)
{
    enum { N = 11 };
    static double values[N][N][TAUT_SURFACE_VECTORS(2)][3];
    double t[N];
    taut_status status = TAUT_OK;
    for (int i = 0; i < N; i++) {
        t[i] = i / (N - 1.0);
    }
    status = taut_surface_eval_grid(patch, N, t, N, t, 2, 1, &values[0][0][0][0]);
    *most = 0;
    for (int i = 0; status == TAUT_OK && i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double w2 = 1 + t[i] * t[i] + t[j] * t[j];
            taut_forms forms;
            taut_forms_of((const double(*)[3])values[i][j], &forms);
            *most = fmax(*most, fabs(forms.gaussian + 1 / (w2 * w2)));
        }
    }
    return status;
}

int main(void)
{
    taut_surface *patch = NULL;
    taut_surface_measure measure;
    taut_error error = {.status = TAUT_OK};
    double most = 0;
    taut_status status = make_patch(&patch, &error);
    if (status == TAUT_OK) {
        status = compare(patch, &most);
    }
    if (status == TAUT_OK) {
        status = taut_measure_surface(patch, NULL, &measure, &error);
    }
    if (status == TAUT_OK) {
        printf("area %.10f, K from %.6f to %.6f\n", measure.area, measure.min_gaussian,
               measure.max_gaussian);
        printf("K agrees with the formula to %s\n", most < 1e-14 ? "14 digits" : "less");
    } else {
        fprintf(stderr, "%s %s\n", error.where,
                error.message[0] != '\0' ? error.message : taut_status_text(status));
    }
    taut_surface_free(patch);
    return taut_status_exit_code(status);
}
