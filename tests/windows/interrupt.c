/* interrupt.c FILE -- begins to write FILE and presses Ctrl-C: the process ends with 130 and nothing is left (interrupt.py looks).
 * 3: there is no console to press it in. */
#include "platform/system.h"
#include "taut/write.h"

#include <stdio.h>
#include <windows.h>

static taut_outputs *outputs;

static void tidy(int code)
{
    (void)code;
    taut_outputs_abandon(outputs);
}

int main(int argc, char **argv)
{
    if (taut_system_begin(&argc, &argv) != 0 || argc != 2 ||
        taut_outputs_new(&outputs) != TAUT_OK) {
        return 2;
    }
    taut_system_on_interrupt(tidy);
    if (taut_outputs_text(outputs, "text", 4, argv[1], NULL) != TAUT_OK) {
        return 2;
    }
    FreeConsole();
    if (!AllocConsole() || !GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0)) {
        return 3;
    }
    Sleep(20000);
    return 1;
}
