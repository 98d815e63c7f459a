using System;
using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol.Cell;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Poses for a frame tree, and how far apart two of them are.</summary>
    static class TreePoses
    {
        public const double Sampling = 0.02;

        public static FrameTree NewTree() => new FrameTree(() => new BodyPredictor("linear", new PredictionLimits()));

        public static ControlTime At(double seconds) => ControlTime.FromSeconds(1000 + seconds);

        public static FrameTransform Pose(double t, string parent, string child, double x = 0, double y = 0, double z = 0, UnitQuaternion? turned = null)
        {
            var q = turned ?? UnitQuaternion.Identity;
            return new FrameTransform(At(t), parent, child, x, y, z, q.X, q.Y, q.Z, q.W);
        }

        public static CellFrame FrameOf(FrameTree tree, string name) => tree[tree.IndexOf(name)];

        public static double Distance(in RigidTransform a, in RigidTransform b) =>
            Math.Sqrt((a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y) + (a.Z - b.Z) * (a.Z - b.Z));
    }
}
