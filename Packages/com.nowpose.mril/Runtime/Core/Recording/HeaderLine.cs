using System;
using System.Collections.Generic;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Recording
{
    /// <summary>The first line of a session file: the format, and the settings in use. Contains no token and no address.</summary>
    static class HeaderLine
    {
        static readonly EnumNames<OutsideRangeResponse> Responses = new EnumNames<OutsideRangeResponse>(response => (int)response);
        static readonly EnumNames<TransportSecurity> Securities = new EnumNames<TransportSecurity>(security => (int)security);

        /// <param name="startedUtc">Start of the recording; null if it is unknown.</param>
        public static void Write(JsonLine line, SessionSettings settings, RobotModel robot, DisplayConditions conditions, DateTime? startedUtc)
        {
            line.Begin("session").Add("format", SessionFormat.Name).Add("version", SessionFormat.Version);
            line.Add("package", SessionFormat.Package).Add("headset", settings.Connection.HeadsetName);
            if (startedUtc.HasValue)
                line.Add("started_utc", startedUtc.Value.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture));
            WriteRobot(line, robot);
            WriteSettings(line, settings);
            WriteConditions(line, conditions);
            line.End();
        }

        /// <summary>Writes the first line of a gateway's file. It contains only the settings that a prediction uses.</summary>
        /// <param name="robot">Model of the robot without a namespace; null without its description.</param>
        /// <param name="others">Namespaces and models of the other described robots.</param>
        public static void WriteOfGateway(
            JsonLine line, string cell, RobotModel robot, IEnumerable<(string Namespace, RobotModel Robot)> others, DateTime startedUtc)
        {
            line.Begin("session").Add("format", SessionFormat.Name).Add("version", SessionFormat.Version);
            line.Add("package", SessionFormat.Package).Add("recorded_by", "gateway");
            if (cell != null) line.Add("cell", cell);
            line.Add("started_utc", startedUtc.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture));
            if (robot != null) WriteRobot(line, robot);
            else line.Open("robot", '{').Add("name", "not described").Open("joints", '[').Close(']').Close('}');
            line.Open("robots", '[');
            foreach (var other in others)
            {
                WriteFields(line.OpenElement().Add("namespace", other.Namespace), other.Robot);
                line.Close('}');
            }
            line.Close(']');
            var prediction = PredictionSettings.Default;
            line.Open("settings", '{').Add("predictor", prediction.Predictor).Add("horizon_cap_ms", prediction.HorizonCap.TotalMilliseconds)
                .Add("maximum_gap_ms", prediction.MaximumGap.TotalMilliseconds).Add("blend_ms", prediction.Blend.TotalMilliseconds).Close('}');
            line.End();
        }

        /// <summary>Writes the fields of a robot: its name, the hash of its description, and its joints with their limits.</summary>
        public static void WriteFields(JsonLine line, RobotModel robot)
        {
            line.Add("name", robot.Name).Add("description_sha256", robot.SourceHash);
            line.Open("joints", '[');
            foreach (var joint in robot.MovingJoints)
            {
                line.OpenElement().Add("name", joint.Name).Add("unit", joint.Kind == JointKind.Prismatic ? "m" : "rad");
                // An unlimited joint has no limit fields, because JSON has no infinity.
                AddLimit(line, "lower", joint.Limits.Lower);
                AddLimit(line, "upper", joint.Limits.Upper);
                AddLimit(line, "velocity", joint.Limits.Velocity);
                AddLimit(line, "acceleration", joint.Limits.Acceleration);
                AddLimit(line, "jerk", joint.Limits.Jerk);
                if (joint.Mimic != null) line.Add("mimics", joint.Mimic.Master);
                line.Close('}');
            }
            line.Close(']');
        }

        static void WriteRobot(JsonLine line, RobotModel robot)
        {
            WriteFields(line.Open("robot", '{'), robot);
            line.Close('}');
        }

        static void AddLimit(JsonLine line, string name, double value)
        {
            if (!double.IsInfinity(value)) line.Add(name, value);
        }

        static void WriteConditions(JsonLine line, DisplayConditions conditions)
        {
            line.Open("conditions", '{');
            for (var condition = DisplayCondition.Device; condition <= DisplayCondition.Reprojection; condition++)
                if (condition == DisplayCondition.DisplayRate) AddRate(line, conditions.DisplayHz);
                else if (conditions[condition] != null) line.Add(DisplayConditionNames.FieldOf(condition), conditions[condition]);
            line.Close('}');
        }

        static void AddRate(JsonLine line, double? hertz)
        {
            if (hertz.HasValue) line.Add(DisplayConditionNames.FieldOf(DisplayCondition.DisplayRate), hertz.Value);
        }

        static void WriteSettings(JsonLine line, SessionSettings settings)
        {
            var prediction = settings.Prediction;
            line.Open("settings", '{').Add("predictor", prediction.Predictor);
            line.Add("horizon_cap_ms", prediction.HorizonCap.TotalMilliseconds).Add("maximum_gap_ms", prediction.MaximumGap.TotalMilliseconds)
                .Add("blend_ms", prediction.Blend.TotalMilliseconds).Add("follow_plan", prediction.FollowPlan).Add("speed_share", prediction.SpeedShare);
            AddLimit(line, "acceleration_limit", prediction.AccelerationLimit);
            AddLimit(line, "jerk_limit", prediction.JerkLimit);
            line.Add("visualisation_ms", settings.Visualisation.Length.TotalMilliseconds);
            line.Add("outside_range_response", Responses.NameOf(settings.OutsideRange)).Add("rewrite_before_render", settings.RewriteBeforeRender);
            if (settings.Range != null && settings.Range.IsLimitReached)
                line.Add("render_time_limit_ms", settings.Range.Limit.TotalMilliseconds)
                    .Add("render_time_source", LatencyNames.RenderTimeSource.NameOf(settings.Range.Source));
            line.Add("clock_estimator", settings.ClockEstimator).Add("sync_interval_ms", settings.SyncInterval.TotalMilliseconds);
            line.Add("greatest_holdover_error_ms", settings.Clock.MaxHoldoverError.TotalMilliseconds);
            line.Add("security", Securities.NameOf(settings.Connection.Security)).Close('}');
        }
    }
}
