using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Session
{
    /// <summary>Connects a session to the network: receives messages, and provides displayed joints and diagnostics. Thread-safe.</summary>
    sealed class SessionListener : IRosbridgeListener
    {
        const int NoDiagnostics = -1;

        readonly CompensationSession _session;
        readonly IHeadsetClock _clock;
        // Most severe state of a pose in the newest diagnostics.
        volatile int _reportedPose = NoDiagnostics;
        volatile bool _needsNamespaces;

        /// <param name="clock">Clock for time stamps of the diagnostics.</param>
        public SessionListener(CompensationSession session, IHeadsetClock clock) => (_session, _clock) = (session, clock);

        public void Received(JointStateMessage message, HeadsetTime arrival, string robot = "")
        {
            var receiver = _session.Robots.Of(robot);
            if (receiver != null) receiver.Intake.Add(message, arrival);
            else message.Release();
        }

        public void Planned(JointTrajectoryMessage message, HeadsetTime arrival, string robot = "") =>
            _session.Robots.Of(robot)?.Intake.Add(message, arrival);

        public void FramesReceived(TransformsMessage message, bool isStationary, HeadsetTime arrival) =>
            _session.Frames.Add(message, isStationary, arrival);

        public void SignalsReceived(SignalsMessage message, HeadsetTime arrival) => _session.Signals.Add(message, arrival);

        public void StatusReceived(JointStatusMessage message, HeadsetTime arrival)
        {
            foreach (var robot in _session.Robots) robot.Joints.Take(message, arrival);
        }

        public void SignalStatusReceived(JointStatusMessage message, HeadsetTime arrival) => _session.Signals.Take(message, arrival);

        public void Described(string urdf, string robot = "")
        {
            var receiver = _session.Robots.Of(robot);
            if (receiver != null && !receiver.Description.Receive(urdf)) Dropped(DropReason.NotUrdf);
        }

        public void Connected(HeadsetTime at)
        {
            _session.VersionMismatch = null;
            foreach (var robot in _session.Robots) robot.OtherNamespaces = null;
            _session.Cell.Connection.Set(at);
        }

        public void VersionReceived(string version) => _session.VersionMismatch = NowposeVersion.MismatchOf(version, "the gateway", "this headset");

        public void NamespacesReceived(IReadOnlyList<string> names)
        {
            foreach (var robot in _session.Robots)
            {
                // A gateway that describes the robot serves it, even if no positions have arrived yet.
                var isServed = names.Count == 0 || names.Contains(robot.Namespace) || robot.Description.Match != RobotDescriptionMatch.Unknown;
                robot.OtherNamespaces = isServed ? null : RobotMessages.OtherNamespaces(robot.Namespace, names);
            }
        }

        public void Dropped(DropReason reason) => _session.Drops.Count(reason);

        public JointStateMessage Displayed() => _session.Displayed();

        public bool HasPoseChanged => _reportedPose != NoDiagnostics && _reportedPose != (int)_session.ReadWorstPose(_clock.Now);

        public bool NeedsNamespaces => _needsNamespaces;

        /// <summary>
        /// Returns the diagnostics that this headset publishes once per second, and at once when the state of the pose changes. The time stamp is zero
        /// until the clock is known.
        /// </summary>
        public DiagnosticsMessage Diagnostics()
        {
            var now = _clock.Now;
            var statistics = _session.Statistics(now);
            _reportedPose = (int)statistics.WorstPose;
            _needsNamespaces = statistics.Robots.Any(robot => robot.Samples == 0);
            return SessionDiagnostics.Of(
                statistics, _session.Cell.Faults(now), _session.Settings.Connection.HeadsetName,
                statistics.Clock.IsKnown ? statistics.Clock.ToControl(now) : default);
        }
    }
}
