using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;

namespace Nowpose.Latency
{
    /// <summary>Calibration result of one device: L_visu, the render times for which it is valid, and how it was measured.</summary>
    /// <remarks>Immutable; validated by the constructor. Schnierle &amp; Röck 2022, section 2.1.2.</remarks>
    public sealed class LatencyProfile
    {
        internal const double MaxVisuMs = 500;
        internal const double MinRenderMs = 0.1;
        internal const double MaxRenderMs = 1000;

        /// <param name="visuMs">As in the other constructor.</param>
        /// <param name="spreadMs">As in the other constructor.</param>
        /// <param name="device">Model name, up to 128 characters; null or empty when it is not known.</param>
        /// <param name="displayHz">Refresh rate, 1 to 1000 Hz; 0 or NaN when it is not known.</param>
        /// <param name="measuredUtc">As in the other constructor.</param>
        /// <param name="method">As in the other constructor.</param>
        /// <param name="measurements">As in the other constructor.</param>
        /// <param name="renderLimitMs">As in the other constructor.</param>
        /// <param name="renderTimeSource">As in the other constructor.</param>
        /// <param name="validToRenderMs">As in the other constructor.</param>
        /// <exception cref="InputException">A value is out of range; the message names it in one line.</exception>
        internal LatencyProfile(
            double visuMs, double spreadMs, string device, double displayHz, DateTime measuredUtc, CalibrationMethod method,
            int measurements, double? renderLimitMs = null, RenderTimeSourceKind renderTimeSource = RenderTimeSourceKind.None,
            double? validToRenderMs = null)
            : this(
                visuMs, spreadMs, new DisplayConditions(device, displayHz), measuredUtc, method, measurements, renderLimitMs, renderTimeSource,
                validToRenderMs)
        {
        }

        /// <param name="visuMs">
        /// L_visu: time from the trigger of the render job to the middle of the interval in which its frame is shown, 0 to 500 ms.
        /// </param>
        /// <param name="spreadMs">Standard deviation of a single measurement of L_visu, 0 to 500 ms.</param>
        /// <param name="conditions">Conditions of the measurement.</param>
        /// <param name="measuredUtc">Date and time of the measurement, UTC.</param>
        /// <param name="method">Method of the measurement.</param>
        /// <param name="measurements">Number of measurements, 0 or more; pictures or repeats, depending on the method.</param>
        /// <param name="renderLimitMs">Maximum render time with constant L_visu, 0.1 to 1000 ms; null when it was not found.</param>
        /// <param name="renderTimeSource">Source of the render times. Required with a limit, which is valid for this source only.</param>
        /// <param name="validToRenderMs">
        /// Maximum render time at which this L_visu was observed, 0.1 to 1000 ms; null to use the limit, or if no render time was measured.
        /// </param>
        /// <param name="headMotion">Latency with which the image follows head motion; null if it was not measured.</param>
        /// <exception cref="InputException">A value is out of range; the message names it in one line.</exception>
        internal LatencyProfile(
            double visuMs, double spreadMs, DisplayConditions conditions, DateTime measuredUtc, CalibrationMethod method,
            int measurements, double? renderLimitMs = null, RenderTimeSourceKind renderTimeSource = RenderTimeSourceKind.None,
            double? validToRenderMs = null, HeadMotionLatency headMotion = null)
        {
            Visualisation = VisualisationLatency.FromMilliseconds(visuMs);
            Spread = SettingRange.RequireMs(spreadMs, 0, MaxVisuMs, SettingNames.VisualisationSpread);
            Conditions = conditions ?? throw new ArgumentNullException(nameof(conditions));
            MeasuredUtc = measuredUtc.Kind == DateTimeKind.Local
                ? measuredUtc.ToUniversalTime() : DateTime.SpecifyKind(measuredUtc, DateTimeKind.Utc);
            Method = method;
            Measurements = SettingRange.RequireCount(measurements, 0, int.MaxValue, "measurements");
            RenderTimeSource = renderTimeSource;
            HeadMotion = headMotion;
            Range = renderLimitMs.HasValue ? new ConstantLatencyRange(renderLimitMs.Value, renderTimeSource) : null;
            ValidToRenderTime = validToRenderMs.HasValue
                ? SettingRange.RequireMs(validToRenderMs.Value, MinRenderMs, MaxRenderMs, SettingNames.MaxRenderTime) : Range?.Limit;
            WatchedRange = Range ?? (validToRenderMs.HasValue && renderTimeSource != RenderTimeSourceKind.None
                ? new ConstantLatencyRange(validToRenderMs.Value, renderTimeSource, isLimitReached: false) : null);
        }

