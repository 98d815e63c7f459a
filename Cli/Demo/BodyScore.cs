using Nowpose.Anchoring;
using Nowpose.Cli.Replay;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>Compares the displayed objects with their true poses in all frames in which the objects move.</summary>
/// <param name="frames">The scored frames.</param>
sealed class BodyScore(DemoRun run, IEnumerable<int> frames)
{
    const double MillimetresPerMetre = 1000, DegreesPerRadian = 180 / Math.PI;

    /// <summary>Gets the results; null if the cell has no objects or no object has moved.</summary>
    public DemoResult.BodyErrors Result()
    {
        if (run.Bodies is not { Work: var work }) return null;
        var errors = frames.SelectMany(frame => ErrorsIn(frame, work)).ToList();
        return errors.Count == 0 ? null : new DemoResult.BodyErrors(
            Of(errors.Select(e => (e.HoldMm, e.Mm))), Of(errors.Select(e => (e.HoldDeg, e.Deg))), LargestSlipMm(work));
    }

    double? LargestSlipMm(CellWork work)
    {
        var tool = new ToolKinematics(run.Settings.Robot);
        var joints = new double[run.Settings.Robot.MovingJoints.Count];
        double? largest = null;
        foreach (var frame in frames)
            for (var body = 0; body < work.Names.Count; body++)
            {
                var shown = run.Bodies.At(frame, body);
                if (!shown.IsKnown || !(shown.Parent == work.Robots[0].Tool || IsCarried(body, frame, work))) continue;
                for (var joint = 0; joint < joints.Length; joint++) joints[joint] = run.Frames.Displayed(frame, joint);
                largest = Math.Max(largest ?? 0, MillimetresPerMetre * shown.Displayed.DistanceTo(tool.PoseAt(joints) * work.Robots[0].InTool));
            }
        return largest;
    }

    // While the arm rests after the grip, the display has no message about the grip yet, and the workpiece is at the same place on the conveyor.
    bool IsCarried(int body, int frame, CellWork work)
    {
        var light = run.Truth.MotionSecondsAt(run.Frames.Rows[frame].TrueLight);
        work.PoseOf(body, light, out var parent);
        return parent == work.Robots[0].Tool && BodyMotion.IsMoving(time => work.WorldOf(body, time), light);
    }

    IEnumerable<(double HoldMm, double Mm, double HoldDeg, double Deg)> ErrorsIn(int frame, CellWork work)
    {
        var light = run.Truth.MotionSecondsAt(run.Frames.Rows[frame].TrueLight);
        for (var body = 0; body < work.Names.Count; body++)
        {
            var shown = run.Bodies.At(frame, body);
            if (!shown.IsKnown || !BodyMotion.IsMoving(time => work.WorldOf(body, time), light)) continue;
            var truth = work.WorldOf(body, light);
            yield return (
                MillimetresPerMetre * shown.Held.DistanceTo(truth), MillimetresPerMetre * shown.Displayed.DistanceTo(truth),
                DegreesPerRadian * shown.Held.AngleTo(truth), DegreesPerRadian * shown.Displayed.AngleTo(truth));
        }
    }

    static DemoResult.PoseErrors Of(IEnumerable<(double Hold, double Displayed)> errors) =>
        ErrorComparison.Of(errors) is { } all ? new DemoResult.PoseErrors(all.RmsHold, all.Rms, all.P95, all.Reduction) : null;
}
