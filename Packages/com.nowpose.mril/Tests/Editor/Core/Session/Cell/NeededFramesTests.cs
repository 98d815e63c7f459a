using System.Linq;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the kept poses of frames that are not shown yet.</summary>
    public class NeededFramesTests
    {
        // Newer messages overtake a message by up to 0.25 s. An older pose shows that the source has restarted.
        [TestCase(0.2, 20)]
        [TestCase(5, 15)]
        public void Need_OlderPoseArrivedLast_IsUsedIfItsSourceHasRestarted(double older, double expected)
        {
            var cell = new CellSession();
            Receive(cell, 20, false, "box");
            Receive(cell, 20 - older, false, "box");
            cell.Run(0.1);

            cell.Session.Frames.Need("box");

            Assert.That(cell.Session.Frames.Find("box").Newest, Is.EqualTo((ControlTime?)ControlTime.FromSeconds(expected)));
        }

        // A stationary pose is sent only once and has no time of its own.
        [TestCase(9, 1)]
        [TestCase(11, 0)]
        public void Add_StationaryFrameAndTooManyTrackedFrames_ReplacesASilentFrame(double silentSeconds, int dropped)
        {
            var cell = new CellSession();
            Receive(cell, 20, false, Enumerable.Range(0, ProtocolLimits.Frames).Select(i => "old" + i).ToArray());
            cell.Run(silentSeconds);

            Receive(cell, 0, true, "fixture");
            cell.Run(0.1);
            cell.Session.Frames.Need("fixture");

            Assert.That(cell.Session.Drops[DropReason.TooManyFrames], Is.EqualTo(dropped));
            Assert.That(cell.Session.Frames.Find("fixture"), dropped == 0 ? Is.Not.Null : Is.Null);
        }

        static void Receive(CellSession cell, double stamp, bool isStationary, params string[] frames) => cell.Session.Listener.FramesReceived(
            new TransformsMessage(frames.Select(frame => At(1, 0).ToTransform(ControlTime.FromSeconds(stamp), "world", frame)).ToArray()),
            isStationary, HeadsetTime.FromSeconds(cell.Now));
    }
}
