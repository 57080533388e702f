/* posix.h -- what tests call of POSIX and Windows has under other names. Read before every test there. */
#ifndef WINDOWS_POSIX_H
#define WINDOWS_POSIX_H

#include <stddef.h>

int setenv(const char *name, const char *value, int replace);
int unsetenv(const char *name);
char *mkdtemp(char *path);
/* malloc's, so that free() takes it: at a multiple of 16, whatever is asked for. */
void *aligned_alloc(size_t alignment, size_t size);

#endif /* WINDOWS_POSIX_H */
