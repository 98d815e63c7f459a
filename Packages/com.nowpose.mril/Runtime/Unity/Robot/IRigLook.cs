using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>Supplies materials and meshes for a robot that a rig builds.</summary>
    interface IRigLook
    {
        /// <summary>Returns the material of a visual.</summary>
        /// <param name="colour">Colour in the URDF; null if the URDF specifies none.</param>
        /// <param name="isTool">Whether the visual belongs to a link that the flange carries.</param>
        Material MaterialOf(VisualColour? colour, bool isTool);

        /// <summary>Creates an object that shows a mesh in the visual's frame, in Unity's axes, without the scale given in the URDF.</summary>
        /// <returns>Null if the mesh cannot be used.</returns>
        GameObject MeshOf(LinkVisual visual, bool isTool);
    }
}
