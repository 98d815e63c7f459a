// Writes depth and nothing else: drawn where a real part is, it hides the virtual parts behind that. Before all geometry, so that
// whatever comes later meets its depth.
Shader "Nowpose/Occluder"
{
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry-10" "IgnoreProjector" = "True" }

        Pass
        {
            ColorMask 0
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
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Fragment
            {
                float4 position : SV_POSITION;
                UNITY_VERTEX_OUTPUT_STEREO
            };

            Fragment Project(Vertex vertex)
            {
                Fragment fragment;
                UNITY_SETUP_INSTANCE_ID(vertex);
                UNITY_INITIALIZE_OUTPUT(Fragment, fragment);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(fragment);
                fragment.position = UnityObjectToClipPos(vertex.position);
                return fragment;
            }

            fixed4 Shade(Fragment fragment) : SV_Target
            {
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(fragment);
                return 0;
            }
            ENDCG
        }
    }
}
