using System;
using Nowpose.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Nowpose.Tests.Unity.Robot
{
    /// <summary>Creates random joint positions, and compares the pose of a rig with the pose that Core computes.</summary>
    static class RobotPoses
    {
        const double ToleranceMetres = 1e-5;

        /// <summary>Returns random positions, which may be beyond the limits. Mimic joints follow the joints that they mimic.</summary>
        public static double[] Any(RobotModel model, Random random)
        {
            var positions = new double[model.MovingJoints.Count];
            for (var i = 0; i < positions.Length; i++)
            {
                var max = model.MovingJoints[i].Kind == JointKind.Prismatic ? 0.5 : 2 * Math.PI;
                positions[i] = (2 * random.NextDouble() - 1) * max;
            }
            model.CompleteMimics(positions, new bool[positions.Length]);
            return positions;
        }

        /// <summary>
        /// Checks that the links of a rig have the poses of Core's forward kinematics. Compares four points of each link, up to half a metre
        /// from its origin, in the rig's axes.
        /// </summary>
        public static void RequireAgreement(RobotRig rig, double[] positions, string message)
        {
            var poses = new RigidTransform[rig.Model.Links.Count];
            new ForwardKinematics(rig.Model).Compute(positions, poses);
            for (var i = 0; i < poses.Length; i++)
            {
                var link = rig.Link(rig.Model.Links[i].Name);
                RequireAt(rig, link, poses[i], (0, 0, 0), message);
                RequireAt(rig, link, poses[i], (0.5, 0, 0), message);
                RequireAt(rig, link, poses[i], (0, 0.5, 0), message);
                RequireAt(rig, link, poses[i], (0, 0, 0.5), message);
            }
        }

        static void RequireAt(RobotRig rig, Transform link, in RigidTransform pose, (double X, double Y, double Z) point, string message)
        {
            var moved = pose * RigidTransform.FromXyzRpy(point.X, point.Y, point.Z, 0, 0, 0);
            var expected = Vector(UnityFrame.DirectionToUnity((moved.X, moved.Y, moved.Z)));
            var actual = rig.transform.InverseTransformPoint(link.TransformPoint(Vector(UnityFrame.DirectionToUnity(point))));
            Assert.That(Vector3.Distance(actual, expected), Is.LessThan(ToleranceMetres), message + ", " + link.name + " " + point);
        }

        static Vector3 Vector((double X, double Y, double Z) v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);
    }
}
