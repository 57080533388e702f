#define _CRT_RAND_S /* rand_s */
#include "windows/posix.h"

#include "folder.h"

#include <direct.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int setenv(const char *name, const char *value, int replace)
{
    (void)replace;
    return _putenv_s(name, value) == 0 ? 0 : -1;
}

int unsetenv(const char *name)
{
    return setenv(name, "", 1);
}

int folder_add(const char *path)
{
    return _mkdir(path);
}

/* The X at the end are replaced; the folder it is to be in is made if need be. */
char *mkdtemp(char *path)
{
    char *const end = path + strlen(path) - 6;
    char *const slash = strrchr(path, '/');
    if (slash != NULL && slash > path) {
        *slash = '\0';
        _mkdir(path);
        *slash = '/';
    }
    for (unsigned tries = 0; tries < 100; tries++) {
        unsigned number = 0;
        char digits[8];
        rand_s(&number);
        snprintf(digits, sizeof digits, "%06x", number & 0xffffffU);
        memcpy(end, digits, 6);
        if (_mkdir(path) == 0) {
            return path;
        }
    }
    return NULL;
}

void *aligned_alloc(size_t alignment, size_t size)
{
    (void)alignment;
    return malloc(size);
}
