/* basis_ops.h -- what one basis must provide, and the inside of taut_basis. */
#ifndef TAUT_BASIS_OPS_H
#define TAUT_BASIS_OPS_H

#include "basis/basis_list.h"
#include "taut/basis.h"

/* Members of a basis document, as bits: which a type needs, which it may have. */
enum {
    TAUT_MEMBER_DEGREE = 1 << 0,
    TAUT_MEMBER_COUNT = 1 << 1,
    TAUT_MEMBER_KNOTS = 1 << 2,
    TAUT_MEMBER_ALPHA = 1 << 3,
    TAUT_MEMBER_BETA = 1 << 4,
    TAUT_MEMBER_GAMMA = 1 << 5,
    TAUT_MEMBER_SEGMENTS = 1 << 6,
    TAUT_MEMBER_RANGE = 1 << 7
};

/* The shape of a basis, worked out from its spec before memory is taken. */
typedef struct taut_basis_shape {
    int count;      /* functions */
    int local;      /* alive on a span */
    int span_count; /* non-empty spans */
    int knot_count; /* full form; 0 where there are no knots */
    int degree;     /* of the polynomials on each span; -1 where they are none */
} taut_basis_shape;

struct taut_change_ops; /* change.h */
struct taut_quasi_kind; /* quasi.h */

typedef struct taut_basis_ops {
    const char *type;
    unsigned needs;  /* members a document must give; a reader asks for them, because 0 is a
                        value like any other for some (ce-bezier's shape numbers) */
    unsigned allows; /* members that may be given besides */
    int weights;     /* rational weights allowed */
    int layers;      /* e^t and e^-t are among the functions: layers of width 1 at the ends of long
                        spans */
    /* Is the spec legal? Fills the shape. `functions` as in taut_basis_new. Members present, degree
     * within its limit and all numbers finite have been checked already. */
    taut_status (*plan)(const struct taut_basis_ops *ops, const taut_basis_spec *spec,
                        int functions, taut_basis_shape *shape, taut_error *error);
    /* Fills basis->breaks, ->first, ->knots, ->data (shape and spec are in place). Cannot fail. */
    void (*fill)(taut_basis *basis);
    /* values[k][a], k = 0..order, a = 0..local-1, at t of the closed span. */
    void (*eval)(const taut_basis *basis, int span, double t, int order, double *values);
    /* The same at t + rest, rest a rounding error of t. NULL where spans are not much narrower than
     * their range, so that it changes nothing that matters. */
    void (*eval_beside)(const taut_basis *basis, int span, double t, double rest, int order,
                        double *values);
    /* t[i], i < count: the coefficients of the function t, sum t[i] N_i(t) = t. NULL where it is
     * not among the functions. */
    void (*linear)(const taut_basis *basis, double *t);
    const struct taut_change_ops *changes; /* splitting, refining and so on */
    const struct taut_quasi_kind *quasi;   /* which of the c- and h- bases; NULL for others */
} taut_basis_ops;

enum { TAUT_BASIS_DATA = 24 };

/* Immutable once made. */
struct taut_basis {
    const taut_basis_ops *ops;
    taut_basis_spec spec; /* as given, defaults filled in; spec.knots points at knots below */
    taut_basis_shape shape;
    double *breaks; /* [span_count + 1] */
    int *first;     /* [span_count] */
    int *knot_span; /* [span_count]: the knot interval of a span; NULL without knots */
    double *knots;  /* [knot_count], full form */
    double data[TAUT_BASIS_DATA]; /* constants a type prepares for its own eval */
};

#define TAUT_BASIS_DECLARE(identifier, name) extern const taut_basis_ops taut_basis_##identifier;
TAUT_BASIS_LIST(TAUT_BASIS_DECLARE)
#undef TAUT_BASIS_DECLARE

/* Values as of taut_basis_eval at t + rest, rest a rounding error of t; t in the closed span. In a
 * span 1e-6 wide beside 1, parameters are rounded to 1e-10 of it: nodes of a quadrature rule that
 * carry their rest integrate as if the span began at 0. */
void taut_basis_eval_beside(const taut_basis *basis, int span, double t, double rest, int order,
                            double *values);

/* The ops of a type by its name, or NULL; and the i-th of the list, NULL beyond the end. */
const taut_basis_ops *taut_basis_ops_find(const char *type);
const taut_basis_ops *taut_basis_ops_at(int i);

#endif /* TAUT_BASIS_OPS_H */
