// Writes only depth. An object with this shader in the place of a real part hides the virtual parts behind the real part. It is drawn before
// all other geometry, so the depth test of the other geometry takes it into account. Pose Appearance ignores objects whose shader has the tag
// PoseAppearance = Ignore.
Shader "Nowpose/Occluder"
{
    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal"
        }
        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry-10" "IgnoreProjector" = "True"
            "PoseAppearance" = "Ignore"
        }

        Pass
        {
            Name "Occluder"
            Tags { "LightMode" = "UniversalForwardOnly" }
            ColorMask 0
            ZWrite On
            Cull Back

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "OccluderPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask 0
            ZWrite On
            Cull Back

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "OccluderPass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry-10" "IgnoreProjector" = "True" "PoseAppearance" = "Ignore" }

        Pass
        {
            Name "Occluder"
            ColorMask 0
            ZWrite On
            Cull Back

            CGPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"
            #include "OccluderPass.hlsl"
            ENDCG
        }
    }
}
