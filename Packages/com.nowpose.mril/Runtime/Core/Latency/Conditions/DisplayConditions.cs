using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Latency.Conditions
{
    /// <summary>Conditions under which L_visu was measured, or under which a device runs. Null means that a condition is not known.</summary>
    /// <remarks>Immutable.</remarks>
    sealed class DisplayConditions : IEquatable<DisplayConditions>
    {
        /// <summary>Maximum length of a string, in characters.</summary>
        public const int MaxTextLength = 128;

        internal const double MinDisplayHz = 1, MaxDisplayHz = 1000;
        internal const string On = "on", Off = "off";

        /// <summary>Maximum difference between two reports of the same rate: 60 Hz may also be reported as 59.94 Hz.</summary>
        const double RateToleranceHz = 1;

        static readonly CultureInfo Culture = CultureInfo.InvariantCulture;

        readonly string[] _values = new string[DisplayConditionNames.Count];

        /// <param name="device">
        /// Model of the headset. It and the other strings are one line of up to 128 characters; null or empty if unknown.
        /// </param>
        /// <param name="displayHz">Refresh rate, 1 to 1000 Hz; null, 0 or NaN when not known.</param>
        /// <param name="graphicsApi">Value of <c>SystemInfo.graphicsDeviceType</c>, such as Direct3D11.</param>
        /// <param name="graphicsJobs">Value of <c>SystemInfo.renderingThreadingMode</c>: MultiThreaded without Graphics Jobs.</param>
        /// <param name="renderPipeline">Type name of the render pipeline's asset, or "built-in".</param>
        /// <param name="rewritesBeforeRender">Whether the pose is computed a second time right before rendering.</param>
        /// <param name="latencyOptimization">OpenXR's Latency Optimization setting: PrioritizeRendering or PrioritizeInputPolling.</param>
        /// <param name="reprojection">Correction for head motion; <see cref="ReprojectionMode.Unknown"/> when not known.</param>
        /// <exception cref="InputException">A string is too long or has several lines, or the rate is out of range.</exception>
        public DisplayConditions(
            string device = null, double? displayHz = null, string graphicsApi = null, string graphicsJobs = null, string renderPipeline = null,
            bool? rewritesBeforeRender = null, string latencyOptimization = null, ReprojectionMode reprojection = ReprojectionMode.Unknown)
        {
            if (displayHz.HasValue && displayHz != 0 && !double.IsNaN(displayHz.Value))
                DisplayHz = SettingRange.Require(displayHz.Value, MinDisplayHz, MaxDisplayHz, "display rate", "Hz");
            RewritesBeforeRender = rewritesBeforeRender;
            Reprojection = reprojection;
            Set(DisplayCondition.Device, device, SettingNames.DeviceModel);
            Set(DisplayCondition.DisplayRate, DisplayHz?.ToString("0.##", Culture));
            Set(DisplayCondition.GraphicsApi, graphicsApi);
            Set(DisplayCondition.GraphicsJobs, graphicsJobs);
            Set(DisplayCondition.RenderPipeline, renderPipeline);
            Set(DisplayCondition.RewriteBeforeRender, rewritesBeforeRender.HasValue ? (rewritesBeforeRender.Value ? On : Off) : null);
            Set(DisplayCondition.LatencyOptimization, latencyOptimization);
            Set(DisplayCondition.Reprojection, reprojection == ReprojectionMode.Unknown ? null : LatencyNames.Reprojection.NameOf(reprojection));
        }

        /// <summary>An instance in which all conditions are unknown.</summary>
        public static DisplayConditions Unknown { get; } = new DisplayConditions();

        /// <summary>Model of the headset.</summary>
        public string Device => this[DisplayCondition.Device];

        /// <summary>Refresh rate, Hz.</summary>
        public double? DisplayHz { get; }

        public string GraphicsApi => this[DisplayCondition.GraphicsApi];

        /// <summary>Rendering threading mode: MultiThreaded without Graphics Jobs.</summary>
        public string GraphicsJobs => this[DisplayCondition.GraphicsJobs];

        public string RenderPipeline => this[DisplayCondition.RenderPipeline];

        /// <summary>Whether the pose is computed a second time right before rendering.</summary>
        public bool? RewritesBeforeRender { get; }

        /// <summary>OpenXR's Latency Optimization setting.</summary>
        public string LatencyOptimization => this[DisplayCondition.LatencyOptimization];

        /// <summary>Correction for head motion; <see cref="ReprojectionMode.Unknown"/> when not known.</summary>
        public ReprojectionMode Reprojection { get; }

        /// <summary>Value of a condition as a string, without a unit; null when it is not known.</summary>
        public string this[DisplayCondition condition] => _values[(int)condition];

        /// <summary>
        /// Returns the conditions that are known in both instances and differ. This instance holds the conditions of a calibration.
        /// </summary>
        /// <param name="actual">Conditions of the device that uses the calibration.</param>
        /// <returns>The mismatches in the order of <see cref="DisplayCondition"/>; empty when nothing differs.</returns>
        public IReadOnlyList<ConditionMismatch> MismatchesWith(DisplayConditions actual)
        {
            var found = new List<ConditionMismatch>();
            for (var condition = DisplayCondition.Device; (int)condition < _values.Length; condition++)
                if (Differs(condition, actual)) found.Add(new ConditionMismatch(condition, this[condition], actual[condition]));
            return found;
        }

        /// <summary>Returns these conditions, in which unknown values are replaced with those of <paramref name="other"/>.</summary>
        public DisplayConditions Or(DisplayConditions other) => new DisplayConditions(
            Device ?? other.Device, DisplayHz ?? other.DisplayHz, GraphicsApi ?? other.GraphicsApi, GraphicsJobs ?? other.GraphicsJobs,
            RenderPipeline ?? other.RenderPipeline, RewritesBeforeRender ?? other.RewritesBeforeRender,
            LatencyOptimization ?? other.LatencyOptimization, Reprojection != ReprojectionMode.Unknown ? Reprojection : other.Reprojection);

        public bool Equals(DisplayConditions other) => other != null && _values.SequenceEqual(other._values) && DisplayHz == other.DisplayHz;

        public override bool Equals(object obj) => Equals(obj as DisplayConditions);

        public override int GetHashCode() => (Device, GraphicsApi, RenderPipeline, Reprojection).GetHashCode();

        /// <summary>Parses the value of each condition.</summary>
        /// <param name="valueOf">Returns the value of a condition as a string in the format of the indexer; null or empty if unknown.</param>
        /// <exception cref="InputException">A string is invalid; the message begins with the name of its field.</exception>
        internal static DisplayConditions Parse(Func<DisplayCondition, string> valueOf) => new DisplayConditions(
            valueOf(DisplayCondition.Device), RateOf(valueOf(DisplayCondition.DisplayRate)), valueOf(DisplayCondition.GraphicsApi),
            valueOf(DisplayCondition.GraphicsJobs), valueOf(DisplayCondition.RenderPipeline), SwitchOf(valueOf(DisplayCondition.RewriteBeforeRender)),
            valueOf(DisplayCondition.LatencyOptimization), ReprojectionOf(valueOf(DisplayCondition.Reprojection)));

        bool Differs(DisplayCondition condition, DisplayConditions actual)
        {
            string calibrated = this[condition], other = actual[condition];
            if (calibrated == null || other == null) return false;
            return condition == DisplayCondition.DisplayRate
                ? Math.Abs(DisplayHz.Value - actual.DisplayHz.Value) > RateToleranceHz
                : !string.Equals(calibrated, other, StringComparison.OrdinalIgnoreCase);
        }

        void Set(DisplayCondition condition, string value, string what = "the value")
        {
            if (string.IsNullOrEmpty(value)) return;
            if (value.Length > MaxTextLength || value.Any(char.IsControl))
                throw new InputException(ConditionMessages.NotOneLine(DisplayConditionNames.FieldOf(condition), what, MaxTextLength));
            _values[(int)condition] = value;
        }

        static double? RateOf(string text)
        {
            if (string.IsNullOrEmpty(text)) return null;
            if (double.TryParse(text, NumberStyles.Float, Culture, out var hertz)) return hertz;
            throw new InputException(ConditionMessages.NotARate(DisplayConditionNames.FieldOf(DisplayCondition.DisplayRate), text));
        }

        static bool? SwitchOf(string text)
        {
            if (string.IsNullOrEmpty(text)) return null;
            return text == On || (text == Off ? false : throw new InputException(
                ConditionMessages.NotASwitch(DisplayConditionNames.FieldOf(DisplayCondition.RewriteBeforeRender), text, On, Off)));
        }

        static ReprojectionMode ReprojectionOf(string text)
        {
            if (string.IsNullOrEmpty(text)) return ReprojectionMode.Unknown;
            return LatencyNames.Reprojection.TryParse(text, out var mode) ? mode : throw new InputException(
                ConditionMessages.NotAMode(DisplayConditionNames.FieldOf(DisplayCondition.Reprojection), text, LatencyNames.Reprojection.All));
        }
    }
}
