/* taut/taut.h -- all of taut's API. */
#ifndef TAUT_TAUT_H
#define TAUT_TAUT_H

#include "taut/asymptotic.h"
#include "taut/basis.h"
#include "taut/biharmonic.h"
#include "taut/bonnet.h"
#include "taut/certify.h"
#include "taut/construct.h"
#include "taut/curve.h"
#include "taut/dirichlet.h"
#include "taut/harmonic.h"
#include "taut/join.h"
#include "taut/limits.h"
#include "taut/measure.h"
#include "taut/mesh.h"
#include "taut/model.h"
#include "taut/monitor.h"
#include "taut/operate.h"
#include "taut/panels.h"
#include "taut/pipe.h"
#include "taut/plateau.h"
#include "taut/read.h"
#include "taut/recognise.h"
#include "taut/record.h"
#include "taut/status.h"
#include "taut/surface.h"
#include "taut/version.h"
#include "taut/write.h"

#endif /* TAUT_TAUT_H */
