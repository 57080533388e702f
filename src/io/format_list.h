/* format_list.h -- every format libtaut writes, sorted by ending; figures and pages have a list of their
 * own (draw/format_list.h). One line adds one: some file exports
 * `const taut_format_ops taut_format_<identifier>`. A format with two endings has two lines. */
#ifndef TAUT_IO_FORMAT_LIST_H
#define TAUT_IO_FORMAT_LIST_H

/*    identifier, ending, what it holds */
#define TAUT_FORMAT_LIST(X)                                                                        \
    X(threemf, "3mf", "mesh: bodies for printing, with unit, colours and names; --thickness")      \
    X(csv, "csv", "table: cables of a film, laths of a net, cut cloth, bends of a pipe")           \
    X(dxf, "dxf", "drawing: curves on layers as lines and splines, or flat panels, 1:1")           \
    X(geomdl, "geomdl.json", "NURBS-Python's exchange JSON, within --tolerance (1e-6)")            \
    X(glb, "glb", "mesh: triangles with normals for renderers, glTF 2.0 in metres; --colour")      \
    X(iges, "iges", "CAD: NURBS within --tolerance (1e-6) of the model, mostly exact")             \
    X(iges, "igs", "the same as iges")                                                             \
    X(json, "json", "the model itself, exact: bases, points, details and certificate")             \
    X(obj, "obj", "mesh: quads with normals and parameters, one group per surface")                \
    X(ply, "ply", "mesh: triangles with normals and parameters, binary, double precision")         \
    X(step, "step", "CAD: NURBS within --tolerance (1e-6), sewn, solid where they close")          \
    X(stl, "stl", "mesh: triangles, binary, single precision")                                     \
    X(step, "stp", "the same as step")                                                             \
    X(vtu, "vtu", "VTK: exact Bezier cells or quads, with H, K, E - G, F and the control nets")

#endif /* TAUT_IO_FORMAT_LIST_H */
