using System;
using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol.Cell;
using Nowpose.Session;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Creates an arm whose gripper closes near objects, for tests of grips by reach.</summary>
    static class GripScene
    {
        public const double Reach = 0.1, Close = 22, Open = 24, Rate = 0.3;

        public static RigidTransform At(double x, double y) => RigidTransform.FromXyzRpy(x, y, 0, 0, 0, 0);

        public static double Distance(in RigidTransform a, in RigidTransform b) =>
            Math.Sqrt((a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y) + (a.Z - b.Z) * (a.Z - b.Z));

        public static double AngleOf(in RigidTransform a, in RigidTransform b) => UnitQuaternion.Of(a.Inverse * b).Log().Length;

        /// <summary>Returns the tool pose of the straight arm, 1 m long, for a shoulder angle in rad.</summary>
        public static RigidTransform Tool(double shoulder) =>
            RigidTransform.FromXyzRpy(Math.Cos(shoulder), Math.Sin(shoulder), 0, 0, 0, shoulder);

        // Returns the shoulder angle in rad. The arm turns at constant speed and passes 0 rad when the gripper closes.
        public static double Shoulder(double t) => Rate * (t - Close);

        public static (CellSession Cell, ReachGrip Grip) NewCell(params string[] objects)
        {
            var cell = new CellSession();
            return (cell, NewGrip(cell, objects));
        }

        public static ReachGrip NewGrip(CellSession cell, params string[] objects) => NewGrip(cell, (IReadOnlyList<string>)objects);

        /// <param name="objects">Names of the objects. The list may change.</param>
        public static ReachGrip NewGrip(CellSession cell, IReadOnlyList<string> objects)
        {
            foreach (var name in objects) cell.Session.Frames.Need(name);
            var robot = cell.Session.Robots[0];
            var grip = new ReachGrip(
                cell.Session.Frames.Tree, robot, robot.Robot.IndexOfLink("tool_centre_point"), Reach, objects);
            cell.Session.Grips.Add(grip, "grip");
            return grip;
        }

        public static PoseState StateOf(CellSession cell, string name = "box") => cell.Session.Frames.StateOf(Find(cell, name));

        /// <summary>Sends the shoulder angles of the last 50 ms.</summary>
        public static void SendShoulder(CellSession cell, double t, double interval)
        {
            for (var i = (int)Math.Round(CellSession.Interval / interval) - 1; i >= 0; i--)
                cell.SendJoints(t - i * interval, Shoulder(t - i * interval), 0);
        }

        /// <summary>Sends a value of the gripper's signal that arrives now.</summary>
        public static void SendGripNow(CellSession cell, double stamp, double value) => SendNow(cell, "grip", stamp, value);

        /// <summary>Sends a value of a signal that arrives now.</summary>
        public static void SendNow(CellSession cell, string signal, double stamp, double value) => cell.Session.Listener.SignalsReceived(
            new SignalsMessage(ControlTime.FromSeconds(stamp), new SignalValue(signal, value)), HeadsetTime.FromSeconds(cell.Now));

        public static CellFrame Find(CellSession cell, string name) => cell.Session.Frames.Find(name);

        public static RigidTransform ToolOf(CellSession cell) => cell.Session.Robots[0].Frame.ToolPose;

        public static void Until(CellSession cell, double time, Action<double> seen = null) => cell.Run(time - cell.Now, seen);
    }
}
