using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Two materials and no meshes: those lie in files that a headset does not have.</summary>
    /// <remarks>Colours come from the materials alone, for on an additive display a dark one is invisible.</remarks>
    sealed class PlainLook : IRigLook
    {
        readonly Material _arm, _tool;

        /// <param name="arm">Of the links up to the flange.</param>
        /// <param name="tool">Of the links that the flange carries.</param>
        public PlainLook(Material arm, Material tool)
        {
            _arm = arm;
            _tool = tool;
        }

        public Material MaterialOf(VisualColour? colour, bool isTool) => isTool ? _tool : _arm;

        public GameObject MeshOf(LinkVisual visual, bool isTool) => null;
    }
}
