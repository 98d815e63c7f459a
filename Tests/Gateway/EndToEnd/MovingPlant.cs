using System.Diagnostics;
using System.Globalization;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Runs an OPC UA server or a simulated ADS PLC with a moving youBot in another process, and computes its true positions.</summary>
sealed class MovingPlant : IPlantTruth, IDisposable
{
    static readonly string[] Arm = ["arm_joint_1", "arm_joint_2", "arm_joint_3", "arm_joint_4", "arm_joint_5"];
    static readonly string[] Fingers = ["gripper_finger_joint_l", "gripper_finger_joint_r"];
    static readonly double[] Middle = [2.9, 1.1, -2.5, 1.7, 2.9];

    readonly PeerProcess _program;
    readonly string _kind;
    int _commands;

    MovingPlant(PeerProcess program, string kind)
    {
        _program = program;
        _kind = kind;
    }

    public string Endpoint => _program.ValueOf("endpoint");

    /// <param name="kind">Kind of the control system: opcua or ads.</param>
    public static async Task<MovingPlant> StartAsync(string kind)
    {
        Needs.Adapters();
        var program = PeerProcess.OfNode("Gateway/Adapters/test/movingPlant.mjs", kind);
        await program.PrintsAsync("state serving");
        return new MovingPlant(program, kind);
    }

    /// <summary>Writes a configuration with which an adapter reads this plant, and returns the path of the file.</summary>
    public string Configure(string folder)
    {
        var path = Path.Combine(folder, _kind + ".yaml");
        File.WriteAllText(path, $"""
            plant:
              kind: {_kind}
              name: plc
              endpoint: {Endpoint}
            {(_kind == "opcua" ? $"  security:\n    folder: {folder}/certificates\n    thumbprint: {_program.ValueOf("thumbprint")}" : "  plain: true\n  local_net_id: 127.0.0.1.1.1")}
              sampling_ms: 10
              publishing_ms: 50
            robot: {RepositoryFiles.Root}/Packages/com.nowpose.mril/Runtime/Robots/youbot.urdf
            joints:
            {string.Join("\n", Joints())}
            """);
        return path;
    }

    public ControlTime TimeAt(HeadsetTime headset)
    {
        var clock = _program.ValueOf("clock").Split(' ').Select(text => decimal.Parse(text, CultureInfo.InvariantCulture)).ToArray();
        // The plant's process reads the same monotonic counter of the system. Here it is in ns.
        var passed = headset.SinceEpoch.Ticks * 100m - clock[0];
        return new ControlTime(new TimeSpan((long)Math.Round((clock[1] + passed * (1 + clock[2] / 1_000_000)) / 100)));
    }

    public void TruthAt(RobotModel robot, ControlTime time, Span<double> positions)
    {
        var seconds = time.SinceEpoch.Ticks % TimeSpan.TicksPerHour / (double)TimeSpan.TicksPerSecond;
        for (var i = 0; i < positions.Length; i++)
        {
            var joint = Array.IndexOf(Arm, robot.MovingJoints[i].Name);
            positions[i] = joint >= 0
                ? Middle[joint] + 0.4 * Math.Sin(2 * Math.PI * (0.2 + 0.05 * joint) * seconds)
                : 0.005 + 0.004 * Math.Sin(2 * Math.PI * 0.3 * seconds);
        }
    }

    /// <summary>Sends the OPC UA server a command: stop, bad or repair with the name of a node, or rest with a time in ms.</summary>
    /// <returns>Time at which the command took effect.</returns>
    public async Task<DateTimeOffset> CommandAsync(string command, string argument)
    {
        var key = $"done {command} {++_commands}";
        _program.Send($"{command} {argument}");
        await _program.PrintsAsync(key + " ");
        return DateTimeOffset.UnixEpoch + TimeSpan.FromSeconds(double.Parse(_program.ValueOf(key), CultureInfo.InvariantCulture));
    }

    public void Dispose()
    {
        // The program deletes its temporary files when its input ends, but not when it is killed.
        _program.CloseInput();
        _program.Dispose();
    }

    IEnumerable<string> Joints()
    {
        var node = _kind == "opcua" ? "node: \"ns=1;s={0}\"" : "symbol: \"{0}\"";
        for (var i = 0; i < Arm.Length; i++)
            yield return Joint(Arm[i], string.Format(node, _kind == "opcua" ? Arm[i] : $"GVL.aJoints[{i}]"), "rad");
        foreach (var finger in Fingers)
            yield return Joint(finger, string.Format(node, _kind == "opcua" ? "gripper_mm" : "MAIN.fGripper"), "mm");
    }

    static string Joint(string name, string from, string unit) => $"  - joint: {name}\n    {from}\n    unit: {unit}";
}
