using System;
using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.DisplayTime;

namespace Nowpose.Session
{
    /// <summary>Display settings of a session: L_visu, the constant-latency range, and the conditions of the device.</summary>
    /// <remarks>
    /// All members are thread-safe except <see cref="Selector"/>, <see cref="RenderTimes"/> and <see cref="Started"/>, which need the session's
    /// lock.
    /// </remarks>
    sealed class SessionDisplay
    {
        readonly SessionSettings _settings;
        readonly object _gate;
        readonly ConditionCheck _conditions;
        DepthSubmission _depth;
        TimeSpan? _newestRenderTime;

        /// <param name="gate">The session's lock.</param>
        public SessionDisplay(SessionSettings settings, object gate)
        {
            _settings = settings;
            _gate = gate;
            _conditions = new ConditionCheck(settings.RewriteBeforeRender);
            Selector = new DisplayTimeSelector(settings.Visualisation, settings.Profile);
            RenderTimes = new ConstantLatencyMonitor(settings.Range);
        }

        public DisplayTimeSelector Selector { get; }

        public ConstantLatencyMonitor RenderTimes { get; }

        public VisualisationLatency Visualisation
        {
            get { lock (_gate) return Selector.Calibrated; }
            set { lock (_gate) Selector.Calibrated = value; }
        }

        public LatencyProfile Profile
        {
            get { lock (_gate) return Selector.Profile; }
        }

        public ConstantLatencyRange Range
        {
            get { lock (_gate) return RenderTimes.Range; }
        }

        public IDisplayTimeSource Source
        {
            get { lock (_gate) return Selector.Source; }
            set { lock (_gate) Selector.Source = value; }
        }

        public bool IsLightPredicted
        {
            get { lock (_gate) return Selector.IsPredicted; }
        }

        public TimeSpan? Ahead
        {
            get { lock (_gate) return Selector.Ahead; }
        }

        public ReprojectionMode Reprojection
        {
            get { lock (_gate) return _conditions.Reprojection; }
            set { lock (_gate) _conditions.Reprojection = value; }
        }

        public DisplayConditions Conditions
        {
            get { lock (_gate) return _conditions.Conditions; }
            set { lock (_gate) _conditions.Report(value); }
        }

        public IReadOnlyList<ConditionMismatch> ProfileMismatches
        {
            get { lock (_gate) return _conditions.MismatchesOf(Selector.Profile); }
        }

        public DepthSubmission DepthSubmission
        {
            get { lock (_gate) return _depth; }
            set { lock (_gate) _depth = value; }
        }

        public TimeSpan? NewestRenderTime
        {
            get { lock (_gate) return _newestRenderTime; }
        }

        public void Calibrate(LatencyProfile profile)
        {
            lock (_gate)
            {
                Selector.Calibrate(profile?.Visualisation ?? _settings.Visualisation, profile ?? _settings.Profile);
                RenderTimes.Range = profile?.WatchedRange ?? _settings.Range;
            }
        }

        /// <summary>Adds the start of a frame that is displayed. Needs the session's lock.</summary>
        public void Started(HeadsetTime start)
        {
            FollowRefreshRate();
            RenderTimes.AddStart(start);
        }

        public void Rendered(TimeSpan renderTime, RenderTimeSourceKind source)
        {
            lock (_gate)
            {
                FollowRefreshRate();
                RenderTimes.Add(renderTime, source);
                _newestRenderTime = source != RenderTimeSourceKind.None && renderTime > TimeSpan.Zero ? renderTime : (TimeSpan?)null;
            }
        }

        // The device's report takes precedence over the profile.
        void FollowRefreshRate()
        {
            var hertz = _conditions.Conditions.DisplayHz ?? Selector.Profile?.Conditions.DisplayHz;
            RenderTimes.RefreshInterval = hertz is double rate ? new TimeSpan((long)(TimeSpan.TicksPerSecond / rate)) : (TimeSpan?)null;
        }
    }
}
