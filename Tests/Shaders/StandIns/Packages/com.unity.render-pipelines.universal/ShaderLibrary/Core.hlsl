// Stand-in for URP's include.
#include "StandIn.hlsl"
