using System.Globalization;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>A joint board in virtual time, with samples of one source and reports of adapters.</summary>
sealed class SampledBoard
{
    public SampledBoard(Func<RobotModel> robot = null, Action<string> log = null)
    {
        Board = new JointBoard(Time, () => robot?.Invoke() is { } model ? [("", model)] : [], log);
        Source = Hub.OpenSource();
    }

    public SteppedTime Time { get; } = new();
    public MessageHub Hub { get; } = new();
    public JointBoard Board { get; }

    /// <summary>Source of the samples that <see cref="Send"/> adds.</summary>
    public HubSource Source { get; set; }

    /// <summary>Adds 20 samples per second for the given time. Each sample is 70 ms old when it is received.</summary>
    public void Send(double seconds, params string[] names)
    {
        for (var i = 0; i < seconds * 20; i++)
        {
            Add(Source, names);
            Time.Advance(TimeSpan.FromMilliseconds(50));
        }
    }

    /// <summary>Adds a sample that is 70 ms old.</summary>
    public void Add(HubSource source, params string[] names)
    {
        var age = TimeSpan.FromMilliseconds(70);
        Board.Add(source, names, Now - age, age);
    }

    /// <summary>Control time, which is equal to the wall clock.</summary>
    public ControlTime Now => new(Time.GetUtcNow() - DateTimeOffset.UnixEpoch);

    public void Report(string adapter, params (string Joint, string State, string Reason)[] joints)
    {
        var since = Time.GetUtcNow().ToUnixTimeMilliseconds() / 1000.0;
        Board.Report(adapter, [.. joints.Select(joint => KeyValuePair.Create(
            $"joint/{joint.Joint}", string.Create(CultureInfo.InvariantCulture, $"{joint.State} {since:0.000} {joint.Reason}")))]);
    }

    public JointSnapshot Joint(string name, string source = null) =>
        Board.Read().Single(joint => joint.Name == name && (source == null || joint.Source == source));
}
