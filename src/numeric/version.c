/* version.c -- which taut this is, and how it computes. */
#include "taut/version.h"

#include "numeric/kernel/kernel.h"

const char *taut_version(void)
{
    return TAUT_VERSION;
}

const char *taut_kernel_in_use(void)
{
    return taut_kernel_name();
}
