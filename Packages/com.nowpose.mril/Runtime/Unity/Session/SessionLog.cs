using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Session
{
    /// <summary>Logs the changes of a session, each change once.</summary>
    sealed class SessionLog
    {
        readonly Object _context;
        string _sync, _samples, _versions;
        bool _hasPositions;
        CompensationSession _followed;
        // Numbers of the logged joints beyond their limits, one per robot.
        readonly List<int> _beyondLimits = new List<int>();
        IReadOnlyList<ConditionMismatch> _mismatches = Array.Empty<ConditionMismatch>();

        /// <param name="context">Object that is selected by a click on a logged line.</param>
        public SessionLog(Object context) => _context = context;

        public void Info(string message) => ConsoleLog.Info(_context, message);
        public void Warn(string message) => ConsoleLog.Warn(_context, message);
        public void Fail(string message) => ConsoleLog.Fail(_context, message);

        /// <summary>
        /// Logs changes of the connections, the first joint positions of a session, joints outside their limits, conditions that differ from the
        /// latency profile, and version mismatches. Call it in each frame; it allocates only if something has changed.
        /// </summary>
        public void Follow(CompensationSession session)
        {
            Follow(session.SyncLink, "clock sync", ref _sync);
            Follow(session.SampleLink, "gateway", ref _samples);
            if (session != _followed) Begin(session);
            FollowPositions(session.Robots);
            FollowLimits(session.Robots);
            Follow(session.ProfileMismatches);
            // Each reconnection reports a version mismatch again, so the same mismatch is logged only once.
            var versions = session.VersionMismatch;
            if (versions != null && versions != _versions) Warn(_versions = versions);
        }

        /// <summary>Logs a change of state.</summary>
        /// <param name="session">The session; null if it has ended.</param>
        /// <param name="statistics">Statistics of the frame with the change; null if the session has ended.</param>
        public void Log(SessionChange change, CompensationSession session, SessionStatistics statistics)
        {
            if ((change & SessionChange.Synchronised) != 0) Info(SessionMessages.Synchronised);
            if ((change & SessionChange.Lost) != 0) Warn(SessionMessages.SynchronisationLost);
            if ((change & SessionChange.EnteredRange) != 0) Info(ReasonInside(statistics));
            if ((change & SessionChange.LeftRange) != 0) Warn(ReasonOutside(statistics));
            if ((change & SessionChange.DisplayTimeInconsistent) != 0) LogDifference(session, statistics);
            if ((change & SessionChange.DisplayTimeImplausible) != 0) Warn(DisplayMessages.ImplausibleTimes(session?.DisplayTimeAhead));
            if ((change & SessionChange.DisplayTimePlausible) != 0) Info(SessionMessages.PlausibleAgain);
            if ((change & SessionChange.Stale) != 0) Warn(SessionMessages.Stale(MissingJointsOf(statistics)));
        }

        static string ReasonInside(SessionStatistics statistics) =>
            statistics?.Range == RangeState.Unknown ? SessionMessages.NoRefreshesMissed : SessionMessages.WithinRange;

        static string ReasonOutside(SessionStatistics statistics) =>
            statistics?.RangeUnknownReason == RangeUnknownReason.LowFrameRate ? SessionMessages.RefreshesMissed : SessionMessages.BeyondRange;

        // Without a profile, L_visu may be the estimate of the settings, which was not measured.
        void LogDifference(CompensationSession session, SessionStatistics statistics)
        {
            if (session == null || statistics == null) return;
            var set = session.Visualisation.Length;
            if (statistics.Profile != null) Warn(SessionMessages.LatenciesDiffer);
            else if (set + statistics.DisplayTimeDifference is TimeSpan predicted)
                Info(SessionMessages.LatencyNotVerified(predicted.TotalMilliseconds, set.TotalMilliseconds));
        }

        void Begin(CompensationSession session)
        {
            _followed = session;
            _hasPositions = false;
            _beyondLimits.Clear();
        }

        void FollowPositions(SessionRobots robots)
        {
            if (_hasPositions || robots[0].Intake.Samples == 0) return;
            _hasPositions = true;
            Info(SessionMessages.FirstPositions);
        }

        void FollowLimits(SessionRobots robots)
        {
            for (var i = 0; i < robots.Count; i++)
            {
                if (_beyondLimits.Count == i) _beyondLimits.Add(0);
                for (var found = robots[i].Limits.Found; _beyondLimits[i] < found.Count; _beyondLimits[i]++)
                    Warn(i == 0 ? found[_beyondLimits[i]].Words : RobotMessages.OfRobot(robots[i].Namespace, found[_beyondLimits[i]].Words));
            }
        }

        static string MissingJointsOf(SessionStatistics statistics) =>
            statistics == null ? "" : JointStatusText.Of(statistics.JointStatuses.Where(joint => joint.IsMissing));

        void Follow(IReadOnlyList<ConditionMismatch> mismatches)
        {
            if (ReferenceEquals(mismatches, _mismatches)) return;
            foreach (var mismatch in mismatches)
                if (!_mismatches.Any(each => each.Words == mismatch.Words)) Warn(mismatch.Words);
            _mismatches = mismatches;
        }

        // Logs changes of a link's state. While the link retries for the same reason, the reason is logged only once.
        void Follow(LinkStatus link, string name, ref string logged)
        {
            if (link.State == LinkState.Connecting || link.Detail == logged) return;
            if (link.State == LinkState.Waiting) Warn(link.Detail);
            else if (link.Warning != null) Warn(name + ": " + link.Detail);
            else if (logged != null || link.State == LinkState.Connected) Info(name + ": " + link.Detail);
            logged = link.Detail;
        }
    }
}
