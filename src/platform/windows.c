/* windows.c -- taut on Windows, by MinGW-w64.
 *
 * Paths are UTF-8 in taut and wide here. A new file is written under a passing name beside its target and moved over it
 * when it is whole.
 */
#include "platform/system.h"

#include "taut/limits.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <malloc.h>
#include <process.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <ntsecapi.h>
#include <shellapi.h>

enum { TRIES = 64, MOVE_TRIES = 20, MOVE_WAIT = 15, STACK = 4 << 20, WIDE_ROOM = TAUT_PATH_ROOM };

/* ---- reasons ---- */

/* The words that other systems have: messages are the same everywhere. */
const char *taut_system_reason(int number, char *text, size_t size)
{
    static const struct {
        int number;
        const char *text;
    } rows[] = {
        {EPERM, "Operation not permitted"},   {ENOENT, "No such file or directory"},
        {EIO, "Input/output error"},          {EBADF, "Bad file descriptor"},
        {ENOMEM, "Cannot allocate memory"},   {EACCES, "Permission denied"},
        {EBUSY, "Device or resource busy"},   {EEXIST, "File exists"},
        {ENODEV, "No such device"},           {ENOTDIR, "Not a directory"},
        {EISDIR, "Is a directory"},           {EINVAL, "Invalid argument"},
        {EMFILE, "Too many open files"},      {EFBIG, "File too large"},
        {ENOSPC, "No space left on device"},  {ESPIPE, "Illegal seek"},
        {EROFS, "Read-only file system"},     {EPIPE, "Broken pipe"},
        {ENAMETOOLONG, "File name too long"}, {ELOOP, "Too many levels of symbolic links"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (rows[i].number == number) {
            return rows[i].text;
        }
    }
    snprintf(text, size, "error %d", number);
    return text;
}

/* What went wrong last, as a number of errno.h. */
static int last_reason(void)
{
    static const struct {
        DWORD error;
        int number;
    } rows[] = {
        {ERROR_FILE_NOT_FOUND, ENOENT},
        {ERROR_PATH_NOT_FOUND, ENOENT},
        {ERROR_BAD_PATHNAME, ENOENT},
        {ERROR_BAD_NETPATH, ENOENT},
        {ERROR_INVALID_DRIVE, ENOENT},
        {ERROR_INVALID_NAME, EINVAL},
        {ERROR_DIRECTORY, ENOTDIR},
        {ERROR_ACCESS_DENIED, EACCES},
        {ERROR_SHARING_VIOLATION, EBUSY},
        {ERROR_LOCK_VIOLATION, EBUSY},
        {ERROR_FILE_EXISTS, EEXIST},
        {ERROR_ALREADY_EXISTS, EEXIST},
        {ERROR_DISK_FULL, ENOSPC},
        {ERROR_HANDLE_DISK_FULL, ENOSPC},
        {ERROR_WRITE_PROTECT, EROFS},
        {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
        {ERROR_TOO_MANY_OPEN_FILES, EMFILE},
        {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
        {ERROR_OUTOFMEMORY, ENOMEM},
        {ERROR_BROKEN_PIPE, EPIPE},
        {ERROR_NO_DATA, EPIPE},
        {ERROR_CANT_RESOLVE_FILENAME, ELOOP},
        {ERROR_NO_UNICODE_TRANSLATION, EINVAL},
    };
    const DWORD error = GetLastError();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (rows[i].error == error) {
            return rows[i].number;
        }
    }
    return EIO;
}

/* ---- memory ---- */

enum { ALIGNED = 16, KERNEL_ALIGNED = 64 };

void *taut_system_take(size_t bytes)
{
    return _aligned_malloc(bytes, ALIGNED);
}

void *taut_system_take_aligned(size_t bytes)
{
    return _aligned_malloc(bytes, KERNEL_ALIGNED);
}

void *taut_system_take_zero(size_t bytes)
{
    void *const block = _aligned_malloc(bytes, ALIGNED);
    return block != NULL ? memset(block, 0, bytes) : NULL;
}

void *taut_system_resize(void *block, size_t bytes)
{
    return _aligned_realloc(block, bytes, ALIGNED);
}

void taut_system_release(void *block)
{
    _aligned_free(block);
}

/* ---- threads and modules ---- */

typedef struct job {
    void (*run)(void *context, int part);
    void *context;
    int part;
} job;

static unsigned __stdcall run_job(void *argument)
{
    const job *j = argument;
    j->run(j->context, j->part);
    return 0;
}

void taut_system_threads(int count, void (*run)(void *context, int part), void *context)
{
    job jobs[TAUT_THREADS_MAX];
    HANDLE handles[TAUT_THREADS_MAX];

    for (int p = count - 1; p >= 0; p--) {
        jobs[p] = (job){run, context, p};
        handles[p] = p > 0 ? (HANDLE)_beginthreadex(NULL, STACK, run_job, &jobs[p],
                                                    STACK_SIZE_PARAM_IS_A_RESERVATION, NULL)
                           : NULL;
        if (handles[p] == NULL) {
            run_job(&jobs[p]);
        }
    }
    for (int p = 1; p < count; p++) {
        if (handles[p] != NULL) {
            WaitForSingleObject(handles[p], INFINITE);
            CloseHandle(handles[p]);
        }
    }
}

const void *taut_system_module(const char *name)
{
    (void)name;
    return NULL;
}

const char *taut_system_lacks_modules(void)
{
    return "is not there on Windows: use taut on Linux, WSL will do";
}

/* ---- paths ---- */

static int is_separator(wchar_t c)
{
    return c == L'/' || c == L'\\';
}

const char *taut_system_last_part(const char *path)
{
    const char *last = path;
    for (const char *c = path; *c != '\0'; c++) {
        if (*c == '/' || *c == '\\' || (*c == ':' && c == path + 1)) {
            last = c + 1;
        }
    }
    return last;
}

int taut_system_is_rooted(const char *path)
{
    return path[0] == '/' || path[0] == '\\' || (path[0] != '\0' && path[1] == ':');
}

int taut_system_same_target(const char *a, const char *b)
{
    wchar_t wide[2][WIDE_ROOM];
    if (MultiByteToWideChar(CP_UTF8, 0, a, -1, wide[0], WIDE_ROOM) == 0 ||
        MultiByteToWideChar(CP_UTF8, 0, b, -1, wide[1], WIDE_ROOM) == 0) {
        return strcmp(a, b) == 0;
    }
    return CompareStringOrdinal(wide[0], -1, wide[1], -1, TRUE) == CSTR_EQUAL;
}

/* The path as Windows has it, in full, so that it may be longer than 260 characters; 0 or a reason.
 * Devices, such as NUL, begin with "\\.\". */
static int full_of(const char *path, wchar_t full[WIDE_ROOM])
{
    enum { PREFIX_ROOM = 8 };
    wchar_t wide[WIDE_ROOM];
    wchar_t *const to = full + PREFIX_ROOM;
    const wchar_t *prefix = L"";
    size_t skip = 0;

    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, WIDE_ROOM) == 0) {
        return GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : EINVAL;
    }
    const DWORD length = GetFullPathNameW(wide, WIDE_ROOM - PREFIX_ROOM, to, NULL);
    if (length == 0) {
        return last_reason();
    }
    if (length >= WIDE_ROOM - PREFIX_ROOM) {
        return ENAMETOOLONG;
    }
    if (wcsncmp(to, L"\\\\?\\", 4) != 0 && wcsncmp(to, L"\\\\.\\", 4) != 0) {
        const int is_network = to[0] == L'\\' && to[1] == L'\\';
        prefix = is_network ? L"\\\\?\\UNC\\" : L"\\\\?\\";
        skip = is_network ? 2 : 0;
    }
    const size_t prefix_length = wcslen(prefix);
    memmove(full + prefix_length, to + skip, (length + 1 - skip) * sizeof *to);
    memcpy(full, prefix, prefix_length * sizeof *prefix);
    return 0;
}

