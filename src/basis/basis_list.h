/* basis_list.h -- every basis taut knows, sorted by name. One line adds one: its file exports
 * `const taut_basis_ops taut_basis_<name>` and nothing else. */
#ifndef TAUT_BASIS_LIST_H
#define TAUT_BASIS_LIST_H

/*    identifier, name in documents */
#define TAUT_BASIS_LIST(X)                                                                         \
    X(bezier, "bezier")                                                                            \
    X(bspline, "bspline")

#endif /* TAUT_BASIS_LIST_H */
