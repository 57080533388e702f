/* turn.c -- faces turned alike, from each first face outwards by breadth.
 *
 * Round a face, its inside on the left, the way goes along u1 and v0 and against u0 and v1; round a
 * turned face the other way. Two faces at an edge agree where their ways along it are opposite. Where
 * that would want a face both ways, as a Moebius band does, the edge is parted.
 */
#include "shell/parts.h"

/* Does the way round an unturned face go along the curve of edge `first`, seen from `edge`? */
static int way_of(int edge, int is_reversed)
{
    return taut_shell_is_along(edge) != is_reversed;
}

static void part_edge(taut_shell_joints *joints, int edge)
{
    joints->partner[joints->partner[edge]] = -1;
    joints->partner[edge] = -1;
}

/* Visits what joins one edge of a face: the face beyond is taken into the shell, or agrees, or the
 * edge is parted. Returns 1 where a face was taken in. */
static int cross_edge(int edge, taut_shell_joints *joints, unsigned char *turned, int *shell)
{
    const int other = joints->partner[edge];
    const int here = edge / 4, there = other / 4;
    const int same_way = way_of(edge, 0) == way_of(other, joints->reversed[edge]);
    const int wanted = turned[here] ^ same_way;
    if (shell[there] < 0) {
        shell[there] = shell[here];
        turned[there] = (unsigned char)wanted;
        return 1;
    }
    if (turned[there] != wanted) {
        part_edge(joints, edge);
    }
    return 0;
}

int taut_shell_turn(int count, taut_shell_joints *joints, unsigned char *turned, int *shell,
                    int *queue)
{
    int shells = 0;
    for (int f = 0; f < count; f++) {
        shell[f] = -1;
        turned[f] = 0;
    }
    for (int f = 0; f < count; f++) {
        int length = 0;
        if (shell[f] >= 0) {
            continue;
        }
        shell[f] = shells++;
        queue[length++] = f;
        for (int k = 0; k < length; k++) {
            for (int e = 4 * queue[k]; e < 4 * queue[k] + 4; e++) {
                if (joints->partner[e] >= 0 && cross_edge(e, joints, turned, shell)) {
                    queue[length++] = joints->partner[e] / 4;
                }
            }
        }
    }
    return shells;
}
