#include "fake_cad.h"

#include "check.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char variable[] = "TAUT_TEST_ROLE";
static const double knots[4] = {0, 0, 1, 1}, points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};

const taut_cad_item fake_cad_items[2] = {
    {"face",
     {1, 1},
     {2, 2},
     {knots, knots},
     points,
     NULL,
     TAUT_CAD_APPROXIMATE,
     "part",
     1 + 0x12ab34,
     0,
     {0}},
    {"edge", {1, 0}, {2, 0}, {knots, NULL}, points, NULL, TAUT_CAD_APPROXIMATE, NULL, 0, 0, {0}}};

static const taut_error nothing_wrong = {.status = TAUT_OK};

static int is_role(const char *role, const char *name)
{
    return strcmp(role, name) == 0;
}

static void wait_for_ever(void)
{
    for (;;) {
        pause();
    }
}

/* What the host left open or blocked; 0 if nothing. */
static int count_left(void)
{
    sigset_t blocked;
    int left = 0;
#if defined(__GLIBC__) /* which alone can close what the host has left open for all to inherit */
    for (int file = STDERR_FILENO + 1; file < 256; file++) {
        left += fcntl(file, F_GETFD) >= 0;
    }
#endif
    sigprocmask(SIG_BLOCK, NULL, &blocked);
    for (int number = 1; number < 32; number++) {
        struct sigaction action;
        left += sigismember(&blocked, number) == 1;
        left += number != SIGKILL && number != SIGSTOP && sigaction(number, NULL, &action) == 0 &&
                action.sa_handler == SIG_IGN;
    }
    return left;
}

static void say_otherwise(const char *role)
{
    char bytes[4096] = "what does it want?";
    if (is_role(role, "echo")) {
        ssize_t got = 0;
        while ((got = read(STDIN_FILENO, bytes, sizeof bytes)) > 0 &&
               write(STDOUT_FILENO, bytes, (size_t)got) == got) {
        }
    } else if (is_role(role, "stranger")) {
        _exit(write(STDOUT_FILENO, bytes, 18) == 18 ? 0 : 1);
    } else if (is_role(role, "deaf")) {
        close(STDOUT_FILENO);
        wait_for_ever();
    } else if (is_role(role, "mute")) {
        wait_for_ever();
    }
    while (is_role(role, "endless") && write(STDOUT_FILENO, bytes, sizeof bytes) > 0) {
    }
    if (is_role(role, "no-load")) {
        _exit(127);
    }
}

static void say_hello(const char *role)
{
    taut_cad_hello hello = taut_cad_hello_answer();
    hello.version += is_role(role, "version") ? 1 : 0;
    hello.layout += is_role(role, "layout") ? 1 : 0;
    taut_cad_put_hello(stdout, hello);
    fflush(stdout);
}

static void end_with(int status)
{
    taut_error error = nothing_wrong;
    snprintf(error.reason, sizeof error.reason, "library");
    _exit(taut_cad_put_end(stdout, (taut_status)status, &error) ? 0 : 1);
}

/* One that begins as taut-cad does. */
static void answer(const char *role)
{
    int number = 0;
    say_hello(role);
    if (sscanf(role, "signal %d", &number) == 1) {
        signal(number, SIG_DFL); /* which a sanitizer may have taken for itself */
        kill(getpid(), number);
        wait_for_ever();
    }
    if (is_role(role, "hang")) {
        wait_for_ever();
    }
    if (is_role(role, "reader") || is_role(role, "half")) {
        taut_cad_put_unit(stdout, "in");
        taut_cad_put_item(stdout, &fake_cad_items[0]);
    }
    if (is_role(role, "half")) {
        _exit(fwrite("I12345", 1, 6, stdout) == 6 && fflush(stdout) == 0 ? 0 : 1);
    }
    if (is_role(role, "reader")) {
        taut_cad_put_item(stdout, &fake_cad_items[1]);
    } else if (is_role(role, "writer")) {
        taut_cad_put_text(stdout, "an IGES file\n", 13);
    } else if (is_role(role, "nonsense")) {
        end_with(12345);
    } else if (is_role(role, "host")) {
        end_with(count_left() == 0 ? TAUT_OK : TAUT_INTERNAL);
    } else {
        _exit(0);
    }
    end_with(TAUT_OK);
}

void fake_cad_play(void)
{
    static const char *const others[] = {"silent", "no-load", "stranger", "echo",
                                         "mute",   "endless", "deaf"};
    const char *role = getenv(variable);
    if (role == NULL) {
        return;
    }
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (is_role(role, others[i])) {
            say_otherwise(role);
            _exit(0);
        }
    }
    answer(role);
}

void fake_cad_as(const char *role)
{
    if (role == NULL) {
        CHECK(unsetenv("TAUT_CAD") == 0 && unsetenv(variable) == 0, "environment");
        return;
    }
    CHECK(setenv("TAUT_CAD", "/proc/self/exe", 1) == 0 && setenv(variable, role, 1) == 0,
          "environment");
}
