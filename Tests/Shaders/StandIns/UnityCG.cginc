// Stand-in for the built-in pipeline's include.
#include "StandIn.hlsl"
