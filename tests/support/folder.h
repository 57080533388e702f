/* folder.h -- a folder of a test's own for its files, and files whole. What goes wrong is a CHECK.
 */
#ifndef TAUT_TEST_FOLDER_H
#define TAUT_TEST_FOLDER_H

#include <stddef.h>

/* Makes the folder, one for a process; returns its path. */
const char *folder_make(void);
/* A path in it; four may be in use at a time. */
const char *in_folder(const char *name);
int folder_entries(void); /* hidden ones too */
void folder_empty(void);
void folder_remove(void); /* with all that is in it */

void file_put(const char *path, const void *bytes, size_t length);
void file_put_text(const char *path, const char *text);
/* All of it and a zero byte, free() it; NULL and no failure where there is no such file. length may
 * be NULL. */
char *file_bytes(const char *path, size_t *length);

/* Makes another folder; 0 where that went well. */
int folder_add(const char *path);

#endif /* TAUT_TEST_FOLDER_H */
