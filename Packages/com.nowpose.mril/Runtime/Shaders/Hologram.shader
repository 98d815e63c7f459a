// Draws a virtual part. Opacity (_Fade) and stripes (_Hatch) mark a pose that is not current, independent of colour. The first SubShader is
// for URP, the second for the built-in pipeline; both support single-pass instanced stereo.
Shader "Nowpose/Hologram"
{
    Properties
    {
        // On an additive display black is transparent, so dark colours are not visible.
        _Color ("Colour (alpha: opacity)", Color) = (0.25, 0.75, 1, 1)
        _Fade ("Fade (0: none, 1: a fifth of the opacity is left)", Range(0, 1)) = 0
        _Hatch ("Hatch (1: stripes)", Range(0, 1)) = 0
        // Off for a background that is drawn first: with its depth, the parts behind it would not be drawn at all.
        [Enum(Off, 0, On, 1)] _ZWrite ("Write depth", Float) = 1
    }

    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal"
        }
        // Batching would move the vertices to world space, but the stripes need object space.
        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" "IgnoreProjector" = "True"
            "DisableBatching" = "True"
        }

        Pass
        {
            Name "Hologram"
            Tags { "LightMode" = "UniversalForwardOnly" }
            // The second pair of factors writes the alpha that a mixed reality capture uses.
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            // Writes depth although the colour is blended, because a HoloLens uses the depth to stabilise the image.
            ZWrite [_ZWrite]
            Cull Back

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "HologramPass.hlsl"
            ENDHLSL
        }

        // URP's depth prepass uses this pass for materials with an opaque render queue.
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
            ZWrite [_ZWrite]
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
