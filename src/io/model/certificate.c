/* certificate.c -- certificates in documents. What a saved certificate says is not trusted
 * anywhere: `taut_certify` proves the model again. */
#include "core/fail.h"
#include "io/model/model.h"
#include "taut/limits.h"

#include <math.h>

static const char *const certificate_members[] = {"construct", "holds", "claims", "figures", NULL};
static const char *const claim_members[] = {"claim", "residual", "limit", "holds", "where", NULL};

/* A number, or null for one that is not finite. */
static taut_status read_residual(const taut_json *at, double *value, taut_error *error)
{
    if (taut_json_kind_at(at) == TAUT_JSON_NULL) {
        *value = taut_none;
        return TAUT_OK;
    }
    return taut_json_number(at, value, error);
}

static taut_status read_verdict(const taut_json *at, taut_verdict *verdict, taut_error *error)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    if (kind != TAUT_JSON_TRUE && kind != TAUT_JSON_FALSE && kind != TAUT_JSON_NULL) {
        return taut_json_expected(at, error, "true, false or null");
    }
    *verdict = kind == TAUT_JSON_TRUE    ? TAUT_TRUE
               : kind == TAUT_JSON_FALSE ? TAUT_FALSE
                                         : TAUT_UNDECIDED;
    return TAUT_OK;
}

static taut_status read_claim(const taut_json *at, taut_certificate *certificate, taut_error *error)
{
    taut_status status = taut_json_object(at, claim_members, error);
    const taut_json name = taut_json_member(at, "claim");
    const taut_json residual = taut_json_member(at, "residual");
    const taut_json limit = taut_json_member(at, "limit");
    const taut_json holds = taut_json_member(at, "holds");
    const taut_json where = taut_json_member(at, "where");
    taut_claim claim = {"", 0, 0, TAUT_FALSE, ""};

    if (status == TAUT_OK) {
        status = taut_json_text(&name, &claim.claim, error);
    }
    if (status == TAUT_OK) {
        status = read_residual(&residual, &claim.residual, error);
    }
    if (status == TAUT_OK) {
        status = read_residual(&limit, &claim.limit, error);
    }
    if (status == TAUT_OK) {
        status = read_verdict(&holds, &claim.holds, error);
    }
    if (status == TAUT_OK && where.value != NULL) {
        status = taut_json_text(&where, &claim.where, error);
    }
    if (status == TAUT_OK && taut_certificate_add(certificate, &claim) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    return status;
}

static taut_status read_claims(const taut_json *at, taut_certificate *certificate,
                               taut_error *error)
{
    size_t count = 0;
    taut_status status = taut_json_array(at, 0, TAUT_OBJECTS_MAX, "claims", &count, error);
    for (size_t i = 0; status == TAUT_OK && i < count; i++) {
        const taut_json claim = taut_json_item(at, i);
        status = read_claim(&claim, certificate, error);
    }
    return status;
}

static taut_status read_figures(const taut_json *at, taut_certificate *certificate,
                                taut_error *error)
{
    taut_record *figures = NULL;
    taut_status status = TAUT_OK;
    if (taut_json_kind_at(at) != TAUT_JSON_OBJECT) {
        return taut_json_expected(at, error, "an object");
    }
    status = taut_json_record(at, &figures, error);
    if (status == TAUT_OK) {
        taut_certificate_set_figures(certificate, figures);
    }
    return status;
}

/* The members besides the name. `holds` follows from the claims: only its kind is looked at. */
static taut_status read_members(const taut_json *at, taut_certificate *certificate,
                                taut_error *error)
{
    const taut_json holds = taut_json_member(at, "holds");
    const taut_json claims = taut_json_member(at, "claims");
    const taut_json figures = taut_json_member(at, "figures");
    taut_verdict verdict = TAUT_FALSE;
    taut_status status = TAUT_OK;

    if (holds.value != NULL) {
        status = read_verdict(&holds, &verdict, error);
    }
    if (status == TAUT_OK && claims.value != NULL) {
        status = read_claims(&claims, certificate, error);
    }
    if (status == TAUT_OK && figures.value != NULL) {
        status = read_figures(&figures, certificate, error);
    }
    return status;
}

taut_status taut_certificate_document_read(const taut_json *at, taut_certificate **certificate,
                                           taut_error *error)
{
    taut_status status = taut_json_object(at, certificate_members, error);
    const taut_json construct = taut_json_member(at, "construct");
    taut_certificate *made = NULL;
    const char *name = "";

    if (status == TAUT_OK) {
        status = taut_json_text(&construct, &name, error);
    }
    if (status == TAUT_OK && taut_certificate_new(name, &made) != TAUT_OK) {
        status = taut_fail_memory(error);
    }
    if (status == TAUT_OK) {
        status = read_members(at, made, error);
    }
    if (status != TAUT_OK) {
        taut_certificate_free(made);
        return status;
    }
    *certificate = made;
    return TAUT_OK;
}

static void write_claim(taut_json_out *out, const taut_claim *claim)
{
    taut_json_open_inline(out, '{');
    taut_json_key(out, "claim");
    taut_json_put_text(out, claim->claim);
    taut_json_key(out, "residual");
    taut_json_put_number(out, claim->residual);
    taut_json_key(out, "limit");
    taut_json_put_number(out, claim->limit);
    taut_json_key(out, "holds");
    taut_json_put_verdict(out, claim->holds);
    taut_json_key(out, "where");
    taut_json_put_text(out, claim->where);
    taut_json_close(out, '}');
}

void taut_certificate_document_write(taut_json_out *out, const taut_certificate *certificate)
{
    taut_json_open(out, '{');
    taut_json_key(out, "construct");
    taut_json_put_text(out, taut_certificate_construct(certificate));
    taut_json_key(out, "holds");
    taut_json_put_verdict(out, taut_certificate_holds(certificate));
    taut_json_key(out, "claims");
    taut_json_open(out, '[');
    for (int i = 0; i < taut_certificate_claim_count(certificate); i++) {
        write_claim(out, taut_certificate_claim(certificate, i));
    }
    taut_json_close(out, ']');
    taut_json_key(out, "figures");
    if (taut_certificate_figures(certificate) != NULL) {
        taut_json_put_record(out, taut_certificate_figures(certificate));
    } else {
        taut_json_open(out, '{');
        taut_json_close(out, '}');
    }
    taut_json_close(out, '}');
}
