using System.Collections.Generic;
using System.Linq;
using System.Text;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests the objects and signals in the diagnostics of a headset.</summary>
    public class CellDiagnosticsTests
    {
        [Test]
        public void Diagnostics_PartsNotCurrent_NameThemWithReasonAndAge()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "box", "lid", "lost" }) cell.Session.Frames.Need(name);
            foreach (var name in new[] { "closed", "never" }) cell.Session.Signals.Need(name);
            cell.Send("closed", 19.5, 1);
            cell.Send("other", 19.5, 1);
            cell.Session.Listener.SignalStatusReceived(
                new JointStatusMessage(new[] { new JointReport("closed", JointDataState.Stale, ControlTime.FromSeconds(20.5), "it has ended") }),
                HeadsetTime.FromSeconds(20.5));
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                if (t < 20.5) cell.Send("world", "box", t, RigidTransform.Identity);
                cell.Send("world", "lid", t, RigidTransform.Identity);
            };
            cell.Run(4);

            var message = DiagnosticsOf(cell);

            Assert.That(Values(message, "object_status/"), Is.EqualTo(new[]
            {
                "lost = " + StateNames.Describe(StateNames.NotCurrent, "", FrameMessages.NoPose),
                "box = " + StateNames.Describe(StateNames.NotCurrent, " for 3 s", FrameMessages.PosesStopped),
            }));
            Assert.That(Values(message, "signal_status/"), Is.EqualTo(new[]
            {
                "never = " + StateNames.Describe(StateNames.NotCurrent, "", SignalMessages.NoValue),
                "closed = " + StateNames.Describe(StateNames.NotCurrent, " for 3 s", "it has ended"),
            }));
            Assert.That((Value(message, "objects_not_current"), Value(message, "signals_not_current")), Is.EqualTo(("2", "2")));
            Assert.That((Value(message, "pose"), message.Level), Is.EqualTo(("current", 1)));
            Assert.That(message.Message, Is.EqualTo(FrameMessages.NotCurrent("lost", 2) + "; " + SignalMessages.NotCurrent("never", 2)));
            // The gateway drops values above its limit, and robots with many joints have many errors.
            Assert.That(message.Values.Reverse().TakeWhile(pair => !pair.Key.StartsWith("signal_status/")).Count(pair => pair.Key.StartsWith("error/")), Is.EqualTo(2));
        }

        [Test]
        public void Diagnostics_PartsCurrentOrNoLongerShown_HaveNoEntries()
        {
            var cell = new CellSession();
            foreach (var name in new[] { "box", "hidden", "hidden" }) cell.Session.Frames.Need(name);
            foreach (var name in new[] { "closed", "hidden" }) cell.Session.Signals.Need(name);
            cell.Send("closed", 19.5, 1);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                cell.Send("world", "box", t, RigidTransform.Identity);
            };
            cell.Run(1);
            cell.Session.Frames.Leave("hidden");
            cell.Session.Signals.Leave("hidden");

            Assert.That((Value(DiagnosticsOf(cell), "objects_not_current"), Value(DiagnosticsOf(cell), "signals_not_current")), Is.EqualTo(("1", "0")));

            cell.Session.Frames.Leave("hidden");

            Assert.That((Value(DiagnosticsOf(cell), "objects_not_current"), DiagnosticsOf(cell).Level), Is.EqualTo(("0", 0)));
        }

        // The state of the clock is a value of its own.
        [Test]
        public void Diagnostics_ClockUnknown_NameOnlyPartsWithAReasonOfTheirOwn()
        {
            var cell = new CellSession(isClockKnown: false);
            foreach (var name in new[] { "box", "orphan" }) cell.Session.Frames.Need(name);
            cell.Send("unknown", "orphan", 20, RigidTransform.Identity, isStationary: true);
            cell.Sampling = t => cell.Send("world", "box", t, RigidTransform.Identity);
            cell.Run(1);

            Assert.That(Values(DiagnosticsOf(cell), "object_status/").Single(), Does.StartWith("orphan = ").And.EndWith(FrameMessages.FrameUnknown("unknown")));
        }

        [Test]
        public void Diagnostics_TrackedBaseOfARobotStops_NamesIt()
        {
            var cell = new CellSession();
            var root = cell.Session.Robots[0].Root;
            cell.Sampling = t => cell.SendJoints(t, 0, 0);
            cell.Run(1);
            Assert.That(Values(DiagnosticsOf(cell), "object_status/"), Is.Empty, "a robot without a tracked base");

            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                if (t < 22) cell.Send("world", root, t, RigidTransform.Identity);
            };
            cell.Run(4);

            Assert.That(Values(DiagnosticsOf(cell), "object_status/").Single(), Does.StartWith(root + " = ").And.EndWith(FrameMessages.PosesStopped));
        }

        [Test]
        public void Diagnostics_TrackedBaseOfAHiddenRobotStops_DoNotCountIt()
        {
            var cell = new CellSession();
            var robot = cell.Session.Robots.Add("arm2", cell.Session.Robot);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                if (t < 20.5) cell.Send("world", robot.Root, t, RigidTransform.Identity);
            };
            cell.Run(4);
            string Count() => Value(DiagnosticsOf(cell), "objects_not_current");
            Assert.That(Count(), Is.EqualTo("1"));

            robot.IsShown = false;
            Assert.That(Count(), Is.EqualTo("0"));
            cell.Session.Frames.Need(robot.Root);
            Assert.That(Count(), Is.EqualTo("1"), "an object shows the frame");
            cell.Session.Frames.Leave(robot.Root);
            robot.IsShown = true;
            Assert.That(Count(), Is.EqualTo("1"), "the robot is shown again");
        }

        // Quotation marks and characters of three bytes make the message as long as possible.
        [TestCase('a')]
        [TestCase('"')]
        [TestCase('\u6f22')]
        public void Diagnostics_ManyPartsWithLongNames_StayBelowTheMessageLimitAndCountAll(char letter)
        {
            const int parts = 200;
            var cell = new CellSession();
            for (var i = 0; i < parts; i++)
            {
                var name = i.ToString("D3").PadRight(ProtocolLimits.NameLength, letter);
                cell.Session.Frames.Need(name);
                cell.Send(name + "?", name, 20, RigidTransform.Identity, isStationary: true);
                cell.Session.Signals.Need(name);
            }
            cell.Run(1);

            var message = DiagnosticsOf(cell);

            var sent = RosbridgeWriter.Publish(RosTopics.Diagnostics, message, RosTimeForm.Sec);
            Assert.That(Encoding.UTF8.GetByteCount(sent), Is.LessThan(ProtocolLimits.MessageBytes));
            Assert.That((Value(message, "objects_not_current"), Value(message, "signals_not_current")), Is.EqualTo(("200", "200")));
            Assert.That(Values(message, "object_status/").Count, Is.InRange(10, SessionDiagnostics.MaxParts));
            Assert.That(message.Values.Select(pair => pair.Key), Has.Member("samples").And.Member("l_visu_ms"));
        }

        [Test]
        public void Diagnostics_ManyRobotsWithoutData_StayBelowTheMessageLimit()
        {
            var cell = new CellSession();
            var joints = string.Concat(Enumerable.Range(0, 15).Select(i =>
                $"<joint name='{new string('\u6f22', 120)}{i}' type='revolute'><parent link='l{i}'/><child link='l{i + 1}'/>"
                + "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
                + $"<link name='l{i + 1}'/>"));
            var robot = UrdfReader.Read("<robot name='many'><link name='l0'/>" + joints + "</robot>", "test");
            for (var i = 0; i < ProtocolLimits.Robots; i++) cell.Session.Robots.Add("arm" + i, robot);
            cell.Run(0.1);

            var sent = RosbridgeWriter.Publish(RosTopics.Diagnostics, DiagnosticsOf(cell), RosTimeForm.Sec);

            Assert.That(Encoding.UTF8.GetByteCount(sent), Is.LessThan(ProtocolLimits.MessageBytes));
        }

        static DiagnosticsMessage DiagnosticsOf(CellSession cell) =>
            new SessionListener(cell.Session, new SetClock { Now = HeadsetTime.FromSeconds(cell.Now) }).Diagnostics();

        static string Value(DiagnosticsMessage message, string key) => message.Values.Single(pair => pair.Key == key).Value;

        static List<string> Values(DiagnosticsMessage message, string prefix) =>
            message.Values.Where(pair => pair.Key.StartsWith(prefix)).Select(pair => $"{pair.Key.Substring(prefix.Length)} = {pair.Value}").ToList();
    }
}
