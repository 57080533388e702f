/* workspace.h -- the inside of a taut_workspace: what a construction leaves for the next make.
 *
 * It holds one thing, the last. The function that frees it tells whose it is.
 */
#ifndef TAUT_CONSTRUCT_COMMON_WORKSPACE_H
#define TAUT_CONSTRUCT_COMMON_WORKSPACE_H

#include "taut/construct.h"

typedef void (*taut_workspace_release)(void *kept);

/* What is kept if it is freed by `release`; NULL if there is nothing of the kind, or no workspace.
 */
void *taut_workspace_find(const taut_workspace *workspace, taut_workspace_release release);
/* Takes `kept` over, in place of what was there. */
void taut_workspace_keep(taut_workspace *workspace, void *kept, taut_workspace_release release);
/* One more make was served by what is kept. */
void taut_workspace_count(taut_workspace *workspace);

#endif /* TAUT_CONSTRUCT_COMMON_WORKSPACE_H */
