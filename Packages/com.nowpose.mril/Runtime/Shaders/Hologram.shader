// A virtual part. Opacity (_Fade) and stripes (_Hatch) tell a pose that is not current without any colour. The first SubShader is for URP,
// the second for the built-in pipeline; both serve single-pass instanced stereo.
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
        PackageRequirements
        {
            "com.unity.render-pipelines.universal"
        }
        // Batching would take away the object's own space, which the stripes are in.
        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" "IgnoreProjector" = "True"
            "DisableBatching" = "True"
        }

        Pass
        {
            Name "Hologram"
            Tags { "LightMode" = "UniversalForwardOnly" }
            // The second pair is for the alpha that a mixed reality capture takes over.
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            // Depth is written although the colour blends: a HoloLens steadies its picture by it.
            ZWrite On
            Cull Back

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "HologramPass.hlsl"
            ENDHLSL
        }

        // URP's depth prepass draws it for a material with an opaque render queue.
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask 0
            ZWrite On
            Cull Back

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment ShadeDepth
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "HologramPass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent" "IgnoreProjector" = "True" "DisableBatching" = "True" }

        Pass
        {
            Name "Hologram"
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            ZWrite On
            Cull Back

            CGPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"
            #include "HologramPass.hlsl"
            ENDCG
        }
    }
}
