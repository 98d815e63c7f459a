namespace Nowpose.Gateway.Rosbridge;

/// <summary>Returns the definitions of the message types on the gateway's topics, in the format of ROS 1 or ROS 2.</summary>
/// <param name="isRos2">Whether to use ROS 2: type names have the form package/msg/Name, and times have the types of ROS 2.</param>
sealed class MessageDefinitions(bool isRos2)
{
    const string Separator = "================================================================================";
    const string HeaderType = "std_msgs/Header";

    // The fields of each type, with ROS 1 names. In ROS 1, "time" and "duration" are built-in types.
    static readonly Dictionary<string, string[]> Fields = new()
    {
        [HeaderType] = ["time stamp", "string frame_id"],
        ["std_msgs/String"] = ["string data"],
        ["sensor_msgs/JointState"] = ["std_msgs/Header header", "string[] name", "float64[] position", "float64[] velocity", "float64[] effort"],
        ["trajectory_msgs/JointTrajectory"] = ["std_msgs/Header header", "string[] joint_names", "trajectory_msgs/JointTrajectoryPoint[] points"],
        ["trajectory_msgs/JointTrajectoryPoint"] =
            ["float64[] positions", "float64[] velocities", "float64[] accelerations", "float64[] effort", "duration time_from_start"],
        ["diagnostic_msgs/DiagnosticArray"] = ["std_msgs/Header header", "diagnostic_msgs/DiagnosticStatus[] status"],
        ["diagnostic_msgs/DiagnosticStatus"] =
            ["byte level", "string name", "string message", "string hardware_id", "diagnostic_msgs/KeyValue[] values"],
        ["diagnostic_msgs/KeyValue"] = ["string key", "string value"],
        ["tf2_msgs/TFMessage"] = ["geometry_msgs/TransformStamped[] transforms"],
        ["geometry_msgs/TransformStamped"] = ["std_msgs/Header header", "string child_frame_id", "geometry_msgs/Transform transform"],
        ["geometry_msgs/Transform"] = ["geometry_msgs/Vector3 translation", "geometry_msgs/Quaternion rotation"],
        ["geometry_msgs/Vector3"] = ["float64 x", "float64 y", "float64 z"],
        ["geometry_msgs/Quaternion"] = ["float64 x", "float64 y", "float64 z", "float64 w"],
        ["nowpose_msgs/Signals"] = ["std_msgs/Header header", "string[] name", "float64[] value"],
        ["builtin_interfaces/Time"] = ["int32 sec", "uint32 nanosec"],
        ["builtin_interfaces/Duration"] = ["int32 sec", "uint32 nanosec"],
    };

    /// <summary>Gets a type's name in the format of this ROS version.</summary>
    public string Spelled(string type) => isRos2 && !type.Contains("/msg/", StringComparison.Ordinal)
        ? type.Replace("/", "/msg/", StringComparison.Ordinal) : type;

    /// <summary>Gets the definitions of a type and of all nested types as one string; empty for an unknown type.</summary>
    public string FullText(string type)
    {
        var types = WithParts(Plain(type));
        return string.Join('\n', types.Select((part, i) =>
            (i == 0 ? "" : $"{Separator}\nMSG: {part}\n") + string.Concat(FieldsOf(part).Select(field => $"{field.Text}\n"))));
    }

    /// <summary>Gets the definitions of a type and of all nested types, field by field; empty for an unknown type.</summary>
    public IEnumerable<TypeDefinition> Details(string type) => WithParts(Plain(type)).Select(part => new TypeDefinition(
        Spelled(part),
        [.. FieldsOf(part).Select(field => field.Name)],
        [.. FieldsOf(part).Select(field => field.Type.Contains('/', StringComparison.Ordinal) ? Spelled(field.Type) : field.Type)],
        [.. FieldsOf(part).Select(field => field.IsArray ? 0 : -1)],
        [.. FieldsOf(part).Select(field => field.IsArray ? "[]" : field.Type == "string" ? "" : field.Type.Contains('/', StringComparison.Ordinal) ? "{}" : "0")],
        [], []));

    static string Plain(string type) => type.Replace("/msg/", "/", StringComparison.Ordinal);

    List<string> WithParts(string type)
    {
        var types = new List<string>();
        void Add(string one)
        {
            if (types.Contains(one) || !Fields.ContainsKey(one)) return;
            types.Add(one);
            foreach (var field in FieldsOf(one)) Add(field.Type);
        }

        Add(type);
        return types;
    }

    IEnumerable<Field> FieldsOf(string type) => Fields[type].Select(text => Field.Of(isRos2 ? InRos2(text) : text));

    static string InRos2(string field) => field
        .Replace("time stamp", "builtin_interfaces/Time stamp", StringComparison.Ordinal)
        .Replace("duration time", "builtin_interfaces/Duration time", StringComparison.Ordinal);

    readonly record struct Field(string Text, string Type, string Name, bool IsArray)
    {
        public static Field Of(string text)
        {
            var words = text.Split(' ');
            var isArray = words[0].EndsWith("[]", StringComparison.Ordinal);
            return new Field(text, isArray ? words[0][..^2] : words[0], words[1], isArray);
        }
    }
}
