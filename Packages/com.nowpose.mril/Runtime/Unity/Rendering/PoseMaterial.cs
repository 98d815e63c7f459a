using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Determines how a material can show that a pose is not current.</summary>
    readonly struct PoseMaterial
    {
        public static readonly PoseMaterial Patterned = new PoseMaterial(PoseMeans.Pattern, 0);
        public static readonly PoseMaterial Helpless = new PoseMaterial(PoseMeans.None, 0);
        public static readonly PoseMaterial NotNeeded = new PoseMaterial(PoseMeans.NotNeeded, 0);

        public static readonly int FadeId = Shader.PropertyToID("_Fade");
        public static readonly int HatchId = Shader.PropertyToID("_Hatch");

        /// <summary>
        /// Tag of a SubShader or material. <c>Ignore</c>: it writes no colour, so it looks the same in every state. <c>Alpha</c>: the alpha
        /// of its colour is its opacity, which cannot be detected if the shader contains a fixed blend factor.
        /// </summary>
        const string Tag = "PoseAppearance", Ignored = "Ignore", Alpha = "Alpha";

        /// <summary>Render queues beyond this one are drawn back to front, which blended materials need.</summary>
        const int LastOpaqueQueue = 2500;

        /// <summary>Value of <c>_SrcBlend</c> with which the alpha determines the visibility: <c>SrcAlpha</c>.</summary>
        const float SourceAlpha = 5;

        static readonly int SourceBlendId = Shader.PropertyToID("_SrcBlend");
        static readonly int ColourId = Shader.PropertyToID("_Color");
        static readonly int BaseColourId = Shader.PropertyToID("_BaseColor");

        PoseMaterial(PoseMeans means, int colour)
        {
            Means = means;
            Colour = colour;
        }

        public PoseMeans Means { get; }

        /// <summary>Property whose alpha is the opacity, for <see cref="PoseMeans.Alpha"/>.</summary>
        public int Colour { get; }

        /// <param name="material">Null for none, which Unity draws magenta.</param>
        public static PoseMaterial Of(Material material)
        {
            if (material == null) return Helpless;
            if (material.HasProperty(FadeId) && material.HasProperty(HatchId)) return Patterned;
            var tag = material.GetTag(Tag, false, "");
            if (tag == Ignored) return NotNeeded;
            // URP's shaders have both properties, and draw with the base colour.
            var colour = material.HasProperty(BaseColourId) ? BaseColourId : ColourId;
            var isBlended = (tag == Alpha || IsBlendedByAlpha(material)) && material.HasProperty(colour);
            return isBlended ? new PoseMaterial(PoseMeans.Alpha, colour) : Helpless;
        }

        // The queue alone is not sufficient: a premultiplied material (One) and an opaque one with a late queue ignore a lower alpha.
        static bool IsBlendedByAlpha(Material material) =>
            material.renderQueue > LastOpaqueQueue && material.HasProperty(SourceBlendId) && material.GetFloat(SourceBlendId) == SourceAlpha;
    }
}
