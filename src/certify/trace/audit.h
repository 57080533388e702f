/* audit.h -- what figures of details are held against, and the one that is farthest off. */
#ifndef TAUT_CERTIFY_TRACE_AUDIT_H
#define TAUT_CERTIFY_TRACE_AUDIT_H

#include "certify/trace/course.h"
#include "certify/trace/seams.h"

/* The figure that is farthest off, relative to what it is of. INFINITY where one is missing or cannot be found again. */
typedef struct taut_net_off {
    double residual;
    char where[96];
} taut_net_off;

void taut_net_off_take(taut_net_off *off, double residual, const char *name, const char *member);

/* Over the range: a place that is so near to a knot may as well be beyond it. */
#define TAUT_NET_AT_KNOT 1e-9

/* Is the place on an inner knot line? */
int taut_net_is_on_knot(const taut_surface *surface, const double at[2]);

/* What figures are held against. */
typedef struct taut_net_audit {
    const taut_net_lines *lines;
    taut_net_cells *cells; /* of surfaces times 2^-unit */
    const taut_net_rule *rule;
    const taut_trace_problem *problem; /* or NULL: then laths are what details say they are */
    int unit;
    double size;      /* times 2^-unit */
    double tolerance; /* of what is drawn, over the size */
    double roundest;  /* the largest R of a grid */
    int is_minimal;   /* by its coefficients */
    int is_saddle;    /* K < 0 everywhere, by proof */
    const taut_net_seams *seams;
} taut_net_audit;

/* R where H^2 and K agree to many digits. */
double taut_net_radius(const taut_forms *forms);
/* What rounding of the surface, of size `size`, may make of curvatures in a direction there, over R; at most 1e-4. */
double taut_net_blur(const taut_surface *surface, double size, const double at[2],
                     const taut_forms *forms);

/* A member of a record of details; NaN, or "", where it is not there. */
double taut_net_number(const taut_record *at, const char *member);
const char *taut_net_text(const taut_record *at, const char *member);

/* The surface that a record names, where there are several; else the first one. */
int taut_net_surface_of(const taut_net_audit *audit, const taut_record *at);

#endif /* TAUT_CERTIFY_TRACE_AUDIT_H */
