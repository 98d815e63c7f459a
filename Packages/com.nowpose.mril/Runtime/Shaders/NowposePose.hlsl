// Fades and stripes a part while its pose is not current. Pose Appearance sets _Fade (0 to 1) and _Hatch (0 or 1) of every
// material whose shader declares both. Include this file after UnityCG.cginc (built-in pipeline) or Core.hlsl (URP).
#ifndef NOWPOSE_POSE_INCLUDED
#define NOWPOSE_POSE_INCLUDED

// Width of a stripe, and of the gap beside it, on a face parallel to two axes of the object, metres.
#define NOWPOSE_STRIPE_METRES 0.01

// Returns a position of the object in metres along the object's own axes. Call it in the vertex stage, after UNITY_SETUP_INSTANCE_ID.
// The stripes stay on the part as it moves, and both eyes see them in the same place.
float3 NowposeMetres(float3 objectPosition)
{
    float3x3 axes = transpose((float3x3)UNITY_MATRIX_M);
    return objectPosition * float3(length(axes[0]), length(axes[1]), length(axes[2]));
}

// Returns 1 in every second of the diagonal stripes, else 0. The planes x + y + z = constant cut each face of a box at 45 degrees.
float NowposeStripe(float3 metres)
{
    float diagonal = (metres.x + metres.y + metres.z) * 0.70710678;
    return step(0.5, frac(diagonal / (2 * NOWPOSE_STRIPE_METRES)));
}

// Returns the share of its opacity that a part keeps. Multiply the alpha of a blended shader, or the colour of an opaque one:
// black is transparent on a see-through display.
float NowposeOpacity(float fade, float hatch, float3 metres)
{
    return (1 - 0.8 * fade) * (1 - 0.85 * hatch * NowposeStripe(metres));
}

#endif
