using System.Collections.Concurrent;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Stores everything that a client receives in queues.</summary>
sealed class QueuedListener : IRosbridgeListener
{
    public ConcurrentQueue<JointStateMessage> Messages { get; } = [];
    public ConcurrentQueue<DropReason> Drops { get; } = [];
    public ConcurrentQueue<string> Descriptions { get; } = [];

    public ConcurrentQueue<JointTrajectoryMessage> Plans { get; } = [];

    public void Received(JointStateMessage message, HeadsetTime arrival, string robot)
    {
        Messages.Enqueue(message);
        Robots.Enqueue(robot);
    }

    /// <summary>Namespaces of the robots, in the same order as <see cref="Messages"/>.</summary>
    public ConcurrentQueue<string> Robots { get; } = [];

    public void Planned(JointTrajectoryMessage message, HeadsetTime arrival, string robot) => Plans.Enqueue(message);

    public ConcurrentQueue<(TransformsMessage Message, bool IsStationary)> Frames { get; } = [];

    public void FramesReceived(TransformsMessage message, bool isStationary, HeadsetTime arrival) => Frames.Enqueue((message, isStationary));

    public ConcurrentQueue<SignalsMessage> Signals { get; } = [];

    public void SignalsReceived(SignalsMessage message, HeadsetTime arrival) => Signals.Enqueue(message);

    public ConcurrentQueue<HeadsetTime> Connections { get; } = [];

    public void Connected(HeadsetTime at) => Connections.Enqueue(at);

    public ConcurrentQueue<string> Versions { get; } = [];

    public void VersionReceived(string version) => Versions.Enqueue(version);

    public ConcurrentQueue<JointStatusMessage> SignalStatuses { get; } = [];

    public void SignalStatusReceived(JointStatusMessage message, HeadsetTime arrival) => SignalStatuses.Enqueue(message);

    public ConcurrentQueue<JointStatusMessage> Statuses { get; } = [];

    public void StatusReceived(JointStatusMessage message, HeadsetTime arrival) => Statuses.Enqueue(message);

    public void Described(string urdf, string robot)
    {
        Descriptions.Enqueue(urdf);
        Describing?.Invoke(urdf);
    }

    public void Dropped(DropReason reason) => Drops.Enqueue(reason);
    public Action<string> Describing { get; set; }
    public bool FailDiagnostics { get; set; }

    public ConcurrentQueue<JointStateMessage> Displays { get; } = [];
    public JointStateMessage Displayed() => Displays.TryDequeue(out var shown) ? shown : null;

    public DiagnosticsMessage Report { get; set; }

    public bool HasPoseChanged { get; set; }

    public bool NeedsNamespaces { get; set; }

    public ConcurrentQueue<IReadOnlyList<string>> Namespaces { get; } = [];

    public void NamespacesReceived(IReadOnlyList<string> names) => Namespaces.Enqueue(names);

    /// <summary>Called before each report.</summary>
    public Action Reporting { get; set; }

    public DiagnosticsMessage Diagnostics()
    {
        Reporting?.Invoke();
        return FailDiagnostics ? throw new InvalidOperationException("no diagnostics today") : Report;
    }
}
