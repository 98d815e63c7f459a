using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Finds out how a material can show that a pose is not current.</summary>
    readonly struct PoseMaterial
    {
        public static readonly PoseMaterial Patterned = new PoseMaterial(PoseMeans.Pattern, 0);
        public static readonly PoseMaterial Helpless = new PoseMaterial(PoseMeans.None, 0);

        public static readonly int FadeId = Shader.PropertyToID("_Fade");
        public static readonly int HatchId = Shader.PropertyToID("_Hatch");

        /// <summary>A SubShader or material with this tag is drawn the same in every state: it writes no colour.</summary>
        const string Tag = "PoseAppearance", Ignored = "Ignore";

        /// <summary>Render queues beyond this one are drawn back to front, which blended materials need.</summary>
        const int LastOpaqueQueue = 2500;

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
            if (material == null || material.HasProperty(FadeId) && material.HasProperty(HatchId)) return Patterned;
            if (material.GetTag(Tag, false, "") == Ignored) return new PoseMaterial(PoseMeans.NotNeeded, 0);
            // URP's shaders have both; the base colour is the one that they draw with.
            var colour = material.HasProperty(BaseColourId) ? BaseColourId : ColourId;
            var isBlended = material.renderQueue > LastOpaqueQueue && material.HasProperty(colour);
            return isBlended ? new PoseMaterial(PoseMeans.Alpha, colour) : Helpless;
        }
    }
}
