#define _GNU_SOURCE /* dladdr */
#include "platform/module.h"

#include "core/fail.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

/* The folder of the object this code is in, "" if unknown. */
static void own_folder(char *folder, size_t size)
{
    static const char here;
    Dl_info info;
    folder[0] = '\0';
    if (dladdr(&here, &info) != 0 && info.dli_fname != NULL) {
        char *slash = NULL;
        snprintf(folder, size, "%s", info.dli_fname);
        slash = strrchr(folder, '/');
        if (slash != NULL) {
            *slash = '\0';
        } else {
            folder[0] = '\0';
        }
    }
}

static void *open_module(const char *name)
{
    static const char *const places[] = {"taut", "../lib/taut", "../modules"};
    char folder[1024];
    char path[1280];
    void *handle = NULL;

    own_folder(folder, sizeof folder);
    for (size_t i = 0; handle == NULL && folder[0] != '\0' && i < 3; i++) {
        snprintf(path, sizeof path, "%s/%s/taut-%s.so", folder, places[i], name);
        handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
    if (handle == NULL) {
        snprintf(path, sizeof path, "%s/taut-%s.so", TAUT_MODULE_INSTALL_DIR, name);
        handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
    if (handle == NULL) {
        snprintf(path, sizeof path, "%s/taut-%s.so", TAUT_MODULE_BUILD_DIR, name);
        handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
    return handle;
}

taut_status taut_module_load(const char *name, const char *package, const void **table,
                             taut_error *error)
{
    void *handle = open_module(name);
    const void *symbol = handle != NULL ? dlsym(handle, "taut_module_table") : NULL;
    if (symbol == NULL) {
        return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                         "the part of taut that needs %s is not installed: install %s and build "
                         "taut again",
                         name, package);
    }
    *table = symbol;
    return TAUT_OK;
}
