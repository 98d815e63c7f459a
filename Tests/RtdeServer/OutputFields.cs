using System.Text.RegularExpressions;

namespace Nowpose.RtdeServer;

/// <summary>The fields that a client may request, with the types of UR's guide. Fields that the server does not simulate are zero.</summary>
static partial class OutputFields
{
    public const string NotFound = "NOT_FOUND";

    const uint PoweredOnAndProgramRunning = 0b11, NormalSafety = 1, ProtectiveStopBits = 1 << 2 | 1 << 10;
    const int RobotRunning = 7, JointRunning = 253;

    static readonly Dictionary<string, (string Type, Action<PackageWriter, RobotState> Write)> Known = new()
    {
        ["timestamp"] = Double(s => s.Timestamp),
        ["target_q"] = Vector6(s => s.Target.Positions),
        ["target_qd"] = Vector6(s => s.Target.Velocities),
        ["target_qdd"] = Vector6(s => s.Target.Accelerations),
        ["actual_q"] = Vector6(s => s.Actual.Positions),
        ["actual_qd"] = Vector6(s => s.Actual.Velocities),
        ["actual_TCP_pose"] = Vector6(s => s.Actual.ToolPose),
        ["target_TCP_pose"] = Vector6(s => s.Target.ToolPose),
        ["actual_digital_input_bits"] = UInt64(s => s.DigitalInputs),
        ["actual_digital_output_bits"] = UInt64(s => s.DigitalOutputs),
        ["runtime_state"] = UInt32(s => (uint)s.Runtime),
        ["robot_mode"] = Int32(_ => RobotRunning),
        ["joint_mode"] = ("VECTOR6INT32", (to, _) => Repeat(6, () => to.Add(JointRunning))),
        ["safety_mode"] = Int32(s => (int)s.Safety),
        ["safety_status"] = Int32(s => (int)s.Safety),
        ["safety_status_bits"] = UInt32(s => s.Safety == SafetyMode.Normal ? NormalSafety : ProtectiveStopBits),
        ["robot_status_bits"] = UInt32(s => s.Runtime == RuntimeState.Playing ? PoweredOnAndProgramRunning : PoweredOnAndProgramRunning & 1),
        ["speed_scaling"] = Double(_ => 1),
        ["target_speed_fraction"] = Double(_ => 1),
        ["actual_main_voltage"] = Double(_ => 48),
        ["actual_robot_voltage"] = Double(_ => 48),
        ["actual_joint_voltage"] = ("VECTOR6D", (to, _) => Repeat(6, () => to.Add(48.0))),
        ["joint_temperatures"] = ("VECTOR6D", (to, _) => Repeat(6, () => to.Add(30.0))),
        ["tool_temperature"] = Double(_ => 30),
        ["tool_output_voltage"] = Int32(_ => 24),
    };

    /// <summary>Names of the fields that are always zero, by type.</summary>
    static readonly Dictionary<string, string> Zero = new()
    {
        ["DOUBLE"] = "actual_execution_time actual_momentum actual_robot_current standard_analog_input0 standard_analog_input1 standard_analog_output0 "
            + "standard_analog_output1 io_current tool_analog_input0 tool_analog_input1 tool_output_current tcp_force_scalar euromap67_24V_voltage "
            + "euromap67_24V_current joint_position_deviation_ratio collision_detection_ratio payload",
        ["VECTOR3D"] = "actual_tool_accelerometer elbow_position elbow_velocity payload_cog",
        ["VECTOR6D"] = "target_current target_moment actual_current actual_current_window joint_control_output actual_TCP_speed actual_TCP_force "
            + "target_TCP_speed tcp_offset ft_raw_wrench payload_inertia",
        ["UINT32"] = "analog_io_types tool_mode tool_analog_input_types euromap67_input_bits euromap67_output_bits output_bit_registers0_to_31 "
            + "output_bit_registers32_to_63 input_bit_registers0_to_31 input_bit_registers32_to_63 script_control_line",
        ["UINT64"] = "actual_configurable_digital_input_bits actual_configurable_digital_output_bits",
        ["INT32"] = "encoder0_raw encoder1_raw time_scale_source",
        ["UINT8"] = "tool_output_mode tool_digital_output0_mode tool_digital_output1_mode",
    };

    static readonly Dictionary<string, string> ZeroTypes =
        Zero.SelectMany(pair => pair.Value.Split(' ').Select(name => (name, pair.Key))).ToDictionary(pair => pair.name, pair => pair.Key);

    [GeneratedRegex(@"^(?:in|out)put_(bit|int|double)_register_(\d{1,3})$")]
    private static partial Regex Register();

    /// <summary>Returns the name of a field's type for the response to a recipe request.</summary>
    public static string TypeOf(string name)
    {
        if (Known.TryGetValue(name, out var known)) return known.Type;
        return ZeroTypes.TryGetValue(name, out var zero) ? zero : RegisterType(name);
    }

    /// <summary>Writes the value of a field in one control cycle.</summary>
    public static void Write(string name, PackageWriter to, RobotState state)
    {
        if (Known.TryGetValue(name, out var known)) known.Write(to, state);
        else Repeat(SizeOf(TypeOf(name)), () => to.Add((byte)0));
    }

    /// <summary>
    /// Returns the type of a general-purpose register. Bit registers are numbered 64 to 127, all other registers 0 to 47.
    /// </summary>
    public static string RegisterType(string name)
    {
        var match = Register().Match(name);
        if (!match.Success) return NotFound;
        var number = int.Parse(match.Groups[2].ValueSpan);
        return match.Groups[1].Value switch
        {
            "bit" => number is >= 64 and <= 127 ? "BOOL" : NotFound,
            "int" => number <= 47 ? "INT32" : NotFound,
            _ => number <= 47 ? "DOUBLE" : NotFound,
        };
    }

    static int SizeOf(string type) => type switch
    {
        "BOOL" or "UINT8" => 1,
        "UINT32" or "INT32" => 4,
        "VECTOR3D" or "VECTOR6INT32" or "VECTOR6UINT32" => 24,
        "VECTOR6D" => 48,
        _ => 8,
    };

    static (string Type, Action<PackageWriter, RobotState> Write) Double(Func<RobotState, double> value) => ("DOUBLE", (to, s) => to.Add(value(s)));
    static (string Type, Action<PackageWriter, RobotState> Write) Vector6(Func<RobotState, double[]> value) => ("VECTOR6D", (to, s) => to.Add(value(s)));
    static (string Type, Action<PackageWriter, RobotState> Write) UInt64(Func<RobotState, ulong> value) => ("UINT64", (to, s) => to.Add(value(s)));
    static (string Type, Action<PackageWriter, RobotState> Write) UInt32(Func<RobotState, uint> value) => ("UINT32", (to, s) => to.Add(value(s)));
    static (string Type, Action<PackageWriter, RobotState> Write) Int32(Func<RobotState, int> value) => ("INT32", (to, s) => to.Add(value(s)));

    static void Repeat(int count, Action action)
    {
        for (var i = 0; i < count; i++) action();
    }
}