static int is_device(const wchar_t *full)
{
    return wcsncmp(full, L"\\\\.\\", 4) == 0;
}

/* ---- reading ---- */

enum { SHARED = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE };

/* A descriptor of the C library for an open handle, which it then owns; -1, and the handle closed. */
static int descriptor_of(HANDLE handle, int flags)
{
    const int file = _open_osfhandle((intptr_t)handle, flags | _O_BINARY);
    if (file < 0) {
        CloseHandle(handle);
    }
    return file;
}

static int look_at(HANDLE handle, taut_source *source)
{
    BY_HANDLE_FILE_INFORMATION about;
    source->size = -1;
    if (GetFileType(handle) != FILE_TYPE_DISK || !GetFileInformationByHandle(handle, &about)) {
        return 0;
    }
    source->size = (double)about.nFileSizeHigh * 0x1p32 + (double)about.nFileSizeLow;
    return about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY ? EISDIR : 0;
}

int taut_system_open(const char *path, taut_source *source)
{
    wchar_t full[WIDE_ROOM];
    if (strcmp(path, "-") == 0) {
        source->file = 0;
        _setmode(0, _O_BINARY);
        return look_at(GetStdHandle(STD_INPUT_HANDLE), source);
    }
    int reason = path[0] == '\0' ? ENOENT : full_of(path, full);
    if (reason != 0) {
        return reason;
    }
    /* with backup semantics a folder opens, and can be told to be one */
    const HANDLE handle = CreateFileW(full, GENERIC_READ, SHARED, NULL, OPEN_EXISTING,
                                      FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (handle == INVALID_HANDLE_VALUE) {
        return last_reason();
    }
    reason = look_at(handle, source);
    if (reason != 0) {
        CloseHandle(handle);
        return reason;
    }
    source->file = descriptor_of(handle, _O_RDONLY);
    return source->file >= 0 ? 0 : EMFILE;
}

int taut_system_read(taut_source *source, char *to, size_t room, size_t *count)
{
    enum { AT_ONCE = 1 << 30 };
    const int got = _read(source->file, to, room < AT_ONCE ? (unsigned)room : AT_ONCE);
    *count = got > 0 ? (size_t)got : 0;
    return got < 0 ? errno : 0;
}

void taut_system_close(taut_source *source)
{
    if (source->file != 0) {
        _close(source->file);
    }
}

/* ---- what is there ---- */

static taut_place place_of(const wchar_t *full)
{
    if (is_device(full)) {
        return TAUT_PLACE_OTHER;
    }
    const DWORD attributes = GetFileAttributesW(full);
    return attributes == INVALID_FILE_ATTRIBUTES          ? TAUT_PLACE_NONE
           : (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? TAUT_PLACE_FOLDER
                                                          : TAUT_PLACE_FILE;
}

taut_place taut_system_place_of(const char *path)
{
    wchar_t full[WIDE_ROOM];
    return path[0] != '\0' && full_of(path, full) == 0 ? place_of(full) : TAUT_PLACE_NONE;
}

/* The name that a file or folder that is there has in full, links followed; 0 or a reason. */
static int final_name(const wchar_t *full, wchar_t name[WIDE_ROOM])
{
    const HANDLE handle =
        CreateFileW(full, 0, SHARED, NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (handle == INVALID_HANDLE_VALUE) {
        return last_reason();
    }
    const DWORD length =
        GetFinalPathNameByHandleW(handle, name, WIDE_ROOM, FILE_NAME_NORMALIZED | VOLUME_NAME_DOS);
    const int reason = length == 0 ? last_reason() : length >= WIDE_ROOM ? ENAMETOOLONG : 0;
    CloseHandle(handle);
    return reason;
}

/* The same for one that is not there: the folder's name, and the last part. */
static int future_name(wchar_t *full, wchar_t name[WIDE_ROOM])
{
    wchar_t *const slash = wcsrchr(full, L'\\');
    wchar_t *const last = slash + 1; /* a full name has one */
    wchar_t first = *last;
    if (first == L'\0') {
        return ENOENT;
    }
    if (wcspbrk(last, L"<>:\"|?*") != NULL) {
        return EINVAL; /* no name; after a colon, that of a stream of another file */
    }
    *last = L'\0';
    const taut_place folder = place_of(full);
    int reason = folder == TAUT_PLACE_FOLDER ? final_name(full, name)
                 : folder == TAUT_PLACE_NONE ? ENOENT
                                             : ENOTDIR;
    *last = first;
    if (reason != 0) {
        return reason;
    }
    size_t length = wcslen(name);
    if (length + 1 + wcslen(last) >= WIDE_ROOM) {
        return ENAMETOOLONG;
    }
    if (length > 0 && !is_separator(name[length - 1])) {
        name[length++] = L'\\';
    }
    wcscpy(name + length, last);
    return 0;
}

/* What a target that is no device is called, in full. */
static int name_of_target(wchar_t *full, taut_place place, wchar_t name[WIDE_ROOM])
{
    if (place == TAUT_PLACE_FOLDER) {
        return EISDIR;
    }
    if (place == TAUT_PLACE_NONE) {
        return future_name(full, name);
    }
    const DWORD attributes = GetFileAttributesW(full);
    return (attributes & FILE_ATTRIBUTE_READONLY) != 0 ? EACCES : final_name(full, name);
}

int taut_system_target(const char *path, taut_target_kind *kind, char target[TAUT_PATH_ROOM])
{
    wchar_t full[WIDE_ROOM], name[WIDE_ROOM];

    if (strcmp(path, "-") == 0) {
        *kind = TAUT_TARGET_STANDARD;
        target[0] = '\0';
        return 0;
    }
    if (path[0] == '\0') {
        return ENOENT;
    }
    int reason = full_of(path, full);
    if (reason != 0) {
        return reason;
    }
    const taut_place place = place_of(full);
    *kind = place == TAUT_PLACE_OTHER ? TAUT_TARGET_DEVICE : TAUT_TARGET_FILE;
    if (place == TAUT_PLACE_OTHER) {
        wcscpy(name, full);
    } else {
        reason = name_of_target(full, place, name);
    }
    if (reason == 0 &&
        WideCharToMultiByte(CP_UTF8, 0, name, -1, target, TAUT_PATH_ROOM, NULL, NULL) == 0) {
        reason = ENAMETOOLONG;
    }
    return reason;
}

/* ---- writing ---- */

static atomic_int is_ending; /* an interrupt is at work, on a thread of its own */

/* 16 hexadecimal digits that nobody can guess. 0: there is no chance to be had. */
static int put_random(char *to)
{
    static const char hex[] = "0123456789abcdef";
    unsigned char random[8];
    if (!RtlGenRandom(random, sizeof random)) {
        return 0;
    }
    for (size_t i = 0; i < sizeof random; i++) {
        to[2 * i] = hex[random[i] >> 4];
        to[2 * i + 1] = hex[random[i] & 15];
    }
    to[2 * sizeof random] = '\0';
    return 1;
}

static int open_new(taut_new_file *made, HANDLE *handle)
{
    char *name = strrchr(made->temporary, '\\') + 1; /* the target is spelled in full */
    wchar_t full[WIDE_ROOM];
    int reason = EEXIST;

    for (int i = 0; i < TRIES && reason == EEXIST; i++) {
        memcpy(name, ".taut-", 6);
        reason = put_random(name + 6) ? full_of(made->temporary, full) : EIO;
        if (reason == 0) {
            made->pending = 1; /* first, so that an interrupt never finds a file not known */
            *handle = CreateFileW(full, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, NULL,
                                  CREATE_NEW, FILE_ATTRIBUTE_NORMAL, NULL);
            reason = *handle == INVALID_HANDLE_VALUE ? last_reason() : 0;
            made->pending = reason == 0;
        }
    }
    return reason;
}

int taut_system_create(taut_new_file *made)
{
    HANDLE handle = INVALID_HANDLE_VALUE;
    const int reason = open_new(made, &handle);
    if (reason != 0) {
        return reason;
    }
    if (atomic_load(&is_ending)) { /* it may have looked for what is to be removed before */
        CloseHandle(handle);
        taut_system_discard(made);
        Sleep(INFINITE);
    }
    const int file = descriptor_of(handle, _O_WRONLY);
    made->stream = file >= 0 ? _fdopen(file, "wb") : NULL;
    if (made->stream == NULL) {
        if (file >= 0) {
            _close(file);
        }
        taut_system_discard(made);
        return ENOMEM;
    }
    return 0;
}

const char *taut_system_own_path(const taut_new_file *file, char own[TAUT_OWN_ROOM])
{
    (void)own;
    return file->temporary;
}

/* Somebody who looks at every new file may hold it, or the old one, for a moment. */
int taut_system_place(taut_new_file *file)
{
    wchar_t from[WIDE_ROOM], to[WIDE_ROOM];
    int reason = full_of(file->temporary, from);
    if (reason == 0) {
        reason = full_of(file->target, to);
    }
    if (reason != 0) {
        return reason;
    }
    for (int i = 0; i < MOVE_TRIES; i++) {
        if (MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING)) {
            file->pending = 0;
            return 0;
        }
        reason = last_reason();
        if (reason != EBUSY && reason != EACCES) {
            return reason;
        }
        Sleep(MOVE_WAIT);
    }
    return reason;
}

void taut_system_discard(taut_new_file *file)
{
    if (file->stream != NULL) {
        fclose(file->stream);
        file->stream = NULL;
    }
    taut_system_remove(file);
    file->pending = 0;
}

/* Also of a file that is open: it is gone when it is closed. */
void taut_system_remove(const taut_new_file *file)
{
    wchar_t full[WIDE_ROOM];
    if (file->pending && full_of(file->temporary, full) == 0) {
        DeleteFileW(full);
    }
}

int taut_system_open_device(const char *target, FILE **stream)
{
    wchar_t full[WIDE_ROOM];
    const int reason = full_of(target, full);
    *stream = NULL;
    if (reason != 0) {
        return reason;
    }
    const HANDLE handle = CreateFileW(full, GENERIC_WRITE, SHARED, NULL, OPEN_EXISTING, 0, NULL);
    if (handle == INVALID_HANDLE_VALUE) {
        return last_reason();
    }
    const int file = descriptor_of(handle, _O_WRONLY);
    *stream = file >= 0 ? _fdopen(file, "wb") : NULL;
    if (*stream == NULL && file >= 0) {
        _close(file);
    }
    return *stream != NULL ? 0 : EMFILE;
}

int taut_system_open_growing(const char *path, FILE **stream)
{
    wchar_t full[WIDE_ROOM];
    const int reason = full_of(path, full);
    if (reason != 0) {
        return reason;
    }
    const taut_place place = place_of(full);
    if (place == TAUT_PLACE_FOLDER || place == TAUT_PLACE_OTHER || is_device(full)) {
        return place == TAUT_PLACE_FOLDER ? EISDIR : EINVAL;
    }
    const HANDLE handle = CreateFileW(full, GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ, NULL,
                                      OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, NULL);
    if (handle == INVALID_HANDLE_VALUE) {
        return last_reason();
    }
    const int file = descriptor_of(handle, _O_RDWR);
    *stream = file >= 0 ? _fdopen(file, "r+b") : NULL;
    if (*stream == NULL && file >= 0) {
        _close(file);
    }
    return *stream != NULL ? 0 : EMFILE;
}

int taut_system_cut(FILE *stream, double length)
{
    if (fflush(stream) != 0) {
        return errno;
    }
    const errno_t reason = _chsize_s(_fileno(stream), (int64_t)length);
    return reason != 0 ? reason : _fseeki64(stream, 0, SEEK_END) == 0 ? 0 : errno;
}

/* The C library has no streams into memory: a file that Windows need not write to a disk, and that
 * is gone when it is closed. */
FILE *taut_system_spool(char **text, size_t *length)
{
    char name[32] = "taut-";
    wchar_t wide[32], path[MAX_PATH + 32];
    const DWORD folder = GetTempPathW(MAX_PATH, path);

    *text = NULL;
    *length = 0;
    if (folder == 0 || folder > MAX_PATH || !put_random(name + 5)) {
        return NULL;
    }
    MultiByteToWideChar(CP_UTF8, 0, name, -1, wide, 32);
    wcscpy(path + folder, wide);
    const HANDLE handle =
        CreateFileW(path, GENERIC_READ | GENERIC_WRITE, FILE_SHARE_DELETE, NULL, CREATE_NEW,
                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    const int file = handle != INVALID_HANDLE_VALUE ? descriptor_of(handle, _O_RDWR) : -1;
    FILE *const spool = file >= 0 ? _fdopen(file, "w+b") : NULL;
    if (spool == NULL && file >= 0) {
        _close(file);
    }
    return spool;
}

/* All of the file. */
static int read_back(int file, char **text, size_t *length)
{
    const int64_t size = _filelengthi64(file);
    char *const block = size >= 0 ? taut_system_take((size_t)size + 1) : NULL;
    taut_source source = {.file = file};
    size_t filled = 0, got = 1;

    if (block == NULL || _lseeki64(file, 0, SEEK_SET) != 0) {
        taut_system_release(block);
        return EOF;
    }
    while (filled < (size_t)size && got > 0 &&
           taut_system_read(&source, block + filled, (size_t)size - filled, &got) == 0) {
        filled += got;
    }
    if (filled < (size_t)size) {
        taut_system_release(block);
        return EOF;
    }
    block[filled] = '\0';
    *text = block;
    *length = filled;
    return 0;
}

int taut_system_spooled(FILE *spool, char **text, size_t *length)
{
    const int reason = fflush(spool) == 0 ? read_back(_fileno(spool), text, length) : EOF;
    fclose(spool);
    return reason;
}

/* ---- the program ---- */

static UINT code_page_before;

static void restore_code_page(void)
{
    SetConsoleOutputCP(code_page_before);
}

/* The words as UTF-8, for the life of the process. */
static char **words_of(wchar_t **wide, int count)
{
    char **const words = calloc((size_t)count + 1, sizeof *words);
    for (int i = 0; words != NULL && i < count; i++) {
        const int room = WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, NULL, 0, NULL, NULL);
        words[i] = room > 0 ? malloc((size_t)room) : NULL;
        if (words[i] == NULL) {
            return NULL;
        }
        WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, words[i], room, NULL, NULL);
    }
    return words;
}

int taut_system_begin(int *count, char ***words)
{
    int found = 0;
    wchar_t **const wide = CommandLineToArgvW(GetCommandLineW(), &found);
    char **const own = wide != NULL ? words_of(wide, found) : NULL;

    LocalFree(wide);
    if (own == NULL) {
        return ENOMEM;
    }
    *count = found;
    *words = own;
    for (int file = 0; file <= 2; file++) {
        _setmode(file, _O_BINARY);
    }
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOOPENFILEERRORBOX); /* no window asks for a disk */
    code_page_before = GetConsoleOutputCP();
    if (code_page_before != 0 && code_page_before != CP_UTF8) {
        SetConsoleOutputCP(CP_UTF8);
        atexit(restore_code_page);
    }
    return 0;
}

