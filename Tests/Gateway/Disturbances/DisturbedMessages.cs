using System.Globalization;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>The joints, frames or signals that a source publishes on a topic.</summary>
sealed record Channel(string Topic, string[] Names)
{
    public bool HasParts => Topic is RosTopics.Tf or RosTopics.TfStatic or RosTopics.Signals;
    public bool IsOfFrames => Topic is RosTopics.Tf or RosTopics.TfStatic;
    public bool IsOfPlans => Topic.EndsWith(RosTopics.JointTrajectory, StringComparison.Ordinal);
}

/// <summary>Random messages. Several sources use the same names.</summary>
sealed class DisturbedMessages(DisturbedGateway gateway, Ledger ledger, Random random)
{
    static readonly string[] Joints = ["a", "b", "c", "d"];
    static readonly string[] Signals = ["u", "v", "w", "x", "y", "z"];
    static readonly string[] Frames = ["0", "1", "2", "3", "4", "5", "r1/base", "base"];
    static readonly string[] Parents = [.. Frames, "r1/tool0", "r1/arm", "tool1", "arm"];

    static readonly string[] Topics =
    [
        RosTopics.JointStates, RosTopics.JointStates, "/r1/joint_states", RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals, RosTopics.Signals,
        RosTopics.JointTrajectory, "/r1/joint_trajectory",
    ];

    public Channel NewChannel() => WithOtherNames(new Channel(Topics[random.Next(Topics.Length)], null));

    /// <summary>Returns the channel with other names in another order.</summary>
    public Channel WithOtherNames(Channel channel)
    {
        var all = channel.IsOfFrames ? Frames : channel.Topic == RosTopics.Signals ? Signals : Joints;
        var some = all.Where(_ => random.Next(2) == 0).ToArray();
        if (some.Length == 0) some = [all[random.Next(all.Length)]];
        random.Shuffle(some);
        return channel with { Names = some };
    }

    /// <summary>Returns a channel with many names that other sources do not have.</summary>
    public Channel NewFlood()
    {
        var topic = random.Next(5) switch
        {
            0 => RosTopics.JointStates,
            1 => RosTopics.Tf,
            2 => RosTopics.TfStatic,
            3 => RosTopics.Signals,
            _ => $"/q{random.Next(30)}/joint_states",
        };
        return new Channel(topic, [.. Enumerable.Range(random.Next(500), random.Next(1, 80)).Select(i => $"new{i}")]);
    }

    /// <summary>Returns a message whose parts have the same new value.</summary>
    /// <param name="ahead">Stamp minus the control time, s.</param>
    /// <param name="isLastWrong">Whether the value of the last part is not a number.</param>
    public string Of(Channel channel, double ahead = 0, bool isLastWrong = false)
    {
        var (stamp, value) = (gateway.Clock.Now + TimeSpan.FromSeconds(ahead), (double)ledger.NextValue());
        var names = channel.Names;
        double[] values = [.. names.Select(_ => value)];
        IRosMessage message =
            channel.IsOfFrames ? new TransformsMessage([.. names.Select(name => PoseOf(name, stamp, value))])
            : channel.Topic == RosTopics.Signals ? new SignalsMessage(stamp, [.. names.Select(name => new SignalValue(name, value))])
            : channel.IsOfPlans ? new JointTrajectoryMessage(stamp, names, [new JointTrajectoryPoint(TimeSpan.FromSeconds(1), values)])
            : new JointStateMessage(stamp, names, values);
        var text = RosbridgeWriter.Publish(channel.Topic, message);
        if (!isLastWrong) return text;
        var number = value.ToString("0.0", CultureInfo.InvariantCulture);
        var at = text.LastIndexOf(number, StringComparison.Ordinal);
        return text[..at] + "NaN" + text[(at + number.Length)..];
    }

    /// <summary>Returns the description of an arm with two joints, whose tool has one of several names.</summary>
    public string Description()
    {
        var tool = $"tool{random.Next(3)}";
        static string Joint(string name, string parent, string child) =>
            $"<joint name='{name}' type='revolute'><parent link='{parent}'/><child link='{child}'/><axis xyz='0 0 1'/>"
            + "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>";
        var joints = Joint("a", "base", "arm") + Joint("b", "arm", tool);
        var urdf = $"<robot name='x'><link name='base'/><link name='arm'/><link name='{tool}'/>{joints}</robot>";
        return RosbridgeWriter.Publish((random.Next(2) == 0 ? "" : "/r1") + RosTopics.RobotDescription, new StringMessage(urdf));
    }

    /// <summary>Returns the report of an adapter that everything on its channels is current.</summary>
    public static string Report(string adapter, IEnumerable<Channel> channels) => RosbridgeWriter.Publish(
        RosTopics.Diagnostics, new DiagnosticsMessage(default, adapter, [new("state", "connected"), .. channels.SelectMany(KeysOf).Select(Live)]));

    static KeyValuePair<string, string> Live(string key) => new(key, "live 0");

    static IEnumerable<string> KeysOf(Channel channel)
    {
        var kind = channel.IsOfFrames ? "frame/" : channel.Topic == RosTopics.Signals ? "signal/" : "joint/";
        return channel.Names.Select(name => kind + RobotTopic.Qualified(RobotTopic.Parse(channel.Topic).Robot, name));
    }

    FrameTransform PoseOf(string name, ControlTime stamp, double value)
    {
        var parent = random.Next(4) == 0 ? Parents[random.Next(Parents.Length)] : FrameParents.World;
        return new FrameTransform(stamp, parent == name ? FrameParents.World : parent, name, value, 0, 0, 0, 0, 0, 1);
    }
}
