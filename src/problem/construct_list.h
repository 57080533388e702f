/* construct_list.h -- every construction taut knows, sorted by name. One line adds one:
 *
 *     src/construct/<identifier>/   exports  const taut_construct_ops taut_construct_<identifier>
 *     src/certify/<identifier>/     exports  const taut_certify_ops   taut_certify_<identifier>
 *     src/io/problem/               exports  const taut_document_ops  taut_document_<identifier>
 *
 * docs/adding.md has the whole table.
 */
#ifndef TAUT_CONSTRUCT_LIST_H
#define TAUT_CONSTRUCT_LIST_H

/*    identifier, name in documents */
#define TAUT_CONSTRUCT_LIST(X)                                                                     \
    X(asymptotic, "asymptotic")                                                                    \
    X(biharmonic, "biharmonic")                                                                    \
    X(bonnet, "bonnet")                                                                            \
    X(dirichlet, "dirichlet")                                                                      \
    X(film, "film")                                                                                \
    X(harmonic, "harmonic")                                                                        \
    X(harmonic_extension, "harmonic-extension")                                                    \
    X(pattern, "pattern")                                                                          \
    X(pipe, "pipe")                                                                                \
    X(plateau, "plateau")                                                                          \
    X(trace, "trace")

#endif /* TAUT_CONSTRUCT_LIST_H */
