using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>Supplies the materials and meshes of a built rig.</summary>
    interface IRigLook
    {
        /// <param name="colour">The URDF's colour; null if it specifies none.</param>
        /// <param name="isTool">Whether the flange carries the link.</param>
        Material MaterialOf(VisualColour? colour, bool isTool);

        /// <returns>
        /// An object that shows the mesh in the visual's frame, in Unity's axes and at the URDF's scale 1; null if the mesh cannot be used.
        /// </returns>
        GameObject MeshOf(LinkVisual visual, bool isTool);
    }
}
