/* branch.h -- Algorithm 1: every sign branch of the quadrilateral, its least curve energy, and the
 * quadrilateral there.
 *
 * A branch is the sign of mu on each edge, where P_2 = P_0 + lambda a_0 + mu c_0: to which side of
 * its start leg an edge bends. For a regular patch nu, its like at the end, has the same sign.
 */
#ifndef TAUT_ASYMPTOTIC_BRANCH_H
#define TAUT_ASYMPTOTIC_BRANCH_H

#include "construct/asymptotic/corner_data.h"
#include "taut/monitor.h"

enum { TAUT_BRANCHES_MAX = 16 };

typedef struct taut_branch {
    int signs[4];  /* 1, -1; 0 on a straight edge */
    double energy; /* sum of the curve energies */
    int found;     /* a minimum was found; else nothing but signs and failure is set */
    double gap;    /* where the closing condition cannot be met: its least violation, a logarithm */
    int unknowns;  /* the energy was minimised over */
    taut_quad quad;
} taut_branch;

/* The closing condition of the corner torsions ([WangZhuLi2017] docs page (4.5)). */
typedef enum taut_closing {
    TAUT_CLOSING_NONE,      /* a straight edge breaks the ring, or degree >= 5 */
    TAUT_CLOSING_IDENTITY,  /* holds for all shapes the data allows */
    TAUT_CLOSING_CONSTRAINT /* takes one unknown away */
} taut_closing;

typedef struct taut_branches {
    int count;
    taut_branch list[TAUT_BRANCHES_MAX + 1]; /* the last is scratch */
    taut_closing closing;
    int unknowns; /* that the energy was minimised over */
} taut_branches;

/* All branches with a minimum, lowest energy first. The corners may have been moved: `rounding` is
 * that of their coordinates as they were given. TAUT_NO_SOLUTION if there is none: *error says
 * which condition fails and what is nearest. */
taut_status taut_branches_find(const taut_asymptotic_corners *corners, double rounding,
                               const taut_monitor *monitor, taut_branches *branches,
                               taut_error *error);

/* Index of the branch the problem asks for; TAUT_NO_SOLUTION names those there are. */
taut_status taut_branch_choose(const taut_asymptotic_corners *corners,
                               const taut_branches *branches, int *index, taut_error *error);

/* signs in the order v0, v1, u0, u1 as text, such as "+-+-". */
void taut_branch_text(const int signs[4], char text[5]);

/* The energy of all four curves of a quadrilateral. */
double taut_quad_energy(const taut_curve_rule *rule, const taut_quad *quad);

#endif /* TAUT_ASYMPTOTIC_BRANCH_H */
