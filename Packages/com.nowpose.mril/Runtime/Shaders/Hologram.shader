// A virtual part in the built-in render pipeline, single-pass instanced stereo included. What it shows has to be told from the real
// scene and from a pose that is not current without any colour: opacity (_Fade) and stripes (_Hatch) say it.
Shader "Nowpose/Hologram"
{
    Properties
    {
        // On an additive display black is transparent: dark colours vanish there.
        _Color ("Colour (alpha: opacity)", Color) = (0.25, 0.75, 1, 1)
        _Fade ("Fade (0: none, 1: a fifth of the opacity is left)", Range(0, 1)) = 0
        _Hatch ("Hatch (1: stripes)", Range(0, 1)) = 0
    }

    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent" "IgnoreProjector" = "True" }

        Pass
        {
            // The second pair is for the alpha that a mixed reality capture takes over.
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            // Depth is written although the colour blends: a HoloLens steadies its picture by it.
            ZWrite On
            Cull Back

            CGPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"

            struct Vertex
            {
                float4 position : POSITION;
                float3 normal : NORMAL;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Fragment
            {
                float4 position : SV_POSITION;
                float4 screen : TEXCOORD0;
                float3 normal : TEXCOORD1;
                float3 view : TEXCOORD2;
                UNITY_VERTEX_INPUT_INSTANCE_ID
                UNITY_VERTEX_OUTPUT_STEREO
            };

            UNITY_INSTANCING_BUFFER_START(Properties)
                UNITY_DEFINE_INSTANCED_PROP(float4, _Color)
                UNITY_DEFINE_INSTANCED_PROP(float, _Fade)
                UNITY_DEFINE_INSTANCED_PROP(float, _Hatch)
            UNITY_INSTANCING_BUFFER_END(Properties)

            Fragment Project(Vertex vertex)
            {
                Fragment fragment;
                UNITY_SETUP_INSTANCE_ID(vertex);
                UNITY_INITIALIZE_OUTPUT(Fragment, fragment);
                UNITY_TRANSFER_INSTANCE_ID(vertex, fragment);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment);

                fragment.position = UnityObjectToClipPos(vertex.position);
                fragment.screen = ComputeScreenPos(fragment.position);
                fragment.normal = UnityObjectToWorldNormal(vertex.normal);
                fragment.view = UnityWorldSpaceViewDir(mul(unity_ObjectToWorld, vertex.position).xyz);
                return fragment;
            }

            // 1 in every second of the diagonal stripes, 48 to the height of the picture; as steep on every display.
            float Stripe(float4 screen)
            {
                float2 place = screen.xy / screen.w;
                place.x *= _ScreenParams.x / _ScreenParams.y;
                return step(0.5, frac((place.x + place.y) * 48));
            }

            fixed4 Shade(Fragment fragment) : SV_Target
            {
                UNITY_SETUP_INSTANCE_ID(fragment);
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);

                float4 colour = UNITY_ACCESS_INSTANCED_PROP(Properties, _Color);
                float fade = UNITY_ACCESS_INSTANCED_PROP(Properties, _Fade);
                float hatch = UNITY_ACCESS_INSTANCED_PROP(Properties, _Hatch);

                // As if the viewer carried the lamp: shapes read the same in a scene without any light.
                float facing = saturate(dot(normalize(fragment.normal), normalize(fragment.view)));
                colour.rgb *= 0.4 + 0.6 * facing;
                colour.a *= (1 - 0.8 * fade) * (1 - 0.85 * hatch * Stripe(fragment.screen));
                return colour;
            }
            ENDCG
        }
    }
}
