/* probe.h -- what OpenCASCADE sees in a STEP file, asked of it without taut. */
#ifndef TAUT_TEST_PROBE_H
#define TAUT_TEST_PROBE_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct step_probe {
    int is_read;
    int valid;                                              /* BRepCheck_Analyzer */
    int closed;                                             /* every shell of a solid */
    int solids, shells, faces, edges, vertices, free_edges; /* different ones; edges with a curve */
    int colours;                                            /* how many faces have one */
    double volume, area; /* by OpenCASCADE's own integration, in mm */
    double tolerance;    /* the largest of an edge or a vertex, in mm */
    double box[6];       /* x y z, least and largest, in mm, of points on the faces */
    char product[300];
} step_probe;

/* 0 where OpenCASCADE was not there when this was built. */
int step_probe_is_there(void);
/* Prints the area of each face of a STEP or IGES file by itself, a line each, integrated to 1e-9; 0 where it cannot be read. */
int step_probe_areas(const char *path);
void step_probe_file(const char *path, step_probe *found);

#ifdef __cplusplus
}
#endif
#endif /* TAUT_TEST_PROBE_H */
