/* film.c -- the soap film in a frame of four arches: built, proved, written as a mesh.
 *
 *     cc film.c $(pkg-config --cflags --libs taut) -o film
 */
#include <stdio.h>
#include <taut/taut.h>

enum { N = 5 }; /* points in each direction */

/* A square frame whose edges arch up and down in turn; the points inside are not known. */
static void frame(double points[N][N][3], unsigned char known[N][N])
{
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const double u = i / (N - 1.0), v = j / (N - 1.0);
            points[i][j][0] = u;
            points[i][j][1] = v;
            points[i][j][2] = u * (1 - u) - v * (1 - v);
            known[i][j] = i == 0 || j == 0 || i == N - 1 || j == N - 1;
        }
    }
}

/* What the certificate says, one line a claim. */
static void tell(const taut_certificate *certificate)
{
    static const char *const verdicts[] = {"does not hold", "holds", "is undecided"};
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        const taut_claim *claim = taut_certificate_claim(certificate, i);
        printf("%s %s\n", claim->claim, verdicts[claim->holds]);
    }
    printf("area %.6f\n",
           taut_record_number(taut_record_get(taut_certificate_figures(certificate), "area")));
}

int main(void)
{
    const taut_basis_spec spec = {.type = "bezier", .degree = N - 1};
    double points[N][N][3];
    unsigned char known[N][N];
    taut_plateau_problem problem = {.net = {.points = &points[0][0][0], .known = &known[0][0]}};
    taut_basis *basis = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_error error = {.status = TAUT_OK};
    taut_status status = taut_basis_new(&spec, N, &basis, &error);

    frame(points, known);
    problem.net.u = problem.net.v = basis;
    if (status == TAUT_OK) {
        status = taut_plateau_make(&problem, NULL, &model, &error);
    }
    if (status == TAUT_OK) {
        status = taut_plateau_certify(model, &problem, NULL, &certificate, &error);
    }
    if (status == TAUT_OK) {
        tell(certificate);
        taut_model_set_certificate(model, certificate); /* which is the model's from now on */
        status = taut_model_write(model, "film.obj", NULL, &error);
    }
    if (status != TAUT_OK) {
        fprintf(stderr, "%s %s\n", error.where, error.message);
    }
    taut_model_free(model);
    taut_basis_free(basis);
    return taut_status_exit_code(status);
}
