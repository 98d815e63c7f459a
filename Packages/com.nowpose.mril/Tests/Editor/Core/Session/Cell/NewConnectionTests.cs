using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests that values from before a connection are not current until they arrive again, because their source may be gone.</summary>
    public class NewConnectionTests
    {
        static readonly RigidTransform Place = RigidTransform.FromXyzRpy(0.5, 0, 0, 0, 0, 0);

        static string FaultOf(CellSession cell, string signal) => cell.Session.Signals.FaultOf(signal, isConnected: true).Reason;

        static PoseState StateOf(CellSession cell, string frame) => cell.Session.Frames.StateOf(cell.Session.Frames.Find(frame));

        // The gateway's latched value has its former stamp; a source that has restarted may give it a new one.
        [TestCase(20)]
        [TestCase(20.2)]
        public void FaultOf_ValueFromBeforeTheConnection_IsNamedUntilTheValueArrivesAgain(double stamp)
        {
            var cell = new CellSession();
            cell.Reconnect();
            cell.Send("grip", 20, 1);
            cell.Send("door", 20, 1);
            cell.Run(0.3);
            Assert.That((FaultOf(cell, "grip"), FaultOf(cell, "door")), Is.EqualTo(((string)null, (string)null)));

            cell.Reconnect();
            cell.Session.Listener.SignalStatusReceived(new JointStatusMessage(Array.Empty<JointReport>()), HeadsetTime.FromSeconds(cell.Now));
            cell.Run(5);
            Assert.That((FaultOf(cell, "grip"), FaultOf(cell, "door")),
                Is.EqualTo((SignalMessages.OlderThanConnection, SignalMessages.OlderThanConnection)));

            cell.Session.Listener.SignalsReceived(
                new SignalsMessage(ControlTime.FromSeconds(stamp), new SignalValue("grip", 1)), HeadsetTime.FromSeconds(cell.Now));
            cell.Run(0.1);
            Assert.That((FaultOf(cell, "grip"), FaultOf(cell, "door")), Is.EqualTo(((string)null, SignalMessages.OlderThanConnection)));
        }

        [Test]
        public void StateOf_StationaryFrameFromBeforeTheConnection_IsHeldAfterSomeTimeUntilItArrivesAgain()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "table", "lid", "by hand" }) cell.Session.Frames.Need(name);
            cell.Sampling = t => cell.Send("table", "lid", t, Place);
            cell.Reconnect();
            cell.Send("world", "table", 20, Place, isStationary: true);
            cell.Session.Frames.Place("by hand", Place);
            cell.Run(5);
            Assert.That((StateOf(cell, "table"), StateOf(cell, "lid")), Is.EqualTo((PoseState.Current, PoseState.Current)));

            cell.Reconnect();
            cell.Run(2, _ => Assert.That((StateOf(cell, "table"), StateOf(cell, "lid")), Is.EqualTo((PoseState.Current, PoseState.Current))));
            cell.Run(1);
            Assert.That((StateOf(cell, "table"), StateOf(cell, "lid")), Is.EqualTo((PoseState.Held, PoseState.Held)));
            Assert.That(cell.Session.Frames.Find("lid").State, Is.EqualTo(FrameState.ParentNotCurrent));
            Assert.That(StateOf(cell, "by hand"), Is.EqualTo(PoseState.Current));

            cell.Reconnect();
            cell.Run(1, _ => Assert.That(StateOf(cell, "table"), Is.EqualTo(PoseState.Held), "another connection alone makes no pose current"));

            cell.Send("world", "table", cell.Now, Place, isStationary: true);
            cell.Run(0.1);
            Assert.That((StateOf(cell, "table"), StateOf(cell, "lid")), Is.EqualTo((PoseState.Current, PoseState.Current)));
        }

        // Each connection is shorter than the time in which a stationary pose must arrive again.
        [Test]
        public void StateOf_StationaryFrameWhileTheConnectionIsLostAgainAndAgain_IsHeldAfterTheSameTime()
        {
            var cell = new CellSession();
            cell.Session.Frames.Need("table");
            cell.Reconnect();
            cell.Send("world", "table", 20, Place, isStationary: true);
            cell.Run(5);

            var lost = cell.Now;
            var held = double.NaN;
            for (var i = 0; i < 6; i++)
            {
                cell.Reconnect();
                cell.Run(1, at => held = double.IsNaN(held) && StateOf(cell, "table") == PoseState.Held ? at - CellSession.Visu - lost : held);
            }

            Assert.That(held, Is.EqualTo(2.5).Within(0.05));
            Assert.That(StateOf(cell, "table"), Is.EqualTo(PoseState.Held));
        }
    }
}
