using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>Draws a robot with two materials and without meshes, because the headset does not have the mesh files of the URDF.</summary>
    /// <remarks>Ignores the colours in the URDF, because a dark colour is invisible on an additive display.</remarks>
    sealed class PlainLook : IRigLook
    {
        const string ShaderName = "Nowpose/Hologram";

        readonly Material _arm, _tool;

        /// <param name="arm">Material of the links up to the flange; if null, a material is created when it is needed.</param>
        /// <param name="tool">Material of the links that the flange carries; if null, a material is created when it is needed.</param>
        public PlainLook(Material arm, Material tool) => (_arm, _tool) = (arm, tool);

        /// <summary>Whether a material was needed that was not supplied.</summary>
        public bool LacksMaterial { get; private set; }

        /// <summary>
        /// Material created in place of a missing material. The caller must destroy it. Null if no material was missing. Also null if the
        /// build does not contain the package's shader; Unity then draws the parts in magenta.
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

        // Unity's default material is available only through GameObject.CreatePrimitive, which throws in a build without colliders.
        static Material NewMaterial()
        {
            var shader = Shader.Find(ShaderName);
            return shader == null ? null : new Material(shader) { name = "Plain" };
        }
    }
}
