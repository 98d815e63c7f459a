using System;
using Nowpose.Kinematics;

namespace Nowpose.Mono.Aot
{
    static class Distance
    {
        /// <summary>Returns the distance between the two origins in m.</summary>
        public static double Between(in RigidTransform a, in RigidTransform b) =>
            Math.Sqrt(Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));
    }
}
