using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Unity.Status
{
    /// <summary>Lists the joints without current data in one line. Creates a new string only when a joint, a state or a reason changes.</summary>
    /// <remarks>
    /// Samples whose time stamps are too far ahead are dropped. If no joint without data has another reason, the line states this one instead.
    ///
    /// The line contains the time of day at which a state began. With the age of the state instead, the string would change continuously, and each
    /// new string allocates.
    /// </remarks>
    sealed class JointStatusLine
    {
        static readonly TimeSpan Tolerance = TimeSpan.FromSeconds(1);

        static readonly Predicate<JointStatus> HasNoReason = joint => string.IsNullOrEmpty(joint.Reason);

        readonly bool _isOfMissing;
        readonly Func<DateTime> _wallClock;
        readonly List<JointStatus> _chosen = new List<JointStatus>();
        readonly List<JointStatus> _described = new List<JointStatus>();
        readonly Func<JointStatus, string> _describe;
        string _text;

        /// <param name="isOfMissing">True to list joints without data; false to list joints that are assumed to be at rest.</param>
        /// <param name="wallClock">Returns the local time.</param>
        public JointStatusLine(bool isOfMissing, Func<DateTime> wallClock)
        {
            _isOfMissing = isOfMissing;
            _wallClock = wallClock;
            _describe = joint => joint.DescriptionSince(TimeOf(joint));
        }

        /// <summary>Returns the line; null if the list is empty.</summary>
        /// <param name="statistics">Statistics of the session; null if no session exists.</param>
        public string Of(SessionStatistics statistics) => Of(statistics?.OwnRobot);

        /// <inheritdoc cref="Of(SessionStatistics)"/>
        /// <param name="robot">State of a robot; null if there is none.</param>
        public string Of(RobotStatistics robot)
        {
            // While the pose looks held, joints whose samples come near the horizon cap have data in some frames only. Their line must not flash, and
            // its time must not change with each sample.
            var isHeld = robot != null && robot.SettledPose == PoseState.Held && !robot.IsSettledLimitedByBase;
            _chosen.Clear();
            for (var i = 0; i < (robot?.JointStatuses.Count ?? 0); i++)
                if (IsDescribed(robot.JointStatuses[i], robot.Samples)) _chosen.Add(robot.JointStatuses[i]);
            if (_isOfMissing && robot?.StampProblem is string problem && _chosen.TrueForAll(HasNoReason)) return problem;
            if (IsSame(isHeld) || (isHeld && _isOfMissing && _chosen.Count == 0)) return _text;
            _described.Clear();
            _described.AddRange(_chosen);
            return _text = _chosen.Count == 0 ? null : JointStatusText.Of(_chosen, _describe);
        }

        // Before the first sample of any joint, the panel's row for the pose already contains this information.
        bool IsDescribed(in JointStatus joint, long samples) => joint.IsMissing == _isOfMissing && (samples > 0 || joint.Since.HasValue);

        string TimeOf(in JointStatus joint)
        {
            if (!joint.Age.HasValue) return null;
            var now = _wallClock();
            var since = now - joint.Age.Value;
            return since.ToString(since.Date == now.Date ? "HH:mm:ss" : "yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture);
        }

        bool IsSame(bool isHeld)
        {
            if (_chosen.Count != _described.Count) return false;
            for (var i = 0; i < _chosen.Count; i++)
                if (!IsSame(_chosen[i], _described[i], isHeld && _chosen[i].State == JointDataState.Stale)) return false;
            return true;
        }

        // A joint has an age only while the clock is known. The tolerance is needed because the gateway may recalculate the start of a state for each
        // report.
        static bool IsSame(in JointStatus a, in JointStatus b, bool atAnyTime) => a.Joint == b.Joint && a.State == b.State && a.Reason == b.Reason
            && a.Age.HasValue == b.Age.HasValue && (atAnyTime || !((a.Since - b.Since)?.Duration() > Tolerance));
    }
}
