// Draws the letters of a TextMesh. In contrast to the font's own shader, it lets objects in front hide the text, and it writes depth, which a
// HoloLens uses to stabilise the image. The component Font Texture sets the texture of the font through a property block.
Shader "Nowpose/Text"
{
    Properties
    {
        [PerRendererData] _MainTex ("Texture of the font", 2D) = "white" {}
        _Color ("Colour (times that of the text)", Color) = (1, 1, 1, 1)
        _Cutoff ("Alpha below which nothing is drawn", Range(0, 1)) = 0.3
    }

    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal"
        }
        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "TransparentCutout" "Queue" = "Transparent" "IgnoreProjector" = "True" "PoseAppearance" = "Alpha"
        }

        Pass
        {
            Name "Text"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            ZTest LEqual
            ZWrite On
            Cull Off

            HLSLPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "TextPass.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "TransparentCutout" "Queue" = "Transparent" "IgnoreProjector" = "True" "PoseAppearance" = "Alpha" }

        Pass
        {
            Name "Text"
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha
            ZTest LEqual
            ZWrite On
            Cull Off

            CGPROGRAM
            #pragma vertex Project
            #pragma fragment Shade
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"
            #include "TextPass.hlsl"
            ENDCG
        }
    }
}
