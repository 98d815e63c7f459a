using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Connects a session to the network: receives messages, and provides displayed joints and diagnostics. Thread-safe.</summary>
    sealed class SessionListener : IRosbridgeListener
    {
        readonly CompensationSession _session;
        readonly SessionIntake _intake;
        readonly JointWatch _joints;
        readonly IHeadsetClock _clock;

        /// <param name="clock">Clock for time stamps of the diagnostics.</param>
        public SessionListener(CompensationSession session, SessionIntake intake, JointWatch joints, IHeadsetClock clock)
        {
            _session = session;
            _intake = intake;
            _joints = joints;
            _clock = clock;
        }

        public void Received(JointStateMessage message, HeadsetTime arrival) => _intake.Add(message, arrival);

        public void Planned(JointTrajectoryMessage message, HeadsetTime arrival) => _intake.Add(message, arrival);

        public void StatusReceived(JointStatusMessage message, HeadsetTime arrival) => _joints.Take(message, arrival);

        public void Described(string urdf) => _session.Described(urdf);

        public void Dropped(DropReason reason) => _intake.Drops.Count(reason);

        public JointStateMessage Displayed() => _session.Displayed();

        /// <summary>Returns the diagnostics, which this headset publishes once per second; the time stamp is zero until the clock is known.</summary>
        public DiagnosticsMessage Diagnostics()
        {
            var now = _clock.Now;
            var statistics = _session.Statistics(now);
            return SessionDiagnostics.Of(
                statistics, _session.Settings.Connection.HeadsetName, statistics.Clock.IsKnown ? statistics.Clock.ToControl(now) : default);
        }
    }
}
