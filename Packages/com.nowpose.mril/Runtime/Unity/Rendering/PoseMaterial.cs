using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Describes how a material can mark a pose as not current.</summary>
    readonly struct PoseMaterial
    {
        public static readonly PoseMaterial Patterned = new PoseMaterial(PoseMeans.Pattern, 0);
        public static readonly PoseMaterial Unsuitable = new PoseMaterial(PoseMeans.None, 0);
        public static readonly PoseMaterial NotNeeded = new PoseMaterial(PoseMeans.NotNeeded, 0);

        public static readonly int FadeId = Shader.PropertyToID("_Fade");
        public static readonly int HatchId = Shader.PropertyToID("_Hatch");

        /// <summary>
        /// Tag: name of a tag of a SubShader or material. Ignored and Alpha: its values. <c>Ignore</c> means that the material writes no colour, so
        /// no marking is necessary. <c>Alpha</c> means that the alpha of the colour is the opacity; it is necessary for shaders with a fixed blend
        /// factor, which cannot be read.
        /// </summary>
        const string Tag = "PoseAppearance", Ignored = "Ignore", Alpha = "Alpha";

        /// <summary>Last render queue for opaque materials. Unity draws later queues from back to front, as blended materials need.</summary>
        const int LastOpaqueQueue = 2500;

        /// <summary>Value of <c>_SrcBlend</c> for the blend factor <c>SrcAlpha</c>, with which the alpha is the opacity.</summary>
        const float SourceAlpha = 5;

        static readonly int SourceBlendId = Shader.PropertyToID("_SrcBlend");
        static readonly int ColourId = Shader.PropertyToID("_Color");
        static readonly int BaseColourId = Shader.PropertyToID("_BaseColor");

        PoseMaterial(PoseMeans means, int colour) => (Means, Colour) = (means, colour);

        public PoseMeans Means { get; }

        /// <summary>Id of the shader property whose alpha is the opacity; used for <see cref="PoseMeans.Alpha"/> only.</summary>
        public int Colour { get; }

        /// <summary>Returns how a material can mark a pose as not current.</summary>
        /// <param name="material">The material; null if it is missing, in which case Unity draws the part in magenta.</param>
        public static PoseMaterial Of(Material material)
        {
            if (material == null) return Unsuitable;
            if (material.HasProperty(FadeId) && material.HasProperty(HatchId)) return Patterned;
            var tag = material.GetTag(Tag, false, "");
            if (tag == Ignored) return NotNeeded;
            // URP's shaders have both colour properties, and use only the base colour.
            var colour = material.HasProperty(BaseColourId) ? BaseColourId : ColourId;
            var isBlended = (tag == Alpha || IsBlendedByAlpha(material)) && material.HasProperty(colour);
            return isBlended ? new PoseMaterial(PoseMeans.Alpha, colour) : Unsuitable;
        }

        // The render queue alone is not sufficient: materials with premultiplied alpha and opaque materials in a late queue ignore the alpha.
        static bool IsBlendedByAlpha(Material material) =>
            material.renderQueue > LastOpaqueQueue && material.HasProperty(SourceBlendId) && material.GetFloat(SourceBlendId) == SourceAlpha;
    }
}
