// Coordinate transforms with matrices that both the built-in pipeline and URP define, for the eye that is being drawn.
#ifndef NOWPOSE_SPACES_INCLUDED
#define NOWPOSE_SPACES_INCLUDED

float3 ToWorld(float3 objectPosition)
{
    return mul(UNITY_MATRIX_M, float4(objectPosition, 1)).xyz;
}

float4 ToClip(float3 worldPosition)
{
    return mul(UNITY_MATRIX_VP, float4(worldPosition, 1));
}

// Returns the normal in world space, not normalised. Uses the cofactor matrix, which is the inverse transpose times the determinant.
float3 NormalToWorld(float3 normal)
{
    float3x3 toWorld = (float3x3)UNITY_MATRIX_M;
    return float3(
        dot(cross(toWorld[1], toWorld[2]), normal), dot(cross(toWorld[2], toWorld[0]), normal), dot(cross(toWorld[0], toWorld[1]), normal));
}

float3 ToViewer(float3 worldPosition)
{
    return _WorldSpaceCameraPos.xyz - worldPosition;
}

#endif
