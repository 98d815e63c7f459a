// Substitute for the include of the built-in pipeline.
#include "StandIn.hlsl"
