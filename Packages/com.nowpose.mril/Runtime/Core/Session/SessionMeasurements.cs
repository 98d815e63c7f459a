using System;
using Nowpose.Latency;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>
    /// Copies the measurements of a session's parts into its statistics. Allocates nothing; thread-safe only if all parts are thread-safe.
    /// </summary>
    sealed class SessionMeasurements
    {
        const double MillimetresPerMetre = 1000;

        /// <summary>Time for which the render time may be unknown at the start, because its source is selected after some frames.</summary>
        static readonly TimeSpan TimeToSelectSource = TimeSpan.FromSeconds(5);

        readonly ClockSynchroniser _clock;
        readonly ApplicationLatency _latency;
        readonly SessionDisplay _display;
        readonly DisplayFrame _frame;
        readonly HindcastMonitor _hindcast;
        HeadsetTime? _unmeasuredSince;

        public SessionMeasurements(
            ClockSynchroniser clock, ApplicationLatency latency, SessionDisplay display, DisplayFrame frame, HindcastMonitor hindcast) =>
            (_clock, _latency, _display, _frame, _hindcast) = (clock, latency, display, frame, hindcast);

        /// <param name="now">Headset time at which the clock's offset and error bound are evaluated.</param>
        public void Fill(SessionStatistics into, HeadsetTime now, CompensationSession session)
        {
            FillSession(into, session);
            FillClock(into, now);
            FillLatency(into, now);
            FillError(into);
            into.Fill(session.Robots, now);
            into.OutsideRange = _frame.OutsideRange;
        }

        static void FillSession(SessionStatistics into, CompensationSession session)
        {
            into.ClockSettings = session.Settings.Clock;
            into.Dropped = session.Drops.Total + session.SyncFaults.Total;
            into.SyncLink = session.SyncLink;
            into.SampleLink = session.SampleLink;
            into.Reprojection = session.Reprojection;
            into.DepthSubmission = session.DepthSubmission;
            into.VersionMismatch = session.VersionMismatch;
            into.ProfileMismatches = session.ProfileMismatches;
            into.Security = session.Settings.Connection.Security;
        }

        void FillClock(SessionStatistics into, HeadsetTime now)
        {
            var clock = _clock.ModelAt(now);
            into.Clock = clock;
            into.Now = clock.IsKnown ? clock.ToControl(now) : (ControlTime?)null;
            into.Offset = clock.IsKnown ? clock.OffsetAt(now) : (ClockOffset?)null;
            into.RoundTripTime = clock.IsKnown ? _clock.RoundTripTime : (TimeSpan?)null;
            into.ClockSteps = clock.Steps;
        }

        void FillLatency(SessionStatistics into, HeadsetTime now)
        {
            var selector = _display.Selector;
            var renderTimes = _display.RenderTimes;
            into.ApplicationLatency = _latency.Median;
            into.ApplicationLatency95 = _latency.Percentile95;
            into.NegativeLatencies = _latency.NegativeCount;
            into.VisualisationLatency = selector.Used;
            into.EndToEndLatency = _latency.Median + selector.Used;
            into.Profile = selector.Profile;
            into.IsLightPredicted = selector.IsPredicted;
            into.DisplayTimeDifference = selector.Difference;
            into.IsDisplayTimeInconsistent = selector.IsInconsistent;
            into.DisplayTimeAhead = selector.Ahead;
            into.IsDisplayTimeImplausible = selector.IsImplausible;
            into.Horizon = _frame.Horizon;
            into.RenderTime = renderTimes.RenderTime;
            into.RenderTimeSource = renderTimes.Source;
            into.Range = renderTimes.State;
            into.RangeUnknownReason = ReasonAt(now, renderTimes.UnknownReason);
        }

        RangeUnknownReason ReasonAt(HeadsetTime now, RangeUnknownReason reason)
        {
            var isUnmeasured = reason == RangeUnknownReason.NoRenderTime;
            _unmeasuredSince = isUnmeasured ? _unmeasuredSince ?? now : (HeadsetTime?)null;
            return isUnmeasured && now - _unmeasuredSince < TimeToSelectSource ? RangeUnknownReason.TooFewFrames : reason;
        }

        void FillError(SessionStatistics into)
        {
            into.ToolError = _hindcast.Tool?.Times(MillimetresPerMetre);
            into.ToolErrorOfRun = _hindcast.ToolOfRun?.Times(MillimetresPerMetre);
            into.ErrorWithheld = _hindcast.Withheld;
            into.ErrorOfRunWithheld = _hindcast.WithheldOfRun;
            var joints = into.PlacesForJointErrors(_hindcast.JointCount);
            for (var i = 0; i < joints.Length; i++) joints[i] = _hindcast.JointAt(i);
        }
    }
}
