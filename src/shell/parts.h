/* parts.h -- what the steps of finding shells hand to each other. */
#ifndef TAUT_SHELL_PARTS_H
#define TAUT_SHELL_PARTS_H

#include "shell/shell.h"

/* Edges among themselves, by 4 face + edge. */
typedef struct taut_shell_joints {
    unsigned char *pole;     /* [4 count]: the edge is one point */
    unsigned char *loop;     /* it ends where it begins */
    int *partner;            /* the edge that is the same, or -1 */
    unsigned char *reversed; /* the partner runs against it */
    double *gap;             /* the proved distance of the two */
} taut_shell_joints;

/* edges.c: which edges are points, and which two are one, however their faces are turned. */
taut_status taut_shell_join_edges(const taut_surface *const *surfaces, int count, double moved,
                                  taut_arena *arena, taut_shell_joints *joints);

/* turn.c: turns faces so that joined edges run against each other, and parts those that cannot;
 * shell[face] numbers what hangs together, by its first face: so many shells are returned. `queue`
 * is room for count faces. */
int taut_shell_turn(int count, taut_shell_joints *joints, unsigned char *turned, int *shell,
                    int *queue);

/* volume.c: adds volume and area of one surface, times `sign`, seen from `origin`, lengths in units of
 * 2^scale: an estimate. `room` is double[taut_shell_volume_room(surface)]. TAUT_NO_MEMORY. */
typedef struct taut_shell_content {
    double volume, area;
} taut_shell_content;

size_t taut_shell_volume_room(const taut_surface *surface);
taut_status taut_shell_add_volume(const taut_surface *surface, const double origin[3], int scale,
                                  double sign, double *room, taut_shell_content *content);
/* The same of a lid on edge 4 f + e of surface f, which is a loop: the cone from where the loop begins, turned as the surface
 * is. Its area is left out. */
taut_status taut_shell_add_lid(const taut_surface *surface, int edge, const double origin[3],
                               int scale, double sign, double *room, taut_shell_content *content);

#endif /* TAUT_SHELL_PARTS_H */
