// The passes of Nowpose/Occluder in both pipelines.
#include "Spaces.hlsl"

struct Vertex
{
    float4 position : POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Fragment
{
    float4 position : SV_POSITION;
    UNITY_VERTEX_OUTPUT_STEREO
};

Fragment Project(Vertex vertex)
{
    Fragment fragment = (Fragment)0;
    UNITY_SETUP_INSTANCE_ID(vertex);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment);
    fragment.position = ToClip(ToWorld(vertex.position.xyz));
    return fragment;
}

half4 Shade(Fragment fragment) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);
    return 0;
}
