/* format_list.h -- every format of libtaut-draw, sorted by ending, as io/format_list.h has the library's own. One line adds
 * one: some file of draw or page exports `const taut_format_ops taut_format_<identifier>`. */
#ifndef TAUT_DRAW_FORMAT_LIST_H
#define TAUT_DRAW_FORMAT_LIST_H

/*    identifier, ending, what it holds */
#define TAUT_DRAW_FORMAT_LIST(X)                                                                   \
    X(html, "html", "a page to turn the model in: one file, no network, with the certificate")     \
    X(pdf, "pdf", "figure: shaded surfaces on a page")                                             \
    X(png, "png", "figure: shaded surfaces as an image")                                           \
    X(svg, "svg", "figure: shaded surfaces as vectors")

#endif /* TAUT_DRAW_FORMAT_LIST_H */
