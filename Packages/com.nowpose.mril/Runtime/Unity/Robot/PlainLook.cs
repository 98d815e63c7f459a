using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>Two materials and no meshes: those lie in files that a headset does not have.</summary>
    /// <remarks>Colours come from the materials alone, for on an additive display a dark one is invisible.</remarks>
    sealed class PlainLook : IRigLook
    {
        const string ShaderName = "Nowpose/Hologram";

        readonly Material _arm, _tool;

        /// <param name="arm">Of the links up to the flange; null for one that is made when it is needed.</param>
        /// <param name="tool">Of the links that the flange carries; null for the same.</param>
        public PlainLook(Material arm, Material tool)
        {
            _arm = arm;
            _tool = tool;
        }

        /// <summary>Whether a material was asked for that it was not given.</summary>
        public bool LacksMaterial { get; private set; }

        /// <summary>
        /// Material made in place of a missing one; its user destroys it. Null for none, also where the build does not contain the
        /// package's shader: then Unity draws the parts magenta.
        /// </summary>
        public Material Made { get; private set; }

        public Material MaterialOf(VisualColour? colour, bool isTool)
        {
            var material = isTool ? _tool : _arm;
            if (material != null) return material;
            if (!LacksMaterial) Made = NewMaterial();
            LacksMaterial = true;
            return Made;
        }

        public GameObject MeshOf(LinkVisual visual, bool isTool) => null;

        // Not Unity's default, which only GameObject.CreatePrimitive gives: that throws where a build contains no colliders.
        static Material NewMaterial()
        {
            var shader = Shader.Find(ShaderName);
            return shader == null ? null : new Material(shader) { name = "Plain" };
        }
    }
}
