using Nowpose.Kinematics;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>Selects the frames for the report's 3D playback. Each has the true, the displayed and the uncompensated position of all joints.</summary>
/// <remarks>
/// At most 3600 frames, two minutes at 30 per second. Users send the page by e-mail, so its size must not grow with the duration of the run.
/// </remarks>
sealed class DemoPlayback(DemoScore score, DemoRun run, ControlTime start)
{
    const int MaxInstants = 3600;

    /// <summary>Minimum step between two selected frames. Every second frame is sufficient to show the motion.</summary>
    const int MinStep = 2;

    readonly int _joints = run.Settings.Robot.MovingJoints.Count;

    /// <summary>Gets the frames with the fields of <c>Web/src/data.ts</c>; null if no frame was scored.</summary>
    public object Instants()
    {
        var rows = run.Frames.Rows;
        var step = Math.Max(MinStep, (score.Errors.Count + MaxInstants - 1) / MaxInstants);
        var frames = score.Errors.Where((_, i) => i % step == 0).Select(error => error.Frame).ToList();
        return frames.Count == 0 ? null : new
        {
            Urdf = run.Settings.RobotText,
            Names = run.Settings.Robot.MovingJoints.Select(joint => joint.Name),
            T = frames.Select(frame => Math.Round((rows[frame].TrueLight - start).TotalSeconds, 4)),
            Truth = frames.Select(TruthAt),
            Displayed = frames.Select(frame => Joints(joint => run.Frames.Displayed(frame, joint))),
            Hold = frames.Select(frame => Joints(joint => run.Frames.Held(frame, joint))),
            Objects = Objects(frames),
            Signals = Signals(frames[0], frames[^1]),
        };
    }

    // Gets the objects of the cell; null if it has none. The displayed poses of a frame are null before all objects have a sample.
    object Objects(List<int> frames) => run.Bodies is not { Work: var work } bodies ? null : new
    {
        work.Names,
        CellWork.Size,
        Belt = work.BeltBehind(0).Select(Position),
        Fixture = Position(work.Robots[0].FixturePose),
        Truth = frames.Select(frame => Poses(work, body => TrueOf(work, frame, body))),
        Displayed = frames.Select(frame => bodies.AreKnown(frame) ? Poses(work, body => bodies.At(frame, body).Displayed) : null),
        Hold = frames.Select(frame => bodies.AreKnown(frame) ? Poses(work, body => bodies.At(frame, body).Held) : null),
    };

    // Gets the signals of the cell; null if it has none. Uses every frame, so that the times of the changes are those of the display.
    object Signals(int first, int last) => run.Signals is not { Work: var work } signals ? null : work.Signals.Select((name, i) => new
    {
        Name = name,
        Truth = Changes(first, last, frame => TrueSignal(work, frame, i)),
        Displayed = Changes(first, last, frame => signals.At(frame, i)),
    });

    object Changes(int first, int last, Func<int, double?> valueOf)
    {
        var values = Enumerable.Range(first, last - first + 1).Select(valueOf).ToArray();
        var changes = Enumerable.Range(0, values.Length).Where(i => i == 0 || values[i] != values[i - 1]).ToList();
        return new { T = changes.Select(i => Math.Round((run.Frames.Rows[first + i].TrueLight - start).TotalSeconds, 4)), V = changes.Select(i => values[i]) };
    }

    double? TrueSignal(CellWork work, int frame, int signal)
    {
        Span<double> values = stackalloc double[work.Signals.Count];
        work.SignalsAt(run.Truth.MotionSecondsAt(run.Frames.Rows[frame].TrueLight), values);
        return values[signal];
    }

    RigidTransform TrueOf(CellWork work, int frame, int body) => work.WorldOf(body, run.Truth.MotionSecondsAt(run.Frames.Rows[frame].TrueLight));

    static double[] Poses(CellWork work, Func<int, RigidTransform> poseOf) => [.. Enumerable.Range(0, work.Names.Count).SelectMany(body => Numbers(poseOf(body)))];

    static double[] Numbers(RigidTransform pose)
    {
        var rotation = UnitQuaternion.Of(pose);
        return [.. Position(pose), .. new[] { rotation.X, rotation.Y, rotation.Z, rotation.W }.Select(part => Math.Round(part, 4))];
    }

    static double[] Position(RigidTransform pose) => [Math.Round(pose.X, 5), Math.Round(pose.Y, 5), Math.Round(pose.Z, 5)];

    double[] TruthAt(int frame)
    {
        var joints = new double[_joints];
        run.Truth.JointsAt(run.Frames.Rows[frame].TrueLight, joints);
        return Joints(joint => joints[joint]);
    }

    // Five decimals: 10 µrad at a distance of two metres are 0.02 mm.
    double[] Joints(Func<int, double> position) => [.. Enumerable.Range(0, _joints).Select(joint => Math.Round(position(joint), 5))];
}
