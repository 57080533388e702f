#include "numeric/kernel/simd_baseline.h"

#include "numeric/kernel/kernel_body.h"
