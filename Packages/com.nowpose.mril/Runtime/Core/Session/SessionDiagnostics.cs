using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session.Cell;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>Converts statistics to a message of the diagnostics topic; omits unknown values.</summary>
    static class SessionDiagnostics
    {
        /// <summary>Maximum number of objects, and of signals, that are listed.</summary>
        public const int MaxParts = 32;

        const int MaxMessageLength = 1000;

        /// <param name="cell">Objects and signals that are not current.</param>
        public static DiagnosticsMessage Of(SessionStatistics statistics, CellFaults cell, string headsetName, ControlTime now)
        {
            var values = new DiagnosticValues();
            void Add(string key, string value) => values.Add(key, value);
            void AddNumber(string key, double? value)
            {
                if (value.HasValue) Add(key, Number(value.Value));
            }
            void AddMs(string key, TimeSpan? length) => AddNumber(key, length?.TotalMilliseconds);

            Add(HeadsetKeys.Version, NowposeVersion.Text);
            Add(HeadsetKeys.State, statistics.Clock.State.Word());
            AddPose(statistics, values);
            Add(HeadsetKeys.ObjectsNotCurrent, Count(cell.Objects.Count));
            Add(HeadsetKeys.SignalsNotCurrent, Count(cell.Signals.Count));
            if (statistics.Offset.HasValue)
            {
                var nanoseconds = statistics.Offset.Value.HeadsetMinusControl.Ticks * (decimal)ClockTicks.NanosecondsPerTick;
                Add(HeadsetKeys.OffsetNs, nanoseconds.ToString(CultureInfo.InvariantCulture));
                Add(HeadsetKeys.SkewPpm, Number(statistics.Clock.Skew * 1e6));
                Add(HeadsetKeys.ErrorBoundUs, Number(statistics.Clock.ErrorBound.TotalMilliseconds * 1000));
                Add(HeadsetKeys.EstimatedErrorUs, Number(statistics.Clock.EstimatedError.TotalMilliseconds * 1000));
            }
            AddMs(HeadsetKeys.RoundTripMs, statistics.RoundTripTime);
            AddMs(HeadsetKeys.ApplicationLatencyMs, statistics.ApplicationLatency);
            AddMs(HeadsetKeys.VisualisationLatencyMs, statistics.VisualisationLatency);
            if (statistics.IsDisplayTimeImplausible)
            {
                Add(HeadsetKeys.DisplayTime, "implausible");
                AddMs(HeadsetKeys.DisplayTimeAheadMs, statistics.DisplayTimeAhead);
            }
            else if (statistics.IsLightPredicted) Add(HeadsetKeys.DisplayTime, "predicted");
            AddMs(HeadsetKeys.DisplayTimeDifferenceMs, statistics.DisplayTimeDifference);
            if (statistics.Reprojection != ReprojectionMode.Unknown)
                Add(HeadsetKeys.Reprojection, LatencyNames.Reprojection.NameOf(statistics.Reprojection));
            if (statistics.DepthSubmission != DepthSubmission.Unknown)
                Add(HeadsetKeys.DepthSubmission, LatencyNames.DepthSubmission.NameOf(statistics.DepthSubmission));
            if (statistics.ProfileMismatches.Count > 0)
                Add(HeadsetKeys.ProfileMismatch, string.Join(",", statistics.ProfileMismatches.Select(each => each.Field)));
            AddMs(HeadsetKeys.HorizonMs, statistics.FramesMissingFor == null ? statistics.Horizon : null);
            AddMs(HeadsetKeys.RenderMs, statistics.RenderTime);
            if (statistics.Range != RangeState.Unknown) Add(HeadsetKeys.Range, LatencyNames.Range.NameOf(statistics.Range));
            if (BeyondLimits(statistics) is { Length: > 0 } beyond) Add(HeadsetKeys.BeyondLimits, beyond);
            if (OtherDescriptions(statistics) is { Length: > 0 } described) Add(HeadsetKeys.DescriptionDiffers, described);
            if (WithheldErrors.WordsOf(statistics.ErrorWithheld) is { } withheld) Add(HeadsetKeys.ErrorWithheld, withheld);
            AddNumber(HeadsetKeys.ErrorMmHold, statistics.HoldErrorMm);
            AddNumber(HeadsetKeys.ErrorMm, statistics.ErrorMm);
            AddNumber(HeadsetKeys.Reduction, statistics.ErrorReduction);
            Add(HeadsetKeys.Samples, Count(statistics.Samples));
            Add(HeadsetKeys.Dropped, Count(statistics.Dropped));
            foreach (var part in cell.Objects.Take(MaxParts)) values.AddDetail(HeadsetKeys.ObjectStatus + part.Name, part.Description);
            foreach (var part in cell.Signals.Take(MaxParts)) values.AddDetail(HeadsetKeys.SignalStatus + part.Name, part.Description);
            // The errors of many joints come last, because the gateway drops values above its limit.
            AddErrors(statistics, (key, value) => { if (value.HasValue) values.AddDetail(key, Fine(value.Value)); });
            var (level, message) = Status(statistics, cell);
            return new DiagnosticsMessage(now, headsetName, values.Pairs, level, message: InputException.OneLine(message, MaxMessageLength));
        }

        static (int Level, string Message) Status(SessionStatistics statistics, CellFaults cell)
        {
            var isCurrent = statistics.WorstPose == PoseState.Current;
            var missing = isCurrent ? "" : MissingJoints(statistics);
            var warnings = (isCurrent ? Warnings(statistics) : Pose(statistics, missing)).Concat(NotCurrent(cell)).Where(text => !string.IsNullOrEmpty(text));
            var message = string.Join("; ", warnings);
            return (message.Length == 0 ? 0 : missing.Length == 0 ? 1 : 2, message);
        }

        static IEnumerable<string> Pose(SessionStatistics statistics, string missing)
        {
            yield return "the pose is " + PoseOf(statistics);
            if (statistics.FramesMissingFor is TimeSpan length) yield return DisplayMessages.NoFrames(length);
            if (missing.Length > 0) yield return "missing joints: " + missing;
            foreach (var robot in statistics.Robots) yield return robot.OtherNamespaces ?? Named(robot, robot.StampProblem);
        }

        static IEnumerable<string> NotCurrent(CellFaults cell)
        {
            if (cell.Objects.Count > 0) yield return FrameMessages.NotCurrent(cell.Objects[0].Name, cell.Objects.Count);
            if (cell.Signals.Count > 0) yield return SignalMessages.NotCurrent(cell.Signals[0].Name, cell.Signals.Count);
        }

        static IEnumerable<string> Warnings(SessionStatistics statistics)
        {
            yield return UncertainJoints(statistics);
            yield return DisplayMessages.ProblemOf(statistics);
            foreach (var robot in statistics.OtherRobots) yield return Named(robot, robot.SampleProblem);
            if (statistics.RobotDescriptionMatch == RobotDescriptionMatch.Different) yield return RobotMessages.DescriptionDiffers;
            foreach (var robot in statistics.OtherRobots)
                if (robot.DescriptionMatch == RobotDescriptionMatch.Different)
                    yield return RobotMessages.OfRobot(robot.Namespace, RobotMessages.DescriptionDiffers);
        }

        static string Named(RobotStatistics robot, string problem) =>
            problem == null || robot.Namespace.Length == 0 ? problem : RobotMessages.OfRobot(robot.Namespace, problem);

        static string PoseOf(SessionStatistics statistics) => PoseStateName.Of(statistics.WorstPose, statistics.IsClockCoarse);

        // Returns for example "joint a1: may not be at rest: the stop itself was not observed"; empty if the rest of all joints is certain.
        static string UncertainJoints(SessionStatistics statistics) =>
            JointStatusText.Of(Joints(statistics).Where(joint => joint.IsRestUncertain), joint => joint.Reason);

        static string MissingJoints(SessionStatistics statistics) =>
            string.Join(",", Joints(statistics).Where(each => each.IsMissing).Select(each => each.Joint));

        // The joints of all robots. Those of a robot in a namespace have cell-wide names, such as arm2/elbow.
        static IEnumerable<JointStatus> Joints(SessionStatistics statistics) =>
            from robot in statistics.Robots
            from joint in robot.JointStatuses
            select robot.Namespace.Length == 0 ? joint : new JointStatus(robot.NameOf(joint.Joint), joint.State, joint.Since, joint.Age, joint.Reason);

        static string BeyondLimits(SessionStatistics statistics) => string.Join(",",
            statistics.Robots.Where(robot => robot.BeyondLimits != null).Select(robot => robot.NameOf(robot.BeyondLimits.Joint.Name)));

        // The robots whose description differs from that of the gateway; "main" for the robot without a namespace.
        static string OtherDescriptions(SessionStatistics statistics) => string.Join(",",
            statistics.Robots.Where(robot => robot.DescriptionMatch == RobotDescriptionMatch.Different)
                .Select(robot => robot.Namespace.Length == 0 ? "main" : robot.Namespace));

        static void AddPose(SessionStatistics statistics, DiagnosticValues values)
        {
            values.Add(HeadsetKeys.Pose, PoseOf(statistics));
            if (statistics.CurrentShare.HasValue && statistics.FramesMissingFor == null)
                values.Add(HeadsetKeys.CurrentShare, Number(statistics.CurrentShare.Value));
            values.Add(HeadsetKeys.MissingJoints, MissingJoints(statistics));
            foreach (var joint in Joints(statistics)) values.AddDetail(HeadsetKeys.JointStatus + joint.Joint, joint.Description);
        }

        static void AddErrors(SessionStatistics statistics, Action<string, double?> add)
        {
            var tool = statistics.ToolError;
            add(HeadsetKeys.ErrorMmP95, tool?.P95);
            add(HeadsetKeys.ErrorMmHoldP95, tool?.HoldP95);
            add(HeadsetKeys.ErrorMmTruth, tool?.TruthUncertainty);
            add(HeadsetKeys.ErrorMmClock, tool?.ClockUncertainty);
            add(HeadsetKeys.ReductionUncertainty, tool?.ReductionUncertainty);
            foreach (var joint in statistics.JointErrors)
            {
                var name = statistics.OwnRobot.NameOf(joint.Joint);
                add(HeadsetKeys.JointError + name, joint.Error?.Rms);
                add(HeadsetKeys.JointErrorP95 + name, joint.Error?.P95);
                add(HeadsetKeys.JointErrorHold + name, joint.Error?.HoldRms);
                add(HeadsetKeys.JointErrorHoldP95 + name, joint.Error?.HoldP95);
                add(HeadsetKeys.JointReduction + name, joint.Error?.Reduction);
                add(HeadsetKeys.JointReductionUncertainty + name, joint.Error?.ReductionUncertainty);
            }
        }

        static string Count(long number) => number.ToString(CultureInfo.InvariantCulture);

        // Format for radians, metres and ratios.
        static string Fine(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);

        static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);
    }
}