int taut_system_is_terminal(taut_standard stream)
{
    const HANDLE handle =
        GetStdHandle(stream == TAUT_STANDARD_OUTPUT ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
    DWORD mode = 0;
    return GetConsoleMode(handle, &mode) &&
           SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

int64_t taut_system_date(void)
{
    const time_t now = time(NULL);
    return now > 0 ? (int64_t)now : 0;
}

double taut_system_seconds(void)
{
    LARGE_INTEGER now, frequency;
    QueryPerformanceFrequency(&frequency);
    QueryPerformanceCounter(&now);
    return (double)now.QuadPart / (double)frequency.QuadPart;
}

int taut_system_processors(void)
{
    SYSTEM_INFO info;
    GetSystemInfo(&info);
    return info.dwNumberOfProcessors < 1                  ? 1
           : info.dwNumberOfProcessors > TAUT_THREADS_MAX ? TAUT_THREADS_MAX
                                                          : (int)info.dwNumberOfProcessors;
}

/* Seconds that the processors have worked for this process. */
static double worked(void)
{
    FILETIME times[4];
    double sum = 0;
    if (!GetProcessTimes(GetCurrentProcess(), &times[0], &times[1], &times[2], &times[3])) {
        return 0;
    }
    for (int i = 2; i < 4; i++) { /* in the kernel, and in the program */
        sum += (double)times[i].dwHighDateTime * 0x1p32 + (double)times[i].dwLowDateTime;
    }
    return 1e-7 * sum;
}

static const char *notice; /* what the alarm says */
static int notice_after;

static unsigned __stdcall watch(void *nothing)
{
    enum { LOOK_EVERY = 100 };
    DWORD done = 0;
    (void)nothing;
    while (worked() < notice_after) {
        Sleep(LOOK_EVERY);
    }
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), notice, (DWORD)strlen(notice), &done, NULL);
    return 0;
}

