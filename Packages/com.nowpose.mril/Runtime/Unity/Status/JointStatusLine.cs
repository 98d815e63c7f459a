using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Session;

namespace Nowpose.Unity.Status
{
    /// <summary>The joints that are not live, in one line; changed only when a joint, a state or a reason changes.</summary>
    /// <remarks>Shows the time of day at which a state began: unlike its age, that text is constant, so that frames allocate nothing.</remarks>
    sealed class JointStatusLine
    {
        static readonly TimeSpan Tolerance = TimeSpan.FromSeconds(1);

        readonly bool _isOfMissing;
        readonly Func<DateTime> _wallClock;
        readonly List<JointStatus> _chosen = new List<JointStatus>();
        readonly List<JointStatus> _described = new List<JointStatus>();
        readonly Func<JointStatus, string> _describe;
        string _text;

        /// <param name="isOfMissing">True to describe joints without data, false for those that are assumed at rest.</param>
        /// <param name="wallClock">Returns the local time.</param>
        public JointStatusLine(bool isOfMissing, Func<DateTime> wallClock)
        {
            _isOfMissing = isOfMissing;
            _wallClock = wallClock;
            _describe = joint => joint.DescriptionSince(TimeOf(joint));
        }

        /// <summary>Returns the line; null if there is nothing to describe.</summary>
        /// <param name="statistics">Null without a session.</param>
        public string Of(SessionStatistics statistics)
        {
            _chosen.Clear();
            for (var i = 0; i < (statistics?.JointStatuses.Count ?? 0); i++)
                if (IsDescribed(statistics.JointStatuses[i], statistics.Samples)) _chosen.Add(statistics.JointStatuses[i]);
            if (IsSame()) return _text;
            _described.Clear();
            _described.AddRange(_chosen);
            return _text = _chosen.Count == 0 ? null : JointStatusText.Of(_chosen, _describe);
        }

        // Before the first sample of any joint, the row of the pose contains the same information.
        bool IsDescribed(in JointStatus joint, long samples) => joint.IsMissing == _isOfMissing && (samples > 0 || joint.Since.HasValue);

        string TimeOf(in JointStatus joint)
        {
            if (!joint.Age.HasValue) return null;
            var now = _wallClock();
            var since = now - joint.Age.Value;
            return since.ToString(since.Date == now.Date ? "HH:mm:ss" : "yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture);
        }

        bool IsSame()
        {
            if (_chosen.Count != _described.Count) return false;
            for (var i = 0; i < _chosen.Count; i++)
                if (!IsSame(_chosen[i], _described[i])) return false;
            return true;
        }

        // The time of day is known only if the clock is. A gateway may recompute the start of a state for each report.
        static bool IsSame(in JointStatus a, in JointStatus b) => a.Joint == b.Joint && a.State == b.State && a.Reason == b.Reason
            && a.Age.HasValue == b.Age.HasValue && !((a.Since - b.Since)?.Duration() > Tolerance);
    }
}
