/* left_out_nets.c -- nets of curves are left out of the module that is held small (TAUT_WEB_NETS): their documents are read, and
 * making or judging one says where it is done. */
#include "certify/certify_ops.h"
#include "construct/construct_ops.h"
#include "core/fail.h"

static taut_status refuse(taut_error *error)
{
    return taut_fail(error, TAUT_IO, "not-installed", NULL, taut_none, taut_none,
                     "nets of curves are not traced by this module: let the program `taut trace` "
                     "do it, or the studio, whose "
                     "module has them");
}

static taut_status make(const void *data, const taut_make_options *options, taut_model **model,
                        taut_error *error)
{
    (void)data;
    (void)options;
    (void)model;
    return refuse(error);
}

static taut_status certify(const taut_model *model, const void *data, const taut_audit *audit,
                           taut_certificate *certificate, taut_error *error)
{
    (void)model;
    (void)data;
    (void)audit;
    (void)certificate;
    return refuse(error);
}

const taut_construct_ops taut_construct_trace = {.make = make};
const taut_certify_ops taut_certify_trace = {.certify = certify};
