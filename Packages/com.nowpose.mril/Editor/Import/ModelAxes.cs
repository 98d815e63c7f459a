using System;
using System.Linq;
using UnityEngine;

namespace Nowpose.Editor.Import
{
    /// <summary>The changes that Unity's model importer makes to the axes of a file, and the rotation that undoes them.</summary>
    /// <remarks>
    /// A URDF uses a mesh's coordinates as they are in the file, independent of the file's up axis; rviz does the same. Unity's importer
    /// <list type="bullet">
    /// <item>mirrors x, of OBJ, DAE and FBX alike, because its own axes are left-handed;</item>
    /// <item>turns the up axis of a DAE or FBX to its own y, by a rotation of the model's root or of its vertices, depending on the
    /// import settings; an OBJ has no up axis and is not turned;</item>
    /// <item>converts the unit of a DAE or FBX to metres (import setting Convert Units, on by default), as rviz does; an OBJ has no
    /// unit and is read in metres.</item>
    /// </list>
    /// So a point (x, y, z) of the file becomes (−x, y, z) from a Y-up file, (−x, z, −y) from a Z-up file and (y, x, z) from an
    /// X-up file. Its correct position is (−y, z, x).
    /// </remarks>
    static class ModelAxes
    {
        /// <summary>Rotation from an imported model to the axes of <see cref="Nowpose.Kinematics.UnityFrame"/>.</summary>
        public static Quaternion ToRobot(UpAxis up)
        {
            switch (up)
            {
                case UpAxis.X: return Quaternion.Euler(-90, 90, 90);
                case UpAxis.Z: return Quaternion.Euler(0, 90, 0);
                default: return Quaternion.Euler(-90, 90, 0);
            }
        }

        /// <summary>Returns whether the project has a script that already rotates every imported DAE: ROS# and Unity's URDF Importer do.</summary>
        public static bool TurnsColladaByItself() =>
            AppDomain.CurrentDomain.GetAssemblies().Any(assembly => assembly.GetType("RosSharp.ColladaAssetPostProcessor") != null);
    }
}
