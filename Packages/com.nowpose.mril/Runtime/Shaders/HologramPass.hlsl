// The pass of Nowpose/Hologram in both pipelines.
#include "Spaces.hlsl"
#include "NowposePose.hlsl"

struct Vertex
{
    float4 position : POSITION;
    float3 normal : NORMAL;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Fragment
{
    float4 position : SV_POSITION;
    float3 metres : TEXCOORD0;
    float3 normal : TEXCOORD1;
    float3 view : TEXCOORD2;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

// Without instancing, these macros declare a plain buffer named UnityPerMaterial, which URP's SRP batcher needs.
UNITY_INSTANCING_BUFFER_START(UnityPerMaterial)
    UNITY_DEFINE_INSTANCED_PROP(float4, _Color)
    UNITY_DEFINE_INSTANCED_PROP(float, _Fade)
    UNITY_DEFINE_INSTANCED_PROP(float, _Hatch)
UNITY_INSTANCING_BUFFER_END(UnityPerMaterial)

Fragment Project(Vertex vertex)
{
    Fragment fragment = (Fragment)0;
    UNITY_SETUP_INSTANCE_ID(vertex);
    UNITY_TRANSFER_INSTANCE_ID(vertex, fragment);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment);

    float3 world = ToWorld(vertex.position.xyz);
    fragment.position = ToClip(world);
    fragment.metres = NowposeMetres(vertex.position.xyz);
    fragment.normal = NormalToWorld(vertex.normal);
    fragment.view = ToViewer(world);
    return fragment;
}

half4 Shade(Fragment fragment) : SV_Target
{
    UNITY_SETUP_INSTANCE_ID(fragment);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);

    float4 colour = UNITY_ACCESS_INSTANCED_PROP(UnityPerMaterial, _Color);
    float fade = UNITY_ACCESS_INSTANCED_PROP(UnityPerMaterial, _Fade);
    float hatch = UNITY_ACCESS_INSTANCED_PROP(UnityPerMaterial, _Hatch);

    // Shades as if the only light were at the viewer, so shapes are recognisable in a scene without lights. The absolute value is needed
    // because a mirrored object has reversed normals. A line has no normals: Unity then reads zeros, which cannot be normalised.
    float square = dot(fragment.normal, fragment.normal);
    float facing = square > 0 ? abs(dot(fragment.normal, normalize(fragment.view))) * rsqrt(square) : 1;
    colour.rgb *= 0.4 + 0.6 * facing;
    colour.a *= NowposeOpacity(fade, hatch, fragment.metres);
    return colour;
}

// The fragment shader of the pass that writes only depth.
half4 ShadeDepth(Fragment fragment) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);
    return 0;
}
