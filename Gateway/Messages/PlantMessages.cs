namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about simulated and recorded plants.</summary>
static class PlantMessages
{
    public const string SamplingTime = "must be at least one control cycle of 1 ms";

    public static string AcquisitionTime(TimeSpan max) =>
        FormattableString.Invariant($"must be from 0 ms to the maximum, {max.TotalMilliseconds} ms");

    public const string RigidBody = "the recording is of a rigid body; a recording with one column for each joint of the robot is needed";

    public static string ColumnCount(int columns, string names, string robot, int joints) =>
        $"the recording has {columns} columns ({names}), but robot {robot} has {joints} joints that move independently; remove "
        + "columns, or choose a robot with at least one such joint for each column";

    public static string NoRobot(string allowed) => $"no robot is named; {allowed}";
    public static string IsAFolder(string path, string allowed) => $"{path}: is a folder; {allowed}";
    public static string Robots(string names) => $"{names} or the path of a .urdf file is needed";
}
