#include "construct/common/workspace.h"

#include "core/memory.h"

#include <stddef.h>

struct taut_workspace {
    void *kept;
    taut_workspace_release release;
    size_t reuses;
};

taut_status taut_workspace_new(taut_workspace **workspace)
{
    taut_workspace *made = NULL;
    if (workspace == NULL) {
        return TAUT_BAD_ARGUMENT;
    }
    made = taut_alloc_zero(1, sizeof *made);
    if (made == NULL) {
        return TAUT_NO_MEMORY;
    }
    *workspace = made;
    return TAUT_OK;
}

void taut_workspace_free(taut_workspace *workspace)
{
    if (workspace != NULL) {
        taut_workspace_keep(workspace, NULL, NULL);
        taut_free(workspace);
    }
}

size_t taut_workspace_reuses(const taut_workspace *workspace)
{
    return workspace->reuses;
}

void *taut_workspace_find(const taut_workspace *workspace, taut_workspace_release release)
{
    return workspace != NULL && workspace->release == release ? workspace->kept : NULL;
}

void taut_workspace_keep(taut_workspace *workspace, void *kept, taut_workspace_release release)
{
    if (workspace->kept != NULL) {
        workspace->release(workspace->kept);
    }
    workspace->kept = kept;
    workspace->release = release;
}

void taut_workspace_count(taut_workspace *workspace)
{
    workspace->reuses++;
}
