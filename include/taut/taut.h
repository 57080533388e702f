/* taut/taut.h -- all of taut's API, in the order of the work. */
#ifndef TAUT_TAUT_H
#define TAUT_TAUT_H

/* What surfaces are made of */
#include "taut/basis.h"
#include "taut/curve.h"
#include "taut/surface.h"

/* Problems: made and certified */
#include "taut/construct.h"

/* Constructions */
#include "taut/asymptotic.h"
#include "taut/biharmonic.h"
#include "taut/bonnet.h"
#include "taut/dirichlet.h"
#include "taut/harmonic.h"
#include "taut/pattern.h"
#include "taut/pipe.h"
#include "taut/plateau.h"
#include "taut/trace.h"

/* How what comes out changes with what goes in */
#include "taut/gradient.h"

/* What comes out */
#include "taut/certify.h"
#include "taut/model.h"
#include "taut/record.h"

/* Measured, joined, cut */
#include "taut/join.h"
#include "taut/measure.h"
#include "taut/operations.h"
#include "taut/recognise.h"

/* Meshes, panels and files */
#include "taut/mesh.h"
#include "taut/panels.h"
#include "taut/read.h"
#include "taut/write.h"

/* Figures and pages, of the library libtaut-draw */
#include "taut/draw.h"

/* For every call */
#include "taut/abi.h"
#include "taut/export.h"
#include "taut/film.h"
#include "taut/limits.h"
#include "taut/monitor.h"
#include "taut/status.h"
#include "taut/version.h"

#endif /* TAUT_TAUT_H */
