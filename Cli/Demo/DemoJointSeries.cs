using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>Gets the true, the received and the displayed position of one joint over time, for Fig. 16.</summary>
sealed class DemoJointSeries(DemoRun run, ControlTime start)
{
    readonly int _joints = run.Settings.Robot.MovingJoints.Count;

    /// <summary>Gets the series of the joint with the longest travel; null if no frame was displayed.</summary>
    public object Busiest()
    {
        var shown = Enumerable.Range(0, run.Frames.Rows.Count).Where(i => run.Frames.Rows[i].State != PoseState.Incomplete).ToList();
        if (shown.Count == 0) return null;
        var truth = shown.Select(frame => JointsAt(run.Frames.Rows[frame].TrueLight)).ToList();
        var joint = Enumerable.Range(0, _joints).MaxBy(j => truth.Zip(truth.Skip(1), (a, b) => Math.Abs(b[j] - a[j])).Sum());
        var times = shown.Select(frame => Math.Round((run.Frames.Rows[frame].TrueLight - start).TotalSeconds, 5)).ToList();
        var model = run.Settings.Robot.MovingJoints[joint];
        return new
        {
            model.Name,
            Unit = model.Kind == JointKind.Prismatic ? "m" : "rad",
            Truth = new { T = times, V = truth.Select(joints => Round(joints[joint])) },
            Received = Received(joint, shown, times),
            Predicted = new { T = times, V = shown.Select(frame => Round(run.Frames.Displayed(frame, joint))) },
        };
    }

    // The uncompensated value changes when a sample arrives, so each change is the first frame in which a sample is visible.
    object Received(int joint, List<int> shown, List<double> times)
    {
        var held = shown.Select(frame => run.Frames.Held(frame, joint)).ToList();
        var changes = Enumerable.Range(0, times.Count).Where(i => i == 0 || i == times.Count - 1 || held[i] != held[i - 1]).ToList();
        return new { T = changes.Select(i => times[i]), V = changes.Select(i => Round(held[i])) };
    }

    double[] JointsAt(ControlTime t)
    {
        var joints = new double[_joints];
        run.Truth.JointsAt(t, joints);
        return joints;
    }

    static double Round(double value) => Math.Round(value, 6);
}
