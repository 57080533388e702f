/* command_list.h -- every command, in the order the help shows them. One line adds one: its file
 * exports `const cli_command cli_command_<identifier>`. */
#ifndef TAUT_COMMAND_LIST_H
#define TAUT_COMMAND_LIST_H

#define CLI_COMMAND_LIST(X)                                                                        \
    X(make)                                                                                        \
    X(certify)                                                                                     \
    X(measure)                                                                                     \
    X(join)                                                                                        \
    X(eval)                                                                                        \
    X(split)                                                                                       \
    X(refine)                                                                                      \
    X(convert)                                                                                     \
    X(boundary)                                                                                    \
    X(panels)                                                                                      \
    X(trace)                                                                                       \
    X(pattern)                                                                                     \
    X(view)                                                                                        \
    X(studio)                                                                                      \
    X(example)                                                                                     \
    X(reproduce)                                                                                   \
    X(schema)

#endif /* TAUT_COMMAND_LIST_H */