        public VisualisationLatency Visualisation { get; }

        /// <summary>Standard deviation of a single measurement.</summary>
        public TimeSpan Spread { get; }

        /// <summary>Conditions of the measurement.</summary>
        internal DisplayConditions Conditions { get; }

        /// <summary>Model name; empty when it is not known.</summary>
        public string Device => Conditions.Device ?? "";

        /// <summary>Refresh rate; 0 when it is not known.</summary>
        public double DisplayHz => Conditions.DisplayHz ?? 0;

        /// <summary>Latency with which the image follows head motion; null if it was not measured.</summary>
        internal HeadMotionLatency HeadMotion { get; }

        public DateTime MeasuredUtc { get; }

        internal CalibrationMethod Method { get; }

        public int Measurements { get; }

        /// <summary>Source of the render times; <see cref="RenderTimeSourceKind.None"/> when they were not measured.</summary>
        public RenderTimeSourceKind RenderTimeSource { get; }

        /// <summary>The constant-latency range; null when no limit is known.</summary>
        public ConstantLatencyRange Range { get; }

        /// <summary>Maximum render time at which this L_visu was observed, or else the limit; null if neither is known.</summary>
        public TimeSpan? ValidToRenderTime { get; }

        /// <summary>
        /// Range for <see cref="ConstantLatencyMonitor"/>: the constant-latency range, or else the range in which L_visu was observed; null if
        /// neither is known.
        /// </summary>
        internal ConstantLatencyRange WatchedRange { get; }

        /// <summary>
        /// Returns the profile for a headset without a display, which renders nothing: without the range, the refresh rate, and the other
        /// conditions of rendering.
        /// </summary>
        internal LatencyProfile WithoutDisplay() => new LatencyProfile(
            Visualisation.Length.TotalMilliseconds, Spread.TotalMilliseconds, new DisplayConditions(Device), MeasuredUtc, Method, Measurements,
            headMotion: HeadMotion);

        /// <summary>Returns the conditions that are known for both the profile and the device, and that differ.</summary>
        /// <param name="actual">Conditions of the device that uses the profile.</param>
        /// <returns>Empty when nothing differs.</returns>
        internal IReadOnlyList<ConditionMismatch> MismatchesWith(DisplayConditions actual) => Conditions.MismatchesWith(actual);

        /// <summary>
        /// Returns the reason why the profile must not be used on a device; null if it may be used. Unknown values are not compared.
        /// </summary>
        /// <param name="device">Model name that the device reports; the comparison ignores case.</param>
        /// <param name="displayHz">0 or NaN when it is not known.</param>
        /// <returns>One line with the calibrated and the actual value.</returns>
        public string RefusalFor(string device, double displayHz) => RefusalFor(new DisplayConditions(device, displayHz));

        /// <summary>Returns the reason why the profile must not be used under these conditions; null if it may be used.</summary>
        /// <returns>The <see cref="ConditionMismatch.Words"/> of the first mismatch that is a refusal.</returns>
        internal string RefusalFor(DisplayConditions actual) => MismatchesWith(actual).FirstOrDefault(each => each.IsRefusal)?.Words;
    }
}
