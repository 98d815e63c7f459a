// The pass of Nowpose/Text in both pipelines.
#include "Spaces.hlsl"

struct Vertex
{
    float4 position : POSITION;
    float4 colour : COLOR;
    float2 place : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Fragment
{
    float4 position : SV_POSITION;
    float4 colour : COLOR;
    float2 place : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Texture2D _MainTex;
SamplerState sampler_MainTex;

UNITY_INSTANCING_BUFFER_START(UnityPerMaterial)
    UNITY_DEFINE_INSTANCED_PROP(float4, _Color)
    UNITY_DEFINE_INSTANCED_PROP(float, _Cutoff)
UNITY_INSTANCING_BUFFER_END(UnityPerMaterial)

Fragment Project(Vertex vertex)
{
    Fragment fragment = (Fragment)0;
    UNITY_SETUP_INSTANCE_ID(vertex);
    UNITY_TRANSFER_INSTANCE_ID(vertex, fragment);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment);

    fragment.position = ToClip(ToWorld(vertex.position.xyz));
    fragment.colour = vertex.colour * UNITY_ACCESS_INSTANCED_PROP(UnityPerMaterial, _Color);
    fragment.place = vertex.place;
    return fragment;
}

half4 Shade(Fragment fragment) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(fragment);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);

    // The alpha of a font's texture contains the letters. Pixels outside them write neither colour nor depth.
    float letter = _MainTex.Sample(sampler_MainTex, fragment.place).a;
    clip(letter - UNITY_ACCESS_INSTANCED_PROP(UnityPerMaterial, _Cutoff));
    return half4(fragment.colour.rgb, fragment.colour.a * letter);
}
