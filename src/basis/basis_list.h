/* basis_list.h -- every basis taut knows, sorted by name. One line adds one: its file exports
 * `const taut_basis_ops taut_basis_<identifier>`. */
#ifndef TAUT_BASIS_LIST_H
#define TAUT_BASIS_LIST_H

/*    identifier, name in documents */
#define TAUT_BASIS_LIST(X)                                                                         \
    X(bezier, "bezier")                                                                            \
    X(bspline, "bspline")                                                                          \
    X(c_bezier, "c-bezier")                                                                        \
    X(c_bspline, "c-bspline")                                                                      \
    X(ce_bezier, "ce-bezier")                                                                      \
    X(h_bezier, "h-bezier")                                                                        \
    X(h_bspline, "h-bspline")

#endif /* TAUT_BASIS_LIST_H */
