using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>What a built rig looks like.</summary>
    interface IRigLook
    {
        /// <param name="colour">The URDF's own; null where it gives none.</param>
        /// <param name="isTool">Whether the flange carries the link.</param>
        Material MaterialOf(VisualColour? colour, bool isTool);

        /// <returns>
        /// An object that shows the mesh in Unity's axes of the visual's frame, at the scale 1 of the URDF; null where it cannot be had.
        /// </returns>
        GameObject MeshOf(LinkVisual visual, bool isTool);
    }
}
