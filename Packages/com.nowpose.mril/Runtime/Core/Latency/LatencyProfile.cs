using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;

namespace Nowpose.Latency
{
    /// <summary>What the calibration of one device found: L_visu, up to which render time it holds, and where that comes from.</summary>
    /// <remarks>Immutable, checked once. Schnierle &amp; Röck 2022, section 2.1.2.</remarks>
    public sealed class LatencyProfile
    {
        internal const double GreatestVisuMs = 500;
        internal const double LeastRenderMs = 0.1;
        internal const double GreatestRenderMs = 1000;
        internal const double GreatestDisplayHz = DisplayConditions.MaxDisplayHz;

        /// <param name="visuMs">As of the other constructor.</param>
        /// <param name="spreadMs">As of the other constructor.</param>
        /// <param name="device">The model, up to 128 characters; null or empty when it is not known.</param>
        /// <param name="displayHz">Refreshes per second, up to 1000 Hz; 0 or NaN when they are not known.</param>
        /// <param name="measuredUtc">As of the other constructor.</param>
        /// <param name="method">As of the other constructor.</param>
        /// <param name="measurements">As of the other constructor.</param>
        /// <param name="renderLimitMs">As of the other constructor.</param>
        /// <param name="renderTimeSource">As of the other constructor.</param>
        /// <param name="validToRenderMs">As of the other constructor.</param>
        /// <exception cref="InputException">A value is out of range; one line names it.</exception>
        internal LatencyProfile(
            double visuMs, double spreadMs, string device, double displayHz, DateTime measuredUtc, CalibrationMethod method,
            int measurements, double? renderLimitMs = null, RenderTimeSourceKind renderTimeSource = RenderTimeSourceKind.None,
            double? validToRenderMs = null)
            : this(
                visuMs, spreadMs, new DisplayConditions(device, displayHz), measuredUtc, method, measurements, renderLimitMs, renderTimeSource,
                validToRenderMs)
        {
        }

        /// <param name="visuMs">L_visu: trigger of the render job to the middle of the interval in which its frame is shown, 0 to 500 ms.</param>
        /// <param name="spreadMs">How single measurements of it scatter, one standard deviation, 0 to 500 ms.</param>
        /// <param name="conditions">Conditions of the measurement.</param>
        /// <param name="measuredUtc">When, UTC.</param>
        /// <param name="method">How.</param>
        /// <param name="measurements">Pictures, repeats or whatever the method counts, 0 or more.</param>
        /// <param name="renderLimitMs">Render time up to which L_visu is constant, 0.1 to 1000 ms; null when it was not found.</param>
        /// <param name="renderTimeSource">What the render times were measured with; needed for a limit, which holds for no other.</param>
        /// <param name="validToRenderMs">
        /// The greatest render time that was seen with this L_visu, 0.1 to 1000 ms; null for the limit, or where none was measured.
        /// </param>
        /// <param name="headMotion">Latency that remains for head motion; null when it was not measured.</param>
        /// <exception cref="InputException">A value is out of range; one line names it.</exception>
        internal LatencyProfile(
            double visuMs, double spreadMs, DisplayConditions conditions, DateTime measuredUtc, CalibrationMethod method,
            int measurements, double? renderLimitMs = null, RenderTimeSourceKind renderTimeSource = RenderTimeSourceKind.None,
            double? validToRenderMs = null, HeadMotionLatency headMotion = null)
        {
            Visualisation = VisualisationLatency.FromMilliseconds(visuMs);
            Spread = SettingRange.RequireMs(spreadMs, 0, GreatestVisuMs, "spread of the visualisation latency");
            Conditions = conditions ?? throw new ArgumentNullException(nameof(conditions));
            MeasuredUtc = measuredUtc.Kind == DateTimeKind.Local
                ? measuredUtc.ToUniversalTime() : DateTime.SpecifyKind(measuredUtc, DateTimeKind.Utc);
            Method = method;
            Measurements = SettingRange.RequireCount(measurements, 0, int.MaxValue, "measurements");
            RenderTimeSource = renderTimeSource;
            HeadMotion = headMotion;
            Range = renderLimitMs.HasValue ? new ConstantLatencyRange(renderLimitMs.Value, renderTimeSource) : null;
            ValidToRenderTime = validToRenderMs.HasValue
                ? SettingRange.RequireMs(validToRenderMs.Value, LeastRenderMs, GreatestRenderMs, "greatest render time seen") : Range?.Limit;
            WatchedRange = Range ?? (validToRenderMs.HasValue && renderTimeSource != RenderTimeSourceKind.None
                ? new ConstantLatencyRange(validToRenderMs.Value, renderTimeSource, isLimitReached: false) : null);
        }

        public VisualisationLatency Visualisation { get; }

        /// <summary>How single measurements scatter, one standard deviation.</summary>
        public TimeSpan Spread { get; }

        /// <summary>Conditions of the measurement.</summary>
        internal DisplayConditions Conditions { get; }

        /// <summary>The model; empty when it is not known.</summary>
        public string Device => Conditions.Device ?? "";

        /// <summary>Refreshes per second; 0 when they are not known.</summary>
        public double DisplayHz => Conditions.DisplayHz ?? 0;

        /// <summary>Latency that remains for head motion; null when it was not measured.</summary>
        internal HeadMotionLatency HeadMotion { get; }

        public DateTime MeasuredUtc { get; }

        internal CalibrationMethod Method { get; }

        public int Measurements { get; }

        /// <summary>What the render times were measured with; none when they were not.</summary>
        public RenderTimeSourceKind RenderTimeSource { get; }

        /// <summary>Null when no limit is known.</summary>
        public ConstantLatencyRange Range { get; }

        /// <summary>The greatest render time for which L_visu was seen to be this, or the limit; null when none was measured.</summary>
        public TimeSpan? ValidToRenderTime { get; }

        /// <summary>What a monitor judges by: the range, or how far L_visu was seen to be constant; null when neither is known.</summary>
        internal ConstantLatencyRange WatchedRange { get; }

        /// <summary>Conditions that are known on both sides and differ.</summary>
        /// <param name="actual">Conditions of the device that uses the profile.</param>
        /// <returns>Empty when nothing differs.</returns>
        internal IReadOnlyList<ConditionMismatch> MismatchesWith(DisplayConditions actual) => Conditions.MismatchesWith(actual);

        /// <summary>Why the profile must not be used on a device; null when it may. What either side does not know is not compared.</summary>
        /// <param name="device">As the device names its model; upper and lower case are the same.</param>
        /// <param name="displayHz">0 or NaN when it is not known.</param>
        /// <returns>One line that names both.</returns>
        public string RefusalFor(string device, double displayHz) => RefusalFor(new DisplayConditions(device, displayHz));

        /// <summary>Why the profile must not be used under these conditions; null when it may.</summary>
        /// <returns>The <see cref="ConditionMismatch.Words"/> of the first mismatch that is a refusal.</returns>
        internal string RefusalFor(DisplayConditions actual) => MismatchesWith(actual).FirstOrDefault(each => each.IsRefusal)?.Words;
    }
}
