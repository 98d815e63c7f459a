using System;
using System.Linq;
using UnityEngine;

namespace Nowpose.Editor.Import
{
    /// <summary>What Unity's model importer does to the axes of a file, and the rotation that undoes it.</summary>
    /// <remarks>
    /// A URDF takes a mesh's coordinates as they stand in the file, whatever the file calls up: so does rviz. Unity's importer
    /// <list type="bullet">
    /// <item>mirrors x, of OBJ, DAE and FBX alike, because its own axes are left-handed;</item>
    /// <item>turns what a DAE or FBX calls up to its own y, by a rotation of the model's root or of its vertices, as its import
    /// settings say; an OBJ names no axis and is not turned;</item>
    /// <item>converts the unit that a DAE or FBX names to metres (import setting Convert Units, on unless switched off), as
    /// rviz does; an OBJ names none and counts as metres.</item>
    /// </list>
    /// So a point (x, y, z) of the file arrives as (−x, y, z) from a Y-up file, (−x, z, −y) from a Z-up one and (y, x, z) from an
    /// X-up one, and belongs at (−y, z, x).
    /// </remarks>
    static class ModelAxes
    {
        /// <summary>Turns a model, as imported, to where <see cref="Nowpose.Kinematics.UnityFrame"/> puts its coordinates.</summary>
        public static Quaternion ToRobot(UpAxis up)
        {
            switch (up)
            {
                case UpAxis.X: return Quaternion.Euler(-90, 90, 90);
                case UpAxis.Z: return Quaternion.Euler(0, 90, 0);
                default: return Quaternion.Euler(-90, 90, 0);
            }
        }

        /// <summary>Whether the project has a script that does the same to every DAE on its import: ROS# and Unity's URDF Importer do.</summary>
        public static bool TurnsColladaByItself() =>
            AppDomain.CurrentDomain.GetAssemblies().Any(assembly => assembly.GetType("RosSharp.ColladaAssetPostProcessor") != null);
    }
}
