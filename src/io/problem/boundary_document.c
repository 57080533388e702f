#include "io/problem/boundary_document.h"

#include "io/problem/boundary_file.h"
#include "io/problem/member.h"

int taut_boundary_document_is(const taut_reader *document)
{
    return taut_reader_has(document, "boundary");
}

static void keep_net(const taut_net_document *read, taut_dirichlet_problem *net)
{
    net->u = read->u;
    net->v = read->v;
    net->points = read->points;
    net->known = read->known;
    net->weights = read->weights;
}

void taut_boundary_document_net(taut_reader *document, taut_problem *problem,
                                taut_dirichlet_problem *net)
{
    taut_net_document read = {NULL, NULL, NULL, NULL, NULL};

    if (taut_boundary_document_is(document)) {
        taut_boundary_file_net(document, problem, &read);
    } else {
        taut_net_document_read(document, problem->arena, &read);
    }
    keep_net(&read, net);
}

void taut_boundary_document_curves(taut_reader *document, taut_problem *problem,
                                   const taut_curve *const curves[TAUT_SIDES],
                                   taut_dirichlet_problem *net)
{
    taut_net_document read = {NULL, NULL, NULL, NULL, NULL};
    taut_boundary_curves_net(document, problem, curves, &read);
    keep_net(&read, net);
}

void taut_boundary_document_bezier(taut_reader *document, taut_problem *problem,
                                   const char *const *others, int agree,
                                   const taut_curve *sides[TAUT_SIDES])
{
    taut_boundary_file_bezier(document, problem, others, agree, sides);
}
