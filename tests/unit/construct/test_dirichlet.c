/* test_dirichlet.c -- the worked examples against exact rationals, and what is refused. */
#include "check.h"
#include "problems.h"

#include <string.h>

/* An entry of the solution of an example: exact rational control points ([WuWang2011] section 4).
 */
typedef struct expected {
    int example, index;
    double point[3];
} expected;

static const expected solutions[] = {
    {1, 4, {0, 0, -0.5}},
    {2, 5, {-0.5, -0.5, 0.375}},
    {2, 6, {-0.5, 0.5, 0.375}},
    {2, 9, {0.5, -0.5, 0.375}},
    {2, 10, {0.5, 0.5, 0.375}},
    {3, 5, {-43.0 / 156, -43.0 / 156, 1.0 / 6}},
    {3, 6, {-43.0 / 156, 43.0 / 156, 1.0 / 6}},
    {3, 9, {43.0 / 156, -43.0 / 156, 1.0 / 6}},
    {3, 10, {43.0 / 156, 43.0 / 156, 1.0 / 6}},
    {4, 6, {-12907.0 / 38283, -409.0 / 546, 1576.0 / 6733}},
    {4, 7, {-13327.0 / 38283, 0, 9057.0 / 47131}},
    {4, 8, {-12907.0 / 38283, 409.0 / 546, 1576.0 / 6733}},
    {4, 11, {12907.0 / 38283, -409.0 / 546, 1576.0 / 6733}},
    {4, 12, {13327.0 / 38283, 0, 9057.0 / 47131}},
    {4, 13, {12907.0 / 38283, 409.0 / 546, 1576.0 / 6733}},
};

static void test_examples(void)
{
    for (size_t k = 0; k < sizeof solutions / sizeof *solutions; k++) {
        const expected *e = &solutions[k];
        test_problem problem = problem_example(e->example);
        const double *points = NULL;
        taut_model *model = problem_make(&problem, &points);
        for (int c = 0; model != NULL && c < 3; c++) {
            CHECK_NEAR(points[3 * e->index + c], e->point[c], 4e-15, "example %d point %d",
                       e->example, e->index);
        }
        taut_model_free(model);
        problem_free(&problem);
    }
}

int main(void)
{
    test_examples();
    return check_failures != 0;
}
