namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about simulated and recorded plants.</summary>
static class PlantMessages
{
    /// <param name="file">Path of the recording.</param>
    public static string RigidBody(string file) =>
        $"{file}: is the motion of a rigid body; a recording with one column for each joint of the robot is needed";

    /// <param name="file">Path of the recording.</param>
    /// <param name="columns">Names of the columns that are not joints of the robot, although others are.</param>
    public static string UnknownColumns(string file, string columns, string robot, string joints) =>
        $"{file}: robot {robot} has no joint {columns}, although other columns have names of its joints, which are {joints}; correct the header";

    /// <param name="moves">The joint that each column moves.</param>
    public static string ColumnsInOrder(string file, string robot, string moves) =>
        $"{file}: no column has the name of a joint of robot {robot}, so the columns move the joints in their order: {moves}; "
        + "to choose other joints, use their names in the header";

    public static string ColumnCount(string file, int columns, string names, string robot, int joints) =>
        $"{file}: the recording has {columns} columns ({names}), but robot {robot} has {joints} joints that move independently; remove "
        + "columns, or choose a robot with at least one such joint for each column";

    /// <param name="bytes">Length of the message with the description.</param>
    public static string LongDescription(string file, int bytes) =>
        $"{file}: a message with this description has {bytes} bytes, and the maximum is {ProtocolLimits.DescriptionBytes} bytes; shorten it";

    public static string NoRobot(string allowed) => $"no robot is named; {allowed}";
    public static string IsAFolder(string path, string allowed) => $"{path}: is a folder; {allowed}";
    public static string Robots(string names) => $"{names} or the path of a .urdf file is needed";
}
