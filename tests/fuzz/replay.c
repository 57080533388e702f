/* replay.c -- runs a fuzz target over the files of a folder, once each, without libFuzzer: the
 * inputs that were found before stay tested in every build. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* 1 if the file could be read and was run. */
static int replay(const char *path)
{
    FILE *file = fopen(path, "rb");
    uint8_t *data = NULL;
    long size = -1;
    int done = 0;

    if (file != NULL && fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 &&
        fseek(file, 0, SEEK_SET) == 0) {
        data = malloc(size > 0 ? (size_t)size : 1); /* exact, so that sanitizers see the end */
        if (data != NULL && fread(data, 1, (size_t)size, file) == (size_t)size) {
            LLVMFuzzerTestOneInput(data, (size_t)size);
            done = 1;
        }
    }
    free(data);
    if (file != NULL) {
        fclose(file);
    }
    return done;
}

int main(int argc, char **argv)
{
    DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
    const struct dirent *entry = NULL;
    int count = 0;
    int failures = 0;

    if (folder == NULL) {
        fprintf(stderr, "usage: %s FOLDER, a folder of inputs\n", argv[0]);
        return 2;
    }
    while ((entry = readdir(folder)) != NULL) {
        char path[4096];
        if (entry->d_name[0] == '.') {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s", argv[1], entry->d_name);
        fprintf(stderr, "%s\n", path); /* the last one printed is the one that crashed */
        failures += !replay(path);
        count++;
    }
    closedir(folder);
    printf("%d inputs, %d could not be read\n", count, failures);
    return count == 0 || failures != 0;
}
