using System;
using System.Linq;
using UnityEngine;

namespace Nowpose.Editor.Import
{
    /// <summary>Undoes the changes that Unity's model importer makes to the axes of a file.</summary>
    /// <remarks>
    /// A URDF uses the coordinates of a mesh as they are in the file, independent of the up axis of the file; rviz does the same. Unity's importer
    /// changes the coordinates:
    /// <list type="bullet">
    /// <item>It mirrors x, because Unity's axes are left-handed.</item>
    /// <item>It turns the up axis of a DAE or FBX to y, by a rotation of the model's root or of the vertices, depending on the import settings. An
    /// OBJ has no up axis and is not turned.</item>
    /// <item>It converts the unit of a DAE or FBX to metres (import setting Convert Units, on by default), as rviz does. An OBJ has no unit and is
    /// read in metres.</item>
    /// </list>
    /// A point (x, y, z) of the file becomes (−x, y, z) from a Y-up file, (−x, z, −y) from a Z-up file, and (y, x, z) from an X-up file. The
    /// correct position in Unity's axes is (−y, z, x).
    /// </remarks>
    static class ModelAxes
    {
        /// <summary>Returns the rotation from an imported model to the axes of <see cref="Nowpose.Kinematics.UnityFrame"/>.</summary>
        public static Quaternion ToRobot(UpAxis up)
        {
            switch (up)
            {
                case UpAxis.X: return Quaternion.Euler(-90, 90, 90);
                case UpAxis.Z: return Quaternion.Euler(0, 90, 0);
                default: return Quaternion.Euler(-90, 90, 0);
            }
        }

        /// <summary>Returns whether the project has a script that already rotates each imported DAE, as in ROS# and Unity's URDF Importer.</summary>
        public static bool TurnsColladaByItself() =>
            AppDomain.CurrentDomain.GetAssemblies().Any(assembly => assembly.GetType("RosSharp.ColladaAssetPostProcessor") != null);
    }
}
