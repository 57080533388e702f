/* proof.h -- isothermal, harmonic, minimal: proved over the whole of a surface. */
#ifndef TAUT_CERTIFY_BONNET_PROOF_H
#define TAUT_CERTIFY_BONNET_PROOF_H

#include "certify/bonnet/local.h"
#include "taut/certify.h"

enum { TAUT_BONNET_ISOTHERMAL, TAUT_BONNET_HARMONIC, TAUT_BONNET_MINIMAL, TAUT_BONNET_PROVED };

/* What is known of one claim. residual: nowhere on the surface is it larger, where `holds` is true;
 * found somewhere, where it is false. limit: what rounding explains, 1e-6 at most. */
typedef struct taut_bonnet_proof {
    taut_verdict holds;
    double residual, limit;
    double at[2];
    const char *why; /* it is undecided; else NULL */
} taut_bonnet_proof;

/* Begins with proofs of nothing; each surface makes them weaker. */
void taut_bonnet_proof_init(taut_bonnet_proof proofs[TAUT_BONNET_PROVED]);
/* Points times 2^-unit. Returns bit k where this surface is the one that proof k tells of now. */
int taut_bonnet_prove(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                      taut_bonnet_proof proofs[TAUT_BONNET_PROVED]);

/* Across inner breaks: the largest jump of the first derivative over its size. 0, limit 0, where the
 * bases are C^1 by themselves. A surface that is isothermal and harmonic on both sides, and whose
 * derivatives agree along the break, is one surface. */
void taut_bonnet_smooth(const taut_surface *surface, const taut_bonnet_scale *scale, int unit,
                        taut_bonnet_proof *proof);

#endif /* TAUT_CERTIFY_BONNET_PROOF_H */
