namespace Nowpose.RtdeServer;

/// <summary>The fields that a client may write. The server accepts them but ignores their values.</summary>
static class InputFields
{
    /// <summary>Reported instead of the type of an input if another client writes the input.</summary>
    public const string InUse = "IN_USE";

    static readonly Dictionary<string, string> Known = new()
    {
        ["speed_slider_mask"] = "UINT32",
        ["speed_slider_fraction"] = "DOUBLE",
        ["standard_digital_output_mask"] = "UINT8",
        ["configurable_digital_output_mask"] = "UINT8",
        ["standard_digital_output"] = "UINT8",
        ["configurable_digital_output"] = "UINT8",
        ["standard_analog_output_mask"] = "UINT8",
        ["standard_analog_output_type"] = "UINT8",
        ["standard_analog_output_0"] = "DOUBLE",
        ["standard_analog_output_1"] = "DOUBLE",
        ["tool_digital_output_mask"] = "UINT8",
        ["tool_digital_output"] = "UINT8",
        ["external_force_torque"] = "VECTOR6D",
        ["input_bit_registers0_to_31"] = "UINT32",
        ["input_bit_registers32_to_63"] = "UINT32",
    };

    public static string TypeOf(string name)
    {
        if (Known.TryGetValue(name, out var type)) return type;
        return name.StartsWith("input_", StringComparison.Ordinal) ? OutputFields.RegisterType(name) : OutputFields.NotFound;
    }
}
