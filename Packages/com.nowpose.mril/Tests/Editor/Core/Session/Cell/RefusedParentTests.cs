using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests frames whose source reports a parent that the tree of frames cannot take.</summary>
    public class RefusedParentTests
    {
        static RigidTransform Along(double x) => RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, 0);

        // The frame is no longer at its former place in the former parent.
        [Test]
        public void StateOf_SourceReportsAParentThatWouldFormACycle_IsHeldWithTheReasonUntilAnotherParent([Values] bool isStationary)
        {
            var cell = new CellSession();
            foreach (var name in new[] { "tray", "part" }) cell.Session.Frames.Need(name);
            var parent = "world";
            void Send(string frame, string on, double t)
            {
                if (!isStationary || t == 0) cell.Send(on, frame, t, Along(0.1), isStationary);
            }
            cell.Sampling = t =>
            {
                Send("part", "tray", t);
                Send("tray", parent, t);
            };
            Send("part", "tray", 0);
            Send("tray", "world", 0);
            cell.Run(1);
            Assert.That(StateOf(cell, "tray"), Is.EqualTo(PoseState.Current));

            parent = "part";
            Send("tray", parent, 0);
            cell.Run(0.2);
            Assert.That(StateOf(cell, "tray"), Is.EqualTo(PoseState.Held));
            Assert.That(StateOf(cell, "part"), Is.Not.EqualTo(PoseState.Current));
            Assert.That(cell.Session.Frames.Faults(null).Select(fault => fault.Reason), Has.Member(FrameMessages.ParentRefused("part")));

            parent = "world";
            Send("tray", parent, 0);
            cell.Run(1);
            Assert.That((StateOf(cell, "tray"), StateOf(cell, "part")), Is.EqualTo((PoseState.Current, PoseState.Current)));
        }

        static PoseState StateOf(CellSession cell, string name) => cell.Session.Frames.StateOf(cell.Session.Frames.Find(name));
    }
}
