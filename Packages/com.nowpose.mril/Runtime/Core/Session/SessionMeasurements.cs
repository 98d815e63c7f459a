using System;
using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>Copies the measurements of a session's parts into its statistics. Allocates nothing; as thread-safe as the parts.</summary>
    sealed class SessionMeasurements
    {
        const double MillimetresPerMetre = 1000;

        readonly ClockSynchroniser _clock;
        readonly ApplicationLatency _latency;
        readonly DisplayTimeSelector _light;
        readonly ConstantLatencyMonitor _monitor;
        readonly DisplayFrame _frame;
        readonly HindcastMonitor _hindcast;

        public SessionMeasurements(
            ClockSynchroniser clock, ApplicationLatency latency, DisplayTimeSelector light, ConstantLatencyMonitor monitor, DisplayFrame frame,
            HindcastMonitor hindcast)
        {
            _clock = clock;
            _latency = latency;
            _light = light;
            _monitor = monitor;
            _frame = frame;
            _hindcast = hindcast;
        }

        /// <param name="now">Headset time at which the clock's offset and error bound are evaluated.</param>
        public void Fill(SessionStatistics into, HeadsetTime now)
        {
            FillClock(into, now);
            FillLatency(into);
            FillError(into);
            into.Pose = _frame.State;
            into.OutsideRange = _frame.OutsideRange;
        }

        void FillClock(SessionStatistics into, HeadsetTime now)
        {
            var clock = _clock.ModelAt(now);
            into.Clock = clock;
            into.Offset = clock.IsKnown ? clock.OffsetAt(now) : (ClockOffset?)null;
            into.RoundTripTime = clock.IsKnown ? _clock.RoundTripTime : (TimeSpan?)null;
            into.ClockSteps = clock.Steps;
        }

        void FillLatency(SessionStatistics into)
        {
            into.ApplicationLatency = _latency.Median;
            into.ApplicationLatency95 = _latency.Percentile95;
            into.NegativeLatencies = _latency.NegativeCount;
            into.VisualisationLatency = _light.Used;
            into.EndToEndLatency = _latency.Median + _light.Used;
            into.Profile = _light.Profile;
            into.IsLightPredicted = _light.IsPredicted;
            into.DisplayTimeDifference = _light.Difference;
            into.IsDisplayTimeInconsistent = _light.IsInconsistent;
            into.DisplayTimeAhead = _light.Ahead;
            into.IsDisplayTimeImplausible = _light.IsImplausible;
            into.Horizon = _frame.Horizon;
            into.RenderTime = _monitor.RenderTime;
            into.RenderTimeSource = _monitor.Source;
            into.Range = _monitor.State;
            into.RangeUnknownReason = _monitor.UnknownReason;
        }

        void FillError(SessionStatistics into)
        {
            into.ToolError = _hindcast.Tool?.Times(MillimetresPerMetre);
            into.ToolErrorOfRun = _hindcast.ToolOfRun?.Times(MillimetresPerMetre);
            into.IsRunPartlyOutsideRange = _hindcast.IsRunPartlyOutside;
            var joints = into.PlacesForJointErrors(_hindcast.JointCount);
            for (var i = 0; i < joints.Length; i++) joints[i] = _hindcast.JointAt(i);
        }
    }
}
