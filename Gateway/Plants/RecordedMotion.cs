using Nowpose.Gateway.MotionRecordings;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Gateway.Plants;

/// <summary>The motion of a robot from a recording. One cycle plays the recording forward and then backward.</summary>
public sealed class RecordedMotion : IMotion
{
    readonly MotionRecording _recording;
    readonly RobotModel _robot;
    readonly int[] _joints;
    readonly bool[] _given;
    readonly double[] _rest;

    /// <summary>
    /// Assigns the columns to joints by name. If no column has the name of a joint of the robot, assigns all columns in the order of the robot's
    /// joints, without mimic joints.
    /// </summary>
    /// <remarks>
    /// A joint without a column stays at 0 or, if its limits exclude 0, at the limit nearest to 0. A mimic joint without a column follows the joint
    /// that it mimics.
    /// </remarks>
    /// <exception cref="InputException">
    /// The recording is of a rigid body, has more columns than the robot has joints, or has names of joints in only some of its columns; or the
    /// robot has too many joints.
    /// </exception>
    public RecordedMotion(MotionRecording recording, RobotModel robot)
    {
        if (recording.IsBody) throw new InputException(PlantMessages.RigidBody(recording.Source));
        _recording = recording;
        _robot = robot;
        JointNames = PlantJoints.NamesOf(robot);
        _joints = ByName(recording, robot);
        if (_joints == null)
        {
            _joints = InOrder(recording, robot);
            var moves = recording.Names.Zip(_joints, (column, joint) => $"{column} moves {JointNames[joint]}");
            Warning = PlantMessages.ColumnsInOrder(recording.Source, robot.Name, string.Join(", ", moves));
        }

        _rest = [.. robot.MovingJoints.Select(joint => joint.Limits.Clamp(0))];
        _given = [.. robot.MovingJoints.Select(joint => joint.Mimic == null || _joints.Contains(joint.MovingIndex))];
    }

    public IReadOnlyList<string> JointNames { get; }

    /// <summary>Lists the joints that the columns move, if they were assigned in order; null if they were assigned by name.</summary>
    public string Warning { get; }

    public double CycleSeconds => 2 * _recording.Duration;

    public void At(double seconds, Span<double> positions)
    {
        var inCycle = Math.Max(seconds, 0) % CycleSeconds;
        Span<double> columns = stackalloc double[_joints.Length];
        _recording.At(Math.Min(inCycle, CycleSeconds - inCycle), columns);
        _rest.CopyTo(positions);
        for (var i = 0; i < _joints.Length; i++)
            positions[_joints[i]] = columns[i];
        _robot.CompleteMimics(positions, _given);
    }

    static int[] ByName(MotionRecording recording, RobotModel robot)
    {
        var joints = recording.Names.Select(robot.IndexOfMovingJoint).ToArray();
        if (!joints.Contains(-1)) return joints;
        // A misspelt name among names of joints must not move another joint.
        var unknown = recording.Names.Where((_, column) => joints[column] < 0).ToArray();
        if (unknown.Length == joints.Length) return null;
        throw new InputException(PlantMessages.UnknownColumns(
            recording.Source, string.Join(", ", unknown), robot.Name, string.Join(", ", robot.MovingJoints.Select(joint => joint.Name))));
    }

    static int[] InOrder(MotionRecording recording, RobotModel robot)
    {
        var joints = robot.MovingJoints.Where(joint => joint.Mimic == null).Select(joint => joint.MovingIndex).ToArray();
        if (recording.Names.Count > joints.Length)
            throw new InputException(
                PlantMessages.ColumnCount(recording.Source, recording.Names.Count, string.Join(", ", recording.Names), robot.Name, joints.Length));
        return joints[..recording.Names.Count];
    }
}
