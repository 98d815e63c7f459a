using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the tool error of a robot whose base is a frame of the cell. It does not contain the error of a moving base.</summary>
    public class BaseErrorTests
    {
        [Test]
        public void ToolJudged_BaseMovedUntilSomeTime_HasOnlyLaterFrames()
        {
            var cell = Cell(out var root);
            var judged = new List<double>();
            cell.Session.Robots[0].Hindcast.ToolJudged += (at, _, __) => judged.Add(at.SinceEpoch.TotalSeconds);
            cell.Sampling += t => cell.Send("world", root, t, At(0.15 * Math.Sin(5 * t)));
            cell.Run(2);

            cell.Sampling = SendJoints(cell);
            cell.Send("world", root, cell.Now, At(1), isStationary: true);
            var stationary = double.NaN;
            cell.Run(2, at =>
            {
                if (double.IsNaN(stationary) && cell.Session.Frames.Find(root).IsFixed) stationary = at;
            });

            Assert.That(judged, Is.Not.Empty.And.All.GreaterThanOrEqualTo(stationary - 1e-6));
        }

        [Test]
        public void ToolErrorOfRun_FrameBelowTheBaseArrivesOneFrameLater_IsStated()
        {
            var cell = Cell(out var root);
            cell.Session.Frames.Need(root);
            cell.Run(1);
            cell.Send("table", root, cell.Now, At(1), isStationary: true);
            cell.Run(1 / 60.0);
            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Incomplete), "the place of the base is unknown");
            cell.Send("world", "table", cell.Now, At(1), isStationary: true);
            cell.Run(3);

            AssertStated(cell);
        }

        [Test]
        public void ToolErrorOfRun_PoseOfTheFrameBelowTheBaseWasOutdated_IsStated()
        {
            var cell = Cell(out var root);
            SendTable(cell, root);
            cell.Run(1);
            cell.Reconnect();
            cell.Run(4);
            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Held), "the source of the table may be gone");
            SendTable(cell, root);
            cell.Run(2);

            AssertStated(cell);
        }

        static void AssertStated(CellSession cell)
        {
            var statistics = cell.Session.Statistics(HeadsetTime.FromSeconds(cell.Now));
            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Current));
            Assert.That((statistics.ErrorWithheld, statistics.ErrorOfRunWithheld), Is.EqualTo((ErrorWithheldReason.None, ErrorWithheldReason.None)));
            Assert.That(statistics.ToolErrorOfRun, Is.Not.Null);
        }

        static CellSession Cell(out string root)
        {
            var cell = new CellSession();
            cell.Sampling = SendJoints(cell);
            root = cell.Session.Robots[0].Root;
            return cell;
        }

        static Action<double> SendJoints(CellSession cell) => t => cell.SendJoints(t, 0.3 * Math.Sin(2 * t), 0);

        static void SendTable(CellSession cell, string root)
        {
            cell.Send("world", "table", cell.Now, At(1), isStationary: true);
            cell.Send("table", root, cell.Now, At(1), isStationary: true);
        }

        static RigidTransform At(double x) => RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, 0);
    }
}
