using System;
using System.Globalization;
using System.IO;
using Newtonsoft.Json;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;

namespace Nowpose.Latency.Profile
{
    /// <summary>Reads and writes latency profiles as JSON, version 1: durations in ms, null for unknown values.</summary>
    static class LatencyProfileJson
    {
        const string Format = "nowpose-latency-profile";
        const int Version = 1;

        public static string Write(LatencyProfile profile)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
            using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented };
            json.WriteStartObject();
            void Add(string name, object value)
            {
                json.WritePropertyName(name);
                json.WriteValue(value);
            }
            Add("format", Format);
            Add("version", Version);
            Add("visu_ms", profile.Visualisation.Length.TotalMilliseconds);
            Add("visu_spread_ms", profile.Spread.TotalMilliseconds);
            Add("limit_render_ms", profile.Range?.Limit.TotalMilliseconds);
            Add("valid_to_render_ms", profile.ValidToRenderTime?.TotalMilliseconds);
            var source = profile.RenderTimeSource;
            Add("render_source", source == RenderTimeSourceKind.None ? null : LatencyNames.RenderTimeSource.NameOf(source));
            Add("device", profile.Device);
            Add("display_hz", profile.DisplayHz);
            for (var condition = DisplayCondition.GraphicsApi; condition <= DisplayCondition.Reprojection; condition++)
                Add(DisplayConditionNames.FieldOf(condition), profile.Conditions[condition]);
            Add("head_latency_ms", profile.HeadMotion?.Latency.TotalMilliseconds);
            Add("head_latency_uncertainty_ms", profile.HeadMotion?.Uncertainty.TotalMilliseconds);
            Add("measured", profile.MeasuredUtc.ToString("yyyy-MM-dd'T'HH:mm:ss.FFFFFFF'Z'", CultureInfo.InvariantCulture));
            Add("method", LatencyNames.CalibrationMethod.NameOf(profile.Method));
            Add("measurements", profile.Measurements);
            json.WriteEndObject();
            json.Flush();
            return text + "\n";
        }

        /// <param name="name">Name of the input in messages, such as a file name.</param>
        /// <exception cref="InputException">
        /// The text is not a profile, has a newer version, or has an invalid value, which the message names.
        /// </exception>
        public static LatencyProfile Read(string text, string name)
        {
            var fields = new ProfileFields(text, name);
            CheckFormat(fields);
            try
            {
                return new LatencyProfile(
                    fields.Number("visu_ms", 0, LatencyProfile.MaxVisuMs, "ms"),
                    fields.Number("visu_spread_ms", 0, LatencyProfile.MaxVisuMs, "ms"),
                    ConditionsOf(fields),
                    fields.Utc("measured"),
                    MethodOf(fields),
                    fields.Count("measurements"),
                    RenderMs(fields, "limit_render_ms"),
                    SourceOf(fields),
                    RenderMs(fields, "valid_to_render_ms"),
                    HeadMotionOf(fields));
            }
            catch (InputException fault) when (!fault.Message.StartsWith(name + ": ", StringComparison.Ordinal))
            {
                throw fields.Fault(fault.Message);
            }
        }

        // The version is checked first, because fields of a newer version may have another meaning.
        static void CheckFormat(ProfileFields fields)
        {
            var format = fields.OptionalText("format");
            if (format != Format) throw fields.Fault(ProfileMessages.OtherFormat(format, Format));
            var version = fields.Count("version");
            if (version > Version)
                throw fields.Fault(ProfileMessages.NewerVersion(version, Version));
            if (version < 1) throw fields.Fault(ProfileMessages.Version(version, Version));
        }

        // Profiles of older versions contain only the device and the display rate.
        static DisplayConditions ConditionsOf(ProfileFields fields)
        {
            var device = fields.Text("device");
            var displayHz = fields.Number("display_hz", 0, DisplayConditions.MaxDisplayHz, "Hz");
            var others = DisplayConditions.Parse(
                condition => condition > DisplayCondition.DisplayRate ? fields.OptionalText(DisplayConditionNames.FieldOf(condition)) : null);
            return new DisplayConditions(device, displayHz).Or(others);
        }

        static HeadMotionLatency HeadMotionOf(ProfileFields fields)
        {
            var latencyMs = fields.OptionalNumber("head_latency_ms", HeadMotionLatency.MinMs, HeadMotionLatency.MaxMs, "ms");
            if (!latencyMs.HasValue) return null;
            return new HeadMotionLatency(latencyMs.Value, fields.Number("head_latency_uncertainty_ms", 0, HeadMotionLatency.MaxMs, "ms"));
        }

        static double? RenderMs(ProfileFields fields, string field) =>
            fields.OptionalNumber(field, LatencyProfile.MinRenderMs, LatencyProfile.MaxRenderMs, "ms");

        static CalibrationMethod MethodOf(ProfileFields fields)
        {
            var name = fields.Text("method");
            return LatencyNames.CalibrationMethod.TryParse(name, out var method)
                ? method : throw fields.Fault(ProfileMessages.UnknownMethod(name, LatencyNames.CalibrationMethod.All));
        }

        static RenderTimeSourceKind SourceOf(ProfileFields fields)
        {
            var name = fields.OptionalText("render_source") ?? "";
            return LatencyNames.RenderTimeSource.TryParse(name, out var source)
                ? source : throw fields.Fault(ProfileMessages.UnknownSource(name, LatencyNames.RenderTimeSource.All));
        }
    }
}