void taut_system_pause(double seconds)
{
    Sleep((DWORD)(1e3 * seconds));
}

void taut_system_alarm(int seconds, const char *text)
{
    notice = text;
    notice_after = seconds;
    const uintptr_t thread =
        _beginthreadex(NULL, 1 << 16, watch, NULL, STACK_SIZE_PARAM_IS_A_RESERVATION, NULL);
    if (thread != 0) {
        CloseHandle((HANDLE)thread);
    }
}

void taut_system_say(const char *text)
{
    (void)!_write(2, text, (unsigned)strlen(text));
}

static void (*volatile tidy_up)(int code);

/* On a thread of its own, with the others at work: so the process ends here and now. */
static BOOL WINAPI interrupted(DWORD event)
{
    atomic_store(&is_ending, 1);
    const int code = event == CTRL_C_EVENT ? 130 : 143;
    tidy_up(code);
    if (code_page_before != 0) {
        restore_code_page();
    }
    TerminateProcess(GetCurrentProcess(), (UINT)code);
    return TRUE;
}

void taut_system_on_interrupt(void (*tidy)(int code))
{
    static int is_set;
    tidy_up = tidy;
    if (!is_set) {
        is_set = SetConsoleCtrlHandler(interrupted, TRUE) != 0;
    }
}
