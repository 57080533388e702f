#include "folder.h"

#include "check.h"

#include <dirent.h>
#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/taut-test-XXXXXX";

const char *folder_make(void)
{
    CHECK(mkdtemp(folder) != NULL, "%s cannot be made", folder);
    return folder;
}

const char *in_folder(const char *name)
{
    static char paths[4][96];
    static int next = 0;
    next = (next + 1) % 4;
    snprintf(paths[next], sizeof paths[next], "%s/%s", folder, name);
    return paths[next];
}

int folder_entries(void)
{
    DIR *directory = opendir(folder);
    int count = -2; /* "." and ".." */
    while (directory != NULL && readdir(directory) != NULL) {
        count++;
    }
    closedir(directory);
    return count;
}

static int remove_inside(const char *path, const struct stat *about, int kind, struct FTW *place)
{
    (void)about;
    if (place->level == 0) {
        return 0;
    }
    return kind == FTW_DP ? rmdir(path) : unlink(path);
}

void folder_empty(void)
{
    CHECK(nftw(folder, remove_inside, 16, FTW_DEPTH | FTW_PHYS) == 0, "%s", folder);
}

void folder_remove(void)
{
    folder_empty();
    CHECK(rmdir(folder) == 0, "%s", folder);
}

void file_put(const char *path, const void *bytes, size_t length)
{
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(bytes, 1, length, file) == length && fclose(file) == 0, "%s",
          path);
}

void file_put_text(const char *path, const char *text)
{
    file_put(path, text, strlen(text));
}

char *file_bytes(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    size_t count = 0, room = 1 << 16;
    char *bytes = file != NULL ? malloc(room) : NULL;
    while (bytes != NULL && (count += fread(bytes + count, 1, room - count, file)) == room) {
        room *= 2;
        bytes = realloc(bytes, room);
    }
    if (file != NULL) {
        CHECK(bytes != NULL && ferror(file) == 0, "%s", path);
        fclose(file);
    }
    if (bytes != NULL) {
        bytes[count] = '\0';
    }
    if (length != NULL) {
        *length = count;
    }
    return bytes;
}
