using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Detects the joints without current data, from their samples and from the gateway's reports.</summary>
    /// <remarks>
    /// The gateway has more information: it can immediately distinguish a joint at rest from a joint whose variable was deleted. A server
    /// without the topic <see cref="RosTopics.JointStatus"/> reports nothing; then the age of the samples decides. Allocates nothing in a
    /// frame.
    /// </remarks>
    sealed class JointWatch
    {
        /// <summary>Lifetime of a report. The gateway repeats a report every second while a joint is not live.</summary>
        static readonly TimeSpan ReportLifetime = TimeSpan.FromSeconds(5);

        /// <summary>Lifetime of a report of rest, which explains missing samples. The gateway repeats it; one repetition may be lost.</summary>
        static readonly TimeSpan RestLifetime = TimeSpan.FromMilliseconds(2500);

        readonly string _prefix;
        readonly RobotModel _robot;
        readonly JointTracks _tracks;
        readonly TimeSpan _horizonCap;
        readonly bool[] _isToolJoint;
        // Used under its own lock, because both the frame thread and the socket's thread call MissingSince.
        readonly List<JointStatus> _listed = new List<JointStatus>();
        volatile Reports _newest;

        /// <param name="name">Namespace of the robot. It precedes the joints' names in reports; empty for the robot without a namespace.</param>
        /// <param name="horizonCap">Maximum age of a joint's newest sample at the display time. A joint with an older sample has no data.</param>
        public JointWatch(string name, RobotModel robot, JointTracks tracks, TimeSpan horizonCap)
        {
            _prefix = RobotTopic.Qualified(name, "");
            _robot = robot;
            _tracks = tracks;
            _horizonCap = horizonCap;
            _isToolJoint = new bool[robot.MovingJoints.Count];
            foreach (var joint in ToolJoints.Of(robot)) _isToolJoint[joint] = true;
        }

        /// <summary>Stores the newest report, which replaces the previous report. Thread-safe.</summary>
        public void Take(JointStatusMessage message, HeadsetTime arrival)
        {
            var reports = new Reports(arrival, _robot.MovingJoints.Count);
            foreach (var report in message.Joints)
            {
                if (!report.Joint.StartsWith(_prefix, StringComparison.Ordinal)) continue;
                var joint = _robot.IndexOfMovingJoint(report.Joint.Substring(_prefix.Length));
                if (joint < 0) continue;
                reports.OfJoint[joint] = report;
                reports.IsAnyMissing |= HoldsPose(joint, report.State);
            }
            _newest = reports;
        }

        /// <summary>Returns whether the gateway reports missing data for a joint that is required for a current pose.</summary>
        public bool IsAnyReportedMissing(HeadsetTime now)
        {
            var reports = ReportsAt(now);
            if (reports == null || reports.IsAnyMissing) return reports != null;
            for (var i = 0; i < _isToolJoint.Length; i++)
                if (IsRestUnknown(i, reports.OfJoint[i])) return true;
            return false;
        }

        /// <summary>Replaces the elements of a list with the joints that are not live, in the robot's order.</summary>
        /// <param name="shownFor">Display time of the newest frame; null while unknown.</param>
        public void Fill(List<JointStatus> into, HeadsetTime now, in ClockModel clock, ControlTime? shownFor)
        {
            into.Clear();
            var reports = ReportsAt(now);
            var controlNow = clock.IsKnown ? clock.ToControl(now) : (ControlTime?)null;
            var isRestConfirmed = reports != null && now - reports.Arrival <= RestLifetime;
            for (var i = 0; i < _isToolJoint.Length; i++)
            {
                var report = reports?.OfJoint[i] ?? default;
                if (!report.State.IsGood()) into.Add(StatusOf(i, report.State, report.Since, controlNow, report.Reason));
                else if (IsRestUnknown(i, report) || (_isToolJoint[i] && report.State != JointDataState.Rest && !_tracks.HasSample(i)))
                    into.Add(StatusOf(i, JointDataState.Missing, null, controlNow, ""));
                else if (report.State == JointDataState.Rest && (isRestConfirmed || !IsOld(i, shownFor)))
                    into.Add(StatusOf(i, JointDataState.Rest, report.Since, controlNow, report.Reason));
                else if (IsOld(i, shownFor) && _tracks.ReceivesOldSamples(i))
                    into.Add(StatusOf(i, JointDataState.Stale, null, controlNow, RobotMessages.SamplesTooOld));
                else if (IsOld(i, shownFor)) into.Add(StatusOf(i, JointDataState.Stale, _tracks.NewestOf(i), controlNow, ""));
            }
        }

        /// <summary>
        /// Returns the time since which a joint that is required for a current pose has had no data, or another joint if all these have data. Returns null
        /// if the time is unknown or all joints have data. Thread-safe while no frame is computed.
        /// </summary>
        /// <inheritdoc cref="Fill"/>
        public ControlTime? MissingSince(HeadsetTime now, in ClockModel clock, ControlTime? shownFor)
        {
            lock (_listed)
            {
                Fill(_listed, now, clock, shownFor);
                var isHeld = false;
                foreach (var joint in _listed) isHeld |= HoldsPose(joint);
                ControlTime? since = null;
                foreach (var joint in _listed)
                    if ((isHeld ? HoldsPose(joint) : joint.IsMissing) && !(joint.Since >= since)) since = joint.Since ?? since;
                return since;
            }
        }

        bool HoldsPose(in JointStatus joint) => HoldsPose(_robot.IndexOfMovingJoint(joint.Joint), joint.State);

        // A gripper may send samples only while it moves. If they stop for an unknown reason, the gripper is listed, but the arm's pose stays
        // current.
        bool HoldsPose(int joint, JointDataState state) => !state.IsGood() && (_isToolJoint[joint] || state != JointDataState.Stale);

        // A joint at rest may send no samples. Until its first sample, the displayed position is that of the robot model.
        bool IsRestUnknown(int joint, in JointReport report) => report.State == JointDataState.Rest && !_tracks.HasPosition(joint);

        bool IsOld(int joint, ControlTime? shownFor) => _isToolJoint[joint] && shownFor - _tracks.NewestOf(joint) > _horizonCap;

        JointStatus StatusOf(int joint, JointDataState state, ControlTime? since, ControlTime? now, string reason)
        {
            var age = now - since;
            return new JointStatus(_robot.MovingJoints[joint].Name, state, since, age < TimeSpan.Zero ? TimeSpan.Zero : age, reason);
        }

        Reports ReportsAt(HeadsetTime now)
        {
            var newest = _newest;
            return newest != null && now - newest.Arrival <= ReportLifetime ? newest : null;
        }

        sealed class Reports
        {
            public Reports(HeadsetTime arrival, int joints)
            {
                Arrival = arrival;
                OfJoint = new JointReport[joints];
            }

            public HeadsetTime Arrival { get; }

            /// <summary>Reports by index of the moving joint. A joint without a report has the default state, live.</summary>
            public JointReport[] OfJoint { get; }

            public bool IsAnyMissing { get; set; }
        }
    }
}
