// Fades and stripes a part while its pose is not current. Pose Appearance sets _Fade (0 to 1) and _Hatch (0 or 1) of every
// material whose shader declares both. Include this file after UnityCG.cginc (built-in pipeline) or Core.hlsl (URP).
#ifndef NOWPOSE_POSE_INCLUDED
#define NOWPOSE_POSE_INCLUDED

// Width in metres of a stripe and of the gap beside it, on a face that is parallel to two axes of the object.
#define NOWPOSE_STRIPE_METRES 0.01

// Converts a position in object space to metres along the axes of the object. Call it in the vertex stage, after UNITY_SETUP_INSTANCE_ID.
// Stripes in these coordinates move with the part, and both eyes see them in the same place.
float3 NowposeMetres(float3 objectPosition)
{
    float3x3 axes = transpose((float3x3)UNITY_MATRIX_M);
    return objectPosition * float3(length(axes[0]), length(axes[1]), length(axes[2]));
}

// Returns 1 in every second diagonal stripe, otherwise 0. The planes x + y + z = constant cut each face of a box at 45 degrees.
float NowposeStripe(float3 metres)
{
    float diagonal = (metres.x + metres.y + metres.z) * 0.70710678;
    return step(0.5, frac(diagonal / (2 * NOWPOSE_STRIPE_METRES)));
}

// Returns the fraction of its opacity that a part keeps. Multiply it with the alpha in a blended shader, or with the colour in an opaque
// shader: black is transparent on a see-through display.
float NowposeOpacity(float fade, float hatch, float3 metres)
{
    return (1 - 0.8 * fade) * (1 - 0.85 * hatch * NowposeStripe(metres));
}

#endif
