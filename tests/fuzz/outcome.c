#include "outcome.h"

#include "io/format.h"
#include "platform/system.h"
#include "taut/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double deadline; /* of the one monitor there is */

void require(int condition)
{
    if (!condition) {
        abort();
    }
}

void require_error(taut_status status, const taut_error *error)
{
    require(status == error->status && error->message[0] != '\0');
    require(memchr(error->message, '\0', sizeof error->message) != NULL);
    require(memchr(error->where, '\0', sizeof error->where) != NULL);
}

static char *text_of(const taut_model *model, size_t *length)
{
    const taut_write_options options = {0};
    char *text = NULL;
    FILE *out = taut_system_spool(&text, length);
    require(out != NULL);
    require(taut_format_json.write(model, &options, out, NULL) == TAUT_OK);
    require(taut_system_spooled(out, &text, length) == 0);
    return text;
}

void require_model(const taut_model *model)
{
    size_t length = 0, again_length = 0;
    char *text = text_of(model, &length), *again = NULL;
    taut_model *back = NULL;
    for (int s = 0; s < taut_model_surface_count(model); s++) {
        const taut_surface *surface = taut_model_surface(model, s);
        const long count = (long)taut_basis_count(taut_surface_u(surface)) *
                           taut_basis_count(taut_surface_v(surface));
        for (long i = 0; i < 3 * count; i++) {
            require(isfinite(taut_surface_points(surface)[i]));
        }
    }
    require(taut_model_read_text(text, length, "text", &back, NULL) == TAUT_OK);
    again = text_of(back, &again_length);
    require(length == again_length && memcmp(text, again, length) == 0);
    free(text);
    free(again);
    taut_model_free(back);
}

void require_certificate(const taut_certificate *certificate)
{
    taut_verdict verdict = TAUT_TRUE;
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        require(claim->holds != TAUT_TRUE || (!isnan(claim->residual) && !isnan(claim->limit)));
        const int is_offered =
            strcmp(claim->claim, "least") == 0; /* undecided, it does not count */
        if (claim->holds == TAUT_FALSE ||
            (claim->holds == TAUT_UNDECIDED && verdict == TAUT_TRUE && !is_offered)) {
            verdict = claim->holds;
        }
    }
    require(taut_certificate_holds(certificate) == verdict);
}

static int is_tame_surface(const taut_surface *surface)
{
    enum { N = 9 };
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

int is_tame(const taut_model *model)
{
    int tame = taut_model_surface_count(model) > 0;
    for (int i = 0; i < taut_model_surface_count(model) && tame; i++) {
        tame = is_tame_surface(taut_model_surface(model, i));
    }
    return tame;
}

static int look_at_clock(void *context, double done, const char *what)
{
    (void)context;
    (void)done;
    (void)what;
    return (double)clock() / CLOCKS_PER_SEC > deadline;
}

taut_monitor patient_monitor(double seconds)
{
    const taut_monitor monitor = {look_at_clock, NULL};
    deadline = (double)clock() / CLOCKS_PER_SEC + seconds;
    return monitor;
}
