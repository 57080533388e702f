#include "folder.h"

#include <sys/stat.h>

int folder_add(const char *path)
{
    return mkdir(path, 0700);
}
