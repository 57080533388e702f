/* certificate.c -- certificates in documents. What a saved certificate says is not trusted
 * anywhere: `taut_certify` proves the model again. */
#include "core/fail.h"
#include "io/model/model.h"
#include "taut/limits.h"

#include <math.h>
#include <string.h>

static const char *const certificate_members[] = {"construct", "holds", "claims", "figures", NULL};
static const char *const claim_members[] = {"claim", "kind",  "residual", "limit",
                                            "holds", "where", NULL};

/* A number, or null for one that is not finite. */
static taut_status read_residual(const taut_json *at, void *value, taut_error *error)
{
    if (taut_json_kind_at(at) == TAUT_JSON_NULL) {
        *(double *)value = taut_none;
        return TAUT_OK;
    }
    return taut_json_number(at, value, error);
}

static taut_status read_verdict(const taut_json *at, void *verdict, taut_error *error)
{
    const taut_json_kind kind = taut_json_kind_at(at);
    if (kind != TAUT_JSON_TRUE && kind != TAUT_JSON_FALSE && kind != TAUT_JSON_NULL) {
        return taut_json_refuse(at, error, "type", "true, false or null");
    }
    *(taut_verdict *)verdict = kind == TAUT_JSON_TRUE    ? TAUT_TRUE
                               : kind == TAUT_JSON_FALSE ? TAUT_FALSE
                                                         : TAUT_UNDECIDED;
    return TAUT_OK;
}

static taut_status read_kind(const taut_json *at, void *kind, taut_error *error)
{
    const char *name = "";
    const taut_status status = taut_json_text(at, &name, error);
    if (status != TAUT_OK) {
        return status;
    }
    for (int k = TAUT_CHECK; k <= TAUT_EXACT; k++) {
        if (strcmp(name, taut_claim_kind_name((taut_claim_kind)k)) == 0) {
            *(taut_claim_kind *)kind = (taut_claim_kind)k;
            return TAUT_OK;
        }
    }
    return taut_json_refuse(at, error, "value", "\"exact\", \"bound\" or \"check\"");
}

static taut_status read_place(const taut_json *at, void *where, taut_error *error)
{
    return taut_json_text(at, where, error);
}

static taut_status read_claim(const taut_json *at, void *certificate, taut_error *error)
{
    taut_claim claim = {.claim = "", .where = "", .as_saved = 1};
    taut_reader in = taut_reader_of(at, claim_members, error);

    taut_reader_text(&in, "claim", &claim.claim);
    taut_reader_optional(&in, "kind", read_kind, &claim.kind);
    taut_reader_member(&in, "residual", read_residual, &claim.residual);
    taut_reader_member(&in, "limit", read_residual, &claim.limit);
    taut_reader_member(&in, "holds", read_verdict, &claim.holds);
    taut_reader_optional(&in, "where", read_place, &claim.where);
    if (in.status != TAUT_OK) {
        return in.status;
    }
    return taut_certificate_add(certificate, &claim) == TAUT_OK ? TAUT_OK : taut_fail_memory(error);
}

static taut_status read_claims(const taut_json *at, void *certificate, taut_error *error)
{
    return taut_json_each(at, 0, TAUT_OBJECTS_MAX, "claims", read_claim, certificate, error);
}

static taut_status read_figures(const taut_json *at, void *certificate, taut_error *error)
{
    taut_record *figures = NULL;
    const taut_status status = taut_json_record_object(at, &figures, error);
    if (status == TAUT_OK) {
        taut_certificate_set_figures(certificate, figures);
    }
    return status;
}

taut_status taut_certificate_document_read(const taut_json *at, taut_certificate **certificate,
                                           taut_error *error)
{
    taut_certificate *made = NULL;
    taut_verdict verdict = TAUT_FALSE;
    const char *name = "";
    taut_reader in = taut_reader_of(at, certificate_members, error);

    taut_reader_text(&in, "construct", &name);
    if (in.status != TAUT_OK) {
        return in.status;
    }
    if (taut_certificate_new(name, &made) != TAUT_OK) {
        return taut_fail_memory(error);
    }
    /* `holds` follows from the claims: only its kind is looked at */
    taut_reader_optional(&in, "holds", read_verdict, &verdict);
    taut_reader_optional(&in, "claims", read_claims, made);
    taut_reader_optional(&in, "figures", read_figures, made);
    if (in.status != TAUT_OK) {
        taut_certificate_free(made);
        return in.status;
    }
    *certificate = made;
    return TAUT_OK;
}

static void write_claim(taut_json_out *out, const taut_claim *claim)
{
    taut_json_open_inline(out, '{');
    taut_json_pair_text(out, "claim", claim->claim);
    taut_json_pair_text(out, "kind", taut_claim_kind_name(claim->kind));
    taut_json_pair_number(out, "residual", claim->residual);
    taut_json_pair_number(out, "limit", claim->limit);
    taut_json_pair_verdict(out, "holds", claim->holds);
    taut_json_pair_text(out, "where", claim->where);
    taut_json_close(out, '}');
}

void taut_certificate_document_write(taut_json_out *out, const taut_certificate *certificate)
{
    taut_json_open(out, '{');
    taut_json_pair_text(out, "construct", taut_certificate_construct(certificate));
    taut_json_pair_verdict(out, "holds", taut_certificate_holds(certificate));
    taut_json_open_pair(out, "claims", '[');
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
