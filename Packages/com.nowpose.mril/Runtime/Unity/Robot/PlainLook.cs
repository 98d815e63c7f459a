using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>A look of two materials without meshes, because a headset does not have the mesh files.</summary>
    /// <remarks>Ignores the URDF's colours, because a dark colour is invisible on an additive display.</remarks>
    sealed class PlainLook : IRigLook
    {
        const string ShaderName = "Nowpose/Hologram";

        readonly Material _arm, _tool;

        /// <param name="arm">Material of the links up to the flange; null to create one when needed.</param>
        /// <param name="tool">Material of the links that the flange carries; null to create one when needed.</param>
        public PlainLook(Material arm, Material tool)
        {
            _arm = arm;
            _tool = tool;
        }

        /// <summary>Whether a missing material was requested.</summary>
        public bool LacksMaterial { get; private set; }

        /// <summary>
        /// Material created in place of a missing one; the caller destroys it. Null if none was needed, or if the build does not contain the
        /// package's shader: Unity then draws the parts magenta.
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

        // Creates its own material, because only GameObject.CreatePrimitive returns Unity's default one, and that method throws in a build
        // without colliders.
        static Material NewMaterial()
        {
            var shader = Shader.Find(ShaderName);
            return shader == null ? null : new Material(shader) { name = "Plain" };
        }
    }
}
