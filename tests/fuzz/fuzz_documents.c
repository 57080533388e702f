/* fuzz_documents.c -- any bytes as a problem and as a model.
 *
 * Beyond not crashing: a refusal is told whole (status, a sentence), a model that was read can be
 * written, and what is written reads back to the same bytes. A small problem that was read is made
 * and certified too.
 */
#include "outcome.h"

#include "taut/read.h"

#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SMALL = 4096 }; /* bytes of a problem that is quick to solve */

/* Is the normal nowhere far from its mean? Where a surface folds over, its area is an integral with
 * a kink, which takes seconds here. */
static int is_tame(const taut_model *model)
{
    enum { N = 9 };
    const taut_surface *surface = taut_model_surface(model, 0);
    const taut_basis *u = taut_surface_u(surface), *v = taut_surface_v(surface);
    double normals[N * N][3], mean[3] = {0, 0, 0};
    int tame = 1;
    for (int i = 0; i < N * N; i++) {
        const double s = (double)(i / N) / (N - 1), t = (double)(i % N) / (N - 1);
        double x[3][3];
        if (taut_surface_eval(surface, taut_basis_lo(u) * (1 - s) + taut_basis_hi(u) * s,
                              taut_basis_lo(v) * (1 - t) + taut_basis_hi(v) * t, 1,
                              &x[0][0]) != TAUT_OK) {
            return 0;
        }
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            normals[i][c] = x[1][d] * x[2][e] - x[1][e] * x[2][d];
            mean[c] += normals[i][c] / (N * N);
        }
    }
    const double size = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
    for (int i = 0; i < N * N; i++) {
        const double *n = normals[i];
        tame &= n[0] * mean[0] + n[1] * mean[1] + n[2] * mean[2] > 0.1 * size;
    }
    return tame;
}

static void make_and_certify(const taut_problem *problem)
{
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {TAUT_OK, 0, 0, "", ""};
    const taut_make_options options = {.monitor = patient_monitor(2)};
    taut_status status = taut_make(problem, &options, &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
        return;
    }
    require_model(model);
    status = taut_model_surface_count(model) > 0 && is_tame(model)
                 ? taut_certify(model, problem, NULL, &certificate, &error)
                 : TAUT_OK;
    if (status != TAUT_OK) {
        require_error(status, &error);
    } else if (certificate != NULL) {
        require_certificate(certificate);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *text = (const char *)data;
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_error error = {TAUT_OK, 0, 0, "", ""};
    taut_status status = taut_problem_read_text(text, size, "problem", &problem, &error);

    if (status != TAUT_OK) {
        require_error(status, &error);
    } else if (size <= SMALL) {
        make_and_certify(problem);
    }
    taut_problem_free(problem);
    error.status = TAUT_OK;
    status = taut_model_read_text(text, size, "model", &model, &error);
    if (status != TAUT_OK) {
        require_error(status, &error);
    } else {
        require_model(model);
    }
    taut_model_free(model);
    return 0;
}
