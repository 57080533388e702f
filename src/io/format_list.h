/* format_list.h -- every format taut writes, sorted by ending. One line adds one: some file exports
 * `const taut_format_ops taut_format_<identifier>`. A format with two endings has two lines. */
#ifndef TAUT_IO_FORMAT_LIST_H
#define TAUT_IO_FORMAT_LIST_H

/*    identifier, ending, what it holds */
#define TAUT_FORMAT_LIST(X)                                                                        \
    X(glb, "glb", "mesh: triangles with normals for renderers, glTF 2.0 in metres; --colour")      \
    X(json, "json", "the model itself, exact: bases, points, details and certificate")             \
    X(obj, "obj", "mesh: quads with normals and parameters, one group per surface")                \
    X(pdf, "pdf", "figure: shaded surfaces on a page")                                             \
    X(ply, "ply", "mesh: triangles with normals and parameters, binary, double precision")         \
    X(png, "png", "figure: shaded surfaces as an image")                                           \
    X(stl, "stl", "mesh: triangles, binary, turned outwards where the surfaces close")             \
    X(svg, "svg", "figure: shaded surfaces as vectors")

#endif /* TAUT_IO_FORMAT_LIST_H */
