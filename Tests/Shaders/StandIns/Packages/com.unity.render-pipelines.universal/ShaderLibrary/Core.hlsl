// Substitute for the include of URP.
#include "StandIn.hlsl"
